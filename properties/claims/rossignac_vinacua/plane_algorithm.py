"""Appendix A.5: how the algorithm in the plane selects its case, and what comes of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.definitions import determinant, eigenvalues
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.poses import affines
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array, identity, tangent

_Select = Callable[[Context, Array], str]


def _numbers(m: Context, linear: Array) -> tuple[Number, Number, Number]:
    """r, d_L and s = sqrt(d_L), which is no real number for d_L < 0."""
    r = (linear[0, 0] + linear[1, 1]) / 2
    d = r * r - determinant(linear)
    return r, d, m.sqrt(d)


def _selected(m: Context, linear: Array) -> str:
    """Algorithm 1, line by line."""
    r, d, s = _numbers(m, linear)
    if d < 0:
        return "G1"
    if r > s:
        if r + s != 1 and r - s != 1:
            return "G2"
        return "S1"
    if s == 0 and linear[0, 1] == 0 and linear[1, 0] == 0:
        return "S2"
    return "G3"


def _selected_with_double(m: Context, linear: Array) -> str:
    """Algorithm 1 with a branch before the second line."""
    r, d, _ = _numbers(m, linear)
    return "D" if d == 0 and r > 0 and r != 1 else _selected(m, linear)


def _any_double(m: Context, linear: Array) -> str:
    """S2 without the test of a_12 and a_21."""
    r, d, _ = _numbers(m, linear)
    return "S2" if d == 0 and r < 0 else _selected_with_double(m, linear)


def _larger_only(m: Context, linear: Array) -> str:
    """Without the test of r - s."""
    r, d, s = _numbers(m, linear)
    return "G2" if d > 0 and r > s and r + s != 1 else _selected_with_double(m, linear)


def _sign_of_trace(m: Context, linear: Array) -> str:
    """G3 before G1."""
    return "G3" if linear.trace() <= 0 and size(linear - linear.T) else _selected_with_double(m, linear)


def _logarithm(select: _Select) -> Any:
    """The logarithm of A, (3, 3), by the selected procedure as corrected (see A.3, A.4); None for G3."""

    def printed(m: Context, matrix: Array) -> Array | None:
        linear, translation = matrix[:2, :2], matrix[:2, 2]
        r, d, s = _numbers(m, linear)
        moving, chosen = linear - identity(m, 2), select(m, linear)
        if chosen == "G3":
            return None
        if chosen == "S1":
            return tangent(m, *_singular(m, moving, translation))
        if chosen == "S2":
            c = m.log(-r) * identity(m, 2) + m.pi * array([[0, -1], [1, 0]])
        elif chosen == "D":
            c = m.log(r) * identity(m, 2) + (linear - r * identity(m, 2)) / r
        elif chosen == "G1":
            root = m.sqrt(-d)
            c = _about_r(m, linear, m.atan2(root, r) / root)
        else:
            chi = r / s
            c = _about_r(m, linear, m.log((chi + 1) / (chi - 1)) / 2 / s)
        return tangent(m, c, c @ _inverse(moving) @ translation)

    return printed


def _about_r(m: Context, linear: Array, ratio: Number) -> Array:
    """Equations 13 to 19, a_12 cancelled, for the ratio y / sqrt(d_L)."""
    r = (linear[0, 0] + linear[1, 1]) / 2
    found: Array = m.log(determinant(linear)) / 2 * identity(m, 2) + ratio * (linear - r * identity(m, 2))
    return found


def _inverse(linear: Array) -> Array:
    (a, b), (c, d) = linear.tolist()
    found: Array = array([[d, -b], [-c, a]]) / (a * d - b * c)
    return found


def _singular(m: Context, moving: Array, translation: Array) -> tuple[Array, Array]:
    """S1 by appendix A.4: translation, scaling in one direction, shear."""
    other = moving.trace() + 1
    if other == 1:
        return moving, translation - moving @ translation / 2
    rate = m.log(other) / (other - 1)
    scaled = moving @ translation / (other - 1)
    return rate * moving, translation + (rate - 1) * scaled


def _wrong(form: Any, case: tuple[Array]) -> Number:
    """How far from the logarithm; infinite if there is one and none is told, or the reverse."""
    (matrix,) = case
    found = form(mp, matrix)
    if found is None or not sam.exists(mp, matrix):
        return mp.zero if found is None and not sam.exists(mp, matrix) else mp.inf
    return distance(found, sam.log(mp, matrix))


_LINEARS = (
    [[1, 0], [0, 1]],
    [[2, 0], [0, 1]],
    [[1, 0], [0, 3]],
    [[1, 1], [0, 1]],
    [[2, 0], [0, 2]],
    [[-1, 0], [0, -1]],
    [[0, -1], [1, 0]],
    [[3, 0], [0, 2]],
    [[2, 1], [0, 2]],
    [[1, 1], [-1, 3]],
    [[-2, 0], [0, -2]],
    [[-2, 1], [0, -2]],
    [[-1, 0], [0, -2]],
    [[-3, 1], [1, -1]],
    [[-1, -1], [1, 0]],
    [[-1, -2], [2, -1]],
    [[1, 2], [0, 0.5]],
    [[2, 1], [1, 2]],
)
"""A matrix of each kind: 1 as an eigenvalue, double eigenvalues, negative ones, turns, two of one sign."""


def _all_kinds() -> list[tuple[Array]]:
    return [(affine(each, [1, 2]),) for each in _LINEARS] + [(each,) for each in affines("algorithm", 4)]


def _linears() -> list[tuple[Array]]:
    return [(exactly(each),) for each in _LINEARS]


def _pair(sign: int = 1, halved: bool = True) -> Any:
    def values(m: Context, linear: Array) -> tuple[Number, Number]:
        r, _, s = _numbers(m, linear)
        s = s if halved else 2 * s
        return r + s, sign * (r - s)

    return values


def _no_eigenvalues(form: Any, case: tuple[Array]) -> Number:
    (linear,) = case
    values = sorted(eigenvalues(mp, linear), key=lambda each: (mp.re(each), mp.im(each)))
    told = sorted(form(mp, linear), key=lambda each: (mp.re(each), mp.im(each)))
    # Of a double eigenvalue without two eigenvectors the numerical ones have half of the digits; their mean has all.
    scale = size(linear)
    gaps = [((first - second) / scale) ** 2 for first, second in (told, values)]
    return max(abs(sum(told) - sum(values)) / scale, abs(gaps[0] - gaps[1]))


def _kind(linear: Array) -> str:
    """What the text says of each procedure, by the eigenvalues as the discriminant's sign and the matrix tell them."""
    trace, det = linear.trace(), determinant(linear)
    gap = trace * trace - 4 * det
    if gap < 0:
        return "G1"
    if det - trace + 1 == 0:
        return "S1"
    if trace > 0:
        return "G2"
    return "S2" if not size(linear + mp.sqrt(det) * identity(mp, 2)) else "G3"


def _selects(select: _Select, case: tuple[Array]) -> int:
    return int(select(mp, case[0]) != _kind(case[0]))


def _exchanged(m: Context, linear: Array) -> str:
    """The fourth line before the third: S1 wherever r > s and one of r + s, r - s is other than 1."""
    chosen = _selected(m, linear)
    return {"G2": "S1", "S1": "G2"}.get(chosen, chosen)


def _without_difference(m: Context, linear: Array) -> str:
    r, d, s = _numbers(m, linear)
    return "G2" if d >= 0 and r > s and r + s != 1 else _selected(m, linear)


def _diagonal_only(m: Context, linear: Array) -> str:
    """S2 by a_12 = a_21 = 0 alone."""
    _, d, _ = _numbers(m, linear)
    return "S2" if d >= 0 and linear.trace() < 0 and not linear[0, 1] and not linear[1, 0] else _selected(m, linear)


def _complement(condition: str) -> Any:
    def is_g3(linear: Array) -> bool:
        r, d, s = _numbers(mp, linear)
        scaling = d == 0 and not linear[0, 1] and not linear[1, 0]
        told = {
            "d > 0 and r < s": d > 0 and r < s,
            "d >= 0, r < 0, no scaling": d >= 0 and r < 0 and not scaling,
            "d >= 0, r < 0": d >= 0 and r < 0,
        }
        return bool(told[condition])

    return is_g3


def _no_complement(form: Any, case: tuple[Array]) -> int:
    """Whether it is told wrongly if L has no real logarithm."""
    (linear,) = case
    return int(form(linear) != (not sam.exists(mp, affine(linear, [0, 0]))))


def _count(form: Any, case: tuple[Array]) -> int:
    """Whether the number of fixed points is none of those told: by the ranks of L - 1 and of (L - 1, t)."""
    (matrix,) = case
    moving, moved = matrix[:2, :2] - identity(mp, 2), matrix[:2, 2]
    rank = 2 if determinant(moving) else 1 if size(moving) else 0
    minors = [moving[0, k] * moved[1] - moving[1, k] * moved[0] for k in range(2)]
    augmented = 2 if determinant(moving) or size(minors) else 1 if size(moving) or size(moved) else 0
    number = "none" if augmented > rank else "one" if rank == 2 else "infinitely many"
    return int(number not in form)


def _singular_maps() -> list[tuple[Array]]:
    linears = ([[1, 0], [0, 1]], [[2, 0], [0, 1]], [[1, 1], [0, 1]], [[1, 2], [0, 0.5]])
    return [(affine(each, moved),) for each in linears for moved in ([0, 0], [1, 0], [0, 1])]


def _uncomputed(computed: str, needed: str) -> int:
    return len(set(needed.split()) - set(computed.split()))


def _product(sign: int = 1) -> Any:
    """The printed (r + s)(r - s), or another product."""

    def product(m: Context, linear: Array) -> Number:
        r, _, s = _numbers(m, linear)
        return (r + s) * (r - sign * s)

    return product


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.5.eigenvalues",
        place="appendix A.5",
        statement="With r = trace(L) / 2, d_L = r² - det L and s = sqrt(d_L) the eigenvalues of L are r + s and r - s: "
        "real for d_L >= 0, double for d_L = 0.",
        printed="r + s, r - s",
        verdict=Verdict.CONFIRMED,
        form=_pair(),
        cases=_linears,
        deviation=_no_eigenvalues,
        copies=(Copy("s - r for r - s", _pair(-1)), Copy("2 s for s", _pair(halved=False))),
    ),
    Claim(
        id="rossignac_vinacua.A.5.r_is_not_s",
        place="appendix A.5, G3",
        statement="r = s cannot be, for then an eigenvalue were 0: det L = (r + s)(r - s).",
        verdict=Verdict.CONFIRMED,
        form=_product(),
        cases=_linears,
        deviation=equals(lambda m, linear: determinant(linear)),
        copies=(Copy("(r + s)²", _product(-1)),),
        remark="So r >= s, as the text has it of G2, and r > s, as algorithm 1 has it, are the same.",
    ),
    Claim(
        id="rossignac_vinacua.A.5.selection",
        place="appendix A.5, algorithm 1",
        statement="Algorithm 1 selects what the text says: G1 for complex eigenvalues, S1 if 1 is one, G2 for two "
        "positive ones, S2 for a scaling by a negative factor, G3 for the rest.",
        printed="if (d_L < 0) G1(); else if (r > s) { if (r + s != 1 && r - s != 1) G2(); else S1(); } "
        "else if (s == 0 && a_12 == 0 && a_21 == 0) S2(); else G3();",
        verdict=Verdict.CONFIRMED,
        form=_selected,
        cases=_linears,
        deviation=_selects,
        copies=(
            Copy("without the test of r - s", _without_difference),
            Copy("S1 and G2 exchanged", _exchanged),
            Copy("S2 without the test of s", _diagonal_only),
        ),
        remark="In float64 r + s is hardly ever 1 after rounding: next to it G2 goes on with a fixed point far away.",
    ),
    Claim(
        id="rossignac_vinacua.A.5.algorithm",
        place="appendix A.5, algorithm 1",
        statement="The selected procedures compute the logarithm of A, or tell that there is none.",
        printed="if (d_L < 0) G1(); else if (r > s) { if (r + s != 1 && r - s != 1) G2(); else S1(); } "
        "else if (s == 0 && a_12 == 0 && a_21 == 0) S2(); else G3();",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_logarithm(_selected),
        cases=_all_kinds,
        deviation=_wrong,
        correction=Correction(
            statement="With a branch before the second, if (d_L == 0 && r > 0 && r != 1): C = log r + (L - r) / r.",
            form=_logarithm(_selected_with_double),
        ),
        copies=(
            Copy("S2 without the test of a_12 and a_21", _logarithm(_any_double)),
            Copy("G2 without the test of r - s", _logarithm(_larger_only)),
            Copy("G3, by the trace, before G1", _logarithm(_sign_of_trace)),
        ),
        losses=(
            Loss(
                where="eigenvalues 5 and 1 + 1e-12",
                formula=_logarithm(_selected),
                truth=sam.log,
                at=([[5.0, 0.0, 0.0], [0.0, 1.0 + 1e-12, 1.0], [0.0, 0.0, 1.0]],),
                digits=12,
            ),
            Loss(
                where="a turn by 1e-8 with the growth 1e-8: d_L is 0",
                formula=_logarithm(_selected),
                truth=sam.log,
                at=([[1.0 + 1e-8, -1e-8, 1.0], [1e-8, 1.0 + 1e-8, 1.0], [0.0, 0.0, 1.0]],),
                digits=16,
            ),
        ),
        remark="A double positive eigenvalue other than 1, as of a uniform scaling, goes to G2, where χ = r / 0; "
        "A.2 promises that the algorithm treats d_C = 0. Here G1 has θ in its quadrant, and G2 a_12 cancelled.",
    ),
    Claim(
        id="rossignac_vinacua.A.5.S1",
        place="appendix A.5, S1",
        statement="In the case S1 there may be infinitely many or no fixed points, but not one.",
        verdict=Verdict.CONFIRMED,
        form=("none", "infinitely many"),
        cases=_singular_maps,
        deviation=_count,
        copies=(Copy("none only", ("none",)), Copy("infinitely many only", ("infinitely many",))),
    ),
    Claim(
        id="rossignac_vinacua.A.5.G1",
        place="appendix A.5, G1",
        statement="G1 computes θ, x, c_2, c_3, z and at last c_1 and c_2.",
        printed="compute θ, x, c_2, c_3, z and ultimately c_1 and c_2",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form="θ x c_2 c_3 z c_1 c_2",
        cases=lambda: ["c_1 c_2 c_3 c_4"],
        deviation=_uncomputed,
        correction=Correction(statement="At last c_1 and c_4, by equation 19.", form="θ x c_2 c_3 z c_1 c_4"),
        copies=(Copy("c_3 left out", "θ x c_2 z c_1 c_4"),),
    ),
    Claim(
        id="rossignac_vinacua.A.5.G3",
        place="appendix A.5, G3",
        statement="There is no real logarithm of L just when d_L > 0 and r < s: the complement of all other cases.",
        printed="d_L > 0 and r < s",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_complement("d > 0 and r < s"),
        cases=_linears,
        deviation=_no_complement,
        correction=Correction(
            statement="There is none just when d_L >= 0 and r < 0, except for d_L = a_12 = a_21 = 0.",
            form=_complement("d >= 0, r < 0, no scaling"),
        ),
        copies=(Copy("without the exception", _complement("d >= 0, r < 0")),),
        remark="A double negative eigenvalue with one eigenvector has d_L = 0. Algorithm 1 has it right.",
    ),
)
