"""Volume changes one way along an interpolation: it grows all the time, or it shrinks all the time."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import Inexact, determinant, exact, log_determinant, ratio
from affinecert.properties.law import Law

STATEMENT = "for s < t: det T_s < det T_t if det T > 1, det T_s > det T_t if det T < 1, and both are 1 if det T = 1"


def _residual(name: str, maps: Maps, matrix: Array, one: Array, other: Array) -> float:
    linear = matrix[:-1, :-1]
    return _monotone(linear, one, other, lambda time: ask(maps, name, matrix, time).affine.linear)


def _linear_residual(name: str, maps: Maps, linear: Array, one: Array, other: Array) -> float:
    return _monotone(linear, one, other, lambda time: ask(maps, name, linear, time).whole)


def _monotone(linear: Array, one: Array, other: Array, moved: Callable[[Array], Inexact]) -> float:
    earlier, later = sorted((one, other))
    before, error_before = log_determinant(moved(earlier))
    after, error_after = log_determinant(moved(later))
    volume = determinant(exact(linear))
    wrong_way = before - after if volume > 1 else after - before if volume < 1 else abs(after - before)
    return ratio(wrong_way, error_before + error_after)


LAWS = (
    Law(
        name="volume_monotone.affine_lie",
        statement=STATEMENT,
        source="bansal_tatu, Lemma 3",
        domain="det T > 0; all real s and t",
        needs=("affine_lie.interpolate",),
        inputs=st.tuples(
            strategies.affine_maps(3) | special.volume_keeping_maps(3), strategies.times(), strategies.times()
        ),
        residual=partial(_residual, "affine_lie.interpolate"),
    ),
    Law(
        name="volume_monotone.sam",
        statement=STATEMENT,
        source="rossignac_vinacua, sections 2.3 (4) and 6.4",
        domain="T with a real logarithm, of the plane and of space; all real s and t",
        needs=("sam.power",),
        inputs=st.tuples(
            strategies.affine_maps() | special.volume_keeping_maps(2), strategies.times(), strategies.times()
        ),
        residual=partial(_residual, "sam.power"),
    ),
    Law(
        name="volume_monotone.homotopy2",
        statement=STATEMENT,
        source="kaji_2d, section 3",
        domain="det A > 0; all real s and t",
        needs=("homotopy2.exponential",),
        inputs=st.tuples(special.plane_maps(), strategies.times(), strategies.times()),
        residual=partial(_linear_residual, "homotopy2.exponential"),
    ),
)
