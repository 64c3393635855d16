"""Sections 1 and 2.2: the steady affine morph, its powers, and where there is one."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import HOLDS, difference, distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    QUARTER,
    Morph,
    Pair,
    at,
    general_pairs,
    law,
    steady,
    unit,
    unlike_steady,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam
from affinecert.reference._matrices import Array, Context, Number, homogeneous, identity, tangent


def _has_root(linear: Array) -> bool:
    return sam.exists(mp, homogeneous(mp, linear, linear[0] * 0))


def _is_bent(form: Any, case: tuple[Array, Array]) -> Number:
    """Whether two matrices with the property have a mixture without it."""
    first, second = case
    mixtures = ((3 * first + second) / 4, (first + second) / 2, (first + 3 * second) / 4)
    return mp.mpf(form(first) and form(second) and not all(map(form, mixtures)))


def _upright() -> list[tuple[Array, Array]]:
    """Pairs of matrices L with L + L^T positive definite, the first ones hardly so."""
    spun = [(a - a.T + b @ b.T, b - b.T + a @ a.T) for a, b in arrays("upright", 4, (2, 3, 3), -2, 2)]
    return [_about_quarter_turns(mp.mpf(2) ** -20), *spun]


def _about_quarter_turns(positive: Number) -> tuple[Array, Array]:
    """The quarter turns both ways, and in addition diag(1, 2) times a number."""
    quarter, stretch = exactly([[0, -1], [1, 0]]), exactly([[1, 0], [0, 2]]) * positive
    return quarter + stretch, quarter.T + stretch


def _leaning() -> list[tuple[Array, Array]]:
    """Pairs of matrices that turn by hardly more than a right angle, with real logarithms."""
    return [_about_quarter_turns(-(mp.mpf(2) ** -20)), _about_quarter_turns(-mp.mpf(0.25))]


def _turns(linear: Array) -> bool:
    """Whether there are complex eigenvalues."""
    return any(abs(mp.im(each)) > HOLDS for each in definitions.eigenvalues(mp, linear))


def _power(m: Context, affinity: Array, t: Number) -> Array:
    return sam.exponential(m, sam.log(m, affinity) * t)


def _unlike_roots(form: Any, case: tuple[Array, int, int]) -> Number:
    """How far the n-th power of A^(k/n) is from A^k."""
    affinity, k, n = case
    root = form(mp, affinity, mp.mpf(k) / n)
    return distance(np.linalg.matrix_power(root, n), np.linalg.matrix_power(affinity, k))


def _roots() -> list[tuple[Array, int, int]]:
    quotients = [pair[1] @ inverse(pair[0]) for d in (2, 3) for pair in general_pairs(d)]
    return [(QUARTER, 1, 2)] + [(each, k, n) for each in quotients for k, n in ((1, 2), (2, 3), (5, 4))]


def _quotient(pair: Pair) -> Array:
    found: Array = pair[1] @ inverse(pair[0])
    return found


def _in_frame_of_start(m: Context, start: Array, end: Array, t: Array) -> Array:
    """A^t, A = C B^-1, applied in the frame of B."""
    found: Array = start @ sam.power(m, _quotient((start, end)), t)
    return found


def _local(m: Context, start: Array, end: Array, t: Array) -> Array:
    """B (B^-1 C)^t."""
    found: Array = start @ sam.power(m, inverse(start) @ end, t)
    return found


def _simple_pairs() -> list[Pair]:
    return [(unit(2), QUARTER), (QUARTER, affine([[1, 0], [0, 1]], [1, 0])), *general_pairs(2), *general_pairs(3)]


def _other_order(m: Context, start: Array, end: Array, t: Array) -> Array:
    found: Array = sam.power(m, inverse(start) @ end, t) @ start
    return found


def _coincide(form: tuple[Morph, ...], pair: Pair) -> Number:
    """Whether not all are morphs between the poses, or two of them have the same pose half way."""
    astray = any(law("endpoints")(morph, pair) > HOLDS for morph in form)
    halves = [at(morph, pair, 0.5) for morph in form]
    return mp.mpf(astray or any(difference(a, b) < HOLDS for a, b in combinations(halves, 2)))


def _straight(m: Context, affinity: Array, t: Number) -> Array:
    """The linear part of A^t, with the translation in a straight line."""
    return homogeneous(m, _power(m, affinity, t)[:-1, :-1], affinity[:-1, -1] * t)


def _turned(m: Context, affinity: Array) -> Array:
    """The logarithm that turns the other way round, of a map of the plane that turns."""
    linear = affinity[:-1, :-1]
    spin = linear - linear.trace() / 2 * identity(m, 2)
    other = sam.log(m, affinity)[:-1, :-1] - 2 * m.pi / m.sqrt(definitions.determinant(spin)) * spin
    return tangent(m, other, -other @ sam.fixed_point(m, affinity))


def _spins(angle: Number) -> list[Array]:
    """The velocities X of steady motions e^(tX) that turn by an angle: a circle, a spiral, an ellipse."""
    spins = [[[0, -1], [1, 0]], [[0, 1], [-1, 0]], [[1, -2], [1, -1]]]
    growths = (mp.zero, mp.mpf(0.5), -mp.one)
    found = []
    for spin, growth in zip(spins, growths, strict=True):
        linear = exactly(spin) * angle + growth * identity(mp, 2)
        found.append(tangent(mp, linear, exactly([1, 2])))
    return found


def _not_found_again(form: Any, velocity: Array) -> Number:
    return distance(form(mp, sam.exponential(mp, velocity)), velocity)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.abstract.convex",
        place="abstract, sections 1 and 5",
        statement="A^t exists as a real affinity for a convex set of orientation-preserving affinities A.",
        verdict=Verdict.BOUND,
        domain="the set of all L with L + Lᵀ positive definite, which is convex: these turn no direction by a right "
        "angle or more. Just beyond it, the mixture of two affinities that have A^t may have none",
        form=_has_root,
        cases=_upright,
        outside=_leaning,
        deviation=_is_bent,
        copies=(Copy("the affinities that have complex eigenvalues", _turns),),
        remark="What section 5.2 shows to be convex is a region of parameters, a turn by a after a stretch by s: not a "
        "set of affinities. In the space of matrices the affinities that have A^t are no convex set.",
    ),
    Claim(
        id="rossignac_vinacua.2.2.power",
        place="section 2.2, equations 1 and 2",
        statement="A^t = e^(t log A) is the power: its n-th power at t = k/n is A^k.",
        printed="A^t = e^(t log(A))",
        verdict=Verdict.CONFIRMED,
        form=_power,
        cases=_roots,
        deviation=_unlike_roots,
        copies=(
            Copy("the translation in a straight line", _straight),
            Copy("t² for t", lambda m, affinity, t: _power(m, affinity, t * t)),
        ),
        remark="The translation of A^t comes with it: steadiness settles the whole motion, not its linear part alone.",
    ),
    Claim(
        id="rossignac_vinacua.2.2.frame",
        place="section 2.2",
        statement="With A = C B^-1, the motion from B to C applies A_t in the frame of B.",
        printed="to each time t associate the affinity A_t ∘ B, thus applying A_t in the frame of B",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_in_frame_of_start,
        cases=_simple_pairs,
        deviation=unlike_steady,
        correction=Correction(
            statement="A_t B applies A_t in the frame in which B and C are written. In the frame of B the same motion "
            "is (B^-1 C)^t: (C B^-1)^t B = B (B^-1 C)^t.",
            form=_local,
        ),
        copies=(Copy("(B^-1 C)^t B", _other_order),),
        remark="The formula A_t ∘ B is right.",
    ),
    Claim(
        id="rossignac_vinacua.2.2.ends",
        place="section 2.2",
        statement="The steady affine morph (C B^-1)^t B starts at B and ends at C.",
        printed="A^t ∘ B with A = C ∘ B^-1",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=_simple_pairs,
        deviation=law("endpoints"),
        copies=(Copy("A = B^-1 C", _other_order),),
    ),
    Claim(
        id="rossignac_vinacua.2.2.many",
        place="sections 1 and 2.2",
        statement="B and C do not determine the motion: infinitely many affine motions lead from one to the other.",
        verdict=Verdict.CONFIRMED,
        form=(steady, morphs.linear, morphs.rarap, morphs.asap, morphs.log_spiral),
        cases=lambda: [*general_pairs(2), *general_pairs(3)],
        deviation=_coincide,
        copies=(Copy("B (B^-1 C)^t and (C B^-1)^t B", (steady, _local)),),
        remark="The mixtures of any two of them, weighted by a function of time, are such motions too.",
    ),
    Claim(
        id="rossignac_vinacua.2.2.unique",
        place="section 2.2, (3)",
        statement="A steady motion that interpolates two poses is unique: e^(tX) is the one that log e^X gives.",
        verdict=Verdict.BOUND,
        domain="steady motions that turn by less than half a turn; at half a turn there are two, and with more turns "
        "infinitely many",
        form=sam.log,
        cases=lambda: [each for angle in (1, mp.pi - mp.mpf(2) ** -30) for each in _spins(angle)],
        outside=lambda: [each for angle in (mp.pi + mp.mpf(2) ** -30, 5) for each in _spins(angle)],
        deviation=_not_found_again,
        copies=(Copy("the logarithm that turns the other way round", _turned),),
    ),
    Claim(
        id="rossignac_vinacua.2.2.no_closed_form",
        place="section 2.2",
        statement="As far as the authors know, there is no simple closed form of the logarithm of a homogeneous 4x4 "
        "matrix.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement about what the authors know",
        remark="Their own observation of section 4 gives one: log A = [[log L, -log(L) q], [0, 0]], q the fixed point; "
        "and log(L) (L - I)^-1 t for -log(L) q, continued to eigenvalues 1 of L, where there is none.",
    ),
)
