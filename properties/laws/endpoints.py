"""An interpolation starts at its start and ends at its end."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import affine, precisely
from affinecert.properties.law import Law

START, END = np.array(0.0), np.array(1.0)


def _from_identity(name: str, maps: Maps, matrix: Array, _: Array) -> float:
    start, end = (ask(maps, name, matrix, time).affine for time in (START, END))
    return max(start.misfit(affine(np.eye(len(matrix)))), end.misfit(affine(matrix)))


def _between_maps(name: str, maps: Maps, source: Array, target: Array, _: Array) -> float:
    start, end = (ask(maps, name, source, target, time).affine for time in (START, END))
    return max(start.misfit(affine(source)), end.misfit(affine(target)))


def _between_vertices(name: str, maps: Maps, source: Array, target: Array, _: Array) -> float:
    start, end = (ask(maps, name, source, target, time)["vertices"] for time in (START, END))
    return max(start.misfit(precisely(source)), end.misfit(precisely(target)))


def _from_identity_of_the_plane(name: str, maps: Maps, linear: Array, _: Array) -> float:
    start, end = (ask(maps, name, linear, time).whole for time in (START, END))
    return max(start.misfit(precisely(np.eye(2))), end.misfit(precisely(linear)))


def _between_shapes(name: str, maps: Maps, source: Array, target: Array, triangles: Array, _: Array) -> float:
    start, end = (ask(maps, name, source, target, triangles, time)["vertices"] for time in (START, END))
    return max(start.misfit(precisely(source)), end.misfit(precisely(target)))


def _law(name: str, statement: str, source: str, domain: str, residual: Callable[..., float]) -> Law:
    return Law(
        name=f"endpoints.{name}",
        statement=statement,
        source=source,
        domain=domain,
        needs=(name,),
        inputs=strategies.inputs(name),
        residual=partial(residual, name),
    )


LAWS = (
    _law(
        "affine_lie.interpolate",
        "T_0 = I and T_1 = T",
        "bansal_tatu, section 4, equation 2",
        "det T > 0",
        _from_identity,
    ),
    _law(
        "affine_lie.interpolate_tetrahedra",
        "the interpolant is the source at t = 0 and the target at t = 1",
        "bansal_tatu, section 4, equation 4",
        "tetrahedra oriented as the canonical one",
        _between_vertices,
    ),
    _law(
        "affine_lie.interpolate_triangles",
        "the interpolant is the source at t = 0 and the target at t = 1",
        "bansal_tatu, section 4, equation 4",
        "triangles that are no segments",
        _between_vertices,
    ),
    _law(
        "sam.power",
        "A^0 = I and A^1 = A",
        "rossignac_vinacua, section 2.2, equation 1",
        "A with a real logarithm",
        _from_identity,
    ),
    _law(
        "sam.morph",
        "the morph is B at t = 0 and C at t = 1",
        "rossignac_vinacua, section 2.2",
        "C B^-1 with a real logarithm",
        _between_maps,
    ),
    *(
        _law(
            name,
            "A(0) = I and A(1) = A",
            f"kaji_2d, section 3, equation {equation}",
            "det A > 0",
            _from_identity_of_the_plane,
        )
        for name, equation in (("homotopy2.polar", 2), ("homotopy2.exponential", 3))
    ),
    _law(
        "mesh2.frobenius",
        "the shape is the source at t = 0 and the target at t = 1",
        "kaji_2d, section 4",
        "shapes without triangles that are turned over",
        _between_shapes,
    ),
)
