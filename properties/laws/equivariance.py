"""A steady affine motion, or one by splines, does not depend on the frame in which it is written down."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answer import rounded_affine
from affinecert.properties.answers import Maps, ask
from affinecert.properties.culver import without_half_turns
from affinecert.properties.inexact import affine, exact
from affinecert.properties.law import Law

# P has small whole entries or powers of two, and an exact inverse; what P A P^-1 is rounded by is carried along.


def _frame(maps: Maps, matrix: Array, time: Array, frame: Array) -> float:
    without_half_turns(exact(matrix[:-1, :-1]))
    change = affine(frame)
    back = change.inverse()
    seen = ask(maps, "sam.power", rounded_affine(change @ affine(matrix) @ back), time)
    return (change @ ask(maps, "sam.power", matrix, time).affine @ back).misfit(seen.affine)


def _affine_invariance(maps: Maps, start: Array, end: Array, time: Array, frame: Array) -> float:
    without_half_turns((affine(end) @ affine(start).inverse()).linear.value)
    change = affine(frame)
    seen = ask(maps, "sam.morph", *(rounded_affine(change @ affine(pose)) for pose in (start, end)), time)
    return (change @ ask(maps, "sam.morph", start, end, time).affine).misfit(seen.affine)


def _keys(maps: Maps, poses: Array, time: Array, frame: Array) -> float:
    # P has one entry in each row and column, a power of two: nothing is rounded in P A P^-1.
    back = frame.T / np.max(frame**2, axis=1, initial=0.0)
    seen = ask(maps, "splines.motion", frame @ poses @ back, time)
    here = ask(maps, "splines.motion", poses, time).affine
    return (affine(frame) @ here @ affine(back)).misfit(seen.affine)


LAWS = (
    Law(
        name="equivariance.sam.power",
        statement="(P A P^-1)^t = P A^t P^-1",
        source="rossignac_vinacua, section 2.3 (2)",
        domain="A with a real logarithm and no negative eigenvalue; every P with det P > 0; all real t. At a double "
        "negative eigenvalue the law is false: A^t has to turn through some ellipse, and no choice of it suits every P",
        needs=("sam.power",),
        inputs=special.with_frame(strategies.inputs("sam.power")),
        residual=_frame,
    ),
    Law(
        name="equivariance.sam.morph",
        statement="the morph from P B to P C is P times the morph from B to C",
        source="rossignac_vinacua, section 2.3 (2)",
        domain="C B^-1 with a real logarithm and no negative eigenvalue; every P with det P > 0; all real t",
        needs=("sam.morph",),
        inputs=special.with_frame(strategies.inputs("sam.morph")),
        residual=_affine_invariance,
    ),
    Law(
        name="equivariance.splines.motion",
        statement="the motion through the poses P A_i P^-1 is P M P^-1, M the one through the A_i",
        source="gallier, section 5: rotation vectors turn with P, and c with its adjoint map",
        domain="every similarity P; poses A_i of which none is turned by pi, or has two rotation vectors equally near "
        "to that of the one before; all real t",
        needs=("splines.motion",),
        inputs=special.with_turn(
            st.one_of([strategies.regime("splines.motion", name) for name in ("through-pi", "two-keys")])
        ),
        residual=_keys,
    ),
)
