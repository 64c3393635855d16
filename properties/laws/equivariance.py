"""What changes with the frame as it should: steady motions in any frame, polar factors in rotated ones."""

from __future__ import annotations

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answer import rounded_affine
from affinecert.properties.answers import Maps, ask, ask_all
from affinecert.properties.culver import without_half_turns
from affinecert.properties.inexact import affine, exact, precisely
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


def _rotated_frames(maps: Maps, linear: Array, after: Array, before: Array) -> float:
    # Rotations of whole entries: the products are exact.
    rotation, stretch = ask_all(maps, "polar.decompose", linear)
    turned, moved = ask_all(maps, "polar.decompose", after @ linear @ before)
    left, right = precisely(after), precisely(before)
    return max(turned.whole.misfit(left @ rotation.whole @ right), moved.whole.misfit(right.T @ stretch.whole @ right))


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
)
