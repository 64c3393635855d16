"""Appendix A.4: affine maps of the plane that have no fixed point, or many: 1 is an eigenvalue of L."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.definitions import eigenvalues, exponential, inverse
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.poses import affines, power
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity, tangent


def _solved(sign: int) -> Any:
    """The q with (L - 1) q = sign t."""

    def point(m: Context, matrix: Array) -> Array:
        moving = matrix[:-1, :-1] - identity(m, len(matrix) - 1)
        found: Array = inverse(m, moving) @ (sign * matrix[:-1, -1])
        return found

    return point


def _moved(form: Any, case: tuple[Array]) -> Number:
    """How far A moves the point."""
    (matrix,) = case
    point = form(mp, matrix)
    return distance(matrix[:-1, :-1] @ point + matrix[:-1, -1], point)


def _with_translations() -> list[tuple[Array]]:
    return [(each,) for each in (affine([[0, -1], [1, 0]], [2, 0]), *affines("fixed", 3), *affines("fixed", 3, 3))]


def _no_one(linear: Array) -> bool:
    """Whether 1 is no eigenvalue, by the eigenvalues themselves."""
    return bool(min(abs(each - 1) for each in eigenvalues(mp, linear)) > mp.mpf(10) ** -20)


def _regular(linear: Array) -> bool:
    return bool(min(abs(each) for each in eigenvalues(mp, linear)) > mp.mpf(10) ** -20)


def _changes_area(linear: Array) -> bool:
    return bool(abs(linear[0, 0] * linear[1, 1] - linear[0, 1] * linear[1, 0] - 1) > mp.mpf(10) ** -20)


def _unique(condition: Callable[[Array], bool], linear: Array) -> int:
    """Whether the condition differs from that (L - 1) q = -t has one solution, for its rows are independent."""
    (a, b), (c, d) = linear - identity(mp, 2)
    return int(condition(linear) != bool(a * d - b * c))


def _small_matrices(*, singular: bool = False) -> list[Array]:
    """Integer matrices of positive determinant, with the eigenvalue 1 if asked for."""
    rows = itertools.product(range(-1, 4), repeat=4)
    kept = [(a, b, c, d) for a, b, c, d in rows if a * d > b * c]
    some = [each for each in kept if not singular or (each[0] - 1) * (each[3] - 1) == each[1] * each[2]]
    return [exactly([[a, b], [c, d]]) for a, b, c, d in (some if singular else some[::9])]


def _kinds(*, shears: bool = True) -> Callable[[Array], tuple[bool, ...]]:
    """Which of the three singular cases a matrix with the eigenvalue 1 is."""

    def kinds(linear: Array) -> tuple[bool, ...]:
        unit, other = not size(linear - identity(mp, 2)), linear.trace() - 1
        return unit, bool(other != 1), shears and not unit and bool(other == 1)

    return kinds


def _not_one_kind(form: Any, linear: Array) -> int:
    """Whether a matrix is of other than one kind, or not what the kind says."""
    unit, simple, shear = form(linear)
    moving = linear - identity(mp, 2)
    nilpotent = not size(moving @ moving)
    right = not (unit and size(moving)) and not (simple and nilpotent) and not (shear and not nilpotent)
    return int(unit + simple + shear != 1 or not right)


def _translating(exponent: int = 1) -> Any:
    def moved(m: Context, matrix: Array, t: Number) -> Array:
        return homogeneous(m, identity(m, 2), t**exponent * matrix[:2, 2])

    return moved


_Frame = tuple[Array, Number, Array]
"""Eigenvectors e_1 and e_2 in columns, the eigenvalue λ of e_2, and the coordinates τ of the translation in them."""


def _frames() -> list[_Frame]:
    frames = [(identity(mp, 2), mp.mpf(2), exactly([1, 1])), (identity(mp, 2), mp.one / 2, exactly([0, 1]))]
    drawn = arrays("frames", 6, (2, 3), -2, 2)
    scales = map(mp.mpf, (0.25, 0.75, 1.5, 3, 5, 0.125))
    frames += [(each[:, :2], scale, each[:, 2]) for each, scale in zip(drawn, scales, strict=True)]
    return [each for each in frames if _no_zero(each[0])]


def _no_zero(basis: Array) -> bool:
    return bool(basis[0, 0] * basis[1, 1] - basis[0, 1] * basis[1, 0])


def _shears() -> list[_Frame]:
    """With L e_2 = e_2 + e_1 for L e_2 = λ e_2."""
    frames = [(identity(mp, 2), mp.one, exactly([0, 1])), (identity(mp, 2), mp.one, exactly([1, 1]))]
    return frames + [(basis, mp.one, moved) for basis, _, moved in _frames()[2:]]


def _linear(frame: _Frame) -> Array:
    basis, scale, _ = frame
    inside = exactly([[1, 1 if scale == 1 else 0], [0, scale]])
    found: Array = basis @ inside @ inverse(mp, basis)
    return found


def _whole(frame: _Frame) -> Array:
    return homogeneous(mp, _linear(frame), frame[0] @ frame[2])


def _timed(frames: list[_Frame]) -> list[tuple[_Frame, Number]]:
    return [(frame, mp.mpf(k - 1) / 3) for k, frame in enumerate(frames)]


def _power_of(frame: _Frame, t: Number) -> Array:
    return power(mp, _whole(frame), t)


def _scaled(exponent: bool = True) -> Any:
    """L^t by λ^t in the direction of e_2; or by 1 + t (λ - 1)."""

    def printed(m: Context, frame: _Frame, t: Number) -> Array:
        basis, scale, _ = frame
        grown = scale**t if exponent else 1 + t * (scale - 1)
        found: Array = basis @ array([[m.one, m.zero], [m.zero, grown]]) @ inverse(m, basis)
        return found

    return printed


def _kept(*places: int) -> Any:
    """The translation of A', which has τ_1 e_1 or τ_2 e_2 of that of A."""

    def translation(frame: _Frame) -> Array:
        basis, _, moved = frame
        kept = array([moved[k] if k in places else mp.zero for k in range(2)])
        found: Array = basis @ kept
        return found

    return translation


def _no_fixed_line(form: Any, frame: _Frame) -> Number:
    """How far A' moves the points of the line where it moves them least; how far A moves them across e_1."""
    basis, scale, moved = frame
    there = inverse(mp, basis) @ form(frame)
    across = there[1] / (1 - scale) if scale != 1 else -there[0]
    worst = mp.zero
    for along in (0, 3):
        coordinates = array([mp.mpf(along), across])
        point = basis @ coordinates
        worst = max(worst, size(_linear(frame) @ point + form(frame) - point))
        if scale != 1:
            whole = inverse(mp, basis) @ (_linear(frame) @ point + basis @ moved - point)
            worst = max(worst, abs(whole[1]), abs(whole[0] - moved[0]))
    return worst


def _displaced(exponent: int = 1, *, scaled: bool = True) -> Any:
    """Exponential scaling about the fixed line, and the displacement t τ_1 e_1."""

    def printed(m: Context, frame: _Frame, t: Number) -> Array:
        basis, scale, moved = frame
        grown = _scaled()(m, frame, t)
        on_line = basis @ array([m.zero, moved[1] / (1 - scale)])
        along = t**exponent * moved[0] * basis[:, 0]
        return homogeneous(m, grown, (on_line - grown @ on_line if scaled else t * moved[1] * basis[:, 1]) + along)

    return printed


def _decomposed(place: int) -> Any:
    """The exponential of A', which keeps one part of the translation, and then the other part at constant speed."""

    def printed(m: Context, frame: _Frame, t: Number) -> Array:
        kept = homogeneous(m, _linear(frame), _kept(place)(frame))
        moving = kept - identity(m, 3)
        generator = moving - moving @ moving / 2  # the series of log A' ends here
        moved = exponential(m, t * tangent(m, generator[:2, :2], generator[:2, 2]))
        found: Array = moved + 0
        found[:2, 2] = found[:2, 2] + t * _kept(1 - place)(frame)
        return found

    return printed


def _translations() -> list[tuple[Array, Number]]:
    moved = arrays("translations", 4, (2,), -3, 3)
    return [(homogeneous(mp, identity(mp, 2), each), mp.mpf(k - 1) / 3) for k, each in enumerate(moved)]


def _as_matrix(m: Context, frame: _Frame, t: Number) -> Array:
    return _power_of(frame, t)


def _as_linear(m: Context, frame: _Frame, t: Number) -> Array:
    found: Array = _power_of(frame, t)[:2, :2]
    return found


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.4.fixed_point",
        place="appendix A.4",
        statement="The equation q = L(oq) + t of the fixed point is (L - 1)(oq) = ot.",
        printed="(L - 1)(oq) = ot",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_solved(1),
        cases=_with_translations,
        deviation=_moved,
        correction=Correction(statement="It is (L - 1)(oq) = -ot, as equation 21 has it.", form=_solved(-1)),
        copies=(Copy("twice the translation", _solved(-2)),),
    ),
    Claim(
        id="rossignac_vinacua.A.4.unique",
        place="appendix A.4",
        statement="A has a unique fixed point if 1 is not an eigenvalue of L, and only then.",
        verdict=Verdict.CONFIRMED,
        form=_no_one,
        cases=_small_matrices,
        deviation=_unique,
        copies=(Copy("0 for 1", _regular), Copy("if the determinant is not 1", _changes_area)),
    ),
    Claim(
        id="rossignac_vinacua.A.4.cases",
        place="appendix A.4",
        statement="If 1 is an eigenvalue, L is 1, or a scaling in one direction, or a shear: one of the three.",
        verdict=Verdict.CONFIRMED,
        form=_kinds(),
        cases=lambda: _small_matrices(singular=True),
        deviation=_not_one_kind,
        copies=(Copy("no shears", _kinds(shears=False)),),
    ),
    Claim(
        id="rossignac_vinacua.A.4.1",
        place="appendix A.4, case 1",
        statement="If L = 1, A^t is the translation by t ot.",
        printed="A^t = [1 | o + t ot]",
        verdict=Verdict.CONFIRMED,
        form=_translating(),
        cases=_translations,
        deviation=equals(power),
        copies=(Copy("t² for t", _translating(2)),),
    ),
    Claim(
        id="rossignac_vinacua.A.4.2.linear",
        place="appendix A.4, case 2",
        statement="If 1 is a simple eigenvalue, L^t is a scaling by λ^t in the direction of e_2.",
        printed="λ^t",
        verdict=Verdict.CONFIRMED,
        form=_scaled(),
        cases=lambda: _timed(_frames()),
        deviation=equals(_as_linear),
        copies=(Copy("1 + t (λ - 1)", _scaled(exponent=False)),),
    ),
    Claim(
        id="rossignac_vinacua.A.4.2.fixed_line",
        place="appendix A.4, case 2",
        statement="A' = [L | o + τ_2 e_2] has a line of fixed points parallel to e_1, which A moves by τ_1 e_1: with "
        "the origin there τ_2 = 0.",
        printed="A' = [L | o + τ_2 e_2]",
        verdict=Verdict.CONFIRMED,
        form=_kept(1),
        cases=_frames,
        deviation=_no_fixed_line,
        copies=(Copy("τ_1 e_1 for τ_2 e_2", _kept(0)), Copy("the whole translation", _kept(0, 1))),
    ),
    Claim(
        id="rossignac_vinacua.A.4.2.motion",
        place="appendix A.4, case 2",
        statement="SAM is an exponential scaling in the direction of e_2 and the displacement t τ_1 e_1.",
        printed="t τ_1 e_1",
        verdict=Verdict.CONFIRMED,
        form=_displaced(),
        cases=lambda: _timed(_frames()),
        deviation=equals(_as_matrix),
        copies=(
            Copy("t² for t", _displaced(2)),
            Copy("τ_2 e_2 at constant speed as well", _displaced(scaled=False)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.A.4.3.fixed_line",
        place="appendix A.4, case 3",
        statement="For a shear with (L - 1) e_2 = e_1, A' = [L | o + τ_2 e_2] again has a fixed line parallel to e_1.",
        printed="constructing A' as in the previous case, we again find a fixed line",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_kept(1),
        cases=_shears,
        deviation=_no_fixed_line,
        correction=Correction(
            statement="A'' = [L | o + τ_1 e_1] has such a line; A' and A move all points by τ_2 across e_1.",
            form=_kept(0),
        ),
        copies=(Copy("the whole translation", _kept(0, 1)),),
        remark="Nor does A map a line parallel to e_1 onto itself, unless τ_2 = 0: points move on parabolas.",
    ),
    Claim(
        id="rossignac_vinacua.A.4.3.motion",
        place="appendix A.4, case 3",
        statement="For a shear A^t is the exponential of A' = [L | o + τ_2 e_2] and a translation t τ_1 e_1.",
        verdict=Verdict.CONFIRMED,
        form=_decomposed(1),
        cases=lambda: _timed(_shears()),
        deviation=equals(_as_matrix),
        copies=(Copy("the exponential of [L | o + τ_1 e_1] and t τ_2 e_2", _decomposed(0)),),
        remark="A' has no fixed point if τ_2 ≠ 0, so that equation 9 does not give its power: A^t = [1 + t N | t ot + "
        "(t² - t)/2 N(ot)], N = L - 1.",
    ),
)
