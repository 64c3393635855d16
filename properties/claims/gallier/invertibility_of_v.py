"""Section 3, to proposition 3.1: the eigenvalues of V, and when one of them is zero."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.gallier.similarities import skew
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.reference._matrices import Array, Number, identity

NOTHING = mp.mpf(10) ** -30
"""What is smaller than that is zero: eigenvalues that coincide have half the digits."""


def blocks(angles: Sequence[Number], n: int) -> Array:
    """The skew matrix of R^n with eigenvalues +-i theta for these angles, and zeros."""
    matrix: Array = identity(mp, n) * 0
    for k, angle in enumerate(angles):
        matrix[2 * k, 2 * k + 1], matrix[2 * k + 1, 2 * k] = -angle, angle
    return matrix


def turned(matrix: Array) -> Array:
    """A matrix in other axes: the reflection Q in the plane across (1, 2, 3, ...) makes Q A Q."""
    normal = exactly(list(range(1, len(matrix) + 1)))
    reflection = identity(mp, len(matrix)) - 2 * np.outer(normal, normal) / (normal @ normal)
    image: Array = reflection @ matrix @ reflection
    return image


def _phi(z: Number) -> Number:
    """The sum of z^k / (k + 1)!."""
    return definitions.integral_of_exponential(mp, exactly([[z]]))[0, 0]


def _matrices() -> list[Array]:
    simple = [exactly([[1, 2], [0, 3]]), exactly([[0, -1], [1, 0]])]
    return simple + [each / 4 for n in (2, 3, 4) for each in arrays(f"any {n}", 1, (n, n), -4, 4)]


def _entry(shift: int) -> Any:
    """1 + the sum of z^k / (k + shift)!, for an eigenvalue z."""

    def printed(z: Number) -> Number:
        total = term = mp.one
        for k in range(1, 100):
            term = term * z / (k + shift)
            total = total + term
        return total

    return printed


def _schur_misses(form: Any, gamma: Array) -> Number:
    """How far V is from U V(T) U*, Gamma = U T U*, and the diagonal of V(T) from what the form has."""
    unitary, upper = (np.array(each.tolist(), dtype=object) for each in mp.schur(mp.matrix(gamma.tolist()) * mp.mpc(1)))
    inner = definitions.integral_of_exponential(mp, upper)
    back = unitary @ inner @ np.conjugate(unitary).T
    diagonal = exactly([form(z) for z in np.diag(upper)])
    due = definitions.integral_of_exponential(mp, gamma)
    return max(distance(back, due), distance(np.diag(inner), diagonal))


def _apart(found: Sequence[Number], due: Sequence[Number]) -> Number:
    """How far two sets of numbers are apart, each number from the nearest one of the other set."""
    ways = [(found, due), (due, found)]
    return max(max(min(abs(a - b) for b in others) for a in some) for some, others in ways)


def _of_eigenvalue(sign: int) -> Any:
    """(e^z - 1) / z, and 1 for z = 0."""

    def printed(z: Number) -> Number:
        return mp.one if abs(z) < NOTHING else (mp.exp(z) + sign) / z

    return printed


def _eigenvalues_miss(form: Any, gamma: Array) -> Number:
    v = definitions.integral_of_exponential(mp, gamma)
    due = definitions.eigenvalues(mp, v)
    return _apart([form(z) for z in definitions.eigenvalues(mp, gamma)], due) / max(map(abs, due))


def _roots(step: int) -> Any:
    """Whether z is a multiple, other than 0, of i pi times the step."""

    def printed(z: Number) -> bool:
        turns = mp.im(z) / (step * mp.pi)
        return bool(mp.re(z) == 0 and z != 0 and abs(turns - mp.nint(turns)) < NOTHING)

    return printed


def _numbers() -> list[Number]:
    """Complex numbers about the zeros of e^z - 1."""
    whole = [mp.mpc(x, 2 * mp.pi * k) for x in (0, 1, -1) for k in (0, 1, -1, 2, -3)]
    between = [mp.mpc(0, mp.pi * k) for k in (1, -1, 3)] + [mp.mpc(0, k) for k in (1, 6, -7)]
    return [z for z in whole + between if z]


def _zero_misses(form: Any, z: Number) -> int:
    return int(form(z) != (abs(mp.exp(z) - 1) < NOTHING))


def _skew_matrices() -> list[Array]:
    simple = [exactly([[0]]), exactly([[0, -1], [1, 0]])]
    return simple + [skew(arrays(f"skew {n}", 1, (n * (n - 1) // 2,), -2, 2)[0], n) for n in (2, 3, 4, 5)]


def _not_imaginary(form: Any, omega: Array) -> Number:
    """How far eigenvalues are from pairs +-i theta and zeros; the form adds what it likes to the matrix."""
    found = definitions.eigenvalues(mp, form(omega))
    return max(size([mp.re(z) for z in found]), _apart(found, [-z for z in found]))


def _with_symmetric(part: str) -> Any:
    def printed(omega: Array) -> Array:
        changed = omega.copy()
        if part:
            changed[0, 0] += mp.mpf(part)
        return changed

    return printed


def _of_gamma(with_middle: bool, opposite: bool = True) -> Any:
    """lambda, if so said, and lambda +- i theta_j."""

    def printed(growth: Number, angles: Sequence[Number]) -> list[Number]:
        pairs = [growth + mp.mpc(0, sign * angle) for angle in angles for sign in ((1, -1) if opposite else (1,))]
        return [growth, *pairs] if with_middle else pairs

    return printed


def _gamma_misses(form: Any, case: tuple[Number, Sequence[Number], int]) -> Number:
    growth, angles, n = case
    gamma = growth * identity(mp, n) + turned(blocks(angles, n))
    return _apart(form(growth, angles), definitions.eigenvalues(mp, gamma))


def _spectra() -> list[tuple[Number, list[Number], int]]:
    """lambda, the theta_j and n, Omega singular."""
    two = mp.mpf(2)
    return [(two, [], 1), (two, [], 2), (two, [mp.one], 3), (-two, [mp.one, two], 5), (two, [two], 4)]


def _regular_spectra() -> list[tuple[Number, list[Number], int]]:
    """The same, Omega invertible."""
    return [(mp.zero, [mp.one], 2), (mp.mpf(2), [mp.one, mp.mpf(3)], 4)]


def _rates() -> list[tuple[Number, list[Number], int]]:
    """lambda, the theta_j and n, on and off the places where V is singular."""
    turn = 2 * mp.pi
    zero, one = mp.zero, mp.one
    return [
        (zero, [], 3),
        (zero, [turn], 2),
        (one, [turn], 3),
        (zero, [mp.pi], 3),
        (zero, [3 * turn], 3),
        (zero, [one, 2 * turn], 4),
        (-one, [turn, 2 * turn], 5),
        (zero, [one, mp.pi], 5),
        (zero, [turn - mp.mpf(10) ** -6], 3),
    ]


def _whole(angle: Number, turn: Number) -> bool:
    return bool(abs(angle / turn - mp.nint(angle / turn)) < NOTHING)


def _determinant(case: tuple[Number, Sequence[Number], int]) -> Number:
    growth, angles, n = case
    gamma = growth * identity(mp, n) + turned(blocks(angles, n))
    return abs(definitions.determinant(definitions.integral_of_exponential(mp, gamma)))


def _singular(turn: int = 2, every: bool = False, growth_too: bool = True) -> Any:
    """Whether V has the eigenvalue 0, as printed; copies have half turns, all angles for some, or no lambda."""

    def printed(growth: Number, angles: Sequence[Number]) -> bool:
        wholes = [_whole(angle, turn * mp.pi) for angle in angles]
        some = bool(wholes) and all(wholes) if every else any(wholes)
        return some and (growth == 0 or not growth_too)

    return printed


def _singular_misses(form: Any, case: tuple[Number, Sequence[Number], int]) -> int:
    return int(form(case[0], case[1]) != (_determinant(case) < NOTHING))


def _invertible(every: bool) -> Any:
    """Lambda is not zero, or all (some) angles are no multiples of 2 pi."""

    def printed(growth: Number, angles: Sequence[Number]) -> bool:
        apart = [not _whole(angle, 2 * mp.pi) for angle in angles]
        return growth != 0 or (all(apart) if every else any(apart) or not apart)

    return printed


def _invertible_misses(form: Any, case: tuple[Number, Sequence[Number], int]) -> int:
    return int(form(case[0], case[1]) and _determinant(case) < NOTHING)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.3.schur",
        place="section 3, by Schur's decomposition",
        statement="With Γ = UTU*, U unitary and T upper triangular, V = U (I + Σ T^k/(k+1)!) U*, and on the diagonal "
        "of what is in brackets is 1 + Σ z^k/(k+1)! for the eigenvalues z of Γ.",
        printed="V = U (I + Σ_{k≥1} T^k/(k+1)!) U*; 1 + Σ_{k≥1} z^k/(k+1)!",
        verdict=Verdict.CONFIRMED,
        form=_entry(1),
        cases=_matrices,
        deviation=_schur_misses,
        copies=(Copy("z^k/k!", _entry(0)),),
    ),
    Claim(
        id="gallier.3.eigenvalues_of_V",
        place="section 3",
        statement="The eigenvalues of V are (e^z - 1)/z for the eigenvalues z ≠ 0 of Γ, and 1 for z = 0.",
        printed="(e^z - 1)/z = 1 + Σ_{k≥1} z^k/(k+1)!",
        verdict=Verdict.CONFIRMED,
        form=_of_eigenvalue(-1),
        cases=lambda: [*_matrices(), blocks([mp.one], 3)],
        deviation=_eigenvalues_miss,
        copies=(Copy("e^z + 1 for e^z - 1", _of_eigenvalue(1)),),
    ),
    Claim(
        id="gallier.3.zeros",
        place="section 3",
        statement="(e^z - 1)/z, z ≠ 0, is zero iff z = 2πik with an integer k ≠ 0.",
        printed="e^z = 1 iff z = ik2π, k ∈ Z - {0}",
        verdict=Verdict.CONFIRMED,
        form=_roots(2),
        cases=_numbers,
        deviation=_zero_misses,
        copies=(Copy("kπ for k2π", _roots(1)), Copy("4kπ for k2π", _roots(4))),
    ),
    Claim(
        id="gallier.3.skew_eigenvalues",
        place="section 3",
        statement="The eigenvalues of a real skew matrix are 0 or pairs ±iθ_j.",
        verdict=Verdict.CONFIRMED,
        form=_with_symmetric(""),
        cases=_skew_matrices,
        deviation=_not_imaginary,
        copies=(Copy("1/1000 on the diagonal", _with_symmetric("0.001")),),
    ),
    Claim(
        id="gallier.3.eigenvalues_of_gamma",
        place="section 3, before Proposition 3.1",
        statement="The eigenvalues of λI + Ω are λ and λ ± iθ_j, ±iθ_j the nonzero ones of Ω.",
        printed="the eigenvalues of Γ are λ and λ ± iθ_j, for j = 1, ..., m",
        verdict=Verdict.BOUND,
        domain="Ω singular, as it is for odd n, 3 for one; an invertible Ω (n = 2m) leaves λ out",
        form=_of_gamma(with_middle=True),
        cases=_spectra,
        outside=_regular_spectra,
        deviation=_gamma_misses,
        copies=(Copy("λ + iθ_j only", _of_gamma(with_middle=True, opposite=False)),),
        remark="Nothing depends on it: λ alone makes no eigenvalue of V zero.",
    ),
    Claim(
        id="gallier.3.singular",
        place="section 3, before Proposition 3.1",
        statement="V has the eigenvalue 0 iff λ = 0 and some θ_j is a multiple of 2π (other than 0).",
        printed="λ = 0 and θ_j = k2π for some j, with k ∈ Z - {0}",
        verdict=Verdict.CONFIRMED,
        form=_singular(),
        cases=_rates,
        deviation=_singular_misses,
        copies=(
            Copy("multiples of π", _singular(turn=1)),
            Copy("all θ_j for some θ_j", _singular(every=True)),
            Copy("whatever λ is", _singular(growth_too=False)),
        ),
    ),
    Claim(
        id="gallier.3.1.invertible",
        place="Proposition 3.1",
        statement="V is invertible if λ ≠ 0, or no θ_j is a multiple of 2π other than 0.",
        printed="V is invertible if either λ ≠ 0, or for j = 1, ..., m, we have θ_j ≠ k2π for all k ∈ Z - {0}",
        verdict=Verdict.CONFIRMED,
        form=_invertible(every=True),
        cases=_rates,
        deviation=_invertible_misses,
        copies=(Copy("some θ_j for all θ_j", _invertible(every=False)),),
        remark="Next to such places V is invertible, and as badly conditioned as one likes.",
    ),
)
