"""Sections 4.1 and 4.2: exponential and logarithm of rotations."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, identity, norm

TINY = [[0, -1e-9, 1e-9], [1e-9, 0, 0], [-1e-9, 0, 0]]
"""A skew matrix of angle 1.4e-9: 1 - cos of it is 0 in float64, where it is 1e-18."""


NEAR_HALF_TURN = [[1.0, 0.0, 0.0], [0.0, -1.0, -1e-8], [0.0, 1e-8, -1.0]]
"""The turn by pi - 1e-8 about x, rounded."""


def _theta(m: Context, x: Array) -> Number:
    return m.sqrt((x.T @ x).trace() / 2)


def _sinc(m: Context, x: Number) -> Number:
    return m.sin(x) / x if x else m.one


def _rodrigues(sign: int = -1) -> Any:
    def printed(m: Context, x: Array) -> Array:
        theta = _theta(m, x)
        second = (1 + sign * m.cos(theta)) / theta**2
        rotation: Array = identity(m, 3) + m.sin(theta) / theta * x + second * (x @ x)
        return rotation

    return printed


def _rodrigues_sinc(part: int = 2) -> Any:
    def printed(m: Context, x: Array) -> Array:
        theta = _theta(m, x)
        second = _sinc(m, theta / part) ** 2 / 2
        rotation: Array = identity(m, 3) + _sinc(m, theta) * x + second * (x @ x)
        return rotation

    return printed


def _skew_matrices() -> list[tuple[Array]]:
    vectors = [exactly(each) for each in ([1, 0, 0], [1, 2, 2], [0, 7, -1])] + arrays("skew", 5, (3,), -3, 3)
    return [(cross_matrix(mp, each),) for each in vectors]


def _approximation(divisor: int) -> Any:
    return lambda theta: 1 - theta**2 / divisor


def _beyond_fourth_order(approximation: Any, theta: Number) -> Number:
    """How far the error of an approximation of sinc is beyond theta^4 / 120, in parts of that."""
    return max(abs(approximation(theta) - mp.sin(theta) / theta) * 120 / theta**4 - 1, mp.zero)


def _logarithm(factor: int = 2) -> Any:
    def printed(m: Context, rotation: Array) -> Array:
        theta = m.acos((rotation.trace() - 1) / 2)
        x: Array = (rotation - rotation.T) / (factor * _sinc(m, theta))
        return x

    return printed


def _principal(m: Context, rotation: Array) -> Array:
    return cross_matrix(m, so3.log(m, rotation))


def _turns() -> list[tuple[Array]]:
    return [(identity(mp, 3),), *((each,) for each in rotations("turns", 7))]


def _half_turns() -> list[tuple[Array]]:
    axes = exactly([[1, 0, 0], [2, 1, 2]])
    return [(axis[:, None] * axis[None, :] * 2 / (axis @ axis) - identity(mp, 3),) for axis in axes]


def _along_eigenvector(m: Context, rotation: Array, sign: int, slip: int = 1) -> Array:
    """The angle times the matrix of the unit eigenvector of eigenvalue 1 that is given by ``sign``."""
    theta, axis = m.acos((rotation.trace() - 1) / 2), so3.log(m, rotation)
    x: Array = cross_matrix(m, axis / norm(m, axis) * sign) * (theta * slip)
    return x


def _not_a_logarithm(form: Any, case: tuple[Array, int]) -> Number:
    rotation, sign = case
    return difference(definitions.exponential(mp, form(mp, rotation, sign)), rotation)


def _signed(*signs: int) -> list[tuple[Array, int]]:
    return [(rotation, sign) for (rotation,) in _turns()[1:5] for sign in signs]


def _squares(plus: int) -> Any:
    """The squares of the parameters, read off the diagonal of equation 4."""

    def squares(m: Context, omega: Array) -> Array:
        rotation, theta = so3.exp(m, omega), norm(m, omega)
        diagonal = array([rotation[k, k] for k in range(3)])
        found: Array = theta**2 * (diagonal - m.cos(theta)) / (1 - plus * m.cos(theta))
        return found

    return squares


def _vectors() -> list[tuple[Array]]:
    return [(exactly(each),) for each in ([1, 0, 0], [0, 1, 3])] + [
        (each,) for each in arrays("axes", 4, (3,), -1.5, 1.5)
    ]


def _read_off(form: Any, case: tuple[Array, Array]) -> int:
    """Whether what is read off the diagonal of a rotation is not its rotation vector."""
    omega, _ = case
    return int(difference(form(mp, omega), omega) > 1e-30)


def _symmetric_part(matrix: Array) -> Number:
    return matrix[1, 2] + matrix[2, 1]


def _trace_angle(m: Context, rotation: list[list[float]]) -> Number:
    return m.acos((m.fsum(rotation[k][k] for k in range(3)) - 1) / 2)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.4.1.eq4.rodrigues",
        place="section 4.1, equation 4, first form",
        statement="The exponential of a skew matrix is given by Rodrigues' formula.",
        printed="exp(X) = I + (sin θ / θ) X + ((1 - cos θ) / θ²) X², θ = sqrt(tr(ᵗXX) / 2)",
        verdict=Verdict.CONFIRMED,
        form=_rodrigues(),
        cases=_skew_matrices,
        deviation=equals(definitions.exponential),
        copies=(Copy("1 + cos θ for 1 - cos θ", _rodrigues(sign=1)),),
        losses=(
            Loss(
                where="the symmetric part off the diagonal, at angle 1.4e-9: the coefficient of X² is 0 for 1/2",
                formula=lambda m, x: _symmetric_part(_rodrigues()(m, x)),
                truth=lambda m, x: _symmetric_part(definitions.exponential(m, x)),
                at=(TINY,),
                digits=16,
            ),
        ),
        remark="The second form does not lose it.",
    ),
    Claim(
        id="kaji_ochiai.4.1.eq4.sinc",
        place="section 4.1, equation 4, second form",
        statement="The second coefficient is half the square of sinc of the half angle.",
        printed="exp(X) = I + sinc(θ) X + (1/2) sinc(θ/2)² X²",
        verdict=Verdict.CONFIRMED,
        form=_rodrigues_sinc(),
        cases=lambda: [*_skew_matrices(), (exactly([[0] * 3] * 3),)],
        deviation=equals(definitions.exponential),
        copies=(Copy("θ for θ/2", _rodrigues_sinc(part=1)),),
    ),
    Claim(
        id="kaji_ochiai.4.1.eq5",
        place="section 4.1, equation 5",
        statement="1 - θ²/6 approximates sinc θ to second order: it is wrong by less than θ⁴/120.",
        printed="sinc(θ) ≈ 1 - θ²/6",
        verdict=Verdict.CONFIRMED,
        form=_approximation(6),
        cases=lambda: [mp.mpf(2) ** -k for k in (20, 10, 5, 1, 0)],
        deviation=_beyond_fourth_order,
        copies=(Copy("θ²/5", _approximation(5)),),
        remark="In float64 it is exact to rounding below θ = 0.0107; sin θ / θ needs no help above 0.",
    ),
    Claim(
        id="kaji_ochiai.4.2.eq8",
        place="section 4.2, equation 8",
        statement="The principal logarithm of a rotation is its skew part, divided by sinc θ.",
        printed="log(R) = (R - ᵗR) / (2 sinc θ), θ = arccos((Tr R - 1) / 2)",
        verdict=Verdict.BOUND,
        domain="0 ≤ θ < π, with sinc 0 = 1; at θ = π it is 0/0",
        form=_logarithm(),
        cases=_turns,
        outside=_half_turns,
        deviation=equals(_principal),
        copies=(Copy("sinc θ for 2 sinc θ", _logarithm(factor=1)),),
        losses=(
            Loss(
                where="θ at angle 1e-8: the trace is 3 in float64, and its arccosine 0",
                formula=_trace_angle,
                truth=lambda m, _: m.mpf(1e-8),
                at=([[1.0, 0, 0], [0, 1.0, -1e-8], [0, 1e-8, 1.0]],),
                digits=16,
            ),
            Loss(
                where="the logarithm of the turn by π - 1e-8: θ comes out as π, sinc θ as 4e-17, the result as 2.6e8",
                formula=lambda m, rotation: _logarithm()(m, rotation)[2, 1],
                truth=lambda m, _: m.pi - m.mpf(1e-8),
                at=(NEAR_HALF_TURN,),
                digits=16,
            ),
        ),
        remark="The quaternion, or atan2 of the skew part's length and the trace, loses nothing.",
    ),
    Claim(
        id="kaji_ochiai.4.2.eigenvector",
        place="section 4.2, angles near π",
        statement="The angle times the matrix of the unit eigenvector of eigenvalue 1 is a logarithm of the rotation.",
        verdict=Verdict.BOUND,
        domain="the eigenvector of the sign of R - ᵗR; either one at θ = π exactly",
        form=_along_eigenvector,
        cases=lambda: [*((each, sign) for (each,) in _half_turns() for sign in (1, -1)), *_signed(1)],
        outside=lambda: _signed(-1),
        deviation=_not_a_logarithm,
        copies=(Copy("twice the angle", lambda m, rotation, sign: _along_eigenvector(m, rotation, sign, slip=2)),),
        remark="Near π the sign hangs on a small difference, R - ᵗR; taken wrongly, the result is off by 2(π - θ).",
    ),
    Claim(
        id="kaji_ochiai.4.2.diagonal.squares",
        place="section 4.2, the alternative by equation 4",
        statement="The diagonal of a rotation gives the squares of the parameters, θ² (R_kk - cos θ) / (1 - cos θ).",
        printed="one can look at the diagonal entries in (4)",
        verdict=Verdict.CONFIRMED,
        form=_squares(1),
        cases=_vectors,
        deviation=equals(lambda m, omega: omega * omega),
        copies=(Copy("1 + cos θ for 1 - cos θ", _squares(-1)),),
        remark="Not their signs, see the next entry; they come from the entries off the diagonal.",
    ),
    Claim(
        id="kaji_ochiai.4.2.diagonal.signs",
        place="section 4.2, the alternative by equation 4",
        statement="The roots of these squares are the parameters of the logarithm.",
        verdict=Verdict.BOUND,
        domain="no parameter is negative: rotations about all axes (±n1, ±n2, ±n3) have one diagonal",
        form=lambda m, omega: array([m.sqrt(abs(each)) for each in _squares(1)(m, omega)]),
        cases=lambda: [(exactly(each), None) for each in ([0, 0, 1], [1, 2, 0], [1, 2, 1.5])],
        outside=lambda: [(exactly(each), None) for each in ([0, 0, -1], [1, -2, 0], [-1, 2, 1.5])],
        deviation=_read_off,
        copies=(Copy("the squares for the roots", _squares(1)),),
    ),
)
