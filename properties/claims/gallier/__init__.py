"""Gallier, Allen-Blanchette and Leonardos, Motion Interpolation in SIM(3): its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

from affinecert.properties.claims.gallier import splicing_conditions, splicing_matrices, splicing_three_points

CHAPTERS: tuple[ModuleType, ...] = (splicing_conditions, splicing_three_points, splicing_matrices)
