"""Section 3: the polar decomposition, and the homotopies A^L, A^P and A^E from the identity to a linear map."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import numbers, plane_rotation
from affinecert.properties.claims.kaji_2d.plane import IDENTITY, J, angle, built, determinant, growths, maps
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp, size
from affinecert.reference._matrices import Array, Context, Number, array

Factors = tuple[Array, Array]


def turned(m: Context, theta: Number) -> Array:
    """R_θ, over a context."""
    cosine, sine = m.cos(theta), m.sin(theta)
    return array([[cosine, -sine], [sine, cosine]])


def power(m: Context, stretch: Array, t: Number) -> Array:
    """S^t by the eigenvalues and eigenvectors of S."""
    values, vectors = m.eigsy(m.matrix(stretch.tolist()))
    basis = array(vectors.tolist())
    raised: Array = basis @ array([[values[0] ** t, m.zero], [m.zero, values[1] ** t]]) @ basis.T
    return raised


def decomposition(a: Array) -> Factors:
    """R_θ and S of A = R_θ S."""
    rotation = plane_rotation(angle(a))
    return rotation, rotation.T @ a


def linear(a: Array, t: Number) -> Array:
    """A^L as printed."""
    mixed: Array = (1 - t) * IDENTITY + t * a
    return mixed


def polar(a: Array, t: Number, turns: int = 0) -> Array:
    """A^P as printed, equation 2, θ and so many half turns."""
    _, stretch = decomposition(a)
    moved: Array = plane_rotation(t * (angle(a) + turns * mp.pi)) @ linear(stretch, t)
    return moved


def exponential(a: Array, t: Number, turns: int = 0) -> Array:
    """A^E as printed, equation 3, θ and so many half turns."""
    _, stretch = decomposition(a)
    moved: Array = plane_rotation(t * (angle(a) + turns * mp.pi)) @ power(mp, stretch, t)
    return moved


def _stretched_last(a: Array, t: Number) -> Array:
    """S^t R_θ^t with the S of A = R_θ S."""
    rotation, stretch = decomposition(a)
    moved: Array = power(mp, stretch, t) @ plane_rotation(t * angle(rotation))
    return moved


def _mixed_last(a: Array, t: Number) -> Array:
    rotation, stretch = decomposition(a)
    moved: Array = linear(stretch, t) @ plane_rotation(t * angle(rotation))
    return moved


def _ends(homotopy: Any, a: Array) -> Number:
    """How far the homotopy is from I at 0, and from A at 1."""
    return max(distance(homotopy(a, mp.zero), IDENTITY), distance(homotopy(a, mp.one), a))


def _no_polar_factors(factors: Any, a: Array) -> Number:
    """How far two matrices are from a rotation and a positive definite symmetric one with the product A."""
    rotation, stretch = factors(a)
    indefinite = stretch[0, 0] <= 0 or determinant(stretch) <= 0 or determinant(rotation) <= 0
    gaps = distance(rotation @ stretch, a), difference(rotation.T @ rotation, IDENTITY), difference(stretch, stretch.T)
    return max(*gaps, mp.mpf(indefinite))


def _triangular(a: Array) -> Factors:
    """The factors Q R."""
    column = a[:, 0] / mp.norm(a[:, 0].tolist())
    rotation = array([column, J @ column]).T
    return rotation, rotation.T @ a


def _other_order(a: Array) -> Factors:
    rotation, stretch = decomposition(a)
    return rotation, rotation @ stretch @ rotation.T


def _collapses(homotopy: Any, case: tuple[Array, Number]) -> Number:
    return size(homotopy(*case))


def _turns_between(turns: int) -> Any:
    """The homotopy A^E with θ + π turns, relative to that with θ: the ends, and the turn between them."""
    return lambda a, t: exponential(a, t, turns) @ definitions.inverse(mp, exponential(a, t))


def _not_modulo(relative: Any, case: tuple[Array, Number]) -> Number:
    """How far another choice of θ is from homotopies with the same ends, turned by 2 π k t between, k not 0."""
    a, t = case
    ends = max(difference(relative(a, mp.mpf(end)), IDENTITY) for end in (0, 1))
    between = min(difference(relative(a, t), plane_rotation(2 * mp.pi * k * t)) for k in (-2, -1, 1, 2))
    return max(ends, between)


def _maps_and_times() -> list[tuple[Array, Number]]:
    drawn = maps("choice", 4)
    return list(zip(drawn, [mp.mpf(1) / 2, mp.mpf(1) / 3, *numbers("choice", len(drawn), 0.125, 0.875)], strict=False))


def _factors_and_times() -> list[tuple[Number, Array, Number]]:
    """An angle, log S and a time: near a turn by π, and at times outside of [0, 1], too."""
    stretches = [exactly([[0, 0], [0, 1]]), exactly([[0, 1], [1, 0]]), exactly([[0, 0], [0, 0]]), *growths("log S", 5)]
    angles = [mp.pi / 2, mp.mpf(1), mp.pi, -mp.mpf(31) / 10, *numbers("angle", 4, -3, 3)]
    times = [mp.mpf(each) for each in (0.5, 0.25, 0.5, 1.375, -2, 3, *numbers("time", 2, 0, 1))]
    return list(zip(angles, stretches, times, strict=True))


def _product_of_exponentials(m: Context, theta: Number, growth: Array, t: Number) -> Array:
    """exp(t θ J) exp(t log S), by series."""
    product: Array = definitions.exponential(m, t * theta * J) @ definitions.exponential(m, t * growth)
    return product


def _of_map(homotopy: Any) -> Any:
    return lambda m, theta, growth, t: homotopy(built(theta, growth), t)


def _rotation_power(m: Context, theta: Number, p: int, q: int) -> Array:
    """The p-th power of the q-th root of R_θ that turns by the least angle."""
    root = definitions.exponential(m, theta * J / q)
    product: Array = IDENTITY * m.one
    for _ in range(p):
        product = product @ root
    return product


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.3.linear_homotopy",
        place="section 3, linear homotopy",
        statement="A^L is a homotopy of A: the identity at 0 and A at 1.",
        printed="A^L(t) = (1 - t) I + t A",
        verdict=Verdict.CONFIRMED,
        form=linear,
        cases=lambda: maps("ends", 4),
        deviation=_ends,
        copies=(Copy("Aᵀ for A", lambda a, t: linear(a.T, t)),),
    ),
    Claim(
        id="kaji_2d.3.linear_collapse",
        place="section 3, after the linear homotopy",
        statement="A^L of the half turn collapses at t = 0.5 to a point.",
        printed="when A = -I then A(0.5) = 0",
        verdict=Verdict.CONFIRMED,
        form=linear,
        cases=lambda: [(-IDENTITY * mp.one, mp.mpf(0.5))],
        deviation=_collapses,
        copies=(Copy("A^P for A^L", polar), Copy("A^E for A^L", exponential)),
        remark="A^L(t) is singular where 1 - 1/t is an eigenvalue of A: for t in (0, 1) if one is negative.",
    ),
    Claim(
        id="kaji_2d.3.polar_decomposition",
        place="section 3, before equation 2",
        statement="Each A of positive determinant is R_θ S, with a rotation and a positive definite symmetric matrix.",
        printed="A = R_θ S, θ ∈ (-π, π]",
        verdict=Verdict.CONFIRMED,
        form=decomposition,
        cases=lambda: maps("polar", 6),
        deviation=_no_polar_factors,
        copies=(
            Copy("the S of A = S R_θ", _other_order),
            Copy("-R_θ and -S", lambda a: (-decomposition(a)[0], -decomposition(a)[1])),
            Copy("the triangular factor of A = Q R", _triangular),
        ),
        remark="In the plane no eigenvalue is needed: θ = atan2(a₂₁ - a₁₂, a₁₁ + a₂₂) and S = R_θᵀ A.",
    ),
    Claim(
        id="kaji_2d.3.choice_of_angle",
        place="section 3, before equation 2",
        statement="θ is determined modulo 2π only: any choice gives a homotopy with the same ends, but another one.",
        printed="θ has choice up to modulo 2π, which may cause a problem",
        verdict=Verdict.CONFIRMED,
        form=_turns_between(2),
        cases=_maps_and_times,
        deviation=_not_modulo,
        copies=(
            Copy("π for 2π", _turns_between(1)),
            Copy("no turn added", _turns_between(0)),
        ),
        remark="At t = 1/2 a turn by 2π more changes the sign. Neighbours with θ on both sides of π part that far.",
    ),
    Claim(
        id="kaji_2d.equation_2.ends",
        place="equation 2",
        statement="A^P is a homotopy of A: the identity at 0 and A at 1.",
        printed="A^P(t) = R_(tθ) ((1 - t) I + t S)",
        verdict=Verdict.CONFIRMED,
        form=polar,
        cases=lambda: maps("ends", 4),
        deviation=_ends,
        copies=(Copy("the factors in the other order", _mixed_last), Copy("θ + π for θ", lambda a, t: polar(a, t, 1))),
    ),
    Claim(
        id="kaji_2d.equation_3.ends",
        place="equation 3",
        statement="A^E is a homotopy of A: the identity at 0 and A at 1.",
        printed="A^E(t) = R_θ^t S^t",
        verdict=Verdict.CONFIRMED,
        form=exponential,
        cases=lambda: maps("ends", 4),
        deviation=_ends,
        copies=(
            Copy("the factors in the other order", _stretched_last),
            Copy("θ + π for θ", lambda a, t: exponential(a, t, 1)),
        ),
    ),
    Claim(
        id="kaji_2d.equation_3.exponentials",
        place="equation 3 and below",
        statement="A^E(t) is the product of the exponentials of t log R_θ and t log S.",
        printed="R_θ^t = R_(tθ), S^t = exp(t log S)",
        verdict=Verdict.CONFIRMED,
        form=_of_map(exponential),
        cases=_factors_and_times,
        deviation=equals(_product_of_exponentials),
        copies=(
            Copy("the factors in the other order", _of_map(_stretched_last)),
            Copy("A^P for A^E", _of_map(polar)),
        ),
        remark="It is exp(t log A) only if R_θ and S commute. At θ = π, A^E jumps: to the other side just beyond.",
    ),
    Claim(
        id="kaji_2d.equation_3.rotation_power",
        place="after equation 3",
        statement="The power t of the rotation R_θ is the rotation by t θ.",
        printed="R_θ^t is nothing but R_(tθ)",
        verdict=Verdict.CONFIRMED,
        form=lambda m, theta, p, q: turned(m, theta * p / q),
        cases=lambda: [
            (mp.pi / 2, 1, 2),
            (mp.pi, 1, 2),
            (mp.mpf(1), 7, 3),
            (-mp.mpf(3), 5, 7),
            (mp.mpf(1) / 16, 9, 1),
        ],
        deviation=equals(_rotation_power),
        copies=(
            Copy("-t θ for t θ", lambda m, theta, p, q: turned(m, -theta * p / q)),
            Copy("θ + 2π for θ", lambda m, theta, p, q: turned(m, (theta + 2 * m.pi) * p / q)),
        ),
    ),
)
"""The homotopies."""
