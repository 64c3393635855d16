"""Section 4: the interpolation of affine maps: equations 2 and 3, existence, Lemma 4."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims.bansal_tatu.samples import HALF_TURN, TIMES, at, embedded, maps, rigid_maps, scaling
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import difference, distance, mp, size
from affinecert.reference import affine_lie, morphs, sam, se3, shear
from affinecert.reference._matrices import Array, Number, identity

Path = Callable[[Array, Number], Array]
"""T_t of T and t."""


def powers(pose: Array, t: Number) -> tuple[Array, Array, Array]:
    """A^t, S^t and E^t of T = A S E, each (4, 4)."""
    rigid, matrix, scale = affine_lie.decompose(mp, pose)
    moving = se3.exp(mp, se3.log(mp, rigid) * t)
    return embedded(shear.exp(mp, shear.log(mp, matrix) * t)), scaling(scale[()] ** t), moving


def _by_factors(order: str) -> Path:
    """The product of the powers in an order."""

    def path(pose: Array, t: Number) -> Array:
        first, second, third = (powers(pose, t)["ASE".index(letter)] for letter in order)
        result: Array = first @ second @ third
        return result

    return path


def lie(pose: Array, t: Number) -> Array:
    """The proposed T_t."""
    return affine_lie.interpolate(mp, pose, at(t))


def morph(name: str) -> Path:
    """A morph of the comparison, from I to T."""
    return lambda pose, t: morphs.MORPHS[name](mp, identity(mp, 4), pose, at(t))


def sam_power(pose: Array, t: Number) -> Array:
    """T^t."""
    return sam.power(mp, pose, at(t))


def _off_ends(path: Path, pose: Array) -> Number:
    return max(difference(path(pose, mp.zero), identity(mp, 4)), distance(path(pose, mp.one), pose))


def _other_factors(powers: Any, pose: Array) -> Number:
    """How far E, A, s of T_t are from what the powers of those of T are said to be."""
    worst = mp.zero
    for t in TIMES:
        rigid, matrix, scale = affine_lie.decompose(mp, lie(pose, t))
        worst = max(worst, distance(powers(pose, t), (embedded(matrix), scaling(scale[()]), rigid)))
    return worst


def straight_shear(pose: Array, t: Number) -> tuple[Array, Array, Array]:
    """As `powers`, with (1 - t) I + t A for A^t."""
    _, scale_power, rigid_power = powers(pose, t)
    whole, _, _ = powers(pose, mp.one)
    return identity(mp, 4) * (1 - t) + whole * t, scale_power, rigid_power


def multiplied(factors: tuple[Array, Array, Array]) -> Array:
    """The product of three."""
    first, second, third = factors
    result: Array = first @ second @ third
    return result


def _missing(path: Path, pose: Array) -> Number:
    """1 where there is no path, else how far its ends are off."""
    try:
        return _off_ends(path, pose)
    except InputError:
        return mp.one


def _no_isometry(path: Path, pose: Array) -> Number:
    linears = [path(pose, t)[:3, :3] for t in TIMES]
    return max(size(linear.T @ linear - identity(mp, 3)) for linear in linears)


# An affine map that no steady motion leads to: a quarter turn after a shear against it.
UNSTEADY = affine([[0, -1, 0], [1, -4, 0], [0, 0, 1]], (1, 0, 0))

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.abstract.exists",
        place='abstract, and section 4 ("always exists")',
        statement="The interpolation exists for all affine maps, with T₀ = I and T₁ = T.",
        verdict=Verdict.BOUND,
        domain="affine maps that preserve orientation, det T > 0",
        form=lie,
        cases=lambda: [UNSTEADY, affine(HALF_TURN, (1, 0, 0)), *maps()],
        outside=lambda: [affine([[1, 0, 0], [0, -1, 0], [0, 0, 1]]), affine([[1, 0, 0], [0, 1, 0], [0, 0, 0]])],
        deviation=_missing,
        copies=(Copy("the steady affine morph", sam_power),),
    ),
    Claim(
        id="bansal_tatu.4.equation_2",
        place="section 4, equation 2",
        statement="T_t = exp(t log A) exp(t log S) exp(t log E) leads from I at t = 0 to T = A S E at t = 1.",
        printed="T_t = exp(t log A) exp(t log S) exp(t log E)",
        verdict=Verdict.CONFIRMED,
        form=_by_factors("ASE"),
        cases=maps,
        deviation=_off_ends,
        copies=(Copy("E S A", _by_factors("ESA")), Copy("A E S", _by_factors("AES"))),
    ),
    Claim(
        id="bansal_tatu.4.equation_3",
        place="section 4, equation 3",
        statement="T_t is represented by exp(t log p), that is by E^t, A^t and s^t.",
        printed="p(t) = exp(t log p)",
        verdict=Verdict.CONFIRMED,
        form=powers,
        cases=maps,
        deviation=_other_factors,
        copies=(Copy("(1 - t) I + t A for A^t", straight_shear),),
    ),
    Claim(
        id="bansal_tatu.lemma_4",
        place="section 4, Lemma 4",
        statement="If T is an isometry, so is every T_t.",
        printed="‖T(x - y)‖ = ‖x - y‖",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=rigid_maps,
        deviation=_no_isometry,
        copies=(Copy("entries in straight lines", morph("linear")),),
        remark="Isometries that preserve orientation, that is.",
    ),
)
