"""Appendix A.1: the powers of an affine map reduced to those of its linear part, by the fixed point."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.definitions import exponential
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import distance, equals, mp
from affinecert.properties.claims.rossignac_vinacua.poses import affines, power
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array


def _image(m: Context, matrix: Array, point: Array) -> Array:
    found: Array = matrix[:-1, :-1] @ point + matrix[:-1, -1]
    return found


def _recentred(shift: int = 1) -> Any:
    """The image of p as L(qp) + q; as L(qp) + t for a shift of 0."""

    def image(m: Context, matrix: Array, point: Array) -> Array:
        q = sam.fixed_point(m, matrix)
        found: Array = matrix[:-1, :-1] @ (point - q) + (q if shift else matrix[:-1, -1])
        return found

    return image


def _linear_power(m: Context, matrix: Array, t: Number) -> Array:
    """The printed e^(t log L)."""
    return exponential(m, t * sam.log(m, matrix)[:-1, :-1])


def _moved_image(m: Context, matrix: Array, point: Array, t: Number) -> Array:
    return _image(m, power(m, matrix, t), point)


def _equation_9(back: int = 1) -> Any:
    def image(m: Context, matrix: Array, point: Array, t: Number) -> Array:
        q = sam.fixed_point(m, matrix)
        found: Array = _linear_power(m, matrix, t) @ (point - q) + (q if back else t * q)
        return found

    return image


def _linear_motion(m: Context, matrix: Array, point: Array, t: Number) -> Array:
    """L^t of the point without the fixed point, the translation in proportion to time."""
    found: Array = _linear_power(m, matrix, t) @ point + t * matrix[:-1, -1]
    return found


def _translation(m: Context, matrix: Array, t: Number) -> Array:
    found: Array = power(m, matrix, t)[:-1, -1]
    return found


def _printed_translation(sign: int = -1) -> Any:
    def moved(m: Context, matrix: Array, t: Number) -> Array:
        q = sam.fixed_point(m, matrix)
        found: Array = q + sign * (_linear_power(m, matrix, t) @ q)
        return found

    return moved


def _maps() -> list[Array]:
    return [affine([[0, -1], [1, 0]], [2, 0]), *affines("general", 4), *affines("general", 4, 3)]


def _at_points() -> list[tuple[Array, Array]]:
    points = arrays("points", len(_maps()), (3,), -3, 3)
    return [(matrix, point[: len(matrix) - 1]) for matrix, point in zip(_maps(), points, strict=True)]


def _at_times() -> list[tuple[Array, Array, Number]]:
    return [(matrix, point, mp.mpf(k - 2) / 3) for k, (matrix, point) in enumerate(_at_points())]


def _not_a_motion(form: Any, case: tuple[Array, Array, Number]) -> Number:
    """How far from A(p) the point is at t = 1, and from being moved on by s where moved by t and then by s."""
    matrix, point, t = case
    there = form(mp, matrix, form(mp, matrix, point, t), t / 2)
    return max(
        distance(form(mp, matrix, point, mp.one), _image(mp, matrix, point)),
        distance(there, form(mp, matrix, point, 3 * t / 2)),
    )


def _shape(printed: tuple[int, int], matrix: Array) -> int:
    """Whether [L | t] has another shape, rows by columns."""
    return int(matrix[:-1].shape != printed)


def _spiral_translation(m: Context, stretch: Number, turn: Number, move: Number) -> Array:
    """The translation q - L^(1/2) q for L = (stretch, -turn; turn, stretch) and a translation along x, as printed."""
    gap = 1 - stretch
    divisor = gap * gap + turn * turn
    q = array([gap * move / divisor, turn * move / divisor])
    angle, scale = m.atan2(turn, stretch) / 2, m.sqrt(m.sqrt(stretch * stretch + turn * turn))
    cosine, sine = scale * m.cos(angle), scale * m.sin(angle)
    return array([q[0] - (cosine * q[0] - sine * q[1]), q[1] - (sine * q[0] + cosine * q[1])])


def _true_translation(m: Context, stretch: Number, turn: Number, move: Number) -> Array:
    matrix = affine([[stretch, -turn], [turn, stretch]], [move, 0])
    return _translation(m, matrix, m.one / 2)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.1.recentred",
        place="appendix A.1",
        statement="With the fixed point q of A, A(p) = L(qp) + q.",
        printed="A(p) = L(qp) + q",
        verdict=Verdict.CONFIRMED,
        form=_recentred(),
        cases=_at_points,
        deviation=equals(_image),
        copies=(Copy("t for the last q", _recentred(0)),),
    ),
    Claim(
        id="rossignac_vinacua.A.1.equation_9",
        place="equation 9",
        statement="With the fixed point q of A, A^t(p) = L^t(qp) + q = e^(t log L)(qp) + q.",
        printed="A^t(p) = L^t(qp) + q = e^(t log(L))(qp) + q",
        verdict=Verdict.CONFIRMED,
        form=_equation_9(),
        cases=_at_times,
        deviation=equals(_moved_image),
        copies=(Copy("t q for the last q", _equation_9(0)), Copy("L^t p + t ot", _linear_motion)),
    ),
    Claim(
        id="rossignac_vinacua.A.1.is_a_power",
        place="equation 9",
        statement="What equation 9 defines is a power: it is A at t = 1, and A^s A^t = A^(s + t).",
        printed="A^t(p) = L^t(qp) + q",
        verdict=Verdict.CONFIRMED,
        form=_equation_9(),
        cases=_at_times,
        deviation=_not_a_motion,
        copies=(Copy("t q for the last q", _equation_9(0)), Copy("L^t p + t ot", _linear_motion)),
    ),
    Claim(
        id="rossignac_vinacua.A.1.matrix_form",
        place="appendix A.1",
        statement="The translation of A^t is q - L^t(oq).",
        printed="A^t = [L^t | t_t] = [e^(t log(L)) | q - L^t(oq)]",
        verdict=Verdict.CONFIRMED,
        form=_printed_translation(),
        cases=lambda: [(matrix, t) for matrix, _, t in _at_times()],
        deviation=equals(_translation),
        copies=(Copy("q + L^t(oq)", _printed_translation(1)),),
        losses=(
            Loss(
                where="a turn by 1e-8: q is 1e8 away, and of the difference, 1/2, as many digits are lost",
                formula=_spiral_translation,
                truth=_true_translation,
                at=(1.0, 1e-8, 1.0),
                digits=8,
            ),
            Loss(
                where="a turn and a growth by 1e-13",
                formula=_spiral_translation,
                truth=_true_translation,
                at=(1.0 + 2.0**-43 + 2.0**-52, 2.0**-43, 1.0),
                digits=13,
            ),
        ),
        remark="exp[0, t log L] v with (log L, v) = log A, a divided difference of exp, needs no fixed point and loses "
        "nothing.",
    ),
    Claim(
        id="rossignac_vinacua.A.1.shape",
        place="appendix A.1",
        statement="In space A^t = [L^t | t_t] is a matrix of 4 x 3.",
        printed="4 x 3",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=(4, 3),
        cases=lambda: affines("general", 1, 3),
        deviation=_shape,
        correction=Correction(statement="It is a matrix of 3 x 4, as section 2.1 has it.", form=(3, 4)),
        copies=(Copy("homogeneous, 4 x 4", (4, 4)),),
    ),
)
