"""Appendix A.1.3: the proof of Lemma 1, that the interpolation of one component, or of A S, is steady."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.bansal_tatu.appendix_cases import components, embedded, scaling
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, mp
from affinecert.reference._groups import RIGID, SHEARS
from affinecert.reference._li_hao import Group
from affinecert.reference._matrices import Array, Number, homogeneous, identity

Components = tuple[Array, Array, Number]


def _power(group: Group, matrix: Array, t: Number) -> Array:
    """exp(t log M)."""
    return group.exp(mp, group.log(mp, matrix) * t)


def _linear(_: Group, matrix: Array, t: Number) -> Array:
    mixed: Array = identity(mp, len(matrix)) * (1 - t) + matrix * t
    return mixed


def _apart(group: Group, matrix: Array, t: Number) -> Array:
    """The translation of a rigid motion in a straight line, apart from its rotation."""
    found = _power(group, matrix, t)
    if len(matrix) == 4:
        found[:3, 3] = matrix[:3, 3] * t
    return found


def _members() -> list[tuple[Group, Array]]:
    parts = components("powers", 8)
    return [pair for e, a, _ in parts for pair in ((SHEARS, a), (RIGID, e))]


def _not_power(form: Any, case: tuple[Group, Array]) -> Number:
    """How far the values at 1/2, 1/3 and -1 are from roots and inverse, that at 2 from the square."""
    group, matrix = case
    half, third, inverse, square = (form(group, matrix, mp.mpf(t) / 6) for t in (3, 2, -6, 12))
    one = identity(mp, len(matrix))
    powers = (half @ half, third @ third @ third, square, inverse @ matrix)
    return distance(powers, (matrix, matrix, matrix @ matrix, one))


def interpolated(parts: Components, t: Number, power: Any = _power) -> Array:
    """T_t = exp(t log A) exp(t log S) exp(t log E), equation 2."""
    e, a, s = parts
    product: Array = embedded(mp, power(SHEARS, a, t)) @ scaling(mp, s**t) @ power(RIGID, e, t)
    return product


def _single() -> list[Components]:
    """Components of which all but one are trivial."""
    four, three = identity(mp, 4), identity(mp, 3)
    parts = components("powers", 7)[3:]
    return [one for e, a, s in parts for one in ((e, three, mp.one), (four, a, mp.one), (four, three, s))]


def _sheared() -> list[Components]:
    return [(identity(mp, 4), a, s) for _, a, s in components("powers", 7)]


def _unsteady(form: Any, parts: Components) -> Number:
    """How far T_t T_u is from T_(t + u), and T_1 from T."""
    times = (mp.mpf(1) / 4, mp.mpf(1) / 3)
    first, second, both, whole = (form(parts, t) for t in (*times, sum(times), mp.one))
    e, a, s = parts
    return distance((first @ second, whole), (both, embedded(mp, a) @ scaling(mp, s) @ e))


def _pair(parts: Components) -> tuple[Array, Array]:
    return embedded(mp, parts[1]), scaling(mp, parts[2])


def _stretched(parts: Components) -> tuple[Array, Array]:
    """A, and a scaling along the first axis only."""
    stretch = identity(mp, 3)
    stretch[0, 0] = parts[2]
    return embedded(mp, parts[1]), embedded(mp, stretch)


def _commutator(pair: Any, parts: Components) -> Number:
    first, second = pair(parts)
    return distance(first @ second, second @ first)


def _of_pair(pair: Any) -> Any:
    """exp(t log A) exp(t log S), of the pair with which A and S are replaced."""

    def powers(parts: Components, t: Number) -> Array:
        return interpolated(pair(parts), t)

    return powers


def _rooted(form: Any, parts: Components) -> Number:
    """How far the k-th power of the value at 1/k is from the value at 1, which is the product."""
    whole, half, third = (form(parts, mp.one / k) for k in (1, 2, 3))
    return distance((half @ half, third @ third @ third), (whole, whole))


def _moved(parts: Components) -> Components:
    """A translation by (1, 0, 0) with them."""
    one = identity(mp, 3)
    return homogeneous(mp, one, one[0]), *parts[1:]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.3.powers",
        place="appendix A.1.3",
        statement="exp(t log M) is the power M^t: its values at 1/k are roots, those at whole numbers powers.",
        printed="exp(t log M) = exp(log(M^t)) = M^t",
        verdict=Verdict.CONFIRMED,
        form=_power,
        cases=_members,
        deviation=_not_power,
        copies=(
            Copy("(1 - t) I + t M", _linear),
            Copy("t² for t", lambda group, matrix, t: _power(group, matrix, t * t)),
        ),
        remark="Without exp on both sides, log(M^t) = t log M holds for |t| θ < π only, θ the angle of a rotation.",
    ),
    Claim(
        id="bansal_tatu.A.1.3.single",
        place="appendix A.1.3; Lemma 1",
        statement="If T is a shear A, a scaling S or a rigid motion E alone, T_t is T^t.",
        printed="T_t = T^t",
        verdict=Verdict.CONFIRMED,
        form=interpolated,
        cases=_single,
        deviation=_unsteady,
        copies=(
            Copy("the entries in straight lines", lambda parts, t: interpolated(parts, t, _linear)),
            Copy("the translation in a straight line", lambda parts, t: interpolated(parts, t, _apart)),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.3.commute",
        place="appendix A.1.3; again in A.1.8",
        statement="A and S commute, as 4x4 matrices.",
        verdict=Verdict.CONFIRMED,
        form=_pair,
        cases=_sheared,
        deviation=_commutator,
        copies=(
            Copy("S scales the first axis only", _stretched),
            Copy("A moves by (1, 0, 0) too", lambda parts: (_pair(parts)[0] @ _moved(parts)[0], _pair(parts)[1])),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.3.shear_and_scale",
        place="appendix A.1.3; Lemma 1",
        statement="If T = A S, then T_t is T^t.",
        printed="T_t = exp(t log A) exp(t log S) = A^t S^t = (A S)^t",
        verdict=Verdict.CONFIRMED,
        form=_of_pair(lambda parts: parts),
        cases=_sheared,
        deviation=_rooted,
        copies=(
            Copy("T = A S E with a translation E", _of_pair(_moved)),
            Copy("t² for t in S", lambda parts, t: interpolated((*parts[:2], parts[2] ** t), t)),
        ),
        remark="S and a rotation commute as well: T = S E is steady, too, where E does not translate.",
    ),
)
