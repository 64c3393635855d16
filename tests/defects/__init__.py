"""Seeded defects: bugs that somebody could well write, one function each, injected through a Subject.

A defect is entered by the decorator `seeded`; the modules, one a family, are imported for that.
"""

from . import affine_lie, homotopy2, kaji_ochiai, mesh2, mesh3, polar, sam, se3, shear, so3, sym3
from .defect import DEFECTS, Defect

__all__ = [
    "DEFECTS",
    "Defect",
    "affine_lie",
    "homotopy2",
    "kaji_ochiai",
    "mesh2",
    "mesh3",
    "polar",
    "sam",
    "se3",
    "shear",
    "so3",
    "sym3",
]
