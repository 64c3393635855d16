"""Gallier, Allen-Blanchette and Leonardos, Motion Interpolation in SIM(3): its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim

CLAIMS: tuple[Claim[Any, Any], ...] = ()
