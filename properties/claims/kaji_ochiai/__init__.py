"""Kaji and Ochiai, A concise parametrisation of affine transformation: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.kaji_ochiai import other_parametrisations, parametrisation, plane_example, subspaces

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *plane_example.CLAIMS,
    *other_parametrisations.CLAIMS,
    *parametrisation.CLAIMS,
    *subspaces.CLAIMS,
)
