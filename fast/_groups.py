"""The groups G_A, G_S and SE(3) as groups of matrices of pairs, for the curves of `affinecert.fast._li_hao`."""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._li_hao import Group
from affinecert.fast._wide_affine import affine_exponential, affine_logarithm
from affinecert.fast._wide_rotation import rotation_vector


def _flipped(shear: Array) -> Array:
    """The matrices mirrored at their second diagonals: of a shear an affine map of the plane, last row 0 0 1.

    Mirroring turns products round and leaves sums and powers, so that exp and log may be taken on either side.
    """
    return np.swapaxes(shear, -3, -2)[..., ::-1, ::-1, :]


def _shear_exp(element: Array) -> Array:
    return _flipped(affine_exponential(_flipped(element)))


def _shear_log(shear: Array) -> Array:
    return _flipped(affine_logarithm(_flipped(shear))[0])


def _shear_inverse(shear: Array) -> Array:
    return _flipped(wide.inverse(_flipped(shear)))


def _reciprocal(scale: Array) -> Array:
    return wide.divide(wide.widen(np.ones(scale.shape[:-1])), scale)


def _skew(omega: Array) -> Array:
    x, y, z = np.moveaxis(omega, -2, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-2).reshape(*x.shape[:-1], 3, 3, 2)


def _rigid_log(pose: Array) -> Array:
    """The logarithm [[ [omega]x, v ], [0, 0]]: v solves V v = d, where exp moves the origin by V times its v."""
    turn = _skew(rotation_vector(wide.linear_part(pose)))
    unit = wide.widen(np.eye(3))
    columns = wide.translation(affine_exponential(wide.tangent(turn[..., None, :, :, :], unit)))
    return wide.tangent(turn, wide.image(wide.inverse(wide.transposed(columns)), wide.translation(pose)))


def _rigid_inverse(pose: Array) -> Array:
    back = wide.transposed(wide.linear_part(pose))
    return wide.homogeneous(back, -wide.image(back, wide.translation(pose)))


SHEARS = Group(_shear_exp, _shear_log, _shear_inverse)
"""G_A: (..., 3, 3, 2)."""

SCALES = Group(wide.exponential, wide.logarithm, _reciprocal)
"""G_S: scales as matrices (..., 1, 1, 2)."""

RIGID = Group(affine_exponential, _rigid_log, _rigid_inverse)
"""SE(3): (..., 4, 4, 2), rotations up to 2^-100."""
