"""Section 3, theorem 3.2: every similarity has a logarithm."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import numbers
from affinecert.properties.claims.gallier.invertibility_of_v import NOTHING, blocks, turned
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, homogeneous, identity, tangent


def _logarithm(rotation: Array, half_turns: bool = True) -> Array:
    """A skew matrix with angles in (0, pi] whose exponential is a rotation of R^n.

    The eigenspaces of R + R^T are planes that are turned by one angle theta, where (R - R^T) / 2 is sin theta times a
    quarter turn; where R = -1, any quarter turn does, or none is made.
    """
    values, vectors = mp.eigsy(mp.matrix(((rotation + rotation.T) / 2).tolist()))
    columns, half = np.array(vectors.tolist(), dtype=object), (rotation - rotation.T) / 2
    omega: Array = identity(mp, len(rotation)) * 0
    opposite = []
    for value, column in zip(values, columns.T, strict=True):
        if value < -1 + NOTHING:
            opposite.append(column)
        elif value < 1 - NOTHING:
            theta = mp.acos(value)
            omega = omega + theta / mp.sin(theta) * np.outer(half @ column, column)
    if half_turns:
        for first, second in zip(opposite[::2], opposite[1::2], strict=True):
            omega = omega + mp.pi * (np.outer(second, first) - np.outer(first, second))
    return omega


def _by_one_angle(rotation: Array) -> Array:
    """The formula of space, theta / (2 sin theta) (R - R^T), theta by the trace less n - 3."""
    theta = mp.acos(min((rotation.trace() - len(rotation) + 2) / 2, mp.one))
    factor = theta / (2 * mp.sin(theta)) if theta else mp.zero
    omega: Array = factor * (rotation - rotation.T)
    return omega


def _turns() -> list[tuple[list[Number], int]]:
    """The angles of rotations, and n."""
    one, pi = mp.one, mp.pi
    return [
        ([], 1),
        ([pi], 2),
        ([one], 3),
        ([pi], 3),
        ([one, 2 * one], 4),
        ([pi, pi], 4),
        ([pi, one], 5),
        ([one, one], 5),
        ([4 * one], 3),
    ]


def _rotation(case: tuple[list[Number], int]) -> Array:
    angles, n = case
    return definitions.exponential(mp, turned(blocks(angles, n)))


def _no_logarithm(form: Any, case: tuple[list[Number], int]) -> Number:
    rotation = _rotation(case)
    omega = form(rotation)
    return difference(omega, -omega.T) + difference(definitions.exponential(mp, omega), rotation)


def _below_pi(case: tuple[list[Number], int]) -> bool:
    return all(abs(angle - mp.pi) > NOTHING for angle in case[0])


def _out_of_range(form: Any, case: tuple[list[Number], int]) -> int:
    """Whether a rotation has no logarithm with its angles in (0, most), the most given.

    An angle that is closest to 0 is the one in [0, pi]; so there is one below ``most`` only if this is.
    """
    rotation = _rotation(case)
    angles = [abs(mp.im(z)) for z in definitions.eigenvalues(mp, _logarithm(rotation))]
    return int(max(angles) > form - NOTHING)


def _similarities() -> list[tuple[Array]]:
    """Similarities of R^1 to R^5: without and with a turn, with and without growth."""
    scales = [mp.one, mp.mpf(2), mp.one, mp.mpf(3), mp.mpf(1) / 2, mp.one, mp.mpf(5), mp.one, mp.mpf(1) / 4]
    cases = list(zip(scales, _turns(), strict=True))
    cases += [(mp.mpf(2), ([], 1)), (mp.one, ([], 3)), (mp.mpf(3), ([], 3))]
    return [(homogeneous(mp, scale * _rotation(turn), exactly(list(range(1, turn[1] + 1)))),) for scale, turn in cases]


def _tangent(scale_itself: bool = False, forget_v: bool = False) -> Any:
    """The logarithm of the proof: lambda = log alpha, Omega of the rotation, and u = V^-1 w."""

    def printed(pose: Array) -> Array:
        linear, w = pose[:-1, :-1], pose[:-1, -1]
        n = len(w)
        alpha = mp.root(definitions.determinant(linear), n)
        growth = alpha - 1 if scale_itself else mp.log(alpha)
        gamma = growth * identity(mp, n) + _logarithm(linear / alpha)
        v = identity(mp, n) if forget_v else definitions.integral_of_exponential(mp, gamma)
        return tangent(mp, gamma, definitions.inverse(mp, v) @ w)

    return printed


def _misses(form: Any, case: tuple[Array]) -> Number:
    """How far the exponential is from the similarity, and the logarithm from sim(n)."""
    (pose,) = case
    found = form(pose)
    gamma = found[:-1, :-1]
    even = (gamma + gamma.T) / 2
    outside = difference(even, even[0, 0] * identity(mp, len(gamma)))
    return distance(definitions.exponential(mp, found), pose) + outside


def _case_1(sign: int) -> Any:
    """U = V^-1 w of R = I, w = (1, 2, 3)."""

    def printed(m: Context, alpha: Number) -> Array:
        growth = m.log(alpha)
        w = exactly([1, 2, 3], m)
        u: Array = w if not growth else w * growth / (m.exp(growth) + sign)
        return u

    return printed


def _true_case_1(m: Context, alpha: Number) -> Array:
    v = definitions.integral_of_exponential(m, m.log(alpha) * identity(m, 3))
    u: Array = definitions.inverse(m, v) @ exactly([1, 2, 3], m)
    return u


def _scales() -> list[tuple[Number]]:
    return [(mp.one,), (mp.mpf(2),), (mp.mpf(1) / 3,), *((each,) for each in numbers("alpha", 4, 0.25, 9))]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.3.2.rotations",
        place="theorem 3.2, proof, case 2 (also in section 2)",
        statement="The exponential from so(n) to SO(n) is surjective.",
        verdict=Verdict.CONFIRMED,
        form=_logarithm,
        cases=_turns,
        deviation=_no_logarithm,
        copies=(
            Copy("no logarithm where R is -1", lambda rotation: _logarithm(rotation, half_turns=False)),
            Copy("the formula for one angle", _by_one_angle),
        ),
    ),
    Claim(
        id="gallier.3.2.angles",
        place="theorem 3.2, proof, case 2",
        statement="A rotation has a logarithm all of whose angles are in (0, π), zeros aside.",
        printed="In fact, we may assume that 0 < θ_j < π",
        verdict=Verdict.BOUND,
        domain="-1 is no eigenvalue of R; otherwise 0 < θ_j ≤ π. A half turn has no logarithm below π",
        form=mp.pi,
        cases=lambda: [case for case in _turns() if _below_pi(case)],
        outside=lambda: [case for case in _turns() if not _below_pi(case)],
        deviation=_out_of_range,
        copies=(Copy("θ_j < π/2", mp.pi / 2),),
        remark="V is invertible at π as well, and the theorem holds.",
    ),
    Claim(
        id="gallier.3.2.case_1",
        place="theorem 3.2, proof, case 1",
        statement="For R = I, λ = log α, and V = ((e^λ - 1)/λ) I is inverted to u = V^-1 w; V = I for λ = 0.",
        printed="V = (1/λ)(e^λ - 1) I (V = I when λ = 0), u = V^{-1} w",
        verdict=Verdict.CONFIRMED,
        form=_case_1(-1),
        cases=_scales,
        deviation=equals(_true_case_1),
        copies=(Copy("e^λ + 1 for e^λ - 1", _case_1(1)),),
    ),
    Claim(
        id="gallier.3.2.surjective",
        place="theorem 3.2",
        statement="The exponential from sim(n) to SIM(n) is surjective for n ≥ 1: with λ = log α, e^Ω = R and "
        "u = V^-1 w, (λI + Ω, u; 0, 0) is a logarithm.",
        printed="e^λ e^Ω = αR, Vu = w",
        verdict=Verdict.CONFIRMED,
        form=_tangent(),
        cases=_similarities,
        deviation=_misses,
        copies=(
            Copy("λ = α - 1", _tangent(scale_itself=True)),
            Copy("u = w", _tangent(forget_v=True)),
        ),
    ),
)
