"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

CHAPTERS: tuple[ModuleType, ...] = ()
