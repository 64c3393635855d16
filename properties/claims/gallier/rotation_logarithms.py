"""Section 4: logarithms of rotations of space, and the inverse of V that makes them logarithms of similarities."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, identity, norm

_TURNS = range(-3, 4)


def _units(name: str, count: int) -> list[Array]:
    """Unit vectors: an axis, (1, 2, 2) / 3, and drawn ones."""
    simple = [exactly([1, 0, 0]), exactly([0, 0, 1]), exactly([1, 2, 2]) / 3, exactly([-2, 0, 1]) / mp.sqrt(5)]
    return simple + [each / norm(mp, each) for each in arrays(name, count, (3,), -1, 1) if any(each)]


def _rotation(omega: Array) -> Array:
    return definitions.exponential(mp, cross_matrix(mp, omega))


def _axes_and_angles() -> list[tuple[Array, Number]]:
    """Unit axes and angles of logarithms, whole turns and more among them, that are no multiples of pi."""
    angles = [mp.one, mp.mpf(3), mp.mpf(4), -mp.mpf(2), mp.mpf(9), -mp.mpf(15), *numbers("angles", 3, 0.1, 3)]
    return list(zip(_units("logs", 8), angles, strict=False))


def _by_skew_part(factor: int) -> Any:
    """Theta / (2 sin theta) (R - R^T), theta any angle with 1 + 2 cos theta = tr R."""

    def printed(rotation: Array, theta: Number) -> Array:
        if abs(1 + 2 * mp.cos(theta) - rotation.trace()) > mp.mpf(10) ** -60:
            raise ValueError("not an angle of that rotation")
        omega: Array = theta / (factor * mp.sin(theta)) * (rotation - rotation.T)
        return omega

    return printed


def _set_misses(form: Any, case: tuple[Array, Number]) -> Number:
    """How far the logarithm that R = e^Omega was made of, is from the one of its angle in the set."""
    axis, angle = case
    omega = cross_matrix(mp, axis * angle)
    return distance(form(definitions.exponential(mp, omega), angle), omega)


def _principal() -> Any:
    """Theta / (2 sin theta) (R - R^T), theta the arc cosine of (tr R - 1) / 2 in float64 too."""

    def printed(m: Context, omega: Array) -> Array:
        rotation = so3.exp(mp, exactly(omega)) if m is mp else exactly(_rounded(omega), m)
        theta = m.acos((rotation.trace() - 1) / 2)
        found: Array = theta / (2 * m.sin(theta)) * (rotation - rotation.T)
        return found

    return printed


def _rounded(omega: Array) -> list[list[float]]:
    """The rotation matrix of a vector, rounded to float64."""
    return [[float(x) for x in row] for row in so3.exp(mp, exactly(omega))]


def _skew(m: Context, omega: Array) -> Array:
    return cross_matrix(m, omega)


def _other(step: int) -> Any:
    """(theta + k step pi) B / theta."""

    def printed(principal: Array, theta: Number, k: int) -> Array:
        other: Array = (theta + k * step * mp.pi) * principal / theta
        return other

    return printed


def _other_misses(form: Any, case: tuple[Array, Number]) -> Number:
    axis, angle = case
    principal = cross_matrix(mp, axis * angle)
    rotation = definitions.exponential(mp, principal)
    return max(difference(definitions.exponential(mp, form(principal, angle, k)), rotation) for k in _TURNS)


def _principal_cases() -> list[tuple[Array, Number]]:
    return [(axis, angle) for axis, angle in _axes_and_angles() if 0 < angle < mp.pi]


def _not_unique(form: Any, case: tuple[Array, Number]) -> int:
    """How many logarithms besides one have their angle in (0, most), most given."""
    axis, angle = case
    omegas = [axis * (angle + 2 * mp.pi * k) for k in _TURNS]
    return abs([0 < norm(mp, omega) < form for omega in omegas].count(True) - 1)


def _half_turn_axes() -> list[Array]:
    return _units("half turns", 4)


def _half_turn(axis: Array) -> Array:
    return _rotation(axis * mp.pi)


def _not_symmetric(form: str, axis: Array) -> Number:
    """How far a rotation with the trace given is from a symmetric one."""
    rotation = _rotation(axis * mp.acos((mp.mpf(form) - 1) / 2))
    return difference(rotation, rotation.T)


def _root_misses(form: Any, axis: Array) -> Number:
    """How far U^2 is from the multiple of R - I given, for the U of the unit axis."""
    u = cross_matrix(mp, axis)
    return difference(u @ u, form * (_half_turn(axis) - identity(mp, 3)))


def _half_turn_logarithm(even: int) -> Any:
    def printed(axis: Array, k: int) -> Array:
        omega: Array = (2 * k + even) * mp.pi * cross_matrix(mp, axis)
        return omega

    return printed


def _half_turn_misses(form: Any, axis: Array) -> Number:
    """How far an exponential is from the half turn, and the logarithms of odd multiples of pi from those given."""
    rotation = _half_turn(axis)
    exponentials = [definitions.exponential(mp, form(axis, k)) for k in range(-2, 2)]
    odd = [(2 * k + 1) * mp.pi * cross_matrix(mp, axis) for k in range(-2, 2)]
    missing = max(min(difference(each, form(axis, k)) for k in range(-4, 5)) for each in odd)
    return max(missing, *(difference(each, rotation) for each in exponentials))


def _system(diagonal: int, corner: int = 0) -> Any:
    """The matrix on the left of the system for b, c, d."""

    def printed(m: Context, axis: Array) -> Array:
        b, c, d = axis
        middle = c * d if not corner else b * c
        return array(
            [
                [b**2 + diagonal, b * c, b * d],
                [b * c, c**2 + diagonal, middle],
                [b * d, middle, d**2 + diagonal],
            ]
        )

    return printed


def _half_of_difference(m: Context, axis: Array) -> Array:
    half: Array = (_half_turn(axis) - identity(mp, 3)) / 2
    return half


def _solved(first: int = 1) -> Any:
    """B = pi U by the positive root of a square that is not zero, and the products; a copy has the negative ones."""

    def printed(m: Context, rotation: Array) -> Array:
        half = (rotation - identity(m, 3)) / 2
        squares = [half[k, k] + 1 for k in range(3)]
        k = next(i for i in range(3) if squares[i] > 4 * m.eps)
        root = m.sqrt(squares[k])
        axis = array([root if i == k else first * half[k, i] / root for i in range(3)])
        omega: Array = m.pi * cross_matrix(m, axis)
        return omega

    return printed


def _solution_misses(form: Any, axis: Array) -> Number:
    rotation = _half_turn(axis)
    return difference(definitions.exponential(mp, form(mp, rotation)), rotation)


_NEARLY_ACROSS = [1e-6, 0.6, 0.8]
"""The axis of a half turn, up to its length, whose first component is small."""


def _solved_of_axis(m: Context, axis: Array) -> Array:
    """The algorithm, run on the matrix rounded to float64."""
    direction = exactly(axis) / norm(mp, exactly(axis))
    rotation = 2 * direction[:, None] * direction[None, :] - identity(mp, 3)
    found: Array = _solved()(m, rotation if m is mp else exactly([[float(x) for x in row] for row in rotation], m))
    return found


def _true_of_axis(m: Context, axis: Array) -> Array:
    omega: Array = m.pi * cross_matrix(m, axis / norm(m, axis))
    return omega


def condition(growth: Number, angle: Number) -> Number:
    """The condition number of V, a normal matrix: the ratio of its eigenvalues' absolute values."""
    first, second = (abs(phi(z)) for z in (growth, mp.mpc(growth, angle)))
    return max(first, second) / min(first, second)


def phi(z: Number) -> Number:
    """(e^z - 1) / z, and 1 for 0."""
    return (mp.exp(z) - 1) / z if z else mp.one


def _growths_and_angles() -> list[tuple[Number, Number]]:
    growths = [mp.zero, mp.one, -mp.one, mp.mpf(1) / 100, mp.mpf(-20)]
    return [(growth, mp.pi * part / 8) for growth in growths for part in range(9)]


def _worse(form: Number, case: tuple[Number, Number]) -> Number:
    return max(condition(*case) - form - mp.mpf(10) ** -60, mp.zero)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.4.2.all_logarithms",
        place="section 4, case 2",
        statement="If R ≠ I and tr R ≠ -1, the logarithms of R are (θ/(2 sin θ))(R - Rᵀ) for all θ with "
        "1 + 2 cos θ = tr R.",
        printed="exp^{-1}(R) = {(θ/(2 sin θ))(R - Rᵀ) | 1 + 2 cos θ = tr(R)}",
        verdict=Verdict.CONFIRMED,
        form=_by_skew_part(2),
        cases=_axes_and_angles,
        deviation=_set_misses,
        copies=(Copy("sin θ for 2 sin θ", _by_skew_part(1)),),
    ),
    Claim(
        id="gallier.4.2.principal",
        place="section 4, case 2",
        statement="The logarithm with its angle in (0, π) is unique, and is (θ/(2 sin θ))(R - Rᵀ).",
        printed="B = (θ/(2 sin θ))(R - Rᵀ), 0 < θ < π",
        verdict=Verdict.CONFIRMED,
        form=_principal(),
        cases=lambda: [(axis * angle,) for axis, angle in _principal_cases()],
        deviation=equals(_skew),
        copies=(
            Copy(
                "the angle of the transpose, 2π - θ",
                lambda m, omega: _principal()(m, omega) * (2 * m.pi - norm(m, omega)) / norm(m, omega),
            ),
        ),
        losses=(
            Loss(
                where="π - θ = 1e-4: (π - θ)² goes into tr R + 1",
                formula=_principal(),
                truth=_skew,
                at=([0.0, 0.0, 3.14149265358979],),
                digits=8,
            ),
            Loss(
                where="π - θ = 1e-8: the arc cosine is π, or its neighbour",
                formula=_principal(),
                truth=_skew,
                at=([0.0, 1.8849555861538759, 2.5132741148718345],),
                digits=16,
            ),
            Loss(
                where="θ = 1e-9: the arc cosine is 0, and the formula 0/0",
                formula=_principal(),
                truth=_skew,
                at=([0.0, 0.0, 1e-9],),
                digits=16,
            ),
        ),
        remark="These are the tolerances that section 4 asks for. The quaternion of R needs none: the axis is its "
        "vector part, and the angle 2 atan2(|vector|, scalar).",
    ),
    Claim(
        id="gallier.4.2.unique",
        place="section 4, case 2",
        statement="Among all logarithms of R one only has its angle in (0, π).",
        printed="there is a unique skew-symmetric B with corresponding θ satisfying 0 < θ < π such that e^B = R",
        verdict=Verdict.CONFIRMED,
        form=mp.pi,
        cases=_principal_cases,
        deviation=_not_unique,
        copies=(Copy("(0, 2π)", 2 * mp.pi),),
    ),
    Claim(
        id="gallier.4.2.determinations",
        place="section 4, case 2 (also strategy 2 in section 5)",
        statement="The other logarithms of R are (θ + 2πk) B/θ, B the principal one and θ its angle.",
        printed="(θ + k2π) B/θ, k ∈ Z",
        verdict=Verdict.CONFIRMED,
        form=_other(2),
        cases=_principal_cases,
        deviation=_other_misses,
        copies=(Copy("kπ for k2π", _other(1)),),
    ),
    Claim(
        id="gallier.4.3.symmetric",
        place="section 4, case 3",
        statement="A rotation of trace -1 is symmetric.",
        printed="tr(R) = -1",
        verdict=Verdict.CONFIRMED,
        form="-1",
        cases=_half_turn_axes,
        deviation=_not_symmetric,
        copies=(Copy("a trace of -0.9999", "-0.9999"),),
        remark="R ≠ I says nothing here, as tr I = 3.",
    ),
    Claim(
        id="gallier.4.3.square_root",
        place="section 4, case 3",
        statement="For a half turn there is a skew matrix U with U² = (R - I)/2: that of the unit axis.",
        printed="U² = S = (R - I)/2",
        verdict=Verdict.CONFIRMED,
        form=mp.mpf(1) / 2,
        cases=_half_turn_axes,
        deviation=_root_misses,
        copies=(Copy("R - I for (R - I)/2", mp.one),),
    ),
    Claim(
        id="gallier.4.3.all_logarithms",
        place="section 4, case 3",
        statement="The logarithms of a half turn are (2k + 1)π U, k an integer.",
        printed="exp^{-1}(R) = {(2k+1)π U, k ∈ Z}",
        verdict=Verdict.CONFIRMED,
        form=_half_turn_logarithm(1),
        cases=_half_turn_axes,
        deviation=_half_turn_misses,
        copies=(Copy("2kπ U", _half_turn_logarithm(0)),),
        remark="Two of them, πU and -πU, have the angle π: the principal logarithm is not unique.",
    ),
    Claim(
        id="gallier.4.3.system",
        place="section 4, the system for b, c, d",
        statement="U² is the matrix of b² - 1, bc, bd and so on, where b² + c² + d² = 1.",
        printed="(b² - 1, bc, bd; bc, c² - 1, cd; bd, cd, d² - 1) = S",
        verdict=Verdict.CONFIRMED,
        form=_system(-1),
        cases=lambda: [(axis,) for axis in _half_turn_axes()],
        deviation=equals(_half_of_difference),
        copies=(Copy("+1 for -1 on the diagonal", _system(1)), Copy("bc for cd", _system(-1, corner=1))),
    ),
    Claim(
        id="gallier.4.3.algorithm",
        place="section 4, the solution of the system",
        statement="With one of b, c, d not zero, say b, the positive root of b² and the products bc and bd give a "
        "logarithm πU.",
        verdict=Verdict.CONFIRMED,
        form=_solved(),
        cases=_half_turn_axes,
        deviation=_solution_misses,
        copies=(Copy("c and d with the other sign", _solved(-1)),),
        losses=(
            Loss(
                where="the half turn about (1e-6, 0.6, 0.8), by the first component",
                formula=_solved_of_axis,
                truth=_true_of_axis,
                at=(_NEARLY_ACROSS,),
                digits=12,
            ),
        ),
        remark="Take the largest of b², c², d², at least 1/3, for the root.",
    ),
    Claim(
        id="gallier.4.inverse",
        place="section 4, last paragraph (also section 6)",
        statement="For principal logarithms V is invertible, and its inverse makes no numerical trouble: for angles up "
        "to π the condition number of V is at most π/2, whatever λ is.",
        printed="the matrix V is invertible and we never encountered numerical problems computing the inverse of V",
        verdict=Verdict.CONFIRMED,
        form=mp.pi / 2,
        cases=_growths_and_angles,
        deviation=_worse,
        copies=(Copy("3/2 for π/2", mp.mpf(3) / 2),),
        remark="π/2 is ours; the paper gives no bound.",
    ),
)
