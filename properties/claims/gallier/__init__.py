"""Gallier, Allen-Blanchette and Leonardos, Motion Interpolation in SIM(3): its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

CHAPTERS: tuple[ModuleType, ...] = ()
