"""Morphs of the reference: against other routes to the same definition, and the numbers that the papers print."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import morphs, polar, sam, se3, sim3
from affinecert.reference._matrices import Array, array, cross_matrix, identity, norm, scalar, tangent
from affinecert.reference._matrices import homogeneous as pose_of

from .enclosures import Numbers, context, distance, exponential, length, numbers

BITS = 400
LOST = 60
TIMES = (0.3, -0.75, 1.5)
IN_SPACE_ALONE = {"sim", "sclerp", "dual_quaternion_linear"}
IN_THE_PLANE_ALONE = {"three_spiral"}
EVERYWHERE = sorted(set(morphs.MORPHS) - IN_SPACE_ALONE - IN_THE_PLANE_ALONE)
# They move the barycentre of a simplex, or take the root of a determinant, that differ in the plane and in space.
BY_DIMENSION = {"rarap", "asap", "log_spiral"}


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def homogeneous(linear: Any, translation: Any) -> np.ndarray[Any, Any]:
    affine = np.eye(len(linear) + 1)
    affine[:-1, :-1], affine[:-1, -1] = linear, translation
    return affine


def close(ctx: Any, found: Numbers, expected: Numbers, lost: int = LOST) -> bool:
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected) + ctx.one, lost - BITS))


def rotation(draw: np.random.Generator, size: int) -> np.ndarray[Any, Any]:
    matrix = np.linalg.qr(draw.normal(size=(size, size)))[0]
    return np.asarray(matrix * np.array([np.linalg.det(matrix), *[1.0] * (size - 1)]))


def linear(draw: np.random.Generator, size: int, name: str) -> np.ndarray[Any, Any]:
    """A linear part that the morph of that name takes, and that has a logarithm."""
    if name in IN_SPACE_ALONE:
        return rotation(draw, size) * (draw.uniform(0.5, 2) if name == "sim" else 1.0)
    while True:
        matrix = np.eye(size) + 0.5 * draw.normal(size=(size, size))
        if np.linalg.det(matrix) > 0.1 and sam.exists_exactly(matrix.tolist()):
            return matrix


def pairs(ctx: Any, size: int, name: str = "", count: int = 4) -> list[tuple[Array, Array, Array]]:
    """Poses that the morph of that name takes, and a time."""
    draw = np.random.default_rng(size)
    poses = [homogeneous(linear(draw, size, name), draw.normal(size=size)) for _ in range(2 * count)]
    return [
        (numbers(ctx, poses[2 * i]), numbers(ctx, poses[2 * i + 1]), numbers(ctx, TIMES[i % len(TIMES)]))
        for i in range(count)
    ]


def parts(pose: Array) -> tuple[Array, Array]:
    return pose[:-1, :-1], pose[:-1, -1]


def mixed(first: Any, last: Any, t: Array) -> Any:
    return first * (1 - t[()]) + last * t[()]


def straight(start: Array, end: Array, t: Array) -> Array:
    return np.asarray(mixed(parts(start)[1], parts(end)[1], t))


def inverse(ctx: Any, matrix: Array) -> Array:
    return np.array((ctx.matrix(matrix.tolist()) ** -1).tolist(), dtype=object).reshape(matrix.shape)


def power(ctx: Any, matrix: Array, t: Array) -> Array:
    """The power of a linear map, as that of an affine map that leaves the origin alone."""
    return sam.power(ctx, pose_of(ctx, matrix, numbers(ctx, np.zeros(len(matrix)))), t)[:-1, :-1]


def logarithm(ctx: Any, matrix: Array) -> Array:
    return sam.log(ctx, pose_of(ctx, matrix, numbers(ctx, np.zeros(len(matrix)))))[:-1, :-1]


def exponential_of(ctx: Any, matrix: Array) -> Array:
    return sam.exponential(ctx, tangent(ctx, matrix, numbers(ctx, np.zeros(len(matrix)))))[:-1, :-1]


def factors(ctx: Any, *linears: Array) -> list[tuple[Array, Array]]:
    return [polar.factors(ctx, part, polar.gram(part)) for part in linears]


def in_space(ctx: Any, pose: Array) -> Array:
    """The pose of space that leaves the third coordinate alone."""
    embedded = identity(ctx, 4)
    embedded[np.ix_((0, 1, 3), (0, 1, 3))] = pose
    return embedded


both_sizes = pytest.mark.parametrize("size", [2, 3])


@pytest.mark.parametrize("name", morphs.MORPHS)
def test_the_ends_are_the_poses(ctx: Any, name: str) -> None:
    for size in (3,) if name in IN_SPACE_ALONE else (2,) if name in IN_THE_PLANE_ALONE else (2, 3):
        for start, end, _ in pairs(ctx, size, name):
            for t, pose in ((0.0, start), (1.0, end)):
                # What is rigid or similar is off that by its rounding.
                lost = BITS - 50 if name in IN_SPACE_ALONE else LOST
                assert close(ctx, morphs.MORPHS[name](ctx, start, end, numbers(ctx, t)), pose, lost)


@pytest.mark.parametrize("name", EVERYWHERE)
def test_the_plane_lies_in_space(ctx: Any, name: str) -> None:
    morph = morphs.MORPHS[name]
    for start, end, t in pairs(ctx, 2):
        found, due = morph(ctx, in_space(ctx, start), in_space(ctx, end), t), in_space(ctx, morph(ctx, start, end, t))
        if name in BY_DIMENSION:
            found, due = parts(found)[0], parts(due)[0]
        if name != "log_spiral":
            assert close(ctx, found, due)


@both_sizes
def test_shoemake_and_duff_from_square_roots(ctx: Any, size: int) -> None:
    for start, end, t in pairs(ctx, size):
        (first, first_stretch), (last, last_stretch) = factors(ctx, parts(start)[0], parts(end)[0])
        # R_B (R_B^T R_C)^t is (R_C R_B^T)^t R_B.
        due = power(ctx, last @ first.T, t) @ first @ mixed(first_stretch, last_stretch, t)
        assert close(ctx, morphs.shoemake_duff(ctx, start, end, t), pose_of(ctx, due, straight(start, end, t)), 120)


@both_sizes
def test_as_rigid_as_possible_from_square_roots(ctx: Any, size: int) -> None:
    for start, end, t in pairs(ctx, size):
        (first, origin), (last, goal) = parts(start), parts(end)
        ((turn, stretch),) = factors(ctx, last @ inverse(ctx, first))
        linears = (
            power(ctx, turn, t) @ mixed(identity(ctx, size), stretch, t) @ first,
            power(ctx, turn, t) @ power(ctx, stretch, t) @ first,
        )
        mean = numbers(ctx, np.ones(size)) / (size + 1)
        path = mixed(first @ mean + origin, last @ mean + goal, t)
        due = {
            "arap": pose_of(ctx, linears[0], straight(start, end, t)),
            "rarap": pose_of(ctx, linears[0], path - linears[0] @ mean),
            "asap": pose_of(ctx, linears[1], path - linears[1] @ mean),
        }
        for name, pose in due.items():
            assert close(ctx, morphs.MORPHS[name](ctx, start, end, t), pose, 120), name


@both_sizes
def test_mixed_logarithms_of_polar_factors(ctx: Any, size: int) -> None:
    for start, end, t in pairs(ctx, size):
        (first, first_stretch), (last, last_stretch) = factors(ctx, parts(start)[0], parts(end)[0])
        turned = exponential_of(ctx, mixed(logarithm(ctx, first), logarithm(ctx, last), t))
        grown = exponential_of(ctx, mixed(logarithm(ctx, first_stretch), logarithm(ctx, last_stretch), t))
        sumner = pose_of(ctx, turned @ mixed(first_stretch, last_stretch, t), straight(start, end, t))
        assert close(ctx, morphs.sumner_2005(ctx, start, end, t), sumner, 120)
        kaji = pose_of(ctx, turned @ grown, straight(start, end, t))
        assert close(ctx, morphs.polar_exponential(ctx, start, end, t), kaji, 120)


@both_sizes
def test_alexa_2002_is_enclosed(ctx: Any, size: int) -> None:
    for start, end, t in pairs(ctx, size):
        due = exponential(mixed(sam.log(ctx, start), sam.log(ctx, end), t))
        assert distance(ctx, due, morphs.alexa_2002(ctx, start, end, t)) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize("entries", [[[0, 0], [0, 0]], [[0, 3], [0, 0]], [[1e-40, 0], [0, -1]], [[0, -2], [2, 0]]])
def test_exponentials_with_eigenvalues_that_coincide(ctx: Any, entries: Any) -> None:
    matrix = tangent(ctx, numbers(ctx, np.array(entries, dtype=float)), numbers(ctx, np.array([5.0, -2.0])))
    assert distance(ctx, exponential(matrix), sam.exponential(ctx, matrix)) <= ctx.ldexp(ctx.one, LOST - BITS)


@both_sizes
def test_log_spiral_by_powers_of_similarities(ctx: Any, size: int) -> None:
    for start, end, t in pairs(ctx, size):
        similarities = []
        for pose in (start, end):
            ((turn, _),) = factors(ctx, parts(pose)[0])
            scale = ctx.root(ctx.det(ctx.matrix(parts(pose)[0].tolist())), size)
            similarities.append(pose_of(ctx, turn * scale, parts(pose)[1]))
        first, last = similarities
        rest = mixed(inverse(ctx, first) @ start, inverse(ctx, last) @ end, t)
        due = sam.power(ctx, exact_last_row(last @ inverse(ctx, first)), t) @ first @ rest
        assert close(ctx, morphs.log_spiral(ctx, start, end, t), due, 120)


def exact_last_row(matrix: Array) -> Array:
    """The homogeneous matrix without the rounding of its last row."""
    matrix[-1] = [0 * x for x in matrix[-1, :-1]] + [0 * matrix[-1, -1] + 1]
    return matrix


def similarity(ctx: Any, first: Array, last: Array) -> Array:
    """The similarity of the plane that takes the two points of ``first`` to those of ``last``."""
    side, goal = ctx.mpc(*(first[1] - first[0])), ctx.mpc(*(last[1] - last[0]))
    z = goal / side
    part = array([[z.real, -z.imag], [z.imag, z.real]])
    return pose_of(ctx, part, last[0] - part @ first[0])


def test_three_spirals_by_powers_of_similarities(ctx: Any) -> None:
    corners = numbers(ctx, np.array([[0.0, 0, 1], [1, 0, 1], [0, 1, 1]]))
    for start, end, t in pairs(ctx, 2):
        first, last = ((corners @ pose.T)[:, :2] for pose in (start, end))
        moved = numbers(ctx, np.zeros((3, 2)))
        for side in ([0, 1], [1, 2], [2, 0]):
            step = sam.power(ctx, similarity(ctx, first[side], last[side]), t)
            moved[side] += (first[side] @ step[:2, :2].T + step[:2, 2]) / 2
        found = (corners @ morphs.three_spiral(ctx, start, end, t).T)[:, :2]
        assert close(ctx, found, moved, 120)


@both_sizes
def test_lie_by_aligned_frames(ctx: Any, size: int) -> None:
    """With L = Q U for each pose and the rigid P = [Q, translation], it is (P_C P_B^-1)^t P_B (U_C U_B^-1)^t U_B."""
    for start, end, t in pairs(ctx, size):
        rigid, upper = [], []
        for pose in (start, end):
            q, u = (
                np.array(m.tolist(), dtype=object).reshape(size, size)
                for m in ctx.qr(ctx.matrix(parts(pose)[0].tolist()))
            )
            signs = array([ctx.sign(u[i, i]) for i in range(size)])
            rigid.append(pose_of(ctx, q * signs, parts(pose)[1]))
            upper.append(u * signs[:, None])
        screw = sam.power(ctx, exact_last_row(rigid[1] @ inverse(ctx, rigid[0])), t) @ rigid[0]
        grown = power(ctx, upper[1] @ inverse(ctx, upper[0]), t) @ upper[0]
        due = pose_of(ctx, parts(screw)[0] @ grown, parts(screw)[1])
        assert close(ctx, morphs.lie(ctx, start, end, t), due, 120)


def test_sim_is_enclosed(ctx: Any) -> None:
    for start, end, t in pairs(ctx, 3, "sim"):
        first = sim3.log(ctx, start)
        x = mixed(first, sim3.log_next(ctx, end, first), t)
        matrix = tangent(ctx, cross_matrix(ctx, x[:3]) + identity(ctx, 3) * x[6], x[3:6])
        assert distance(ctx, exponential(matrix), morphs.sim(ctx, start, end, t)) <= ctx.ldexp(ctx.one, LOST - BITS)


def rigid_pairs(ctx: Any) -> list[tuple[Array, Array, Array]]:
    """Rigid poses, exactly so, and a time."""
    draw = np.random.default_rng(7)
    twists = [numbers(ctx, draw.normal(size=6)) for _ in range(8)]
    return [
        (se3.exp(ctx, twists[2 * i]), se3.exp(ctx, twists[2 * i + 1]), numbers(ctx, TIMES[i % len(TIMES)]))
        for i in range(4)
    ]


def test_sclerp_is_the_steady_morph(ctx: Any) -> None:
    for start, end, t in rigid_pairs(ctx):
        assert close(ctx, morphs.sclerp(ctx, start, end, t), sam.morph(ctx, start, end, t), 120)


def test_dual_quaternions_keep_to_the_screw(ctx: Any) -> None:
    """The blend turns by phi and slides by delta along the screw's axis: with dual numbers for angle and slide,

    tan(phi/2) = t sin(theta/2) / (1 - t + t cos(theta/2)), and delta = d phi / d theta times the screw's own slide.
    """
    for start, end, t in rigid_pairs(ctx):
        twist, time = se3.log(ctx, exact_last_row(inverse(ctx, start) @ end)), t[()]
        theta = norm(ctx, twist[:3])
        axis, (sine, cosine) = twist[:3] / theta, (ctx.sin(theta / 2), ctx.cos(theta / 2))
        along = axis * (axis @ twist[3:])
        phi = 2 * ctx.atan2(time * sine, 1 - time + time * cosine)
        slope = time * (time + (1 - time) * cosine) / ((1 - time) ** 2 + time**2 + 2 * time * (1 - time) * cosine)
        blend = np.concatenate([axis * phi, (twist[3:] - along) * (phi / theta) + along * slope])
        due = start @ se3.exp(ctx, blend)
        assert close(ctx, morphs.dual_quaternion_linear(ctx, start, end, t), due, 120)


QUARTER, AWAY = homogeneous([[0.0, -1], [1, 0]], [0.0, 0]), homogeneous(np.eye(2), [6.0, 0])


def test_the_numbers_of_rossignac_and_vinacua(ctx: Any) -> None:
    """Section 3.3.2: B = Rotate(90 degrees), C = Translate(6, 0), and X with X B half way. All printed are right."""
    start, end, half = numbers(ctx, QUARTER), numbers(ctx, AWAY), numbers(ctx, 0.5)
    root = ctx.sqrt(2)
    turn = np.array([[1 / root, 1 / root], [-1 / root, 1 / root]], dtype=object)
    steady = pose_of(ctx, turn, array([ctx.mpf(3), 3 * root - 3]))
    alexa = pose_of(ctx, turn, array([6 * root / ctx.pi, -6 * (root - 2) / ctx.pi]))
    assert close(ctx, sam.morph(ctx, start, end, half), steady @ start)
    assert close(ctx, morphs.alexa_2002(ctx, start, end, half), alexa @ start)
    assert close(ctx, steady @ steady @ start, end)
    there = alexa @ alexa @ start
    assert close(ctx, there, pose_of(ctx, identity(ctx, 2), array([12 * root / ctx.pi, ctx.zero])))
    assert ctx.nstr(there[0, 2], 4) == "5.402"


def turned(ctx: Any, angle: Any, size: int) -> Array:
    """A rotation of the plane, or about the z axis."""
    cosine, sine = ctx.cos_sin(angle)
    plane = pose_of(ctx, array([[cosine, -sine], [sine, cosine]]), numbers(ctx, np.array([1.0, 2.0])))
    return plane if size == 2 else in_space(ctx, plane)


@pytest.mark.parametrize("name", sorted(set(morphs.CONTINUATIONS) - {"sumner_2005", "polar_exponential", "sim"}))
def test_a_morph_is_continued_through_half_a_turn(ctx: Any, name: str) -> None:
    """Between poses turned by pi - h and by pi + h it jumps, and the continuation does not."""
    size = 3 if name in IN_SPACE_ALONE else 2
    step, t = ctx.ldexp(ctx.one, -100), numbers(ctx, 0.5)
    start = turned(ctx, ctx.zero, size)
    before, beyond = (turned(ctx, ctx.pi + sign * step, size) for sign in (-1, 1))
    morph = morphs.MORPHS[name]
    value = morph(ctx, start, before, t)
    assert not close(ctx, morph(ctx, start, beyond, t), value, BITS - 50)
    assert close(ctx, morphs.CONTINUATIONS[name](ctx, value, start, beyond, t), value, BITS - 90)


@pytest.mark.parametrize("name", ["alexa_2002", "sumner_2005", "polar_exponential", "sim"])
def test_a_morph_is_continued_where_a_pose_itself_turns_by_pi(ctx: Any, name: str) -> None:
    size = 3 if name in IN_SPACE_ALONE else 2
    step, t = ctx.ldexp(ctx.one, -100), numbers(ctx, 0.5)
    end = turned(ctx, ctx.mpf(1), size)
    before, beyond = (turned(ctx, ctx.pi + sign * step, size) for sign in (-1, 1))
    morph = morphs.MORPHS[name]
    value = morph(ctx, before, end, t)
    assert not close(ctx, morph(ctx, beyond, end, t), value, BITS - 50)
    assert close(ctx, morphs.CONTINUATIONS[name](ctx, value, beyond, end, t), value, BITS - 90)


def half_turn(size: int) -> np.ndarray[Any, Any]:
    return homogeneous(-np.eye(2), [4.0, 2]) if size == 2 else homogeneous(np.diag([-1.0, -1, 1]), [4.0, 2, 1])


@pytest.mark.parametrize(
    "name", ["shoemake_duff", "arap", "asap", "sumner_2005", "polar_exponential", "log_spiral", "lie"]
)
@both_sizes
def test_half_a_turn_goes_the_positive_way(ctx: Any, name: str, size: int) -> None:
    pose = morphs.MORPHS[name](ctx, identity(ctx, size + 1), numbers(ctx, half_turn(size)), numbers(ctx, 0.5))
    due = numbers(ctx, np.array([[0.0, -1], [1, 0]]))
    # From E_p^-1 E_q backwards: the rotation from C to B is by pi about +z, and B to C the other way.
    assert close(ctx, pose[:2, :2], due.T if name == "lie" else due)


@pytest.mark.parametrize("name", sorted(IN_SPACE_ALONE))
def test_half_a_turn_of_space_alone(ctx: Any, name: str) -> None:
    pose = morphs.MORPHS[name](ctx, identity(ctx, 4), numbers(ctx, half_turn(3)), numbers(ctx, 0.5))
    assert close(ctx, pose[:2, :2], numbers(ctx, np.array([[0.0, -1], [1, 0]])))


@pytest.mark.parametrize("name", morphs.MORPHS)
def test_outside_the_domain(ctx: Any, name: str) -> None:
    size = 2 if name in IN_THE_PLANE_ALONE else 3
    good = np.eye(size + 1)
    mirrored, projective, unbounded = good.copy(), good.copy(), good.copy()
    mirrored[0, 0], projective[-1, 0], unbounded[0, -1] = -1.0, 1e-300, np.inf
    reflected = "not a rotation" if name in IN_SPACE_ALONE - {"sim"} else "determinant"
    for bad, reason in ((mirrored, reflected), (projective, "last row"), (unbounded, "not finite")):
        for argument, poses in (("start", (bad, good)), ("end", (good, bad))):
            with pytest.raises(InputError, match=reason) as caught:
                morphs.MORPHS[name](ctx, *(numbers(ctx, pose) for pose in poses), scalar(ctx.one))
            assert caught.value.argument == argument
    with pytest.raises(InputError, match="t: not finite"):
        morphs.MORPHS[name](ctx, numbers(ctx, good), numbers(ctx, good), scalar(ctx.nan))


def test_poses_without_logarithms(ctx: Any) -> None:
    bad, good = numbers(ctx, np.diag([-1.0, -2, 1])), identity(ctx, 3)
    for argument, poses in (("start", (bad, good)), ("end", (good, bad))):
        with pytest.raises(InputError, match="no real logarithm") as caught:
            morphs.alexa_2002(ctx, *poses, scalar(ctx.one))
        assert caught.value.argument == argument


@pytest.mark.parametrize(("name", "reason"), [("sim", "not a similarity"), ("sclerp", "not a rotation")])
def test_poses_that_are_neither_similar_nor_rigid(ctx: Any, name: str, reason: str) -> None:
    bad, good = numbers(ctx, np.diag([1.0, 1, 1.001, 1])), identity(ctx, 4)
    for argument, poses in (("start", (bad, good)), ("end", (good, bad))):
        with pytest.raises(InputError, match=reason) as caught:
            morphs.MORPHS[name](ctx, *poses, scalar(ctx.one))
        assert caught.value.argument == argument
