"""An interpolation of a map that keeps volume keeps volume all the way."""

from __future__ import annotations

from functools import partial

from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import CTX, log_determinant, precisely, ratio
from affinecert.properties.law import Law

STATEMENT = "det T_t = (det T)^t; so det T_t = 1 if det T = 1"


def _residual(name: str, maps: Maps, matrix: Array, time: Array) -> float:
    volume, error = log_determinant(ask(maps, name, matrix, time).affine.linear)
    due, _ = log_determinant(precisely(matrix[:-1, :-1]))
    return ratio(abs(volume - CTX.mpf(float(time)) * due), error)


LAWS = (
    Law(
        name="volume_kept.affine_lie",
        statement=STATEMENT,
        source="bansal_tatu, Lemma 2 and its proof",
        domain="det T > 0, tried mostly at det T = 1; all real t",
        needs=("affine_lie.interpolate",),
        inputs=st.tuples(special.volume_keeping_maps(3) | strategies.affine_maps(3), strategies.times()),
        residual=partial(_residual, "affine_lie.interpolate"),
    ),
    Law(
        name="volume_kept.sam",
        statement=STATEMENT,
        source="rossignac_vinacua, sections 2.3 (4) and 6.3.3",
        domain="T with a real logarithm, of the plane and of space, tried mostly at det T = 1; all real t",
        needs=("sam.power",),
        inputs=st.tuples(
            special.volume_keeping_maps(2) | special.volume_keeping_maps(3) | strategies.affine_maps(3),
            strategies.times(),
        ),
        residual=partial(_residual, "sam.power"),
    ),
)
