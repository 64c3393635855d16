"""What changes with the frame as it should: steady motions and splines in any frame, polar factors in rotated ones."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answer import Answer, rounded_affine
from affinecert.properties.answers import Maps, ask, ask_all
from affinecert.properties.culver import without_half_turns
from affinecert.properties.inexact import (
    UNDECIDED,
    Affine,
    affine,
    cofactors,
    determinant,
    exact,
    norm,
    precisely,
    real,
)
from affinecert.properties.law import Law, OutOfDomain

# P has small whole entries or powers of two, and an exact inverse; what P A P^-1 is rounded by is carried along.


def _rounded(pose: Affine) -> Answer:
    """A pose as float64; OutOfDomain if the rounding may have made it singular, or turned it over."""
    answer = rounded_affine(pose)
    linear = answer["linear"]
    if real(determinant(linear.value)) <= UNDECIDED * norm(cofactors(linear.value)) * linear.error:
        raise OutOfDomain("singular to within its rounding")
    return answer


def _frame(maps: Maps, matrix: Array, time: Array, frame: Array) -> float:
    without_half_turns(exact(matrix[:-1, :-1]))
    change = affine(frame)
    back = change.inverse()
    seen = ask(maps, "sam.power", _rounded(change @ affine(matrix) @ back), time)
    return (change @ ask(maps, "sam.power", matrix, time).affine @ back).misfit(seen.affine)


def _affine_invariance(maps: Maps, start: Array, end: Array, time: Array, frame: Array) -> float:
    without_half_turns((affine(end) @ affine(start).inverse()).linear.value)
    change = affine(frame)
    seen = ask(maps, "sam.morph", *(_rounded(change @ affine(pose)) for pose in (start, end)), time)
    return (change @ ask(maps, "sam.morph", start, end, time).affine).misfit(seen.affine)


def _rotated_frames(maps: Maps, linear: Array, after: Array, before: Array) -> float:
    # Rotations of whole entries: the products are exact.
    rotation, stretch = ask_all(maps, "polar.decompose", linear)
    turned, moved = ask_all(maps, "polar.decompose", after @ linear @ before)
    left, right = precisely(after), precisely(before)
    return max(turned.whole.misfit(left @ rotation.whole @ right), moved.whole.misfit(right.T @ stretch.whole @ right))


def _keys(maps: Maps, poses: Array, time: Array, frame: Array) -> float:
    # P has one entry in each row and column, a power of two: nothing is rounded in P A P^-1.
    back = frame.T / np.max(frame**2, axis=1, initial=0.0)
    seen = ask(maps, "splines.motion", frame @ poses @ back, time)
    here = ask(maps, "splines.motion", poses, time).affine
    return (affine(frame) @ here @ affine(back)).misfit(seen.affine)


def _curve_invariance(maps: Maps, *arguments: Array) -> float:
    *poses, time, frame = arguments
    change = affine(frame)
    seen = ask(maps, "curves.bezier_quadratic", *(_rounded(change @ affine(pose)) for pose in poses), time)
    return (change @ ask(maps, "curves.bezier_quadratic", *poses, time).affine).misfit(seen.affine)


def _similar_shapes(
    maps: Maps, source: Array, target: Array, triangles: Array, time: Array, similarity: Array
) -> float:
    there = ask(maps, "mesh2.similarity", source, target, triangles, time)["vertices"]
    seen = ask(maps, "mesh2.similarity", source @ similarity.T, target @ similarity.T, triangles, time)["vertices"]
    return (there @ precisely(similarity.T)).misfit(seen)


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
        name="equivariance.polar.decompose",
        statement="the polar factors of P L Q are P R Q and Q^T S Q",
        source="kaji_ochiai, remark 3.1",
        domain="det L > 0, in the plane and in space; rotations P and Q, here those of whole entries",
        needs=("polar.decompose",),
        inputs=special.with_quarter_turns(strategies.linear_maps()),
        residual=_rotated_frames,
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
    Law(
        name="equivariance.curves.bezier_quadratic",
        statement="the curve of P A, P B and P C is P times the curve of A, B and C",
        source="rossignac_vinacua, sections 2.3 (2) and 5.3",
        domain="as for curves.bezier_quadratic; every P with det P > 0",
        needs=("curves.bezier_quadratic",),
        inputs=special.with_frame(strategies.inputs("curves.bezier_quadratic")),
        residual=_curve_invariance,
    ),
    Law(
        name="equivariance.mesh2.similarity",
        statement="the shape from g P to g Q is g times that from P to Q, for a similarity g",
        source="kaji_2d, section 4",
        domain="shapes without triangles that are turned over; g here turns by quarters and scales by powers of two, "
        "which rounds nothing",
        needs=("mesh2.similarity",),
        inputs=special.with_similarity(strategies.inputs("mesh2.similarity")),
        residual=_similar_shapes,
    ),
)
