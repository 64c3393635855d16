"""Kaji and Ochiai, A concise parametrisation of affine transformation: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim

CLAIMS: tuple[Claim[Any, Any], ...] = ()
