"""The spliced splines of the reference: what the paper prints, exact conditions, and what e^c is on the group."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from affinecert.case import generate
from affinecert.catalogue import find
from affinecert.errors import InputError
from affinecert.reference import sim3, so3, splines
from affinecert.reference._matrices import array, homogeneous, norm, scalar
from affinecert.reference._splicing import system, weights

Numbers = Any
Motion = Callable[[Any, Numbers, Numbers], Numbers]

CTX = mpmath.MPContext()
CTX.prec = 500


def numbers(values: Any) -> Numbers:
    return np.vectorize(CTX.mpf, otypes=[object])(np.asarray(values, dtype=object))


def pose(axis: Sequence[int], angle: Any, scale: float, translation: Sequence[float]) -> Numbers:
    return homogeneous(CTX, so3.exp(CTX, numbers(axis) * angle) * CTX.mpf(scale), numbers(translation))


X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
THIRD = 2 * CTX.pi / 3

FOUR = array(
    [
        pose(X, THIRD, 1, (-3, 0, -3)),
        pose(X, 2 * THIRD, 1.5, (3, 3, 2)),
        pose(Y, CTX.zero, 1, (-3, 3, 3)),
        pose(Z, -THIRD / 2, 1.5, (4, 0, -3)),
    ]
)
"""The four poses of section 7. The text says that A_2 does not turn; by its own numbers A_3 does not."""

SCREW = array([pose(Z, k * THIRD, 1.2 if k in (3, 4) else 1.5, (0, 0, 2 * k)) for k in range(10)])
"""The ten bodies of the screw motion of section 7."""


# What is printed


def reduced(lengths: Sequence[int]) -> tuple[Numbers, Numbers]:
    """The equations left for the inner de Boor points, when the first and the last ones of segments are eliminated.

    That is how the paper does it: by the conditions at the ends and at junctions. The second result is what is on the
    right of each equation, for all data points.
    """
    unknown, known = system(lengths)
    rows = np.concatenate([unknown, known], axis=1)
    last = np.cumsum(lengths) - 1
    first = last - np.array(lengths) + 1
    outer = sorted([*first, *last])
    # The conditions are listed with those at the ends and at junctions where their outer points are.
    solved, rest = rows[outer].copy(), np.delete(rows, outer, axis=0)
    for i, column in enumerate(outer):
        pivot = next(k for k in range(i, len(outer)) if solved[k, column])
        solved[[i, pivot]] = solved[[pivot, i]]
        solved[i] = solved[i] / solved[i, column]
        for k in range(len(outer)):
            if k != i:
                solved[k] = solved[k] - solved[k, column] * solved[i]
    for i, column in enumerate(outer):
        rest = rest - rest[:, [column]] * solved[i]
    return np.delete(rest[:, : len(unknown)], outer, axis=1), rest[:, len(unknown) :]


def banded(*rows: tuple[int, ...]) -> Numbers:
    """A square matrix from the entries of its rows about the diagonal, those of the first row from the diagonal on."""
    matrix = np.zeros((len(rows), len(rows)), dtype=int)
    for i, row in enumerate(rows):
        start = max(i - 1, 0)
        matrix[i, start : start + len(row)] = row
    return matrix


FIRST, SECOND, INNER = (4, 1), (4, 15, -1), (1, 4, 1)
"""Rows of a first inner point, of the last one before a junction, and of one in between."""
THREE_FIRST, THREE, AFTER, LAST, THREE_LAST = (15, -1), (-1, 14, -1), (-1, 15, 4), (1, 4), (-1, 15)
"""Rows of a segment of three points: first, inner; of the first point after a junction; of the last ones of all."""

PRINTED = {
    "8.1": ((4, 4, 4, 5), banded(FIRST, SECOND, AFTER, SECOND, AFTER, SECOND, AFTER, INNER, LAST)),
    "8.2": ((3, 5, 5, 3), banded(THREE_FIRST, AFTER, INNER, SECOND, AFTER, INNER, SECOND, THREE_LAST)),
    "8.3, case 1": (
        (5, 3, 3, 5, 5),
        banded(FIRST, INNER, SECOND, THREE, THREE, AFTER, INNER, SECOND, AFTER, INNER, LAST),
    ),
    "8.3, case 2, K = 5": (
        (3, 3, 3, 5, 5),
        banded(THREE_FIRST, THREE, THREE, AFTER, INNER, SECOND, AFTER, INNER, LAST),
    ),
    "8.3, case 2, K = 6": (
        (3, 3, 3, 5, 5, 3),
        banded(THREE_FIRST, THREE, THREE, AFTER, INNER, SECOND, AFTER, INNER, SECOND, THREE_LAST),
    ),
    # The last two rows are printed as (-1, 4, -1) and (0, 15, -1), although the equations above them are right. They
    # are those of the seventh and of the last segment of three points: (-1, 14, -1) and (-1, 15).
    "8.3, case 3, K = 7": (
        (5, 3, 3, 5, 5, 3, 3),
        banded(FIRST, INNER, SECOND, THREE, THREE, AFTER, INNER, SECOND, AFTER, INNER, SECOND, THREE, THREE_LAST),
    ),
    # The same two rows are printed wrong here.
    "8.3, case 3, K = 8": (
        (3, 4, 3, 3, 5, 5, 3, 3),
        banded(THREE_FIRST, AFTER, SECOND, THREE, THREE, AFTER, INNER, SECOND, AFTER, INNER, SECOND, THREE, THREE_LAST),
    ),
    "8.3, case 4": ((3,) * 8, banded(THREE_FIRST, *[THREE] * 6, THREE_LAST)),
}


@pytest.mark.parametrize(("lengths", "printed"), PRINTED.values(), ids=PRINTED)
def test_the_printed_matrices(lengths: tuple[int, ...], printed: Numbers) -> None:
    left, right = reduced(lengths)
    factors = np.diag(printed) / np.diag(left)
    assert (left * factors[:, None] == printed).all()
    assert (right * factors[:, None] == right_sides(lengths)).all()


def right_sides(lengths: Sequence[int]) -> Numbers:
    """What section 8 prints on the right of its equations, with the indices put right.

    In case 1 and in case 3 the equation of the last segment of three points begins with -x_1 of the segment before for
    its -x_2, as the equations above it have it; in case 4 it has -5 x_2 of the segment before for its own.
    """
    starts = np.cumsum([0, *lengths])
    rows = []
    for number, length in enumerate(lengths):
        begin, end = starts[number], starts[number + 1] - 1
        for i in range(begin + 1, end):
            row = np.zeros(starts[-1], dtype=int)
            after_start, before_end = i == begin + 1, i == end - 1
            junction_before, junction_behind = number > 0, number + 1 < len(lengths)
            quarters = length == 3 or (after_start and junction_before) or (before_end and junction_behind)
            row[i] = 24 if quarters else 6
            if after_start:
                row[begin] = -5 if junction_before else -4 if quarters else -1
                row[begin - 1 : begin] = -1
            if before_end:
                row[end] = -5 if junction_behind else -4 if quarters else -1
                row[end + 1 : end + 2] = -1
            rows.append(row)
    return np.array(rows)


def test_the_equations_at_a_junction() -> None:
    """Equations (*) and (**) of section 8.1, and the natural end conditions of section 8.2."""
    d, x = weights((4, 3)).de_boor, np.eye(7, dtype=int).astype(object)
    assert (6 * d[4] == x[3] + 5 * x[4] - d[2] + d[5]).all()
    assert (6 * d[3] == 5 * x[3] + x[4] + d[2] - d[5]).all()
    assert (3 * d[0] == 2 * x[0] + d[1]).all()
    assert (3 * d[6] == 2 * x[6] + d[5]).all()


# Against another formulation, exactly


def natural_bezier(lengths: Sequence[int]) -> Numbers:
    """The Bezier weights by the slopes of the natural spline through the segments, moved to lie end to start."""
    points = [Fraction(1) * row for row in np.eye(sum(lengths), dtype=int).astype(object)]
    spans: list[tuple[Numbers, Numbers]] = []
    for begin, length in zip(np.cumsum([0, *lengths[:-1]]), lengths, strict=True):
        segment = points[begin : begin + length]
        if length == 2:
            segment = [segment[0], (segment[0] + segment[1]) / 2, segment[1]]
        spans += itertools.pairwise(segment)
    count = len(spans)
    matrix, right = np.zeros((count + 1, count + 1), dtype=object) + Fraction(0), []
    for k in range(count + 1):
        near = [i for i in (k - 1, k) if 0 <= i < count]
        for i in near:
            matrix[k, i] += 2 if i == k else 1
            matrix[k, i + 1] += 2 if i + 1 == k else 1
        right.append(sum(3 * (spans[i][1] - spans[i][0]) for i in near))
    for k in range(count):
        factor = matrix[k + 1, k] / matrix[k, k]
        matrix[k + 1] -= factor * matrix[k]
        right[k + 1] = right[k + 1] - factor * right[k]
    slopes = [right[count] / matrix[count, count]]
    for k in range(count - 1, -1, -1):
        slopes.insert(0, (right[k] - matrix[k, k + 1] * slopes[0]) / matrix[k, k])
    return np.array([[a, a + slopes[i] / 3, b - slopes[i + 1] / 3, b] for i, (a, b) in enumerate(spans)])


def partitions(total: int) -> list[tuple[int, ...]]:
    """All lists of lengths from 2 on with that sum."""
    if total == 0:
        return [()]
    return [(n, *rest) for n in range(2, total + 1) for rest in partitions(total - n)]


@pytest.mark.parametrize("total", range(2, 11))
def test_every_list_of_lengths(total: int) -> None:
    for lengths in partitions(total):
        assert (weights(lengths).bezier == natural_bezier(lengths)).all(), lengths


def test_two_points_make_a_straight_line() -> None:
    points, lengths = numbers([[1.0, 2.0], [5.0, -2.0]]), numbers([2])
    for t in (-1, 0, 0.5, 1, 1.75, 2, 3):
        value = splines.evaluate(CTX, points, lengths, scalar(CTX.mpf(t)))
        assert norm(CTX, value - numbers([1 + 2 * CTX.mpf(t), 2 - 2 * CTX.mpf(t)])) < 1e-140


def test_bezier_points_and_values() -> None:
    points, lengths = numbers([[0], [1], [3], [10], [11], [-5], [0], [2]]), numbers([4, 2, 2])
    polygons = splines.bezier_points(CTX, points, lengths)
    assert polygons.shape == (7, 4, 1)
    for span, (a, b, c, d) in enumerate(polygons):
        for s in (CTX.mpf(0), CTX.mpf(0.375)):
            value = splines.evaluate(CTX, points, lengths, scalar(span + s))
            bernstein = a * (1 - s) ** 3 + 3 * b * s * (1 - s) ** 2 + 3 * c * s**2 * (1 - s) + d * s**3
            assert norm(CTX, value - bernstein) < 1e-140
    before = splines.evaluate(CTX, points, lengths, scalar(3 - CTX.mpf(10) ** -100))
    assert abs(before[0] - 10) < 1e-97
    assert abs(splines.evaluate(CTX, points, lengths, scalar(CTX.mpf(3)))[0] - 11) < 1e-140


@pytest.mark.parametrize("lengths", [[3.0, 3.0], [2.5, 2.5], [1.0, 4.0], [-2.0, 7.0], []])
def test_bad_lengths(lengths: list[float]) -> None:
    for lacking in (splines.de_boor, splines.bezier_points):
        with pytest.raises(InputError, match=r"^lengths: "):
            lacking(CTX, numbers(np.ones((5, 2))), numbers(lengths))


# Choosing logarithms


def test_the_example_of_section_5() -> None:
    turns = array([pose(Z, angle, 1, (0, 0, 0)) for angle in (THIRD, 2 * THIRD, 5 * THIRD / 2)])
    points, lengths = splines.select_logarithms(CTX, turns)
    assert lengths.tolist() == [2, 2]
    due = [THIRD, 2 * THIRD, -THIRD, -THIRD / 2]
    assert max(abs(a - b) for a, b in zip(points[:, 2], due, strict=True)) < 1e-140
    assert splines.key_times(CTX, turns).tolist() == [0, 2, 4]


@pytest.mark.parametrize(
    ("poses", "lengths", "times"),
    [(FOUR, [2, 3], [0, 2, 3, 4]), (SCREW, [3, 4, 4, 2], [0, 1, 2, 3, 4, 5, 6, 7, 8, 10])],
    ids=["four poses", "screw motion"],
)
def test_the_segments_of_section_7(poses: Numbers, lengths: list[int], times: list[int]) -> None:
    assert splines.select_logarithms(CTX, poses)[1].tolist() == lengths
    assert splines.key_times(CTX, poses).tolist() == times


def journeys(*regimes: str, count: int = 4) -> list[Numbers]:
    entry = find("splines.motion")
    chosen = [regime for regime in entry.regimes if regime.name in regimes]
    return [numbers(case.inputs[0]) for regime in chosen for case in generate(entry, regime, count, seed=7)]


def test_the_choice_is_that_of_sim3() -> None:
    for poses in journeys("generic", "through-pi", "half-turns", "near-pi", "near-2pi", "equal-keys"):
        points, lengths = splines.select_logarithms(CTX, poses)
        due = []
        for before, there in itertools.pairwise(poses):
            start = sim3.log(CTX, before)
            due += [start, sim3.log_next(CTX, there, start)]
        chosen: list[Numbers] = []
        ends = np.cumsum([int(n) for n in lengths])
        for end, length in zip(ends, lengths, strict=True):
            for leg in itertools.pairwise(points[end - int(length) : end]):
                chosen += leg
        assert norm(CTX, (array(chosen) - array(due)).flat) <= 1e-120 * norm(CTX, array(due).flat)


def test_too_few_poses_and_a_pose_that_is_no_similarity() -> None:
    with pytest.raises(InputError, match=r"^poses: fewer than two"):
        splines.motion(CTX, FOUR[:1], scalar(CTX.zero))
    stretched = FOUR.copy()
    stretched[2, 0, 0] *= 2
    with pytest.raises(InputError, match=r"^poses: not a similarity"):
        splines.motion(CTX, stretched, scalar(CTX.zero))


# Continuity on the group

STEP = CTX.ldexp(1, -120)


def one_sided(motion: Motion, poses: Numbers, time: Any, side: int) -> tuple[Numbers, Numbers, Numbers]:
    """The limits of a motion and of its first two derivatives, from before (side -1) or behind; errors about STEP^2.

    The steps are counted from next to the time, not from it, where a motion takes the later curve.
    """
    values = [motion(CTX, poses, scalar(time + side * STEP * (k + STEP**2))) for k in range(4)]
    first = (4 * values[1] - 3 * values[0] - values[2]) / (2 * side * STEP)
    second = (2 * values[0] - 5 * values[1] + 4 * values[2] - values[3]) / STEP**2
    return values[0], first, second


def jumps(motion: Motion, poses: Numbers) -> list[list[float]]:
    """The jumps of a motion, its velocity and its acceleration at its junctions, relative to their size."""
    _, lengths = splines.select_logarithms(CTX, poses)
    found = []
    for time in np.cumsum([max(int(n), 3) - 1 for n in lengths])[:-1]:
        sides = (one_sided(motion, poses, CTX.mpf(int(time)), side) for side in (-1, 1))
        found.append([float(norm(CTX, (a - b).flat) / norm(CTX, a.flat)) for a, b in zip(*sides, strict=True)])
    return found


def test_the_printed_motion_through_the_four_poses_is_not_once_differentiable() -> None:
    # Section 5 and figure 5 call it C^2. The logarithm goes from Y, turned by 4 pi/3 about x, to X, turned by -2 pi/3.
    ((place, velocity, acceleration),) = jumps(splines.motion, FOUR)
    assert place < 1e-30
    assert velocity == pytest.approx(0.6424, abs=1e-4)
    assert acceleration == pytest.approx(0.6706, abs=1e-4)
    origin = [one_sided(splines.motion, FOUR, CTX.mpf(2), side)[1][:3, 3].astype(float) for side in (-1, 1)]
    np.testing.assert_allclose(origin[0], [-4.0708, -5.8188, 2.4527], atol=1e-4)
    np.testing.assert_allclose(origin[1], [-3.8872, -0.7887, 0.4049], atol=1e-4)
    # Nor is the rotation alone: what the angular velocity has across the axis is multiplied by -(2 pi/3) / (4 pi/3).
    angular = []
    for side in (-1, 1):
        there, rate, _ = one_sided(splines.motion, FOUR, CTX.mpf(2), side)
        spin = (rate[:3, :3] @ there[:3, :3].T).astype(float) / 1.5**2
        angular.append(np.array([spin[2, 1] - spin[1, 2], spin[0, 2] - spin[2, 0], spin[1, 0] - spin[0, 1]]) / 2)
    np.testing.assert_allclose(angular[0], [1.83260, -0.04688, -0.02706], atol=1e-5)
    np.testing.assert_allclose(angular[1], [1.83260, 0.09375, 0.05413], atol=1e-5)


def test_one_axis_is_not_enough_for_the_printed_motion() -> None:
    # All rotations about z, translations across it: the rotation is smooth, the translation is not.
    turns = array([pose(Z, a, 1, w) for a, w in ((2, (1, 0, 0)), (4, (0, 2, 0)), (5, (1, 1, 3)))])
    ((place, velocity, acceleration),) = jumps(splines.motion, turns)
    assert (place < 1e-30, velocity > 0.5, acceleration > 0.4) == (True, True, True)
    sides = [one_sided(splines.motion, turns, CTX.mpf(2), side) for side in (-1, 1)]
    assert all(norm(CTX, (a - b)[:3, :3].flat) < 1e-30 for a, b in zip(*sides, strict=True))


def test_the_printed_screw_motion_is_smooth() -> None:
    found = jumps(splines.motion, SCREW)
    assert len(found) == 3
    assert max(map(max, found)) < 1e-30
    for t in (2.25, 3.5, 5.75, 8.125, 9.9):
        difference = splines.motion(CTX, SCREW, scalar(CTX.mpf(t))) - splines.smooth_motion(
            CTX, SCREW, scalar(CTX.mpf(t))
        )
        assert norm(CTX, difference.flat) < 1e-130


def test_the_smooth_motion_is_twice_continuously_differentiable() -> None:
    crossing = journeys("through-pi", "round-and-round", count=3)
    found = [jump for poses in (FOUR, *crossing) for jump in jumps(splines.smooth_motion, poses)]
    assert len(found) >= 6
    assert max(map(max, found)) < 1e-30
    printed = [jump for poses in crossing for jump in jumps(splines.motion, poses)]
    assert all(place < 1e-30 for place, _, _ in printed)
    assert max(velocity for _, velocity, _ in printed) > 0.1


def test_the_smooth_motion_is_smooth_at_all_other_knots_and_meets_all_keys() -> None:
    for poses in (FOUR, *journeys("through-pi", "generic", count=2)):
        times = splines.key_times(CTX, poses)
        for time, due in zip(times, poses, strict=True):
            there = splines.smooth_motion(CTX, poses, scalar(time))
            nearest = sim3.exp(CTX, sim3.log(CTX, due))
            assert norm(CTX, (there - nearest).flat) < 1e-130 * norm(CTX, due.flat)
        for time in range(1, int(times[-1])):
            sides = [one_sided(splines.smooth_motion, poses, CTX.mpf(time), side) for side in (-1, 1)]
            assert all(norm(CTX, (a - b).flat) < 1e-30 * norm(CTX, a.flat) for a, b in zip(*sides, strict=True))


def test_the_smooth_motion_differs_from_the_printed_one_on_the_span_behind_a_junction_only() -> None:
    for t in (-0.5, 0.25, 1.75, 2.0, 3.0, 3.5, 4.5):
        time = scalar(CTX.mpf(t))
        same = splines.motion(CTX, FOUR, time) - splines.smooth_motion(CTX, FOUR, time)
        assert norm(CTX, same.flat) < 1e-140
    time = scalar(CTX.mpf(2.25))
    assert norm(CTX, (splines.motion(CTX, FOUR, time) - splines.smooth_motion(CTX, FOUR, time)).flat) > 0.1


def test_a_turn_back_keeps_the_exponential() -> None:
    for poses in journeys("generic", "near-2pi", count=3):
        for log in splines.select_logarithms(CTX, poses)[0]:
            (other,) = splines._turned_back(CTX, [log])
            assert abs(norm(CTX, other[:3]) - abs(2 * CTX.pi - norm(CTX, log[:3]))) < 1e-130
            difference = sim3.exp(CTX, log) - sim3.exp(CTX, other)
            assert norm(CTX, difference.flat) < 1e-110 * norm(CTX, sim3.exp(CTX, log).flat)


# What is continued, and what is wrong


def test_ties_are_continued() -> None:
    # The half turn about x has two rotation vectors, equally near to the one about z.
    poses, time = (
        array([pose(Z, THIRD, 1, (1, 0, 2)), *numbers([np.diag([1, -1, -1, 1])]), FOUR[3]]),
        scalar(CTX.mpf(0.5)),
    )
    for motion, continued in (
        (splines.motion, splines.continue_motion),
        (splines.smooth_motion, splines.continue_smooth_motion),
    ):
        base, leaps = motion(CTX, poses, time), []
        for sign in (1, -1):
            moved = poses.copy()
            moved[1, :3, :3] = poses[1, :3, :3] @ so3.exp(CTX, numbers([sign, 0, 0]) * CTX.mpf(10) ** -40)
            leaps.append(norm(CTX, (motion(CTX, moved, time) - base).flat))
            assert norm(CTX, (continued(CTX, base, moved, time) - base).flat) < 1e-38
        assert max(leaps) > 0.1


def test_the_principal_logarithms_take_the_long_way() -> None:
    # From 2 pi/3 to 4 pi/3 through 0 instead of pi (section 5).
    turns = array([pose(Z, angle, 1, (0, 0, 0)) for angle in (THIRD, 2 * THIRD, 2 * THIRD + 1)])
    wrong, right = (
        [float(motion(CTX, turns, scalar(CTX.mpf(t)))[:3, :3].trace()) for t in times]
        for motion, times in ((splines.principal_motion, (0.25, 0.5, 0.75)), (splines.motion, (0.5, 1.0, 1.5)))
    )
    assert max(wrong) > 2.5
    assert max(right) < 1 + 2 * math.cos(2.0)
    single = splines.principal_motion(CTX, FOUR[2:], scalar(CTX.one))
    assert norm(CTX, (single - splines.motion(CTX, FOUR[2:], scalar(CTX.one))).flat) < 1e-140
