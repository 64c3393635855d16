"""Measures of a path do not depend on the frame it is seen from, nor on the sense of time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from affinecert.catalogue import find
from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.law import Law
from affinecert.sampling import homogeneous, quarter_turns


def _seen_from_elsewhere(maps: Maps, poses: Array, points: Array) -> float:
    # A quarter turn, and a scaling by a power of two, are exact.
    size = poses.shape[-1] - 1
    frame = homogeneous(4.0 * quarter_turns(size)[1], np.zeros(size))
    here = ask(maps, "measures.average_relative_acceleration", poses, points)
    there = ask(maps, "measures.average_relative_acceleration", frame @ poses, points)
    return here["acceleration"].misfit(there["acceleration"])


def _backwards(name: str, part: str) -> Callable[..., float]:
    def residual(maps: Maps, poses: Array) -> float:
        there, back = ask(maps, name, poses), ask(maps, name, np.array(poses[::-1]))
        turned = np.array(there.array[::-1] if there.array.ndim else there.array)
        return replace(there, array=turned)[part].misfit(back[part])

    return residual


def _law(measure: str, statement: str, source: str, residual: Callable[..., float]) -> Law:
    return Law(
        name=f"path_invariance.{measure}",
        statement=statement,
        source=source,
        domain=find(f"measures.{measure}").domain,
        needs=(f"measures.{measure}",),
        inputs=strategies.inputs(f"measures.{measure}"),
        residual=residual,
    )


LAWS = (
    _law(
        "average_relative_acceleration",
        "the acceleration in the moving frame is the same for M_i and G M_i, G affine",
        "rossignac_vinacua, sections 1 and 2.3 (2)",
        _seen_from_elsewhere,
    ),
    _law(
        "volume",
        "the path backwards has the same volumes backwards",
        "rossignac_vinacua, section 2.3 (3)",
        _backwards("measures.volume", "volume"),
    ),
    _law(
        "degeneracy",
        "the path backwards loses as much volume",
        "rossignac_vinacua, section 2.3 (3)",
        _backwards("measures.degeneracy", "degeneracy"),
    ),
)
