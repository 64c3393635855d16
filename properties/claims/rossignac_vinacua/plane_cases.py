"""Appendix A.3: the logarithm of what turns, G1, and of what has two positive eigenvalues, G2."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.precision import equals, exactly
from affinecert.properties.claims.rossignac_vinacua.plane_logarithm import logarithm, plain
from affinecert.reference._matrices import Array, Context, Number, array


def _r_and_gap(linear: Array) -> tuple[Number, Number]:
    """The numbers r and det L - r^2."""
    r = (linear[0, 0] + linear[1, 1]) / 2
    return r, determinant(linear) - r * r


def _tangent(sign: int = 1) -> Any:
    def printed(m: Context, linear: Array) -> Number:
        r, gap = _r_and_gap(linear)
        return sign * m.sqrt(gap) / r

    return printed


def _true_tangent(m: Context, linear: Array) -> Number:
    return m.tan(_angle(m, linear))


def _angle(m: Context, linear: Array) -> Number:
    """The imaginary part of an eigenvalue of log L, in (0, pi)."""
    c = logarithm(m, linear)
    return m.sqrt(-(((c[0, 0] - c[1, 1]) / 2) ** 2 + c[0, 1] * c[1, 0]))


def _substituted(m: Context, linear: Array, y: Number, *, divisor: int = 2) -> Array:
    """Equations 15, 16, 14, 13 and 19 in turn, with a_12 in the first row; for equation 16 y as printed there."""
    (a11, a12), (a21, a22) = linear
    x = m.log((a11 + a22) / (m.exp(y) + m.exp(-y)))
    c2 = 2 * a12 * y / m.sqrt((a11 - a22) ** 2 + 4 * a21 * a12)
    c3, z = c2 * a21 / a12, (a11 - a22) * c2 / (divisor * a12)
    return array([[x + z, c2], [c3, x - z]])


def _g1(angle: Callable[[Context, Number, Number], Number], divisor: int = 2) -> Any:
    """G1 with theta found from det L - r^2 and r."""

    def printed(m: Context, linear: Array) -> Array:
        r, gap = _r_and_gap(linear)
        return _substituted(m, linear, m.j * angle(m, m.sqrt(gap), r), divisor=divisor)

    return printed


def _arctangent(m: Context, opposite: Number, adjacent: Number) -> Number:
    return m.atan(opposite / adjacent)


def _in_quadrant(m: Context, opposite: Number, adjacent: Number) -> Number:
    return m.atan2(opposite, adjacent)


def _equation_20(halves: int = 2) -> Any:
    def y(m: Context, linear: Array) -> Number:
        r, gap = _r_and_gap(linear)
        chi = r / m.sqrt(-gap)
        return m.log((chi + 1) / (chi - 1)) / halves

    return y


def _true_y(m: Context, linear: Array) -> Number:
    c = logarithm(m, linear)
    return m.sqrt(((c[0, 0] - c[1, 1]) / 2) ** 2 + c[0, 1] * c[1, 0])


def _g2(halves: int = 2, divisor: int = 2) -> Any:
    def printed(m: Context, linear: Array) -> Array:
        return _substituted(m, linear, _equation_20(halves)(m, linear), divisor=divisor)

    return printed


def _turning() -> list[tuple[Array]]:
    simple = [(exactly(each),) for each in ([[1, -1], [1, 1]], [[1, -1], [4, 1]], [[2, -2], [1, 1]])]
    return simple + [case for case in plain() if _r_and_gap(case[0])[1] > 0 and case[0].trace() > 0]


def _obtuse() -> list[tuple[Array]]:
    """Turns by more than pi / 2, the first hardly more."""
    return [(exactly(each),) for each in ([[-1e-6, -1], [1, -1e-6]], [[-1, -1], [1, 0]], [[-2, -1], [1, -1]])]


def _right_angles() -> list[tuple[Array]]:
    return [(exactly(each),) for each in ([[0, -1], [1, 0]], [[1, -2], [1, -1]])]


def _positive() -> list[tuple[Array]]:
    """Two positive eigenvalues, a_12 a_21 other than 0."""
    rows = [[3, 1], [1, 2]], [[2, 1], [2, 3]], [[5, -2], [1, 1]], [[1, 0.5], [0.25, 4]], [[0.5, 0.0625], [1, 0.75]]
    return [(exactly(each),) for each in rows]


def _diagonal() -> list[tuple[Array]]:
    return [(exactly(each),) for each in ([[3, 0], [0, 2]], [[2, 0], [1, 3]], [[2, 0], [2.0**-20, 3]])]


def _double() -> list[tuple[Array]]:
    return [(exactly(each),) for each in ([[2, 0], [0, 2]], [[2, 1], [0, 2]], [[3, 1], [-1, 1]])]


_NEAR_IDENTITY = ([[1.0, -1e-8], [1e-8, 1.0]],)


def _angle_18(m: Context, linear: Array) -> Number:
    r, gap = _r_and_gap(linear)
    return m.atan2(m.sqrt(gap), r)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.3.equation_18",
        place="equation 18",
        statement="The angle θ in (0, π) by which L turns has the tangent sqrt(det L - r²) / r.",
        printed="tan(θ) = sqrt(det(L) - r²) / r",
        verdict=Verdict.BOUND,
        domain="r ≠ 0, θ ≠ π/2",
        form=_tangent(),
        cases=lambda: [*_turning(), *_obtuse()],
        outside=_right_angles,
        deviation=equals(_true_tangent),
        copies=(Copy("-tan θ", _tangent(-1)),),
        losses=(
            Loss(
                where="a turn by 1e-8: det L - r² is 0 for 1e-16",
                formula=_angle_18,
                truth=_angle,
                at=_NEAR_IDENTITY,
                digits=16,
            ),
            Loss(
                where="a turn by 1e-4, cosine and sine as float64",
                formula=_angle_18,
                truth=_angle,
                at=([[0.9999999950000000, -9.999999983333334e-5], [9.999999983333334e-5, 0.9999999950000000]],),
                digits=8,
            ),
            Loss(
                where="eigenvalues 1 ± 1e-4 i, a_12 = -1",
                formula=_angle_18,
                truth=_angle,
                at=([[1.0, -1.0], [1e-8, 1.0]],),
                digits=8,
            ),
        ),
        remark="det L - r² = -((a_11 - a_22)² / 4 + a_12 a_21) without cancelling.",
    ),
    Claim(
        id="rossignac_vinacua.A.3.G1",
        place="appendix A.3, G1",
        statement="If L turns, θ = arctan(sqrt(det L - r²) / r) and y = iθ in equations 15, 16, 14, 13, 19 give log L.",
        printed="y = θi, tan(θ) = sqrt(det(L) - r²) / r",
        verdict=Verdict.BOUND,
        domain="r > 0; for r < 0 the angle is π + arctan, and x is complex with arctan; for r = 0 equation 15 is 0/0",
        form=_g1(_arctangent),
        cases=_turning,
        outside=lambda: [*_obtuse(), *_right_angles()],
        deviation=equals(logarithm),
        copies=(Copy("a_12 for 2 a_12 in equation 13", _g1(_arctangent, 1)),),
        remark="θ = atan2(sqrt(det L - r²), r) and x = log(det L) / 2 have no such cases.",
    ),
    Claim(
        id="rossignac_vinacua.A.3.G1_in_quadrant",
        place="appendix A.3, G1",
        statement="If L turns, and θ is taken in (0, π), equations 15, 16, 14, 13, 19 with y = iθ give log L.",
        printed="y = θi, then equations (15), (16), (14), (13), (19)",
        verdict=Verdict.BOUND,
        domain="r ≠ 0",
        form=_g1(_in_quadrant),
        cases=lambda: [*_turning(), *_obtuse()],
        outside=lambda: [(exactly([[0, -1], [1, 0]]),)],
        deviation=equals(logarithm),
        copies=(Copy("a_12 for 2 a_12 in equation 13", _g1(_in_quadrant, 1)),),
    ),
    Claim(
        id="rossignac_vinacua.A.3.equation_20",
        place="equation 20",
        statement="For real eigenvalues y = log((χ + 1) / (χ - 1)) / 2, χ = r / sqrt(r² - det L).",
        printed="y = log((χ + 1) / (χ - 1)) / 2, χ = r / sqrt(r² - det(L))",
        verdict=Verdict.BOUND,
        domain="two positive eigenvalues that differ; χ is infinite if they agree",
        form=_equation_20(),
        cases=lambda: [*_positive(), *_diagonal()],
        outside=_double,
        deviation=equals(_true_y),
        copies=(Copy("not halved", _equation_20(1)),),
        losses=(
            Loss(
                where="eigenvalues 1 ± 1e-4",
                formula=_equation_20(),
                truth=_true_y,
                at=([[1.0, 1.0], [1e-8, 1.0]],),
                digits=8,
            ),
            Loss(
                where="eigenvalues 1 and 1 + 1e-8",
                formula=_equation_20(),
                truth=_true_y,
                at=([[1.0, 0.0], [0.0, 1.00000001]],),
                digits=16,
            ),
        ),
        remark="y = atanh(sqrt(d_L) / r), d_L = (a_11 - a_22)² / 4 + a_12 a_21.",
    ),
    Claim(
        id="rossignac_vinacua.A.3.G2",
        place="appendix A.3, G2",
        statement="For two positive eigenvalues equation 20, substituted in 16, 14, 15, 13 and 19, gives log L.",
        printed="y by equation (20), then equations (16), (14), (15) and (13)",
        verdict=Verdict.BOUND,
        domain="a_12 ≠ 0 and eigenvalues that differ; for diagonal and lower triangular L equations 13 and 14 are 0/0",
        form=_g2(),
        cases=_positive,
        outside=lambda: [*_diagonal(), *_double()],
        deviation=equals(logarithm),
        copies=(Copy("y not halved", _g2(1)), Copy("a_12 for 2 a_12 in equation 13", _g2(2, 1))),
        losses=(
            Loss(
                where="eigenvalues 1 ± 1e-4: d_L cancels in equation 20 and not in 16",
                formula=_g2(),
                truth=logarithm,
                at=([[1.0, 1.0], [1e-8, 1.0]],),
                digits=8,
            ),
            Loss(
                where="eigenvalues 2 ± 1e-10: d_L is 0",
                formula=_g2(),
                truth=logarithm,
                at=([[2.0, 1.0], [1e-20, 2.0]],),
                digits=16,
            ),
        ),
        remark="C = x + (y / sqrt(d_L)) (L - r), x = log(det L) / 2, needs no a_12; with atanh(u) / u as a function of "
        "its own it serves double eigenvalues too.",
    ),
)
