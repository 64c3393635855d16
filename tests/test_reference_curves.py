"""Curves of the reference: through their keys, smooth where they should be, and the printed listings word by word."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import affine_lie, curves, sam, scale, se3, shear
from affinecert.reference._matrices import cross_matrix, homogeneous, identity, scalar, tangent
from affinecert.reference._steady import quotient

from .enclosures import Numbers, context, length, numbers

BITS = 400
LOST = 60
STEP = 100
"""Differences are taken over 2**-STEP, and so are derivatives to that accuracy but for a small factor."""

Poses = list[Numbers]


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def close(ctx: Any, found: Any, expected: Any, lost: int = LOST) -> bool:
    found, expected = np.atleast_1d(found), np.atleast_1d(expected)
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected), lost - BITS))


def at(ctx: Any, t: Any) -> Numbers:
    return scalar(ctx.mpf(t))


def shears(ctx: Any, count: int) -> Numbers:
    draw = np.random.default_rng(count)
    keys = np.stack([np.eye(3)] * count)
    keys[:, [0, 0, 1], [1, 2, 2]] = draw.normal(size=(count, 3))
    keys[:, [1, 2], [1, 2]] = np.exp(draw.normal(size=(count, 2)))
    return numbers(ctx, keys)


def scales(ctx: Any, count: int) -> Numbers:
    return numbers(ctx, np.exp(np.random.default_rng(count).normal(size=count)))


def rigids(ctx: Any, count: int) -> Numbers:
    """Rigid motions whose rotations are exact to the context's precision."""
    draw = np.random.default_rng(count)
    return np.stack([se3.exp(ctx, numbers(ctx, draw.normal(size=6))) for _ in range(count)])


def affines(ctx: Any, count: int, n: int = 4, spread: float = 0.3) -> Numbers:
    """Affine maps near enough to one another for steady morphs to exist, and far enough apart not to commute."""
    draw = np.random.default_rng(count * n)
    return numbers(ctx, np.eye(n) + spread * draw.normal(size=(count, n, n)) * (np.arange(n) < n - 1)[:, None])


def regular(ctx: Any, count: int, n: int) -> Numbers:
    """Poses each of which is the one before moved by the same affine map."""
    first, step = affines(ctx, 2, n)
    poses = [first]
    while len(poses) < count:
        poses.append(step @ poses[-1])
    return np.stack(poses)


KEYED: dict[str, tuple[Callable[..., Numbers], Callable[[Any, int], Numbers]]] = {
    "shear_curve": (curves.shear_curve, shears),
    "scale_curve": (curves.scale_curve, scales),
    "rigid_curve": (curves.rigid_curve, rigids),
    "affine_curve": (curves.affine_curve, affines),
    "subdivided_curve": (curves.subdivided_curve, affines),
    "poly_sam": (curves.poly_sam, affines),
}
"""The curves through keys, and what makes keys for them."""

SMOOTH = tuple(name for name in KEYED if name != "poly_sam")
every_dimension = pytest.mark.parametrize("n", [3, 4])


def rates(ctx: Any, curve: Callable[[Any], Numbers], t: Any) -> tuple[Numbers, Numbers]:
    """The derivatives before and after the time t, by differences."""
    step = ctx.ldexp(ctx.one, -STEP)
    here = curve(t)
    return (here - curve(t - step)) / step, (curve(t + step) - here) / step


def smooth(ctx: Any, curve: Callable[[Any], Numbers], t: Any) -> bool:
    before, after = rates(ctx, curve, t)
    return close(ctx, before, after, BITS - STEP + 20)


@pytest.mark.parametrize("name", KEYED)
def test_a_curve_passes_through_its_keys(ctx: Any, name: str) -> None:
    curve, draw = KEYED[name]
    keys = draw(ctx, 4)
    for k, key in enumerate(keys):
        assert close(ctx, curve(ctx, keys, at(ctx, k)), key)


@pytest.mark.parametrize("name", SMOOTH)
def test_a_curve_has_one_velocity_at_a_key(ctx: Any, name: str) -> None:
    curve, draw = KEYED[name]
    keys = draw(ctx, 4)
    for k in (1, 2):
        assert smooth(ctx, lambda t: curve(ctx, keys, scalar(t)), ctx.mpf(k))


def test_a_poly_sam_has_two_velocities_at_a_key(ctx: Any) -> None:
    keys = affines(ctx, 3)
    assert not smooth(ctx, lambda t: curves.poly_sam(ctx, keys, scalar(t)), ctx.one)


@pytest.mark.parametrize("name", KEYED)
def test_the_end_segments_go_on_beyond_the_keys(ctx: Any, name: str) -> None:
    curve, draw = KEYED[name]
    keys = draw(ctx, 3)
    step = ctx.ldexp(ctx.one, -STEP)
    for end in (0, 2):
        # Third differences are of the third order in the step where the curve is analytic; of the second where its
        # curvature jumps, as it may between segments.
        values = [curve(ctx, keys, scalar(end + k * step)) for k in (-1, 0, 1, 2)]
        third = values[3] - 3 * values[2] + 3 * values[1] - values[0]
        assert length(ctx, np.atleast_1d(third)) <= ctx.ldexp(step * step, -60)


def test_two_keys_make_a_geodesic(ctx: Any) -> None:
    t = at(ctx, 0.3)
    first, second = shears(ctx, 2)
    step = shear.log(ctx, quotient_from_left(ctx, first, second))
    assert close(ctx, curves.shear_curve(ctx, np.stack([first, second]), t), first @ shear.exp(ctx, step * t[()]))
    first, second = rigids(ctx, 2)
    step = se3.log(ctx, quotient_from_left(ctx, first, second))
    assert close(ctx, curves.rigid_curve(ctx, np.stack([first, second]), t), first @ se3.exp(ctx, step * t[()]))


def quotient_from_left(ctx: Any, first: Numbers, second: Numbers) -> Numbers:
    inverse = ctx.inverse(ctx.matrix(first.tolist()))
    quotient: Numbers = np.array(inverse.tolist(), dtype=object).reshape(first.shape) @ second
    return quotient


def expm(ctx: Any, matrix: Numbers) -> Numbers:
    """The exponential by its series."""
    with ctx.extraprec(64):
        found = ctx.expm(ctx.matrix(matrix.tolist()), method="taylor")
    return np.array(found.tolist(), dtype=object).reshape(matrix.shape)


def shear_log(ctx: Any, matrix: Numbers) -> Numbers:
    exact = shear.matrix(ctx, shear.parameters(matrix), ctx.one)
    return shear.matrix(ctx, shear.log(ctx, exact), ctx.zero)


def rigid_log(ctx: Any, pose: Numbers) -> Numbers:
    twist = se3.log(ctx, homogeneous(ctx, pose[:3, :3], pose[:3, 3]))
    return tangent(ctx, cross_matrix(ctx, twist[:3]), twist[3:])


def printed(ctx: Any, keys: Numbers, t: Any, log: Callable[[Any, Numbers], Numbers]) -> Numbers:
    """Equations 5 and 6 word by word, exponentials by their series."""
    steps = [quotient_from_left(ctx, *pair) for pair in pairwise(keys)]
    b = [log(ctx, steps[0])]
    c = []
    for step in steps:
        c.append(log(ctx, expm(ctx, -b[-1]) @ step))
        b.append(quotient_from_left(ctx, step, b[-1] @ step) + 2 * c[-1])
    index = min(int(t), len(steps) - 1)
    time = t - index
    point: Numbers = keys[index] @ expm(ctx, b[index] * time) @ expm(ctx, c[index] * time**2)
    return point


@pytest.mark.parametrize("t", [0.25, 1.5, 2.75])
def test_equations_5_and_6_as_printed(ctx: Any, t: float) -> None:
    for curve, keys, log in (
        (curves.shear_curve, shears(ctx, 4), shear_log),
        (curves.rigid_curve, rigids(ctx, 4), rigid_log),
    ):
        assert close(ctx, curve(ctx, keys, at(ctx, t)), printed(ctx, keys, ctx.mpf(t), log))


def test_scales_are_joined_by_a_quadratic_spline(ctx: Any) -> None:
    logarithms = [ctx.mpf(x) for x in (0.5, -1.25, 2.0, 0.75)]
    keys = np.array([ctx.exp(x) for x in logarithms])
    # Slopes at the keys: m_(i+1) = 2 (x_(i+1) - x_i) - m_i, from m_0 = x_1 - x_0 = -7/4 to -7/4, 33/4, -43/4.
    for index, slope in enumerate((-1.75, -1.75, 8.25)):
        change = logarithms[index + 1] - logarithms[index]
        for s in (0.125, 0.5):
            value = logarithms[index] + slope * s + (change - slope) * s * s
            assert close(ctx, curves.scale_curve(ctx, keys, at(ctx, index + s)), ctx.exp(value))


def test_equal_steps_make_a_steady_curve(ctx: Any) -> None:
    first, step = shears(ctx, 2)
    keys = np.stack([first, first @ step, first @ step @ step])
    power = shear.exp(ctx, shear.log(ctx, step) * ctx.mpf(1.375))
    assert close(ctx, curves.shear_curve(ctx, keys, at(ctx, 1.375)), first @ power)
    first, step = rigids(ctx, 2)
    keys = np.stack([first, first @ step, first @ step @ step])
    power = se3.exp(ctx, se3.log(ctx, step) * ctx.mpf(1.375))
    assert close(ctx, curves.rigid_curve(ctx, keys, at(ctx, 1.375)), first @ power)


def factors(ctx: Any, keys: Numbers) -> tuple[Numbers, Numbers, Numbers]:
    rigid, sheared, scaled = zip(*(affine_lie.decompose(ctx, key) for key in keys), strict=True)
    return np.stack(rigid), np.stack(sheared), np.array([s[()] for s in scaled])


def test_the_affine_curve_is_made_of_the_curves_of_its_factors(ctx: Any) -> None:
    keys, t = affines(ctx, 3), at(ctx, 1.25)
    rigid, sheared, scaled = factors(ctx, keys)
    moved, bent, grown = (
        curve(ctx, part, t)
        for curve, part in (
            (curves.rigid_curve, rigid),
            (curves.shear_curve, sheared),
            (curves.scale_curve, scaled),
        )
    )
    upper = homogeneous(ctx, bent * grown[()], np.array([ctx.zero] * 3))
    assert close(ctx, curves.affine_curve(ctx, keys, t), upper @ moved)
    # The order that section 4.1 prints passes by the keys, as E S A is not A S E.
    key = homogeneous(ctx, sheared[1] * scaled[1], np.array([ctx.zero] * 3))
    assert close(ctx, key @ rigid[1], keys[1])
    assert not close(ctx, rigid[1] @ key, keys[1], BITS - 4)


def test_the_subdivided_curve_passes_through_midpoints_of_pairs(ctx: Any) -> None:
    keys = affines(ctx, 3)
    refined = [keys[0]]
    for here, there in pairwise(keys):
        pair = np.stack([here, there])
        refined += [curves.affine_curve(ctx, pair, at(ctx, 0.5)), there]
    for t in (0.25, 0.5, 0.9, 1.7, -0.1):
        expected = curves.affine_curve(ctx, np.stack(refined), scalar(2 * ctx.mpf(t)))
        assert close(ctx, curves.subdivided_curve(ctx, keys, at(ctx, t)), expected)


def test_midpoints_of_pairs_are_those_of_tetrahedra(ctx: Any) -> None:
    # The key T takes a tetrahedron to the canonical one, and the pose half way the tetrahedron that is half way.
    keys = affines(ctx, 2)
    canonical = numbers(ctx, [[0, 0, 0, 1], [1, 0, 0, 1], [1, 1, 0, 1], [0, 0, 1, 1]])
    source, target = (quotient_from_left(ctx, key, canonical.T).T[:, :3] for key in keys)
    middle = affine_lie.interpolate_tetrahedra(ctx, source, target, at(ctx, 0.5))
    vertices = np.vstack([middle.T, [ctx.one] * 4])
    assert close(ctx, curves.subdivided_curve(ctx, keys, at(ctx, 0.5)) @ vertices, canonical.T)


@every_dimension
def test_bezier_curves_as_printed(ctx: Any, n: int) -> None:
    a, b, c, d = affines(ctx, 4, n, 0.2)
    t = at(ctx, 0.3)

    def morph(start: Numbers, end: Numbers) -> Numbers:
        return sam.morph(ctx, start, end, t)

    def bezier(first: Numbers, second: Numbers, third: Numbers) -> Numbers:
        return morph(morph(first, second), morph(second, third))

    assert close(ctx, curves.bezier_quadratic(ctx, a, b, c, t), bezier(a, b, c))
    assert close(ctx, curves.bezier_cubic(ctx, a, b, c, d, t), morph(bezier(a, b, c), bezier(b, c, d)))


def along(ctx: Any, curve: Callable[..., Numbers], poses: tuple[Numbers, ...], t: Any) -> Numbers:
    return curve(ctx, *poses, scalar(t))


@every_dimension
def test_bezier_curves_leave_and_arrive_along_the_legs(ctx: Any, n: int) -> None:
    a, b, c, d = affines(ctx, 4, n, 0.2)
    for degree, curve, poses in ((2, curves.bezier_quadratic, (a, b, c)), (3, curves.bezier_cubic, (a, b, c, d))):
        for t, start, end, pose in ((0, poses[0], poses[1], poses[0]), (1, poses[-2], poses[-1], poses[-1])):
            before, after = rates(ctx, partial(along, ctx, curve, poses), ctx.mpf(t))
            due = degree * sam.log(ctx, quotient(ctx, end, start)) @ pose
            assert close(ctx, (before + after) / 2, due, BITS - STEP + 20)


@every_dimension
def test_cascades_of_equal_steps_are_steady(ctx: Any, n: int) -> None:
    a, b, c, d = poses = regular(ctx, 4, n)
    step = quotient(ctx, b, a)

    def steady(time: float) -> Numbers:
        power: Numbers = sam.power(ctx, step, at(ctx, time)) @ a
        return power

    t = at(ctx, 0.375)
    assert close(ctx, curves.bezier_quadratic(ctx, a, b, c, t), steady(2 * 0.375))
    assert close(ctx, curves.bezier_cubic(ctx, a, b, c, d, t), steady(3 * 0.375))
    for time in (0.375, 0.625):
        assert close(ctx, curves.biarc(ctx, a, b, c, at(ctx, time)), steady(2 * time))
        assert close(ctx, curves.poly_sam(ctx, poses, at(ctx, time + 1)), steady(time + 1))
    for k, pose in enumerate(curves.four_point(ctx, poses)):
        assert close(ctx, pose, steady(k / 2))
    for k, pose in enumerate(curves.regular_pattern(ctx, a, d, copies=5)):
        assert close(ctx, pose, sam.morph(ctx, a, d, scalar(ctx.mpf(k) / 5)))


@every_dimension
def test_the_biarc_is_smooth_in_the_middle_with_the_printed_control_poses(ctx: Any, n: int) -> None:
    a, b, c = affines(ctx, 3, n, 0.2)
    for t, pose in ((0, a), (0.5, b), (1, c)):
        assert close(ctx, curves.biarc(ctx, a, b, c, at(ctx, t)), pose)
    assert smooth(ctx, lambda t: curves.biarc(ctx, a, b, c, scalar(t)), ctx.mpf(0.5))

    def left_control(first: Numbers, second: Numbers, third: Numbers) -> Numbers:
        carrying = sam.power(ctx, quotient(ctx, second, third), at(ctx, 0.25))
        control: Numbers = carrying @ sam.morph(ctx, first, second, at(ctx, 0.75))
        return control

    left, right = left_control(a, b, c), left_control(c, b, a)
    assert close(ctx, sam.morph(ctx, left, right, at(ctx, 0.5)), b)
    for t, (start, control, end), time in (
        (0.25, (a, left, b), 0.5),
        (0.75, (b, right, c), 0.5),
        (0.625, (b, right, c), 0.25),
    ):
        due = curves.bezier_quadratic(ctx, start, control, end, at(ctx, time))
        assert close(ctx, curves.biarc(ctx, a, b, c, at(ctx, t)), due)


def test_four_argument_sam_is_no_product_of_poses(ctx: Any) -> None:
    # Were SAM(F_X, F_A, t, F_B) the product of the poses SAM(F_A, t, F_B) and F_X, then B would not be half way.
    a, b, c = affines(ctx, 3, 3, 0.2)
    left = sam.morph(ctx, c, b, at(ctx, 0.25)) @ sam.morph(ctx, a, b, at(ctx, 0.75))
    right = sam.morph(ctx, a, b, at(ctx, 0.25)) @ sam.morph(ctx, c, b, at(ctx, 0.75))
    assert not close(ctx, sam.morph(ctx, left, right, at(ctx, 0.5)), b, BITS - 4)


def test_four_point_subdivision_of_translations_is_the_classical_scheme(ctx: Any) -> None:
    points = numbers(ctx, [[1.0, 2], [3, -1], [2, 5], [-4, 0], [7, 7]])
    poses = np.stack([homogeneous(ctx, identity(ctx, 2), point) for point in points])
    refined = curves.four_point(ctx, poses)[:, :2, 2]
    sixteenth = ctx.mpf(1) / 16
    assert close(ctx, refined[::2], points)
    for k in (1, 2):
        before, here, there, after = points[k - 1 : k + 3]
        assert close(ctx, refined[2 * k + 1], (9 * (here + there) - before - after) * sixteenth)
    assert close(ctx, refined[1], (3 * points[0] + 6 * points[1] - points[2]) / 8)
    assert close(ctx, refined[-2], (3 * points[-1] + 6 * points[-2] - points[-3]) / 8)


@every_dimension
def test_four_point_subdivision_as_printed(ctx: Any, n: int) -> None:
    poses = affines(ctx, 4, n, 0.2)

    def left(a: Numbers, b: Numbers, c: Numbers) -> Numbers:
        carrying = sam.power(ctx, quotient(ctx, b, c), at(ctx, 0.125))
        prediction: Numbers = carrying @ sam.morph(ctx, a, b, at(ctx, 0.625))
        return prediction

    refined = curves.four_point(ctx, poses)
    assert len(refined) == 7
    for k, pose in enumerate(poses):
        assert close(ctx, refined[2 * k], pose)
    left_1, left_2 = left(*poses[:3]), left(*poses[1:])
    right_1, right_2 = left(*poses[2::-1]), left(*poses[:0:-1])
    assert close(ctx, refined[1], left_1)
    assert close(ctx, refined[3], sam.morph(ctx, right_1, left_2, at(ctx, 0.5)))
    assert close(ctx, refined[5], right_2)


@every_dimension
def test_a_patch_has_its_corners_and_is_regular_with_the_fourth_one_chosen(ctx: Any, n: int) -> None:
    a, b, c, d = affines(ctx, 4, n, 0.2)
    for x, y, corner in ((0, 0, a), (1, 0, b), (0, 1, c), (1, 1, d)):
        assert close(ctx, curves.patch(ctx, a, b, c, d, at(ctx, x), at(ctx, y)), corner)
    fourth = quotient(ctx, b, a) @ c
    s, t = at(ctx, 0.25), at(ctx, 0.625)
    row = sam.morph(ctx, a, c, t)
    along = sam.power(ctx, quotient(ctx, b, a), s)
    assert close(ctx, curves.patch(ctx, a, b, c, fourth, s, t), along @ row)


@every_dimension
def test_the_grazing_point_moves_along_the_surface(ctx: Any, n: int) -> None:
    (affine,) = affines(ctx, 1, n)
    draw = np.random.default_rng(n)
    point, along, normal = (numbers(ctx, draw.normal(size=n - 1)) for _ in range(3))
    s = curves.grazing_parameter(ctx, affine, point, along, normal)[()]
    velocity = sam.velocity(ctx, affine, point + along * s)
    assert abs(normal @ velocity) <= ctx.ldexp(length(ctx, velocity), LOST - BITS)
    # About the fixed point v is zero, and equation 8 right but for its sign.
    fixed, turn = sam.fixed_point(ctx, affine), sam.log(ctx, affine)[:-1, :-1]
    printed_value = (normal @ turn @ (point - fixed)) / (normal @ turn @ along)
    assert close(ctx, s, -printed_value)


def test_a_scaling_has_no_grazing_point_on_a_tangent(ctx: Any) -> None:
    affine = homogeneous(ctx, identity(ctx, 2) * 3, numbers(ctx, [1.0, 2.0]))
    with pytest.raises(InputError, match=r"^tangent: degenerate"):
        curves.grazing_parameter(ctx, affine, *(numbers(ctx, x) for x in ([5.0, 1], [2, 0.1], [-0.1, 2])))


def test_a_half_turn_is_a_morph_between_keys_and_none_on_the_way(ctx: Any) -> None:
    half, start = np.diag([-2.0, -2.0, 1.0]), np.array([[1.0, 2, 0], [0, 1, 1], [0, 0, 1]])
    poses = numbers(ctx, [start, half @ start, half @ half @ start])
    quarter = curves.poly_sam(ctx, poses, at(ctx, 0.5))
    assert close(ctx, quarter, sam.morph(ctx, poses[0], poses[1], at(ctx, 0.5)))
    with pytest.raises(InputError, match=r"^pose_c: no real logarithm that is determined"):
        curves.bezier_quadratic(ctx, poses[0], poses[1], poses[2], at(ctx, 0.3))


@pytest.mark.parametrize("name", KEYED)
def test_one_key_is_too_few(ctx: Any, name: str) -> None:
    curve, draw = KEYED[name]
    with pytest.raises(InputError, match="1 keys where at least two are due"):
        curve(ctx, draw(ctx, 1), at(ctx, 0))
    with pytest.raises(InputError, match="2 keys where at least three are due"):
        curves.four_point(ctx, affines(ctx, 2))


def test_scales_of_a_curve_are_those_of_the_family(ctx: Any) -> None:
    keys = scales(ctx, 2)
    first, second = (scale.log(ctx, scalar(key))[()] for key in keys)
    middle = scale.exp(ctx, scalar((first + second) / 2))
    assert close(ctx, curves.scale_curve(ctx, keys, at(ctx, 0.5)), middle)
