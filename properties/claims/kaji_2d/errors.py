"""Equation 4: the error E^R, invariant under similarities, its closed form and the steps of its proof."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, numbers, plane_rotation
from affinecert.properties.claims.kaji_2d.plane import IDENTITY, J, determinant, inner, maps, square
from affinecert.properties.claims.precision import distance, equals, exactly, mp
from affinecert.reference._least_squares import Square, minimiser
from affinecert.reference._matrices import Array, Context, Number


def frobenius(a: Array, b: Array) -> Number:
    """E^F, the squared Frobenius norm of A - B."""
    return square(a - b)


def similarity(a: Array, b: Array) -> Number:
    """E^R by the closed form of the appendix, exact for rationals."""
    product = b @ a.T
    return square(b) - (square(product) + 2 * determinant(product)) / square(a)


def least(m: Context, a: Array, b: Array) -> Number:
    """The minimum of |(x I + y J) A - B|² over x and y, by the normal equations of its four squares."""
    x, y = _best(m, a, b)
    return square(x * a + y * (J @ a) - b)


def _best(m: Context, a: Array, b: Array) -> Array:
    turned = J @ a
    squares = [
        Square(m.one, [(0, first), (1, second)], goal)
        for first, second, goal in zip(a.flat, turned.flat, b.flat, strict=True)
    ]
    found = minimiser(m, squares, 2, {})
    assert found is not None
    return found


def _closed(doubled: int = 2, *, transposed: bool = False) -> Any:
    def printed(m: Context, a: Array, b: Array) -> Number:
        product = b.T @ a if transposed else b @ a.T
        return square(b) - (square(product) + doubled * determinant(product)) / square(a)

    return printed


def _pairs() -> list[tuple[Array, Array]]:
    firsts = maps("first map", 5)
    seconds = [exactly(each) for each in ([[1, 0], [0, 0]], [[0, 0], [0, 1]], [[1, 2], [3, 4]])]
    seconds += arrays("second map", len(firsts) - len(seconds), (2, 2), -3, 3)
    return list(zip(firsts, seconds, strict=True))


def _pairs_with_numbers() -> list[tuple[Array, Array, Number, Number]]:
    pairs = _pairs()
    xs, ys = (numbers(name, len(pairs), -3, 3) for name in ("x", "y"))
    return [(a, b, x, y) for (a, b), x, y in zip(pairs, xs, ys, strict=True)]


def _combined(m: Context, a: Array, b: Array, x: Number, y: Number) -> Number:
    return square((x * IDENTITY + y * J) @ a - b)


def _expanded(factor: int = 2) -> Any:
    def printed(m: Context, a: Array, b: Array, x: Number, y: Number) -> Number:
        first = x**2 * square(a) - 2 * x * inner(a, b)
        return first + y**2 * square(a) - factor * y * inner(J @ a, b) + square(b)

    return printed


def _completed(turn: Array = J) -> Any:
    def printed(m: Context, a: Array, b: Array, x: Number, y: Number) -> Number:
        along, across = inner(a, b), inner(turn @ a, b)
        squares = (x - along / square(a)) ** 2 + (y - across / square(a)) ** 2
        return square(a) * squares + square(b) - (along**2 + across**2) / square(a)

    return printed


def _two_products(m: Context, a: Array, b: Array) -> Number:
    return inner(a, b) ** 2 + inner(J @ a, b) ** 2


def _norm_and_determinant(sign: int = 1) -> Any:
    def printed(m: Context, a: Array, b: Array) -> Number:
        product = b @ a.T
        return square(product) + sign * 2 * determinant(product)

    return printed


def _attained(turn: Array = J) -> Any:
    def numbers_of_minimum(m: Context, a: Array, b: Array) -> tuple[Number, Number]:
        return inner(a, b) / square(a), inner(turn @ a, b) / square(a)

    return numbers_of_minimum


def _scaled_turn(m: Context, s: Number, delta: Number) -> Array:
    turned: Array = s * plane_rotation(delta)
    return turned


def _as_scaled_turn(matrix: Any, case: tuple[Number, Number]) -> Number:
    """How far x I + y J is from s R_δ with s = hypot(x, y) and δ the direction of (x, y)."""
    x, y = case
    return distance(matrix(x, y), _scaled_turn(mp, mp.hypot(x, y), mp.atan2(y, x)))


def _orthogonal(turn: Any, a: Array) -> Number:
    return abs(inner(turn(a), a))


def _under_source(change: Any, case: tuple[Array, Array, Number, Number]) -> Number:
    """The relative change of the least square if A is changed by (s, δ)."""
    a, b, s, delta = case
    return distance(least(mp, change(s, delta) @ a, b), least(mp, a, b))


def _under_image(change: Any, case: tuple[Array, Array, Number, Number]) -> Number:
    """The same if B is."""
    a, b, s, delta = case
    return distance(least(mp, a, change(s, delta) @ b), least(mp, a, b))


def _turns(scales: tuple[float, ...]) -> list[tuple[Array, Array, Number, Number]]:
    return [
        (a, b, mp.mpf(scales[number % len(scales)]), mp.mpf(number - 3) / 2) for number, (a, b) in enumerate(_pairs())
    ]


def _shear(s: Number, delta: Number) -> Array:
    sheared: Array = _scaled_turn(mp, s, delta) @ exactly([[1, 0], [0, 1.0625]])
    return sheared


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.equation_4.invariant_in_A",
        place="section 4, equation 4",
        statement="E^R(A, B) does not change if A is turned and scaled: it is invariant under similarities.",
        verdict=Verdict.CONFIRMED,
        form=lambda s, delta: _scaled_turn(mp, s, delta),
        cases=lambda: _turns((1, 2, 0.5)),
        deviation=_under_source,
        copies=(Copy("the similarity is followed by a stretch of 17/16", _shear),),
        remark="So E^R sees of the local homotopy nothing but the stretch S(t): R_(tθ), and the choice of θ, drop out.",
    ),
    Claim(
        id="kaji_2d.equation_4.invariant_in_B",
        place="section 4, equation 4",
        statement="E^R measures how different A and B are up to rotation and scale: it is the same for s R B as for B.",
        verdict=Verdict.BOUND,
        domain="s = 1, rotations of B; scaled by s, it is multiplied by s²",
        form=lambda s, delta: _scaled_turn(mp, s, delta),
        cases=lambda: _turns((1,)),
        outside=lambda: _turns((1.0625, 0.9375, 2, 0.5)),
        deviation=_under_image,
        copies=(Copy("the rotation is followed by a stretch of 17/16", _shear),),
        remark="A small image has a small error, the image that is a point none: E^R alone would shrink everything.",
    ),
    Claim(
        id="kaji_2d.appendix.complex_numbers",
        place="appendix, closed form, first equality",
        statement="The maps s R_δ, over all real s and δ, are the maps x I + y J over all real x and y.",
        printed="min |s R_δ A - B|² = min |(x I + y J) A - B|², J = (0 -1; 1 0)",
        verdict=Verdict.CONFIRMED,
        form=lambda x, y: x * IDENTITY + y * J,
        cases=lambda: [(mp.mpf(x), mp.mpf(y)) for x, y in ((1, 0), (0, 1), (0, 0), (-2, 1), (3, -4), (-1, -1))],
        deviation=_as_scaled_turn,
        copies=(
            Copy("Jᵀ for J", lambda x, y: x * IDENTITY + y * J.T),
            Copy("(0 1; 1 0) for J", lambda x, y: x * IDENTITY + y * abs(J)),
        ),
    ),
    Claim(
        id="kaji_2d.appendix.orthogonal",
        place="appendix, closed form",
        statement="J A is orthogonal to A in the scalar product tr(A Bᵀ).",
        printed="⟨J A, A⟩ = 0",
        verdict=Verdict.CONFIRMED,
        form=lambda a: J @ a,
        cases=lambda: [a for a, _ in _pairs()] + [b for _, b in _pairs()],
        deviation=_orthogonal,
        copies=(Copy("J A J for J A", lambda a: J @ a @ J), Copy("(0 1; 1 0) for J", lambda a: abs(J) @ a)),
    ),
    Claim(
        id="kaji_2d.appendix.expansion",
        place="appendix, closed form, second line",
        statement="The square of (x I + y J) A - B, multiplied out.",
        printed="|(x I + y J) A - B|² = x² |A|² - 2 x ⟨A, B⟩ + y² |A|² - 2 y ⟨J A, B⟩ + |B|²",
        verdict=Verdict.CONFIRMED,
        form=_expanded(),
        cases=_pairs_with_numbers,
        deviation=equals(_combined),
        copies=(Copy("y for 2 y", _expanded(factor=1)), Copy("+ for - before 2 y", _expanded(factor=-2))),
    ),
    Claim(
        id="kaji_2d.appendix.completed_squares",
        place="appendix, closed form, third line",
        statement="The same with its squares in x and y completed.",
        printed="|A|² (x - ⟨A, B⟩ / |A|²)² + |A|² (y - ⟨J A, B⟩ / |A|²)² + |B|² - (⟨A, B⟩² + ⟨J A, B⟩²) / |A|²",
        verdict=Verdict.CONFIRMED,
        form=_completed(),
        cases=_pairs_with_numbers,
        deviation=equals(_combined),
        copies=(Copy("Jᵀ for J", _completed(turn=J.T)),),
    ),
    Claim(
        id="kaji_2d.appendix.attained",
        place="appendix, closed form, last step",
        statement="The lower bound is attained, at the x and y that make both squares vanish.",
        printed="x = ⟨A, B⟩ / |A|², y = ⟨J A, B⟩ / |A|²",
        verdict=Verdict.CONFIRMED,
        form=_attained(),
        cases=_pairs,
        deviation=equals(lambda m, a, b: tuple(_best(m, a, b))),
        copies=(Copy("Jᵀ for J", _attained(turn=J.T)),),
    ),
    Claim(
        id="kaji_2d.appendix.last_equality",
        place="appendix, closed form, last line",
        statement="The two squared scalar products are the squared norm and twice the determinant of B Aᵀ.",
        printed="⟨A, B⟩² + ⟨J A, B⟩² = |B Aᵀ|² + 2 det(B Aᵀ)",
        verdict=Verdict.CONFIRMED,
        form=_norm_and_determinant(),
        cases=_pairs,
        deviation=equals(_two_products),
        copies=(Copy("- for +", _norm_and_determinant(sign=-1)),),
    ),
    Claim(
        id="kaji_2d.appendix.closed_form",
        place="appendix, closed form for the similarity invariant error function",
        statement="The least distance of B from the similarity images of A has a closed form.",
        printed="min |s R_δ A - B|² = |B|² - (|B Aᵀ|² + 2 det(B Aᵀ)) / |A|²",
        verdict=Verdict.CONFIRMED,
        form=_closed(),
        cases=_pairs,
        deviation=equals(least),
        copies=(
            Copy("det(B Aᵀ) for 2 det(B Aᵀ)", _closed(doubled=1)),
            Copy("- for + before 2 det(B Aᵀ)", _closed(doubled=-2)),
            Copy("Bᵀ A for B Aᵀ", _closed(transposed=True)),
        ),
        losses=(
            Loss(
                where="B next to a similarity image of A (the error 5e-19 of maps of size 1)",
                formula=_closed(),
                truth=least,
                at=([[1.0, 0.0], [0.0, 1.0]], [[1.0, 0.0], [0.0, 1.000000001]]),
                digits=16,
            ),
            Loss(
                where="the same, a thousandth apart",
                formula=_closed(),
                truth=least,
                at=([[1.0, 0.25], [0.0, 1.0]], [[0.7, 0.175], [0.001, 0.7]]),
                digits=6,
            ),
        ),
        remark="Near its zeros, where it is used, take |B - (x I + y J) A|² with the best x and y: no digit is lost.",
    ),
)
"""Equation 4 and its closed form."""
