"""Kaji et al., Mathematical Analysis on Affine Maps for 2D Shape Interpolation: its claims, in order."""

from __future__ import annotations

from types import ModuleType

CHAPTERS: tuple[ModuleType, ...] = ()
