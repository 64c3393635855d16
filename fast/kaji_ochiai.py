"""Twelve parameters of an affine map of space, and blends, splines and deformations that are taken in them.

The parameters are (l1, l2, l3, x1, x2, x3, y11, y12, y13, y22, y23, y33): a translation, a rotation vector in radians,
and the upper half of a symmetric matrix. phi takes them to the translation by l after exp([x]) exp(Y), [x] being the
matrix of the vector product with x; psi takes an affine map back, by the polar factors of its linear part. Any numbers
are parameters of an affine map of positive determinant; rigid motions, similarities, stretches and so on are linear
subspaces of them. Everything is computed in double-double arithmetic and rounded once.

Source: Kaji and Ochiai, "A concise parametrisation of affine transformation", 2016.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast import _wide as wide
from affinecert.fast._exact import half_turn
from affinecert.fast._kernel import Array, checked
from affinecert.fast._natural_spline import natural_spline_weights
from affinecert.fast._stages import refuse
from affinecert.fast._wide_polar import polar
from affinecert.fast._wide_rotation import rotation, rotation_vector, rotation_vector_near
from affinecert.fast._wide_symmetric import reduced_exponential, symmetric_logarithm

LAST_ROW = "the last row is not 0 0 0 1"
DETERMINANT = "the determinant of the linear part is not positive"

UPPER = ([0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2])
"""Where the last six parameters stand in Y: its upper half, row by row."""

WHOLE = ([0, 1, 2, 1, 3, 4, 2, 4, 5],)
"""Which of the six each entry of Y is, row by row."""

# A rotation whose matrix is so near to symmetric may be a half turn: what a condition of 2^50 leaves of 2^-104.
NEARLY_SYMMETRIC = 2.0**-54

# Longer rotation vectors are known to no better than a radian.
LONGEST_ANGLE = 2.0**51


class _Factors(NamedTuple):
    """Of affine maps (..., 4, 4), as pairs: translation (..., 3, 2), rotation (..., 3, 3, 2) and Y (..., 6, 2)."""

    translation: Array
    rotation: Array
    logarithm: Array

    def parameters(self, rotation_vector: Array) -> Array:
        """The parameters with that logarithm of the rotation, (..., 12, 2)."""
        return np.concatenate([self.translation, rotation_vector, self.logarithm], axis=-2)


def parametrise(affine: ArrayLike) -> Array:
    """The parameters psi(A) with the principal rotation vector (equation 3).

    affine (..., 4, 4); gives (..., 12). With L = R S, x is the rotation vector of R, its angle in [0, pi], at exactly
    pi its first component other than 0 positive; Y = log S. Raises InputError for a wrong shape or dtype, numbers that
    are not finite, a last row other than 0 0 0 1, and a determinant that is not positive.

    >>> parametrise(np.diag([1.0, np.e, np.e**2, 1.0])).round(12) + 0.0
    array([0., 0., 0., 0., 0., 0., 0., 0., 0., 1., 0., 2.])
    """
    (given,), _, _ = checked({"affine": (4, 4)}, (affine,))
    return wide.rounded(_principal(_factors("affine", given)))


def parametrise_near(affine: ArrayLike, near: ArrayLike) -> Array:
    """The parameters psi(A) with the rotation vector nearest to that of the parameters ``near`` (algorithm 1).

    affine (..., 4, 4), near (..., 12), of which entries 3 to 5 count; gives (..., 12). Of rotation vectors that are
    equally near, and without any rotation, the one that `so3.log_near` takes. Raises InputError as `parametrise` does.
    """
    (given, goal), _, _ = checked({"affine": (4, 4), "near": (12,)}, (affine, near))
    factors = _factors("affine", given)
    return wide.rounded(_broadcast(factors, rotation_vector_near(factors.rotation, wide.widen(goal[..., 3:6]))))


def realise(parameters: ArrayLike) -> Array:
    """The affine map phi(l, x, y) = [exp([x]) exp(Y), l] (equation 2).

    parameters (..., 12), any numbers; gives (..., 4, 4), with infinity where an entry is beyond the largest float64.
    Raises InputError for a wrong shape or dtype, and for numbers that are not finite.
    """
    (given,), _, _ = checked({"parameters": (12,)}, (parameters,))
    return _pose(*_realised(wide.widen(given)))


def blend(affines: ArrayLike, weights: ArrayLike) -> Array:
    """The affine map phi(w_1 psi(A_1) + ... + w_n psi(A_n)) (equation 9).

    affines (..., count, 4, 4) and weights (..., count), any numbers; gives (..., 4, 4). Psi is that of `parametrise`,
    and the errors raised are its own.
    """
    shapes = {"affines": ("count", 4, 4), "weights": ("count",)}
    (given, factors), _, _ = checked(shapes, (affines, weights))
    return _pose(*_realised(_mixed(_principal(_factors("affines", given, 1)), wide.widen(factors))))


def interpolate(poses: ArrayLike, knots: ArrayLike, t: ArrayLike) -> Array:
    """The affine map at t of the natural cubic spline of the parameters (section 5.4).

    poses (..., keys, 4, 4), knots (..., keys), t (...), any number; gives (..., 4, 4), at the knots the poses, up to
    rounding. The rotation vector of the first pose is principal, each other the nearest to the one before it; outside
    of the knots the cubics at the ends go on. Raises InputError as `parametrise` does, and for knots that are fewer
    than two or do not increase.
    """
    shapes = {"poses": ("keys", 4, 4), "knots": ("keys",), "t": ()}
    (given, places, time), _, _ = checked(shapes, (poses, knots, t))
    if places.shape[-1] < 2:
        raise InputError("knots", f"shape {places.shape}: fewer than two")
    factors = _factors("poses", given, 1)
    (weights,) = natural_spline_weights(places, time)
    return _pose(*_realised(_mixed(factors.parameters(_chained(factors.rotation)), weights)))


def deform(points: ArrayLike, probes: ArrayLike, weights: ArrayLike) -> Array:
    """Points moved each by the blend of the probes with its own weights (section 5.2).

    points (..., points, 3), probes (..., probes, 4, 4), weights (..., points, probes); gives (..., points, 3): a point
    u is taken to blend(probes, weights of u) u. Raises InputError as `blend` does.
    """
    shapes = {"points": ("points", 3), "probes": ("probes", 4, 4), "weights": ("points", "probes")}
    (places, given, factors), _, _ = checked(shapes, (points, probes, weights))
    parameters = _principal(_factors("probes", given, 1))
    linear, exponents, translation = _realised(wide.product(wide.widen(factors), parameters))
    moved = wide.product(linear, wide.widen(places)[..., None, :])[..., 0, :]
    with np.errstate(over="ignore", under="ignore"):
        return wide.rounded(wide.add(np.ldexp(moved, exponents[..., None, None]), translation))


def _factors(name: str, affine: Array, things: int = 0) -> _Factors:
    """The polar factors of affine maps, of which so many axes number the things of one item; refuses others."""
    batch = affine.shape[: affine.ndim - 2 - things]
    inner = tuple(range(len(batch), len(batch) + things))
    last_rows = np.asarray((affine[..., 3, :] == np.eye(4)[3]).all(axis=(-1, *inner)))
    refuse(last_rows.astype(np.float64), 0.0, name, LAST_ROW, batch)
    pairs = wide.widen(affine)
    linear = wide.linear_part(pairs)
    oriented = np.asarray((wide.determinant_sign(linear) > 0.0).all(axis=inner))
    refuse(oriented.astype(np.float64), 0.0, name, DETERMINANT, batch)
    turn, stretch = polar(linear)
    _settle_half_turns(affine, turn)
    return _Factors(wide.translation(pairs), turn, symmetric_logarithm(stretch)[(..., *UPPER, slice(None))])


def _settle_half_turns(affine: Array, turn: Array) -> None:
    """Makes rotations by pi exactly symmetric, and zeros of their axes exact.

    Both are decided in integers: of an ill-conditioned matrix double-doubles leave them open.
    """
    rough = turn[..., 0]
    skew = np.abs(rough - np.swapaxes(rough, -1, -2)).max(axis=(-2, -1))
    halves = (skew <= NEARLY_SYMMETRIC) & (np.trace(rough, axis1=-2, axis2=-1) < 0.0)
    for index in map(tuple, np.argwhere(halves)):
        # R + I is 2 x x^T, x the axis: any of its columns will do that is not small.
        column = int(np.argmax(np.diagonal(rough[index])))
        zeros = half_turn(affine[index][:3, :3], rough[index][:, column] + np.eye(3)[column])
        if zeros is not None:
            turn[index] = 0.5 * wide.add(turn[index], wide.transposed(turn[index]))
            for k in np.flatnonzero(zeros):
                turn[(*index, k)] = turn[(*index, slice(None), k)] = wide.widen(-np.eye(3)[k])


def _principal(factors: _Factors) -> Array:
    """The parameters with the principal rotation vectors."""
    return factors.parameters(rotation_vector(factors.rotation))


def _broadcast(factors: _Factors, omega: Array) -> Array:
    """The parameters with rotation vectors of a larger batch."""
    batch = omega.shape[:-2]
    translation = np.broadcast_to(factors.translation, (*batch, 3, 2))
    logarithm = np.broadcast_to(factors.logarithm, (*batch, 6, 2))
    return _Factors(translation, factors.rotation, logarithm).parameters(omega)


def _chained(turns: Array) -> Array:
    """The rotation vectors of a sequence (..., keys, 3, 3, 2), the first principal, each other nearest to the last."""
    vectors = [rotation_vector(turns[..., 0, :, :, :])]
    for key in range(1, turns.shape[-4]):
        vectors.append(rotation_vector_near(turns[..., key, :, :, :], vectors[-1]))
    return np.stack(vectors, axis=-3)


def _mixed(parameters: Array, weights: Array) -> Array:
    """The sum of parameters (..., count, 12, 2), with weights (..., count, 2)."""
    return wide.product(weights[..., None, :, :], parameters)[..., 0, :, :]


def _realised(parameters: Array) -> tuple[Array, Array, Array]:
    """The linear part but for powers of two, their exponents, and the translation, of parameters (..., 12, 2)."""
    translation, omega, y = np.split(parameters, [3, 6], axis=-2)
    logarithm = y[(..., *WHOLE, slice(None))].reshape(*y.shape[:-2], 3, 3, 2)
    stretch, exponents = reduced_exponential(logarithm)
    return wide.product(rotation(_bounded(omega)), stretch), exponents, translation


def _bounded(omega: Array) -> Array:
    """Rotation vectors, those that are too long for their angle to be known cut to some angle."""
    largest = np.abs(omega[..., 0]).max(axis=-1)[..., None, None]
    return np.where(largest > LONGEST_ANGLE, omega / np.maximum(largest, 1.0), omega)


def _pose(linear: Array, exponents: Array, translation: Array) -> Array:
    """The homogeneous matrix, rounded."""
    pose = wide.rounded(wide.homogeneous(linear, translation))
    with np.errstate(over="ignore", under="ignore"):
        pose[..., :3, :3] = np.ldexp(pose[..., :3, :3], exponents[..., None, None])
    return pose
