"""Kaji and Ochiai, A concise parametrisation of affine transformation: its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

CHAPTERS: tuple[ModuleType, ...] = ()
