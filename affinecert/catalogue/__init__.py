"""The catalogue: every map that affinecert certifies, one declarative entry each, a file a family."""

from __future__ import annotations

from collections.abc import Mapping
from fnmatch import fnmatchcase
from types import MappingProxyType

from affinecert.catalogue import (
    affine_lie,
    homotopy2,
    kaji_ochiai,
    measures,
    mesh2,
    mesh3,
    morphs,
    polar,
    quaternion,
    sam,
    scale,
    se3,
    shear,
    sim3,
    so3,
    sym3,
)
from affinecert.errors import UnknownNameError
from affinecert.map import Map

CATALOGUE: Mapping[str, Map] = MappingProxyType(
    {
        entry.name: entry
        for family in (
            so3,
            se3,
            sim3,
            scale,
            shear,
            sym3,
            polar,
            affine_lie,
            sam,
            quaternion,
            kaji_ochiai,
            morphs,
            homotopy2,
            mesh2,
            mesh3,
            measures,
        )
        for entry in family.MAPS
    }
)
"""Every map by its name, in the order in which everything shows them."""


def find(name: str) -> Map:
    """The map of that name. Raises UnknownNameError, which offers the nearest names."""
    try:
        return CATALOGUE[name]
    except KeyError:
        raise UnknownNameError("map", name, CATALOGUE) from None


def matching(glob: str) -> tuple[Map, ...]:
    """The maps whose names match a shell pattern (``se3.*``). Raises UnknownNameError where none does."""
    found = tuple(entry for name, entry in CATALOGUE.items() if fnmatchcase(name, glob))
    if not found:
        raise UnknownNameError("map", glob, CATALOGUE)
    return found
