"""A steady affine motion leaves its fixed point where it is."""

from __future__ import annotations

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import affine
from affinecert.properties.law import Law


def _kept(maps: Maps, matrix: Array) -> float:
    point = ask(maps, "sam.fixed_point", matrix)["point"]
    return affine(matrix)(point).misfit(point)


LAWS = (
    Law(
        name="fixed_point.sam",
        statement="A q = q",
        source="rossignac_vinacua, sections 3.1 and 6.1",
        domain="A without the eigenvalue 1, of the plane and of space",
        needs=("sam.fixed_point",),
        inputs=strategies.inputs("sam.fixed_point"),
        residual=_kept,
    ),
)
