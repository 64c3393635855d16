"""Sections 5 to 7: how smooth the motions are, their de Casteljau points, and the examples."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.reference import sim3, so3, splines
from affinecert.reference._matrices import Array, Number, array, homogeneous, norm, scalar

Motion = Callable[[Array, Number], Array]
"""A motion through poses: where it is at a time."""

X, Y, Z = exactly([1, 0, 0]), exactly([0, 1, 0]), exactly([0, 0, 1])
_DIGITS = 220
_STEP = mp.mpf(10) ** -55


def _pose(axis: Array, angle: Number, scale: Any, translation: Sequence[int]) -> Array:
    return homogeneous(mp, so3.exp(mp, axis * angle) * mp.mpf(scale), exactly(list(translation)))


@cache
def _four() -> Array:
    """A_1 to A_4 of section 7."""
    with mp.workdps(_DIGITS):
        third = 2 * mp.pi / 3
        return array(
            [
                _pose(X, third, 1, (-3, 0, -3)),
                _pose(X, 2 * third, 1.5, (3, 3, 2)),
                _pose(Y, mp.zero, 1, (-3, 3, 3)),
                _pose(Z, -third / 2, 1.5, (4, 0, -3)),
            ]
        )


@cache
def _screw(radius: int = 0) -> Array:
    """The ten bodies of the screw motion; with a radius they move off the axis too."""
    with mp.workdps(_DIGITS):
        third = 2 * mp.pi / 3
        return array(
            [_pose(Z, k * third, 1.2 if k in (3, 4) else 1.5, (radius * (k % 2), 0, 2 * k)) for k in range(10)]
        )


@cache
def _turns(move: int) -> Array:
    """Turns by 2, 4 and 5 about one axis, the second one moved across it."""
    with mp.workdps(_DIGITS):
        return array([_pose(Z, mp.mpf(angle), 1, (move * (angle == 4), 0, 0)) for angle in (2, 4, 5)])


def printed_motion(poses: Array, t: Number) -> Array:
    """Exp of the spliced spline through the logarithms of strategy 1."""
    return splines.motion(mp, poses, scalar(t))


def _smooth(poses: Array, t: Number) -> Array:
    return splines.smooth_motion(mp, poses, scalar(t))


def _by_principal_logarithms(poses: Array, t: Number) -> Array:
    return splines.principal_motion(mp, poses, scalar(t))


def _junctions(poses: Array) -> list[int]:
    _, lengths = splines.select_logarithms(mp, poses)
    return [int(time) for time in np.cumsum([max(int(n), 3) - 1 for n in lengths])[:-1]]


def _limits(curve: Callable[[Number], Array], time: int, side: int) -> tuple[Array, Array, Array]:
    """The value of a curve and its first two derivatives, from before (side -1) or behind."""
    values = [curve(time + side * _STEP * (k + _STEP)) for k in range(4)]
    first = (4 * values[1] - 3 * values[0] - values[2]) / (2 * side * _STEP)
    second = (2 * values[0] - 5 * values[1] + 4 * values[2] - values[3]) / _STEP**2
    return values[0], first, second


def _jumps(curve: Callable[[Number], Array], time: int) -> list[Number]:
    """The jumps of the value and the first two derivatives, relative to their size before."""
    sides = [_limits(curve, time, side) for side in (-1, 1)]
    return [difference(before, behind) / (size(before) or 1) for before, behind in zip(*sides, strict=True)]


def _not_smooth(form: Motion, poses: Array) -> Number:
    """The largest jump of the velocity and the acceleration at a junction."""
    with mp.workdps(_DIGITS):
        return max((max(_jumps(lambda t: form(poses, t), time)[1:]) for time in _junctions(poses)), default=mp.zero)


def _not_continuous(form: Motion, poses: Array) -> Number:
    with mp.workdps(_DIGITS):
        return max((_jumps(lambda t: form(poses, t), time)[0] for time in _junctions(poses)), default=mp.zero)


def _velocities() -> dict[str, Any]:
    with mp.workdps(_DIGITS):
        before, behind = (_limits(lambda t: printed_motion(_four(), t), 2, side)[1] for side in (-1, 1))
        return {
            "velocity of the origin of A_2 before": before[:3, 3].astype(float),
            "behind": behind[:3, 3].astype(float),
            "jump of the velocity of the matrix": float(norm(mp, (before - behind).flat)),
            "velocity of the matrix before": float(norm(mp, before.flat)),
        }


def _with_kept_moves(poses: Array, t: Number) -> Array:
    """The same but for the logarithm that each later segment starts with, whose v is that of the one before."""
    points, lengths = splines.select_logarithms(mp, poses)
    points = points.copy()
    for start in np.cumsum([int(n) for n in lengths])[:-1]:
        points[start, 3:6] = points[start - 1, 3:6]
    return sim3.exp(mp, splines.evaluate(mp, points, lengths, scalar(t)))


def _trajectory_jump(form: Motion, point: Array) -> Number:
    """The largest jump of the velocity and acceleration of a point of the body at A_2."""
    place = np.append(point, mp.one)
    with mp.workdps(_DIGITS):
        return max(_jumps(lambda t: form(_four(), t) @ place, 2)[1:])


def _apart(poses: Array, t: Number) -> Array:
    """The splines through the logarithms of each sequence by itself, with no second derivative at its ends."""
    points, lengths = splines.select_logarithms(mp, poses)
    start, begin = 0, 0
    for length in map(int, lengths):
        time = max(length, 3) - 1
        if t < begin + time or start + length == len(points):
            own = points[start : start + length]
            return sim3.exp(mp, splines.evaluate(mp, own, array([mp.mpf(length)]), scalar(t - begin)))
        start, begin = start + length, begin + time
    raise ValueError("no sequence")


def _passes_smoothly(form: Motion, poses: Array) -> int:
    """0 if the motion is continuous at A_2, and its velocity jumps there by a tenth at least."""
    with mp.workdps(_DIGITS):
        place, velocity, _ = _jumps(lambda t: form(poses, t), 2)
    return 0 if place < mp.mpf(10) ** -50 and velocity > mp.mpf(1) / 10 else 1


def _angle(pose: Array) -> Number:
    return norm(mp, sim3.log(mp, pose)[:3])


def _right_way(form: Any, poses: Array) -> int:
    """0 if the rotation from A_1 to A_2 comes near to the identity, and nowhere near to a half turn."""
    motion, duration = form
    angles = [_angle(motion(poses, duration * mp.mpf(k) / 16)) for k in range(17)]
    return 0 if min(angles) < mp.mpf(1) / 2 and max(angles) < mp.mpf("2.2") else 1


def _turned_forward(form: Motion, poses: Array) -> int:
    """0 if a motion about the z-axis turns back somewhere between its first four bodies."""
    times = [mp.mpf(k) / 8 for k in range(25)]
    steps = [before[:2, :2].T @ then[:2, :2] for before, then in pairwise(form(poses, t) for t in times)]
    return 0 if any(step[1, 0] < 0 for step in steps) else 1


def _turn(form: int, poses: Array) -> Number:
    """The angle of the pose of that number."""
    return _angle(poses[form - 1])


def _segments_miss(form: tuple[int, ...], poses: Array) -> int:
    _, lengths = splines.select_logarithms(mp, poses)
    return int(tuple(int(n) for n in lengths) != form)


def _polygons() -> list[tuple[Array, Number]]:
    return [(polygon, mp.mpf(k + 1) / 5) for k, polygon in enumerate(arrays("polygons", 4, (4, 7), -3, 3))]


def _subdivided(polygon: Array, t: Number, last: Number | None = None) -> list[Array]:
    """De Casteljau's scheme, level by level; the last level with another number if so said."""
    levels = [polygon]
    for level in range(3):
        s = t if last is None or level < 2 else last
        levels.append((1 - s) * levels[-1][:-1] + s * levels[-1][1:])
    return levels


def _de_casteljau(polygon: Array, t: Number) -> Array:
    point: Array = _subdivided(polygon, t)[3][0]
    return point


def _bernstein(polygon: Array, t: Number) -> Array:
    a, b, c, d = polygon
    point: Array = a * (1 - t) ** 3 + 3 * b * t * (1 - t) ** 2 + 3 * c * t**2 * (1 - t) + d * t**3
    return point


def _polygon_misses(form: Any, case: tuple[Array, Number]) -> Number:
    return difference(form(*case), _bernstein(*case))


def _halves(polygon: Array) -> list[Array]:
    """The control polygons of both halves."""
    levels = _subdivided(polygon, mp.mpf(1) / 2)
    return [array([level[0] for level in levels]), array([level[-1] for level in reversed(levels)])]


def _bend(polygon: Array) -> Number:
    """The largest second difference of a polygon, which bounds how far it is from its curve."""
    return size(polygon[:-2] - 2 * polygon[1:-1] + polygon[2:])


def _far(form: Number, case: tuple[Array, Number]) -> Number:
    """By how much more than the factor given the polygons of the halves are bent."""
    polygon, _ = case
    return max(max(map(_bend, _halves(polygon))) - form * _bend(polygon), mp.zero)


def _conditions(lengths: tuple[int, ...]) -> Any:
    """The conditions on the coefficients of cubics, rows of numbers, with no point inserted in segments of two.

    Values at both ends of each span, continuous derivatives from span to span, and natural ends.
    """
    count = sum(length - 1 for length in lengths)
    place = np.eye(4 * count).reshape(4 * count, count, 4)
    coefficients = place.transpose(1, 2, 0)
    rows: list[Any] = []
    for span, (a, b, c, d) in enumerate(coefficients):
        rows += [a, a + b + c + d]
        if span:
            _, b0, c0, d0 = coefficients[span - 1]
            rows += [b0 + 2 * c0 + 3 * d0 - b, 2 * c0 + 6 * d0 - 2 * c]
    first, last = coefficients[0], coefficients[-1]
    return np.array([*rows, 2 * first[2], 2 * last[2] + 6 * last[3]])


def _solvable_misses(form: Any, lengths: tuple[int, ...]) -> int:
    """Whether it is told wrongly that the conditions on a spline have one solution."""
    conditions = _conditions(lengths)
    rank = np.linalg.matrix_rank(conditions)
    return int(form(lengths) != bool(rank == len(conditions) == conditions.shape[1]))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.continuous",
        place="section 5, and abstract",
        statement="The exponential removes the jumps of the spliced spline: e^{c(t)} is continuous.",
        printed="Since the exponential map removes the discontinuities",
        verdict=Verdict.CONFIRMED,
        form=printed_motion,
        cases=lambda: [_turns(1), _four(), _screw()],
        deviation=_not_continuous,
        copies=(Copy("v of Y kept for X where a sequence starts", _with_kept_moves),),
    ),
    Claim(
        id="gallier.5.twice_differentiable",
        place="abstract, section 1 and section 5",
        statement="As the first and second derivatives of the spliced spline c agree at the jumps, e^{c(t)} is C².",
        printed="in the end, we obtain C² continuous interpolating splines in SIM(3)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=printed_motion,
        cases=lambda: [_turns(0), _turns(1), _four()],
        deviation=_not_smooth,
        correction=Correction(
            statement="It is C⁰. It is C² if behind a jump from Y to X the spline has the derivatives that φ∘c has, φ "
            "the map from logarithms near Y to those near X with the same exponential (splines.smooth_motion).",
            form=_smooth,
        ),
        copies=(
            Copy("half of the difference made up", lambda poses, t: (_smooth(poses, t) + printed_motion(poses, t)) / 2),
        ),
        numbers=_velocities,
        remark="The derivative of exp at Y is not that at X. Rotations about one axis with translations along it, such "
        "as screw motions, are the exception: there φ is a translation.",
    ),
    Claim(
        id="gallier.5.average",
        place="section 5 and section 6",
        statement="A sequence of two logarithms needs a third point, their average, to be interpolated by a spline.",
        printed="in order to be able to do spline interpolation, we insert the average of X_i and Y_{i+1} as a third "
        "data point",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=lambda lengths: 2 not in lengths,
        cases=lambda: [(3,), (4, 3), (2,), (2, 3), (3, 2, 2)],
        deviation=_solvable_misses,
        correction=Correction(
            statement="The conditions determine the spline without it: one cubic between the two points, with both "
            "derivatives continuous at its junctions.",
            form=lambda lengths: True,
        ),
        copies=(Copy("a sequence of two by itself only", lambda lengths: 2 not in lengths or lengths == (2,)),),
        remark="The de Boor points of section 8, one for each data point and spans of three kinds, do need it. With it "
        "the way between the two poses takes the time 2.",
    ),
    Claim(
        id="gallier.6.de_casteljau",
        place="section 6, the third stage",
        statement="Points of the cubics can be had by Bernstein polynomials or by de Casteljau's algorithm in R^7.",
        verdict=Verdict.CONFIRMED,
        form=_de_casteljau,
        cases=_polygons,
        deviation=_polygon_misses,
        copies=(Copy("1-t for t in the last step", lambda polygon, t: _subdivided(polygon, t, 1 - t)[3][0]),),
    ),
    Claim(
        id="gallier.6.close",
        place="section 6, the third stage",
        statement="The intermediate control points are close to the curve: halving a cubic makes the second "
        "differences of its control polygons a quarter at most.",
        verdict=Verdict.CONFIRMED,
        form=mp.mpf(1) / 4,
        cases=_polygons,
        deviation=_far,
        copies=(Copy("a fifth", mp.mpf(1) / 5),),
        remark="The factor is ours. The points are in R^7: it is their exponentials that are close to the motion.",
    ),
    Claim(
        id="gallier.6.faster",
        place="section 6, the third stage",
        statement="De Casteljau's algorithm with its intermediate points appears to be faster than Bernstein "
        "polynomials.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement on the time that their programs took, without numbers",
    ),
    Claim(
        id="gallier.7.first_examples",
        place="section 7, before figure 4",
        statement="The first examples, figures 1 to 3.",
        verdict=Verdict.UNCHECKABLE,
        reason="neither text nor figures are in the copy at hand",
    ),
    Claim(
        id="gallier.7.unturned",
        place="section 7, the four transformations",
        statement="The rotation part of A_2 is the identity.",
        printed="Observe that the rotation part of A_2 is the identity rotation.",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=2,
        cases=lambda: [_four()],
        deviation=_turn,
        correction=Correction(statement="That of A_3 is; A_2 is turned by 4π/3.", form=3),
        copies=(Copy("A_4", 4),),
    ),
    Claim(
        id="gallier.7.two_splines",
        place="section 7, the four transformations",
        statement="The passage through π makes two splines of the logarithms, from A_1 to A_2, and through A_2, A_3, "
        "A_4.",
        verdict=Verdict.CONFIRMED,
        form=(2, 3),
        cases=lambda: [_four()],
        deviation=_segments_miss,
        copies=(Copy("from A_1 to A_3, and from A_3 to A_4", (3, 2)), Copy("one spline", (4,))),
    ),
    Claim(
        id="gallier.7.figure_5",
        place="section 7, figure 5",
        statement="The trajectory of a point of the ellipsoid, by the spline of the right logarithms, is C² at A_2.",
        printed="Figure 5: C²-continuous trajectory of a point during the motion",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=printed_motion,
        cases=lambda: [exactly(point) for point in ([0, 0, 0], [1, 0, 0], [1, 2, 3])],
        deviation=_trajectory_jump,
        correction=Correction(statement="It is continuous; that of splines.smooth_motion is C².", form=_smooth),
        remark="The point of the figure is not told. The centre of the body arrives with velocity (-4.07, -5.82, 2.45) "
        "and leaves with (-3.89, -0.79, 0.40).",
    ),
    Claim(
        id="gallier.7.figure_6",
        place="section 7, figure 6",
        statement="With two splines joined without regard to derivatives, the trajectory is not even C¹ at A_2.",
        verdict=Verdict.CONFIRMED,
        form=_apart,
        cases=lambda: [_four()],
        deviation=_passes_smoothly,
        copies=(Copy("the motion that is C² on the group", _smooth),),
        remark="Nor is that of figure 5.",
    ),
    Claim(
        id="gallier.7.figure_7",
        place="section 7, figure 7",
        statement="With the spline through the principal logarithms the body turns the wrong way from A_1 to A_2, "
        "through the unturned pose in place of the half turn.",
        verdict=Verdict.CONFIRMED,
        form=(_by_principal_logarithms, 1),
        cases=lambda: [_four()],
        deviation=_right_way,
        copies=(Copy("the logarithms of strategy 1", (printed_motion, 2)),),
    ),
    Claim(
        id="gallier.7.screw",
        place="section 7, figures 11 and 12",
        statement="The screw motion of ten bodies, turned by 2π/3 and moved by (0, 0, 2) each time, is C².",
        verdict=Verdict.CONFIRMED,
        form=_screw(),
        cases=lambda: [printed_motion],
        deviation=lambda form, motion: _not_smooth(motion, form),
        copies=(Copy("every other body moved by 1 across the axis", _screw(1)),),
        remark="Smooth since all turn about the axis along which they move; the logarithms make four sequences.",
    ),
    Claim(
        id="gallier.7.figure_13",
        place="section 7, figure 13",
        statement="With principal logarithms the bodies of the screw motion turn back on their way.",
        verdict=Verdict.CONFIRMED,
        form=_by_principal_logarithms,
        cases=lambda: [_screw()],
        deviation=_turned_forward,
        copies=(Copy("the logarithms of strategy 1", printed_motion),),
    ),
    Claim(
        id="gallier.7.figures",
        place="section 7, figures 4 and 8 to 12",
        statement="Renderings of the ellipsoids and of the motions.",
        verdict=Verdict.UNCHECKABLE,
        reason="the figures are not in the copy at hand, and the text gives neither the ellipsoids nor the points",
    ),
)
