"""Section 4: the interpolation of maps and of tetrahedra, where it exists, and what it keeps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    HALF_TURN,
    REGULAR,
    TIMES,
    affine,
    at,
    between,
    embedded,
    inverse,
    maps,
    moved,
    rigid_maps,
    scaling,
    tetrahedron_pairs,
)
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.reference import affine_lie, morphs, sam, se3, shear
from affinecert.reference._matrices import Array, Number, identity

Path = Callable[[Array, Number], Array]
"""T_t of T and t."""
Between = Callable[[Array, Array, Number], Array]
"""The tetrahedron at t between two."""


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


def _in_group(order: str = "pq") -> Between:
    """Equation 4 with the group's products: vertices E^-1 S^-1 A^-1 of the canonical ones."""

    def tetrahedron(source: Array, target: Array, t: Number) -> Array:
        p, q = (_represented(each) for each in (source, target))
        found = []
        for one, other, power in zip(p, q, (_rigid_power, _shear_power, _scale_power), strict=True):
            step = inverse(one) @ other if order == "pq" else other @ inverse(one)
            found.append(one @ power(step, t))
        rigid, matrix, scale = found
        return moved(inverse(matrix @ scale @ rigid), CANONICAL)

    return tetrahedron


def _represented(tetrahedron: Array) -> tuple[Array, Array, Array]:
    rigid, matrix, scale = affine_lie.represent(mp, tetrahedron, CANONICAL)
    return rigid, embedded(matrix), scaling(scale[()])


def _rigid_power(pose: Array, t: Number) -> Array:
    return se3.exp(mp, se3.log(mp, pose) * t)


def _shear_power(pose: Array, t: Number) -> Array:
    upper = pose[:3, :3].copy()
    upper[:, 0], upper[2, 1] = exactly([1, 0, 0]), mp.zero
    return embedded(shear.exp(mp, shear.log(mp, upper) * t))


def _scale_power(pose: Array, t: Number) -> Array:
    return scaling(pose[0, 0] ** t)


def _off_tetrahedra(path: Between, pair: tuple[Array, Array]) -> Number:
    """How far the ends are from the two tetrahedra, and the path between them from the interpolant."""
    source, target = pair
    ends = max(distance(path(source, target, mp.zero), source), distance(path(source, target, mp.one), target))
    t = TIMES[0]
    return max(ends, distance(path(source, target, t), _tetrahedron(source, target, t)))


def _tetrahedron(source: Array, target: Array, t: Number) -> Array:
    return affine_lie.interpolate_tetrahedra(mp, source, target, at(t))


def _unlike_equation_2(image: Callable[[Array], Array], pose: Array) -> Number:
    """How far the tetrahedron between Δ and that of T is from that of T_t."""
    t = TIMES[0]
    return distance(_tetrahedron(CANONICAL, image(pose), t), image(lie(pose, t)))


def _missing(path: Path, pose: Array) -> Number:
    """1 where there is no path, else how far its ends are off."""
    try:
        return _off_ends(path, pose)
    except InputError:
        return mp.one


def _no_isometry(path: Path, pose: Array) -> Number:
    linears = [path(pose, t)[:3, :3] for t in TIMES]
    return max(size(linear.T @ linear - identity(mp, 3)) for linear in linears)


def _irreversible(path: Between, pair: tuple[Array, Array]) -> Number:
    source, target = pair
    t = TIMES[0]
    return distance(path(source, target, t), path(target, source, 1 - t))


def _by_map(source: Array, target: Array, t: Number) -> Array:
    """The source moved by T_t of equation 2, T being the affine map to the target."""
    return moved(lie(between(source, target), t), source)


def _turned_pairs() -> list[tuple[Array, Array]]:
    """Tetrahedra that are turned by up to 0.9 pi, and others."""
    turned = [(REGULAR, moved(pose, REGULAR)) for pose in rigid_maps()]
    return turned + tetrahedron_pairs()[:4]


def _half_turned() -> list[tuple[Array, Array]]:
    return [(each, moved(affine(HALF_TURN), each)) for each in (CANONICAL, REGULAR)]


# An affine map that no steady motion leads to: a quarter turn after a shear against it.
UNSTEADY = affine([[0, -1, 0], [1, -4, 0], [0, 0, 1]], (1, 0, 0))

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.0.exists",
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
        id="bansal_tatu.4.equation_4",
        place="section 4, equation 4",
        statement="The tetrahedra represented by p exp(t log p⁻¹q) lead from Δ_p to Δ_q.",
        printed="p exp(t log p⁻¹q), t ∈ [0, 1]",
        verdict=Verdict.CONFIRMED,
        form=_in_group(),
        cases=tetrahedron_pairs,
        deviation=_off_tetrahedra,
        copies=(Copy("q p⁻¹ for p⁻¹q", _in_group("qp")),),
    ),
    Claim(
        id="bansal_tatu.4.equations_2_and_4",
        place="sections 3.3 and 4",
        statement="Equation 2 is equation 4 from Δ to T⁻¹Δ: at t there is T_t⁻¹Δ.",
        verdict=Verdict.CONFIRMED,
        form=lambda pose: moved(inverse(pose), CANONICAL),
        cases=maps,
        deviation=_unlike_equation_2,
        copies=(Copy("TΔ for T⁻¹Δ", lambda pose: moved(pose, CANONICAL)),),
        remark="From Δ to TΔ the two equations lead along different paths: T_tΔ is not the tetrahedron of equation 4.",
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
    Claim(
        id="bansal_tatu.lemma_5",
        place="section 4, Lemma 5",
        statement="The interpolation from Δ_q to Δ_p at 1 - t is that from Δ_p to Δ_q at t.",
        printed="Δ_p^q(t) = Δ_q^p(1 - t)",
        verdict=Verdict.BOUND,
        domain="rotations E_p⁻¹E_q by less than π; at π the logarithms of both ways are the same, not opposite",
        form=_tetrahedron,
        cases=_turned_pairs,
        outside=_half_turned,
        deviation=_irreversible,
        copies=(Copy("T_t of equation 2 applied to Δ_p, T the affine map to Δ_q", _by_map),),
    ),
)
