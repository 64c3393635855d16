"""Section 5: the sequences of logarithms that strategy 1 leaves for splines."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import difference, exactly, mp
from affinecert.reference import sim3, so3
from affinecert.reference._matrices import Array, Number, homogeneous

Step = tuple[str, int]
"""A logarithm of a pose: its name, X or Y, and the number of the pose; X for Y where they are the same."""


def _sequences(less: int) -> Any:
    """Cuts X_0, (Y_1, X_1), ..., (Y_(m-1), X_(m-1)), Y_m into sequences as the paper says, with m_1 less that many."""

    def printed(jumps: Sequence[bool]) -> list[list[Step]]:
        m = len(jumps)
        same = [True, *(not jump for jump in jumps)]
        found, start = [], 0
        while True:
            end = max(j for j in range(start, m + 1) if all(same[start + less : j + 1 - less]))
            found.append([("X", start), *(("X" if same[i] else "Y", i) for i in range(start + 1, end + 1))])
            if end in (start, m):
                return found
            start = end

    return printed


def _legs_lost(form: Any, jumps: Sequence[bool]) -> int:
    """How many of the pairs (X_i, Y_(i+1)) are in no sequence, or not in order, and sequences that are none."""
    legs = [pair for sequence in form(jumps) for pair in pairwise(sequence)]
    due = [(("X", i), ("Y" if jump else "X", i + 1)) for i, jump in enumerate(jumps)]
    return len(set(legs) ^ set(due))


def _journeys() -> list[list[bool]]:
    """Whether Y_i is not X_i, for i = 1, ..., m."""
    return [[False, False], [True, False], [True, False, False], [False, True, False, True, True, False, False]]


def _similarities() -> list[tuple[Array, Array]]:
    """Poses and the tangents before, such that strategy 1 takes the other logarithm."""
    turns = [exactly(each) for each in ([2, 1, 1], [0, 0, -3], [1, -2, 1])]
    poses = [
        homogeneous(mp, so3.exp(mp, w) * mp.mpf(scale), exactly([1, 2, 3]))
        for w, scale in zip(turns, (1, 2, 0.5), strict=True)
    ]
    return [(pose, exactly([*(-w), 0, 0, 0, 0])) for pose, w in zip(poses, turns, strict=True)]


def _other_tangent(keep: bool) -> Any:
    """The tangent with the other logarithm of the rotation and v = V^-1 w, or the v of the principal one kept."""

    def printed(pose: Array, before: Array) -> Array:
        principal, other = sim3.log(mp, pose), sim3.log_next(mp, pose, before)
        moved = principal if keep else other
        return np.concatenate([other[:3], moved[3:6], other[6:]])

    return printed


def _other_exponential(form: Any, case: tuple[Array, Array]) -> Number:
    """How far the exponential of the other tangent is from the pose; 1 where it is the principal one after all."""
    found = form(*case)
    same = difference(found[:3], sim3.log(mp, case[0])[:3]) == 0
    return 1 if same else difference(sim3.exp(mp, found), case[0])


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.sequences",
        place="section 5, the K sequences of logarithms",
        statement="The sequences are the longest ones of X_i and Y_(i+1), ..., Y_j with Y = X from one end to the "
        "other, and the next one starts with X_j.",
        printed="the longest subsequence (X_0, Y_1, ..., Y_{m_1}) such that Y_i = X_i for i = 1, ..., m_1; then "
        "(X_{m_1}, ...) such that Y_i = X_i for i = m_1, ..., m_1 + m_2",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_sequences(0),
        cases=_journeys,
        deviation=_legs_lost,
        correction=Correction(
            statement="Y_i = X_i is asked for i = 1, ..., m_1 - 1, and for i = m_1 + 1, ..., m_1 + m_2 - 1: at its "
            "last pose a sequence arrives with Y, whatever X is there. Every pair (X_i, Y_(i+1)) is in one sequence.",
            form=_sequences(1),
        ),
        remark="As printed the first sequence ends before the jump, the second one cannot start, and the way between "
        "is lost. The text goes on with Y_{m_1} ≠ X_{m_1}, and so means what is put right here.",
    ),
    Claim(
        id="gallier.5.same_exponential",
        place="section 5, at the ends of sequences (also abstract)",
        statement="Y ≠ X have the same exponential: both are logarithms of one similarity, v being V^-1 w with "
        "each one's own V.",
        printed="e^{Y_{m_1}} = e^{X_{m_1}}",
        verdict=Verdict.CONFIRMED,
        form=_other_tangent(keep=False),
        cases=_similarities,
        deviation=_other_exponential,
        copies=(Copy("v of X for v of Y", _other_tangent(keep=True)),),
    ),
)
