"""Measures of motions: how unsteady one is, how long, what becomes of volume, and how far orderings lead apart.

A path is given by its poses at equal steps of time, homogeneous matrices (..., poses, n, n), n = 3 in the plane and 4
in space. Volumes and accelerations are computed in double-double arithmetic and rounded once.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from affinecert.errors import InputError
from affinecert.fast import _wide, affine_lie
from affinecert.fast._curve_length import curve_length
from affinecert.fast._kernel import Array, checked
from affinecert.fast._stages import refuse

POSES, SIZES = ("poses", "n", "n"), (3, 4)
"""The shape of a path, and what n may be."""

LAST_ROW = "the last row is not 0 ... 0 1"
DETERMINANT = "the determinant of the linear part is not positive"
END = "the determinant of an end is not positive"

LONGEST = 64.0
"""Rotation vectors have at most so many radians, ten turns: nobody interpolates over more, and the time grows."""


def average_relative_acceleration(poses: ArrayLike, points: ArrayLike) -> Array:
    """The mean acceleration of points in the moving frame, 0 for a steady motion (Rossignac and Vinacua, section 2.4).

    poses (..., poses, n, n), three or more, at equal steps of time, 1 in all, and points (..., points, n - 1); gives
    (...), in units of length, per unit of time squared. In the frame of M_i, a point x moves by M_i^-1 M_(i+1) x - x
    during a step: the velocity is that times the number k of steps, the acceleration k times the difference of two
    successive velocities; its length is averaged over the points and the k - 1 inner times. Raises InputError for a
    wrong shape or dtype, numbers that are not finite, no point, a last row other than 0 ... 0 1, and a determinant that
    is not positive.

    >>> falling = [[[1.0, 0.0, 0.0], [0.0, 1.0, -t * t], [0.0, 0.0, 1.0]] for t in (0.0, 0.5, 1.0)]
    >>> average_relative_acceleration(falling, [[0.0, 0.0]])
    array(2.)
    """
    path, places = checked({"poses": POSES, "points": ("points", "n-1")}, (poses, points), SIZES)[0]
    steps, count = path.shape[-3] - 1, places.shape[-2]
    if steps < 2:
        raise InputError("poses", f"shape {path.shape}: at least three poses are due")
    if count == 0:
        raise InputError("points", f"shape {places.shape}: at least one point is due")
    _with_last_row(path)
    wide = _wide.widen(path)
    _require((_wide.determinant_sign(wide) > 0.0).all(axis=-1), "poses", DETERMINANT)
    before, after = wide[..., :-1, :, :, :], wide[..., 1:, :, :, :]
    step = _wide.product(_wide.inverse(before), _wide.subtract(after, before))
    # Points as columns, so that one product moves them all: (..., steps, n - 1, points, 2).
    columns = _wide.widen(np.swapaxes(places, -1, -2))[..., None, :, :, :]
    moved = _wide.add(_wide.product(_wide.linear_part(step), columns), _wide.translation(step)[..., None, :])
    change = _wide.subtract(moved[..., 1:, :, :, :], moved[..., :-1, :, :, :])
    lengths = _wide.square_root(_total(_wide.multiply(change, change), -3))
    mean = _wide.divide(_total(_total(lengths, -2), -2), _wide.widen(np.array(float(count * (steps - 1)))))
    return _wide.rounded(_wide.times(mean, float(steps * steps)))


class Limit(NamedTuple):
    """The limit of a sequence, and what it may err by."""

    value: float
    error: float


def average_relative_acceleration_limit(
    morph: Callable[[Array, Array, Array], Array],
    start: ArrayLike,
    end: ArrayLike,
    points: ArrayLike,
    tolerance: float = 1e-6,
) -> Limit:
    """What `average_relative_acceleration` of a morph comes to for ever shorter steps, and an estimate of the error.

    morph(start, end, t) gives the poses (times, n, n) for poses (n, n) and times (times,); points are (points, n - 1).
    The number of steps is doubled from 4 on, and the sequence extrapolated (Richardson; the error of k steps is a
    series in 1/k), until two extrapolations in a row agree to ``tolerance``, absolutely or relatively, whichever is
    coarser; or until 1024 steps, beyond which rounding of the poses prevails: the error then tells what was reached.
    """
    rows: list[list[float]] = []
    best = Limit(np.nan, np.inf)
    for level in range(9):
        times = np.linspace(0.0, 1.0, (4 << level) + 1)
        row = [float(average_relative_acceleration(morph(np.asarray(start), np.asarray(end), times), points))]
        for order, before in enumerate(rows[-1] if rows else [], 1):
            row.append(row[-1] + (row[-1] - before) / (2**order - 1))
        if rows:
            found = Limit(row[-1], abs(row[-1] - rows[-1][-1]))
            best = min(best, found, key=lambda limit: limit.error)
            if found.error <= tolerance * max(1.0, abs(found.value)):
                break
        rows.append(row)
    return best


def simplex_grid(dimension: int, parts: int) -> Array:
    """The points of the standard simplex 0, e_1, ..., e_dimension whose coordinates are multiples of 1 / parts.

    Gives (points, dimension) in lexicographic order: where Rossignac and Vinacua, and Bansal and Tatu (with 100 parts),
    average accelerations.

    >>> simplex_grid(2, 1)
    array([[0., 0.],
           [0., 1.],
           [1., 0.]])
    """
    whole = [point for point in product(range(parts + 1), repeat=dimension) if sum(point) <= parts]
    return np.array(whole, dtype=np.float64).reshape(-1, dimension) / parts


def volume(poses: ArrayLike) -> Array:
    """The signed volumes along a path: the determinants of the linear parts.

    poses (..., poses, n, n); gives (..., poses). Raises InputError for a wrong shape or dtype, numbers that are not
    finite, and a last row other than 0 ... 0 1.
    """
    (path,) = checked({"poses": POSES}, (poses,), SIZES)[0]
    _with_last_row(path)
    return _wide.rounded(_volume(path))


def degeneracy(poses: ArrayLike) -> Array:
    """How far a path falls below the volumes of its ends: 1 - min det L_i / min(det L_0, det L_k).

    poses (..., poses, n, n), one or more; gives (...): 0 where no pose has less volume than both ends, 1 where one is
    flat, more where one is turned inside out. Raises InputError as `volume` does, and for an end whose determinant is
    not positive.

    >>> half_turn = [np.diag([1.0 - 2.0 * t, 1.0 - 2.0 * t, 1.0]) for t in (0.0, 0.25, 0.5, 0.75, 1.0)]
    >>> degeneracy(half_turn)  # the linear morph to a half turn
    array(1.)
    """
    (path,) = checked({"poses": POSES}, (poses,), SIZES)[0]
    if path.shape[-3] == 0:
        raise InputError("poses", f"shape {path.shape}: at least one pose is due")
    _with_last_row(path)
    ends = _wide.determinant_sign(_wide.widen(path[..., [0, -1], :, :]))
    _require((ends > 0.0).all(axis=-1), "poses", END)
    volumes = _volume(path)
    least = _least(volumes[..., [0, -1], :])
    return _wide.rounded(_wide.divide(_wide.subtract(least, _least(volumes)), least))


def path_deviation(source: ArrayLike, target: ArrayLike, times: ArrayLike) -> Array:
    """How far the order of a tetrahedron's vertices bends its interpolation (Bansal and Tatu, section 5.2).

    source and target (..., 4, 3), vertices in rows, and times (..., times), one or more; gives (..., 2). With T_t the
    affine map from the source to what `affine_lie.interpolate_orderings` makes of it, one for each of the twelve
    orderings, two orderings deviate by the largest Frobenius norm |T_t - T'_t|, as homogeneous matrices, over the
    times; given are the maximum and the median of the 66 pairs. Raises InputError as
    `affine_lie.interpolate_orderings` does, and for no time.
    """
    inputs = {"source": (4, 3), "target": (4, 3), "times": ("times",)}
    first, last, moments = checked(inputs, (source, target, times))[0]
    if moments.shape[-1] == 0:
        raise InputError("times", f"shape {moments.shape}: at least one time is due")
    maps = affine_lie.maps_by_orderings(first, last, moments)
    apart = _wide.subtract(maps[..., FIRST, :, :, :], maps[..., SECOND, :, :, :])
    squares = _total(_total(_wide.multiply(apart, apart), -2), -2)
    deviations = np.sort(_wide.rounded(_wide.square_root(squares)).max(axis=-2), axis=-1)
    middle = deviations.shape[-1] // 2
    return np.stack([deviations[..., -1], (deviations[..., middle - 1] + deviations[..., middle]) / 2], axis=-1)


FIRST, SECOND = np.triu_indices(len(affine_lie.ORDERINGS), 1)
"""The orderings of each pair."""


def rotation_curve_length(first: ArrayLike, second: ArrayLike) -> Array:
    """The length of the curve exp((1 - s) [a] + s [b]), s from 0 to 1, in SO(3): a turn is as long as its angle.

    first a and second b (..., 3), rotation vectors in radians, 64 at most; gives (...), in radians: the integral of
    |dexp_c (b - a)|, c = (1 - s) a + s b. Gallier, Allen-Blanchette and Leonardos print |b - a| (section 10), to which
    it comes only if a and b are parallel. Raises InputError for a wrong shape or dtype, numbers that are not finite,
    and vectors that are longer.

    >>> rotation_curve_length([0.0, 0.0, 0.5], [0.0, 0.0, -0.25])
    array(0.75)
    >>> print(f"{rotation_curve_length([np.pi, 0.0, 0.0], [0.0, np.pi, 0.0]):.4f}, not {np.pi * np.sqrt(2):.4f}")
    3.6328, not 4.4429
    """
    inputs = {"first": (3,), "second": (3,)}
    arrays = checked(inputs, (first, second))[0]
    for name, vector in zip(inputs, arrays, strict=True):
        # Each entry cut down to one more radian, lest a square overflows; the sum is told from 64^2 to its last bit.
        entries = _wide.widen(np.clip(vector, -LONGEST - 1.0, LONGEST + 1.0))
        excess = _wide.subtract(_total(_wide.multiply(entries, entries), -2), _wide.widen(np.array(LONGEST**2)))
        _require(excess[..., 0] <= 0.0, name, "longer than 64 radians")
    return curve_length(*arrays)


def _with_last_row(path: Array) -> None:
    """Refuses paths with a pose whose last row is not 0 ... 0 1."""
    _require((path[..., -1, :] == np.eye(path.shape[-1])[-1]).all(axis=(-2, -1)), "poses", LAST_ROW)


def _require(good: NDArray[np.bool_] | np.bool_, argument: str, reason: str) -> None:
    """Raises InputError for the first item that is not good, if any."""
    refuse(np.asarray(good, dtype=np.float64), 0.0, argument, reason, np.shape(good))


def _volume(path: Array) -> Array:
    """The determinants of the linear parts, by the first row's cofactors, as pairs."""
    entries = _wide.widen(path[..., :-1, :-1])
    if entries.shape[-2] == 2:
        return _minor(entries, 0, 1, 0, 1)
    first, second, third = (
        _wide.multiply(entries[..., 0, k, :], _minor(entries, 1, 2, (k + 1) % 3, (k + 2) % 3)) for k in range(3)
    )
    return _wide.add(_wide.add(first, second), third)


def _minor(entries: Array, i: int, j: int, k: int, m: int) -> Array:
    """The determinant of rows i and j, columns k and m."""
    one = _wide.multiply(entries[..., i, k, :], entries[..., j, m, :])
    return _wide.subtract(one, _wide.multiply(entries[..., i, m, :], entries[..., j, k, :]))


def _least(pairs: Array) -> Array:
    """The least of pairs along the axis before the last, (..., count, 2) -> (..., 2)."""
    place = np.lexsort((pairs[..., 1], pairs[..., 0]), axis=-1)[..., :1, None]
    return np.take_along_axis(pairs, place, axis=-2)[..., 0, :]


def _total(pairs: Array, axis: int) -> Array:
    """The sum of pairs along an axis, halves upon halves."""
    rows: Array = np.moveaxis(pairs, axis, 0)
    while len(rows) > 1:
        half = len(rows) // 2
        rest = rows[2 * half :]
        rows = np.concatenate([_wide.add(rows[:half], rows[half : 2 * half]), rest])
    return np.asarray(rows[0])
