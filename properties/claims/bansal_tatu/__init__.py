"""Bansal and Tatu, Affine Interpolation in a Lie Group Framework: its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

from affinecert.properties.claims.bansal_tatu import rigid_exponential

CHAPTERS: tuple[ModuleType, ...] = (rigid_exponential,)
