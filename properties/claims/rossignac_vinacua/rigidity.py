"""Section 3.3.3: steadiness and rigidity."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import HOLDS, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import Morph, Pair, at, rigid_pairs, steady, unit
from affinecert.reference import morphs
from affinecert.reference._matrices import Array, Number, norm
from affinecert.reference.measures import average_relative_acceleration

_STEPS = 8


def _path(form: Morph, pair: Pair) -> Array:
    return np.array([at(form, pair, mp.mpf(k) / _STEPS) for k in range(_STEPS + 1)], dtype=object)


def _stretching(path: Array, witnesses: Array) -> Number:
    """The squared rates at which the lengths of witness vectors change, summed over the steps of a path."""
    lengths = [[norm(mp, pose[:-1, :-1] @ each) for each in witnesses] for pose in path]
    return sum((b - a) ** 2 for before, after in pairwise(lengths) for a, b in zip(before, after, strict=True)) * _STEPS


def _acceleration(path: Array, _: Array) -> Number:
    """The average relative acceleration, whatever the witnesses."""
    corners = np.concatenate([exactly([[0] * (path.shape[-1] - 1)]), exactly(np.eye(path.shape[-1] - 1).tolist())])
    return average_relative_acceleration(mp, path, corners)[()]


def _both_measures(form: Morph, pair: Pair) -> Number:
    path = _path(form, pair)
    witnesses = exactly([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    return max(_stretching(path, witnesses), _acceleration(path, witnesses))


def _independent(form: Any, case: tuple[Pair, Array, Array]) -> Number:
    """Whether a measure of the steady morph is the same with other witnesses."""
    pair, first, second = case
    path = _path(steady, pair)
    return mp.mpf(abs(form(path, first) - form(path, second)) < HOLDS)


def _witnesses() -> list[tuple[Pair, Array, Array]]:
    stretch, shear = affine([[2, 0], [0, 1]], [0, 0]), affine([[1, 2], [0, 1]], [1, 0])
    return [
        ((unit(2), stretch), exactly([[1, 0]]), exactly([[0, 1]])),
        ((unit(2), shear), exactly([[1, 0], [0, 1]]), exactly([[1, 1], [-1, 1]])),
    ]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.3.3.zero",
        place="section 3.3.3",
        statement="Where the poses are images of each other under a rigid motion, the steady morph keeps the lengths "
        "of all witness vectors; their measure of rigidity and ARA both are 0.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=lambda: rigid_pairs()[:3],
        deviation=_both_measures,
        copies=(
            Copy("R^t ((1 - t) I + t S), which keeps the lengths", morphs.rarap),
            Copy("(1 - t) B + t C", morphs.linear),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.3.witnesses",
        place="section 3.3.3",
        statement="In other cases the measure of Hyun and others (2002) depends on the choice of witness vectors.",
        verdict=Verdict.CONFIRMED,
        form=_stretching,
        cases=_witnesses,
        deviation=_independent,
        copies=(Copy("ARA for the lengths of witnesses", _acceleration),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.3.as_rigid",
        place="section 3.3.3",
        statement="Steady motions ensure that the deformation is as rigid as possible, and the motion free of "
        "undesired undulation.",
        verdict=Verdict.UNCHECKABLE,
        reason="neither rigidity nor undulation is defined, but for isometries",
    ),
)
