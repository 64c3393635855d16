"""Appendix A.1.7: the proof of Lemma 5, that the way back is the way there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import (
    CANONICAL,
    TIMES,
    components,
    embedded,
    rigid,
    tetrahedra,
)
from affinecert.properties.claims.bansal_tatu.steadiness_proof import interpolated
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference import affine_lie, so3
from affinecert.reference._groups import RIGID, SHEARS
from affinecert.reference._li_hao import Group
from affinecert.reference._matrices import Array, Number, cross_matrix, homogeneous, scalar, tangent
from affinecert.reference.shear import matrix

Pair = tuple[Group, Array, Array]
AXES = tuple(exactly(axis) / 5 for axis in ([5, 0, 0], [0, 3, 4], [-3, 0, 4]))
NEAR = mp.mpf(2) ** -40
HALF_TURNS = tuple(
    exactly(rows)
    for rows in (
        [[1, 0, 0], [0, -1, 0], [0, 0, -1]],
        [[-1, 0, 0], [0, 0, 1], [0, 1, 0]],
        [[0, 0, -1], [0, -1, 0], [-1, 0, 0]],
    )
)
DOMAIN = "the rotation of p⁻¹q is by less than π"
AT_PI = "At π exactly R⁻¹ = R: whatever is chosen for log(R), log(R⁻¹) is the same, and not -log(R)."


def _generators() -> list[tuple[Array, Number]]:
    """Logarithms of shears and of rigid motions, with times."""
    shears = [matrix(mp, alpha, mp.zero) for alpha in arrays("shears", 3, (5,), -1, 1)]
    twists = [tangent(mp, cross_matrix(mp, x[:3]), x[3:]) for x in arrays("twists", 3, (6,), -1, 1)]
    return [(x, t) for x, t in zip([*shears, *twists], [*TIMES, *TIMES], strict=True)]


def _split(sign: int = -1) -> Any:
    """exp(X) exp(-t X)."""
    return lambda m, x, t: definitions.exponential(m, x) @ definitions.exponential(m, sign * t * x)


def _pairs() -> list[Pair]:
    """Shears; rigid motions that turn by less than π from one to the other, some by nearly that."""
    parts = components("ends", 8)
    shears = [(SHEARS, p[1], q[1]) for p, q in zip(parts, parts[3:], strict=False)]
    turns = [mp.mpf(1), mp.mpf(3), mp.pi - NEAR]
    return [*shears, *_turned(turns)]


def _turned(angles: list[Number]) -> list[Pair]:
    starts = [e for e, _, _ in components("ends", 6)[3:]]
    shift = exactly([1, 2, -1])
    return [(RIGID, e, e @ rigid(mp, axis * angle, shift)) for angle, axis, e in zip(angles, AXES, starts, strict=True)]


def _half_turned() -> list[Pair]:
    return _turned([mp.pi] * 3)


def _minus_log(sign: int = -1, *, right: bool = False) -> Any:
    """-log(p⁻¹ q), which is said to be log(q⁻¹ p); of q p⁻¹ if ``right``."""

    def said(group: Group, p: Array, q: Array) -> Array:
        inverse = group.inverse(mp, p)
        logarithm: Array = sign * group.log(mp, q @ inverse if right else inverse @ q)
        return logarithm

    return said


def _wrong_log(form: Any, case: Pair) -> Number:
    group, p, q = case
    return distance(form(*case), group.log(mp, group.inverse(mp, q) @ p))


def _geodesic(group: Group, p: Array, q: Array, t: Number) -> Array:
    """The curve p exp(t log(p⁻¹ q))."""
    curve: Array = p @ group.exp(mp, group.log(mp, group.inverse(mp, p) @ q) * t)
    return curve


def _eased(group: Group, p: Array, q: Array, t: Number) -> Array:
    return _geodesic(group, p, q, t * t)


def _from_identity(group: Group, p: Array, q: Array, t: Number) -> Array:
    """The power p^(1 - t) times the power q^t."""
    curve: Array = group.exp(mp, group.log(mp, p) * (1 - t)) @ group.exp(mp, group.log(mp, q) * t)
    return curve


def _irreversible(form: Any, case: Pair) -> Number:
    group, p, q = case
    return max(distance(form(group, q, p, 1 - t), form(group, p, q, t)) for t in TIMES[1:])


def _solids() -> list[tuple[Array, Array]]:
    """Tetrahedra; the last ones turned by nearly half a turn, and sheared."""
    found = list(zip(tetrahedra("ends", 4), tetrahedra("more ends", 7)[3:], strict=True))
    return [*found, *_turned_solids([so3.exp(mp, axis * (mp.pi - NEAR)) for axis in AXES])]


def _turned_solids(turns: Sequence[Array]) -> list[tuple[Array, Array]]:
    """Tetrahedra with others whose aligning rotations differ by these: sheared as aligned, then turned."""
    shears = [a for _, a, _ in components("ends", 6)[3:]]
    return [
        (solid, homogeneous(mp, turn, exactly([1, 0, 2])) @ _reshaped(solid, a))
        for solid, turn, a in zip(tetrahedra("ends", 3), turns, shears, strict=True)
    ]


def _reshaped(solid: Array, shear_matrix: Array) -> Array:
    e, _, _ = affine_lie.represent(mp, solid[:3].T, CANONICAL[:3].T)
    reshaped: Array = RIGID.inverse(mp, e) @ embedded(mp, shear_matrix) @ e @ solid
    return reshaped


def _between(source: Array, target: Array, t: Number) -> Array:
    """Equation 4, as vertices in rows."""
    return affine_lie.interpolate_tetrahedra(mp, source[:3].T, target[:3].T, scalar(t))


def _by_map(source: Array, target: Array, t: Number) -> Array:
    """The source moved by T_t of equation 2, T the map from source to target."""
    e, a, s = affine_lie.decompose(mp, _affine(source, target))
    vertices: Array = (interpolated((e, a, s[()]), t) @ source)[:3].T
    return vertices


def _affine(source: Array, target: Array) -> Array:
    """The map from source to target, its last row exact."""
    affine: Array = target @ definitions.inverse(mp, source)
    affine[3] = exactly([0, 0, 0, 1])
    return affine


def _irreversible_solids(form: Any, case: tuple[Array, Array]) -> Number:
    source, target = case
    return max(distance(form(target, source, 1 - t), form(source, target, t)) for t in TIMES[1:])


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.7.split",
        place="appendix A.1.7, second line",
        statement="Multiples of one logarithm may be split into factors.",
        printed="exp((1 - t) log(q⁻¹p)) = exp(log(q⁻¹p)) exp(-t log(q⁻¹p))",
        verdict=Verdict.CONFIRMED,
        form=_split(),
        cases=_generators,
        deviation=lambda form, case: distance(form(mp, *case), definitions.exponential(mp, case[0] * (1 - case[1]))),
        copies=(Copy("exp(t X) for exp(-t X)", _split(1)),),
    ),
    Claim(
        id="bansal_tatu.A.1.7.logarithm",
        place="appendix A.1.7, from the second line to the third",
        statement="The logarithm of q⁻¹p is minus that of p⁻¹q.",
        printed="q exp(log(q⁻¹p)) exp(-t log(q⁻¹p)) = p exp(t log(p⁻¹q))",
        verdict=Verdict.BOUND,
        domain=DOMAIN,
        form=_minus_log(),
        cases=_pairs,
        outside=_half_turned,
        deviation=_wrong_log,
        copies=(
            Copy("log(q⁻¹p) = log(p⁻¹q)", _minus_log(1)),
            Copy("q p⁻¹ for p⁻¹q", _minus_log(right=True)),
        ),
        remark=AT_PI,
    ),
    Claim(
        id="bansal_tatu.A.1.7.geodesic",
        place="appendix A.1.7, the chain of equations",
        statement="The geodesic from q to p at 1 - t is the one from p to q at t.",
        printed="q exp((1 - t) log(q⁻¹p)) = p exp(t log(p⁻¹q))",
        verdict=Verdict.BOUND,
        domain=DOMAIN,
        form=_geodesic,
        cases=_pairs,
        outside=_half_turned,
        deviation=_irreversible,
        copies=(Copy("t² for t", _eased), Copy("p^(1 - t) q^t", _from_identity)),
        remark=AT_PI,
    ),
    Claim(
        id="bansal_tatu.A.1.7.reversibility",
        place="appendix A.1.7; Lemma 5",
        statement="The tetrahedron between q and p at 1 - t is the one between p and q at t.",
        printed="Δ_p^q(t) = Δ_q^p(1 - t)",
        verdict=Verdict.BOUND,
        domain="the aligning rotations of p and q are less than π apart",
        form=_between,
        cases=_solids,
        outside=lambda: _turned_solids(HALF_TURNS),
        deviation=_irreversible_solids,
        copies=(Copy("the source moved by T_t of equation 2, T the map from p to q", _by_map),),
        remark="Near π the two ways agree only as long as rounding does not carry the rotation over π.",
    ),
)
