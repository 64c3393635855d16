"""Kaji et al., Mathematical Analysis on Affine Maps for 2D Shape Interpolation: its claims, in order."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim

CLAIMS: tuple[Claim[Any, Any], ...] = ()
