"""The listings of section 5.3, over SAM(B, t, C) = (C B^-1)^t B, and velocities of motions in the moving frame."""

from __future__ import annotations

from collections.abc import Callable

from affinecert.errors import InputError
from affinecert.properties.claims import definitions
from affinecert.properties.claims.precision import exactly, mp, size
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, scalar

Poses = tuple[Array, Array, Array]
"""F_A, F_B and F_C, homogeneous."""

EIGHTHS = tuple(mp.mpf(k) / 8 for k in range(9))
"""Times from 0 to 1."""

Motion = Callable[[Number], Array]


def steady(start: Array, t: Number, end: Array) -> Array:
    """SAM(F_A, t, F_B). Raises InputError if there is none."""
    pose: Array = power(end @ definitions.inverse(mp, start), t) @ start
    return pose


def carried(pose: Array, start: Array, t: Number, end: Array) -> Array:
    """SAM(F_X, F_A, t, F_B): the image of F_X under the motion (F_B F_A^-1)^t."""
    image: Array = power(end @ definitions.inverse(mp, start), t) @ pose
    return image


def power(affine: Array, t: Number) -> Array:
    """A^t. Raises InputError if there is none."""
    return sam.power(mp, affine, scalar(mp.mpf(t)))


def bezier(start: Array, middle: Array, end: Array, t: Number) -> Array:
    """The listing bezier of three poses."""
    return steady(steady(start, t, middle), t, steady(middle, t, end))


def left_control(start: Array, middle: Array, end: Array) -> Array:
    """The listing leftControl."""
    return carried(steady(start, mp.mpf(3) / 4, middle), end, mp.mpf(1) / 4, middle)


def biarc(poses: Poses, t: Number, control: Callable[[Array, Array, Array], Array] = left_control) -> Array:
    """The bi-arc, with the control poses F_L = control(F_A, F_B, F_C) and F_R = control(F_C, F_B, F_A)."""
    first, middle, last = poses
    if t <= mp.mpf(1) / 2:
        return bezier(first, control(first, middle, last), middle, 2 * t)
    return bezier(middle, control(last, middle, first), last, (t - mp.mpf(1) / 2) * 2)


def local_velocity(motion: Motion, t: Number) -> Array:
    """The velocity of a motion at a time in its moving frame, M^-1 M', a homogeneous matrix with last row zero."""
    velocity: Array = definitions.inverse(mp, motion(t)) @ definitions.derivative(mp, motion, t)
    return velocity


def jump(motion: Motion, t: Number) -> Number:
    """How much the velocity of a motion jumps at a time: of one that is smooth less than 1e-50."""
    with mp.workdps(160):
        step = mp.mpf(10) ** -60
        before, at, after = (motion(t + k * step) for k in (-1, 0, 1))
        return size((after - at) - (at - before)) / step


def stretched_turns(k: int) -> Poses:
    """The poses 1, P and Q P: quarter turns, P stretched by k along the first axis and Q by 1/k, k a power of two.

    The powers P^s = [[cos a, -k sin a], [sin a / k, cos a]], a = s pi/2, and Q^s have products of the trace 2 cos^2 a -
    (k^2 + 1/k^2) sin^2 a. The last pose is bad: [[-k^2, 0], [0, -1/k^2]] or its reverse.
    """
    there = exactly([[0, -k, 0], [1 / k, 0, 1], [0, 0, 1]])
    back = exactly([[0, -1 / k, 2], [k, 0, 0], [0, 0, 1]])
    return exactly([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), there, back @ there


def ordinary_poses() -> list[Poses]:
    """Poses of the plane and of space, a bad pair of first and last poses among them, and good ones between."""
    half_turn = exactly([[-1, 0, 4], [0, -2, 1], [0, 0, 1]]), exactly([[0, -1, 1], [1.5, 0, 2], [0, 0, 1]])
    plane = exactly([[1.5, 0.5, 2], [-0.25, 1, 1], [0, 0, 1]]), exactly([[0.5, -1, 3], [1, 1, 0], [0, 0, 1]])
    space = (
        exactly([[1, 0.5, 0, 1], [-0.5, 1, 0.25, 0], [0, 0, 1.5, 1], [0, 0, 0, 1]]),
        exactly([[0.5, 1, 0, 2], [-1, 0.5, 0.5, 0], [0.25, 0, 2, 1], [0, 0, 0, 1]]),
    )
    starts = [exactly([[int(i == j) for j in range(n)] for i in range(n)]) for n in (3, 3, 4)]
    return [
        (starts[0], half_turn[1], half_turn[0]),
        (starts[1], plane[0], plane[1]),
        (starts[2], space[0], space[1]),
    ]


def regular_poses() -> Poses:
    """1, P and P^2: the poses of one steady motion."""
    step = exactly([[0.75, -0.5, 1], [0.5, 1.25, 0], [0, 0, 1]])
    return exactly([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), step, step @ step


def with_good_legs() -> list[Poses]:
    """Poses with steady morphs from the first to the second and from the second to the third."""
    return [*map(_legs_are_good, ordinary_poses()), *with_stretched_legs(2)()]


def with_stretched_legs(*factors: int) -> Callable[[], list[Poses]]:
    """The same, the legs being `stretched_turns`."""
    return lambda: [_legs_are_good(stretched_turns(k)) for k in factors]


def _legs_are_good(poses: Poses) -> Poses:
    """The poses, if the two steady morphs exist between them, and InputError if not."""
    half = mp.mpf(1) / 2
    steady(poses[0], half, poses[1])
    steady(poses[1], half, poses[2])
    return poses


def undefined(motion: Callable[[Poses, Number], Array], poses: Poses) -> int:
    """Whether a motion is missing at one of the eighths of its time."""
    try:
        for t in EIGHTHS:
            motion(poses, t)
    except InputError:
        return 1
    return 0
