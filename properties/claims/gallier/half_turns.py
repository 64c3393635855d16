"""Section 4, case 3: logarithms of half turns."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.gallier.rotation_logarithms import unit_vectors
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, identity, norm


def _rotation(omega: Array) -> Array:
    return definitions.exponential(mp, cross_matrix(mp, omega))


def _half_turn_axes() -> list[Array]:
    return unit_vectors("half turns", 4)


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


CLAIMS: tuple[Claim[Any, Any], ...] = (
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
)
