"""Section 4.3: which of the logarithms of a rotation is meant."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.precision import difference, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, cross_matrix, identity, norm


def _whole_turns(pair: tuple[Array, Array], _: None) -> int:
    """Whether two different rotation vectors are not of one rotation, the identity."""
    a, b = (definitions.exponential(mp, cross_matrix(mp, each)) for each in pair)
    return int(max(difference(a, identity(mp, 3)), difference(b, identity(mp, 3))) > 1e-50 or not difference(*pair))


def _nearest(m: Context, rotation: Array, near: Array) -> Array:
    """Theta n + 2 pi k n, k the integer nearest to (near . n - theta) / 2 pi."""
    omega = so3.log(m, rotation)
    theta = norm(m, omega)
    axis = omega / theta
    k = m.nint((axis @ near - theta) / (2 * m.pi))
    found: Array = axis * (theta + 2 * m.pi * k)
    return found


def _nearest_by_length(m: Context, rotation: Array, near: Array) -> Array:
    """The same with the length of the given vector for its part along the axis."""
    omega = so3.log(m, rotation)
    theta = norm(m, omega)
    k = m.nint((norm(m, near) - theta) / (2 * m.pi))
    found: Array = omega / theta * (theta + 2 * m.pi * k)
    return found


def _not_nearest(form: Any, case: tuple[Array, Array]) -> Number:
    """How much further a logarithm is from a given vector than another one of the same rotation."""
    rotation, near = case
    omega = so3.log(mp, rotation)
    axis = omega / norm(mp, omega)
    candidates = [norm(mp, omega + axis * (2 * mp.pi * k) - near) for k in range(-6, 7)]
    return abs(norm(mp, form(mp, rotation, near) - near) - min(candidates))


def _goals() -> list[tuple[Array, Array]]:
    turns = rotations("of which a logarithm is asked", 8)
    return list(zip(turns, arrays("goals", 8, (3,), -9, 9), strict=True))


def _untracked(follow: Any, step: Number) -> Number:
    """How far the logarithm, continued along two turns in equal steps of an angle, is from the angle turned by."""
    axis = exactly([1, 2, 2]) / 3
    omega = axis * step
    count = int(mp.floor(4 * mp.pi / step))
    for k in range(2, count + 1):
        omega = follow(mp, so3.exp(mp, axis * (step * k)), omega)
    return difference(omega, axis * (step * count))


def _lifted(angle: Number, corner: bool) -> tuple[Array, ...]:
    """A path of rotations that turns by an angle about x and from there back about x, or about y if at a corner."""
    fine = mp.mpf(1) / 64
    ahead = [exactly([1, 0, 0]) * (angle - k * fine) for k in range(8, 0, -1)]
    end = so3.exp(mp, exactly([1, 0, 0]) * angle)
    back = [end @ so3.exp(mp, exactly([0, 1, 0] if corner else [1, 0, 0]) * (k * fine)) for k in range(1, 9)]
    return (ahead[0], *(so3.exp(mp, each) for each in ahead), *back)


def _jumps(follow: Any, path: tuple[Array, ...]) -> int:
    """Whether the continued logarithm jumps along a path of small steps."""
    omega = path[0]
    for rotation in path[1:]:
        found = follow(mp, rotation, omega)
        if difference(found, omega) > 1:
            return 1
        omega = found
    return 0


def _principal_vector(m: Context, rotation: Array, _: Array) -> Array:
    return so3.log(m, rotation)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.4.3.whole_turns",
        place="section 4.3, second paragraph",
        statement="The parameters tell a whole turn about x from the identity and from a whole turn about y.",
        verdict=Verdict.CONFIRMED,
        form=(exactly([1, 0, 0]) * (2 * mp.pi), exactly([0, 1, 0]) * (2 * mp.pi)),
        cases=lambda: [None],
        deviation=_whole_turns,
        copies=(
            Copy("half turns", (exactly([1, 0, 0]) * mp.pi, exactly([0, 1, 0]) * mp.pi)),
            Copy("the same turn", (exactly([1, 0, 0]) * (2 * mp.pi),) * 2),
        ),
    ),
    Claim(
        id="kaji_ochiai.4.3.closest",
        place="section 4.3, Algorithm 1",
        statement="The logarithm (θ + 2πk) n with k nearest to (X'·n - θ) / 2π is the one closest to X'.",
        printed="Algorithm 1 computes the logarithm of R which is closest to a given X'",
        verdict=Verdict.CONFIRMED,
        form=_nearest,
        cases=_goals,
        deviation=_not_nearest,
        copies=(Copy("the length of X' for X'·n", _nearest_by_length),),
        remark="The listing is lost; this is what it has to compute. At R = I every axis will do: that of X'.",
    ),
    Claim(
        id="kaji_ochiai.4.3.algorithm_1",
        place="section 4.3, Algorithm 1",
        statement="The steps of Algorithm 1.",
        verdict=Verdict.UNCHECKABLE,
        reason="The listing is missing in the copy of the paper at hand.",
    ),
    Claim(
        id="kaji_ochiai.4.3.tracking",
        place="section 4.3, turns by more than 2π",
        statement="The closest logarithm, asked for step by step, tracks a turn by more than 2π about an axis.",
        verdict=Verdict.BOUND,
        domain="steps by less than π; a longer step is taken for one backwards",
        form=_nearest,
        cases=lambda: [mp.mpf(each) for each in (0.5, 1, 2.5, 3.125)],
        outside=lambda: [mp.mpf(each) for each in (3.1875, 3.5, 4)],
        deviation=_untracked,
        copies=(Copy("the principal logarithm", _principal_vector),),
    ),
    Claim(
        id="kaji_ochiai.4.3.continuity",
        place="section 4.2, last paragraph; section 4.3",
        statement="Continuity gives a choice of the logarithm along every path of rotations.",
        printed="If we impose continuity, we will have one explicit choice",
        verdict=Verdict.BOUND,
        domain="paths along which the logarithm never is 2π long, 4π, ...; from there it continues along its own axis "
        "only, and a path that leaves the identity about another axis has no continuous logarithm",
        form=_nearest,
        cases=lambda: [
            _lifted(angle, corner)
            for angle, corner in (
                (mp.one, True),
                (mp.pi, True),
                (mp.mpf(4), True),
                (2 * mp.pi - mp.mpf("0.125"), True),
                (2 * mp.pi, False),
            )
        ],
        outside=lambda: [_lifted(2 * mp.pi, True), _lifted(4 * mp.pi, True)],
        deviation=_jumps,
        copies=(Copy("the principal logarithm", _principal_vector),),
        remark="The exponential covers the rotations by balls and shells, not evenly: a deformer that follows twists "
        "has to keep the axis where whole turns are passed.",
    ),
)
