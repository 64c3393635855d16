"""Sections 1 and 2.4: other morphs, which of them are unsteady, and whose areas do not evolve monotonically."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import HOLDS, distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    QUARTER,
    Morph,
    Pair,
    at,
    general_pairs,
    law,
    steady,
    unit,
    unsteadiness,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.properties.matrix.domains import ALL
from affinecert.properties.matrix.standard import PAIRS
from affinecert.reference import morphs
from affinecert.reference._matrices import Number
from affinecert.reference.measures import average_relative_acceleration

_PREVIOUS: Mapping[str, Morph] = {
    "alexa_2002": morphs.alexa_2002,
    "asap": morphs.asap,
    "linear": morphs.linear,
    "shoemake_duff": morphs.shoemake_duff,
    "arap": morphs.arap,
    "rarap": morphs.rarap,
    "log_spiral": morphs.log_spiral,
    "three_spiral": morphs.three_spiral,
}
"""The morphs that sections 2.4 and 3.3.2 speak of; "log_spiral" is (c), "three_spiral" (d)."""

_FIGURE_2 = ("linear", "rarap", "log_spiral", "three_spiral")


def _any_steady(form: tuple[str, ...], pair: Pair) -> Number:
    """Whether one of the morphs is steady between two poses of the plane."""
    return mp.mpf(any(unsteadiness(morphs.MORPHS[name], pair) < HOLDS for name in form))


def _exceptions() -> list[Pair]:
    """Pairs with B = I, and with a stretch about the centre of the triangle (1, 1), (4, 1), (4, 4)."""
    start, there = affine([[3, 3], [0, 3]], [1, 1]), affine([[1, 0], [0, 1]], [3, 2])
    stretched = there @ affine([[2, 0], [0, 1]], [0, 0]) @ inverse(there) @ start
    return [
        (unit(2), affine([[2, 0], [0, 1]], [0, 0])),
        (unit(2), affine([[1, -2], [1, 1]], [3, 1])),
        (start, stretched),
    ]


def _by_similarities() -> list[Pair]:
    """Pairs B, A B with a similarity A."""
    steps = [QUARTER, affine([[1, -2], [2, 1]], [1, 0]), affine([[0.5, 0.25], [-0.25, 0.5]], [2, 1])]
    return [(start, step @ start) for (start, _), step in zip(general_pairs(2), steps, strict=True)]


def _unlike_steady(form: tuple[Morph, ...], pair: Pair) -> Number:
    return max(distance(at(morph, pair, t), at(steady, pair, t)) for morph in form for t in (0.25, 0.5))


def _misjudged(form: frozenset[str], name: str) -> Number:
    """Whether the area is said to rise and fall in a morph where it never does, or not said where it does."""
    wavers = any(law("volume monotone")(_PREVIOUS[name], pair) > HOLDS for pair in _areas())
    return mp.mpf(wavers != (name in form))


def _areas() -> list[Pair]:
    """Pairs of poses of one area, and others."""
    shears = [(unit(2), affine([[1, 2], [0, 1]], [0, 0])), (unit(2), affine([[0, -2], [1, 0]], [1, 0]))]
    start = affine([[1, 1], [0, 1]], [0, 0])
    return [*shears, (start, affine([[-1, -2], [1, 1]], [0, 0])), *general_pairs(2)]


def _accelerations() -> dict[str, Any]:
    """The average relative accelerations of the corners of a triangle that is turned, stretched and carried away."""
    pair = tuple(exactly(pose.tolist()) for pose in PAIRS[ALL])
    corners = exactly([[0, 0], [1, 0], [0, 1]])
    found = {}
    for name in (*_FIGURE_2, "asap", "sam"):
        poses = np.array([at(morphs.MORPHS[name], pair, mp.mpf(k) / 16) for k in range(17)], dtype=object)
        found[name] = average_relative_acceleration(mp, poses, corners)[()]
    return found


_WAVERING = frozenset({"linear", "shoemake_duff", "arap", "rarap", "log_spiral", "three_spiral"})

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.1.previous_unsteady",
        place="section 1",
        statement="Except for cases where A is an isometry or a similarity of the plane, previously proposed solutions "
        "are not steady.",
        verdict=Verdict.BOUND,
        domain="B and C in general position. Among the exceptions are B = I, from which, whatever A is, "
        "e^((1 - t) log B + t log C) of Alexa (2002) is the steady morph; and R^t S^t is where A is a stretch about "
        "the centre of the shape",
        form=tuple(_PREVIOUS),
        cases=lambda: general_pairs(2, 4),
        outside=_exceptions,
        deviation=_any_steady,
        copies=(Copy("the steady morph among them", (*_PREVIOUS, "sam")),),
    ),
    Claim(
        id="rossignac_vinacua.1.similarities_steady",
        place="sections 1 and 2.4, (c) and (d)",
        statement="Where A is a similarity of the plane the logarithmic spiral of the poses, and the mean of those of "
        "the sides of the triangle, are the steady morph.",
        verdict=Verdict.CONFIRMED,
        form=(morphs.log_spiral, morphs.three_spiral),
        cases=_by_similarities,
        deviation=_unlike_steady,
        copies=(
            Copy("R^t S^t for the spiral of the poses", (morphs.asap, morphs.three_spiral)),
            Copy("e^((1 - t) log B + t log C) for it", (morphs.alexa_2002, morphs.three_spiral)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.1.wavering_areas",
        place="section 1, of sections 2 and 6.4",
        statement="The alternatives that are not steady exhibit non-monotonic changes of volume or area.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=frozenset(_PREVIOUS),
        cases=lambda: list(_PREVIOUS),
        deviation=_misjudged,
        correction=Correction(
            statement="Those do that mix matrices evenly, be it a stretch or a remainder only (linear, Shoemake and "
            "Duff, ARAP, rARAP, spiral and remainder, three spirals). The determinants of R^t S^t and of "
            "e^((1 - t) log B + t log C) are exponentials.",
            form=_WAVERING,
        ),
        copies=(Copy("without the three spirals", _WAVERING - {"three_spiral"}),),
    ),
    Claim(
        id="rossignac_vinacua.2.4.unsteady",
        place="section 2.4, figure 2",
        statement="Linear interpolation, rARAP, the spiral with a linear remainder and the mean of three spirals have "
        "ARA > 0 between poses in general position; the steady morph has 0.",
        verdict=Verdict.CONFIRMED,
        form=_FIGURE_2,
        cases=lambda: general_pairs(2, 4),
        deviation=_any_steady,
        copies=(Copy("the steady morph for the three spirals", ("linear", "rarap", "log_spiral", "sam")),),
        numbers=_accelerations,
        remark="The numbers are of poses of our own, in 16 steps. Their order is that of figure 2, in which the two "
        "kinds of spirals swap places between triangle and rectangle.",
    ),
    Claim(
        id="rossignac_vinacua.2.4.figure_2",
        place="section 2.4, figure 2",
        statement="The ARA are .063, .047, .029, .008 and .000 for the triangle (linear, rARAP, ASAP, TSB, SAM), and "
        ".417, .189, .015, .021 and .000 for the rectangle.",
        printed="Top: linear=.063, rARAP=.047, ASAP=.029, TSB=.008, and SAM=.000. "
        "Bottom: linear=.417, rARAP=.189, ASAP=.015, TSB=.021, and SAM=.000",
        verdict=Verdict.UNCHECKABLE,
        reason="neither the control poses nor the number of steps and the vicinity that was sampled are given",
        remark="The morph (c), a spiral with a linear remainder, is labelled ASAP here; section 3.3.2 calls ASAP a "
        "product of two powers. Whether the mean or, as said here, the integral over space is meant makes a factor.",
    ),
    Claim(
        id="rossignac_vinacua.2.4.least_distorted",
        place="section 2.3, (8)",
        statement="Of the five motions of figure 2 the steady one has the most uniformly spaced and least distorted "
        "pattern of pictures.",
        verdict=Verdict.UNCHECKABLE,
        reason="no measure of spacing and distortion is named; by ARA it holds by definition",
    ),
)
