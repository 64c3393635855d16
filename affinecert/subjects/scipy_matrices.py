"""`scipy.linalg`: exponential, logarithm, powers and factors of matrices, where the catalogue's maps are these.

The adapter packs vectors into matrices and back, and hands on a complex result as it is: where a real value exists, a
complex one is the finding.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy import linalg

from affinecert.map import Array
from affinecert.subjects import generators
from affinecert.subjects.preconditions import (
    require_affine,
    require_last_row,
    require_positive,
    require_principal,
    require_similarities,
    require_symmetric,
)


def logm(matrix: Array) -> Any:
    """The matrix logarithms; the warning by which `linalg.logm` tells that a matrix is singular is its refusal."""
    with warnings.catch_warnings():
        warnings.filterwarnings("error", message="The logm input matrix is exactly singular")
        return require_principal(matrix, linalg.logm(matrix))


def powers(matrix: Array, t: Array) -> Any:
    """The powers A^t (N, n, n) of matrices (N, n, n).

    SciPy computes them in complex arithmetic wherever an eigenvalue is complex, and leaves the rounding in the
    imaginary part; that much is dropped, as everybody has to who uses it.
    """
    found = [linalg.fractional_matrix_power(item, float(power)) for item, power in zip(matrix, t, strict=True)]
    return require_principal(matrix, generators.real(np.stack(found)))


def sim3_exp(tangent: Array) -> Any:
    """The similarities (N, 4, 4) of tangents (N, 7)."""
    return linalg.expm(generators.similar(tangent[:, :3], tangent[:, 3:6], tangent[:, 6]))


def sim3_log(pose: Array) -> Any:
    """The tangents (N, 7) of similarities (N, 4, 4)."""
    require_similarities(pose)
    return generators.tangent(logm(pose))


def shear_exp(shear_twist: Array) -> Any:
    """The elements (N, 3, 3) of G_A from their logarithms (N, 5)."""
    return linalg.expm(generators.sheared(shear_twist))


def shear_log(shear: Array) -> Any:
    """The logarithms (N, 5) of elements (N, 3, 3) of G_A."""
    return logm(shear)[:, generators.SHEAR_ROWS, generators.SHEAR_COLUMNS]


def sym3_exp(matrix: Array) -> Any:
    """The exponentials (N, 3, 3) of symmetric matrices (N, 3, 3)."""
    require_symmetric(matrix)
    return linalg.expm(matrix)


def sym3_log(matrix: Array) -> Any:
    """The logarithms (N, 3, 3) of positive definite matrices (N, 3, 3)."""
    require_positive(matrix)
    return logm(matrix)


def sym3_power(matrix: Array, t: Array) -> Any:
    """The powers S^t (N, 3, 3) of positive definite matrices (N, 3, 3)."""
    require_positive(matrix)
    return powers(matrix, t)


def polar_decompose(linear: Array) -> tuple[Array, Array]:
    """Rotations and stretches (N, d, d) of linear maps (N, d, d); `linalg.polar` takes reflections for rotations."""
    if np.any(np.linalg.slogdet(linear)[0] <= 0):
        raise ValueError("the determinant is not positive")
    rotation, stretch = np.empty_like(linear), np.empty_like(linear)
    for item, turn, root in zip(linear, rotation, stretch, strict=True):
        turn[:], root[:] = linalg.polar(item)
    return rotation, stretch


def affine_lie_decompose(affine: Array) -> tuple[Array, Array, Array]:
    """Rigid (N, 4, 4), shear (N, 3, 3) and scale (N,) of affine maps (N, 4, 4), by LAPACK's RQ factorisation.

    RQ leaves the signs of the triangle's diagonal free; here they are made positive.
    """
    require_affine(affine)
    rigid = np.broadcast_to(np.eye(4), affine.shape).copy()
    shear = np.empty((len(affine), 3, 3))
    for item, pose, normal in zip(affine, rigid, shear, strict=True):
        triangle, rotation = linalg.rq(item[:3, :3])
        signs = np.copysign(1.0, np.diag(triangle))
        pose[:3, :3] = signs[:, None] * rotation
        normal[:] = triangle * signs
        pose[:3, 3] = linalg.solve_triangular(normal, item[:3, 3])
    scale = shear[:, 0, 0].copy()
    return rigid, shear / scale[:, None, None], scale


def sam_log(affine: Array) -> Any:
    """The logarithms (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return logm(affine)


def sam_power(affine: Array, t: Array) -> Any:
    """The powers A^t (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return powers(affine, t)


def sam_velocity(affine: Array, point: Array) -> Any:
    """The velocities (N, n - 1) at points (N, n - 1) of the flow whose time-one map is A (N, n, n)."""
    generator = sam_log(affine)
    return (generator[:, :-1, :-1] @ point[:, :, None])[:, :, 0] + generator[:, :-1, -1]


def sam_fixed_point(affine: Array) -> Any:
    """The fixed points (N, n - 1) of affine maps (N, n, n)."""
    require_affine(affine)
    size = affine.shape[-1] - 1
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", linalg.LinAlgWarning)
        return linalg.solve(np.eye(size) - affine[:, :-1, :-1], affine[:, :-1, -1:])[..., 0]


def volume(poses: Array) -> Any:
    """The determinants (N, k) of the linear parts of poses (N, k, n, n)."""
    for path in poses:
        require_last_row(path)
    return linalg.det(poses[:, :, :-1, :-1])


MAPS: dict[str, Callable[..., Any]] = {
    "sim3.exp": sim3_exp,
    "sim3.log": sim3_log,
    "shear.exp": shear_exp,
    "shear.log": shear_log,
    "sym3.exp": sym3_exp,
    "sym3.log": sym3_log,
    "sym3.power": sym3_power,
    "polar.decompose": polar_decompose,
    "affine_lie.decompose": affine_lie_decompose,
    "sam.log": sam_log,
    "sam.power": sam_power,
    "sam.velocity": sam_velocity,
    "sam.fixed_point": sam_fixed_point,
    "measures.volume": volume,
}

REFUSALS = {"an eigenvalue is negative": "logm, fractional_matrix_power: principal, by [2] and [3], so complex"}

CONVENTIONS = {
    "matrix exponential": "linalg.expm at the generator that the adapter packs",
    "matrix logarithm": "linalg.logm: principal; the warning that a matrix is singular is its refusal",
    "matrix power": "linalg.fractional_matrix_power: principal; an imaginary part below 2e-10 is dropped",
    "polar factors": "linalg.polar: stretch on the right; the adapter refuses what preserves no orientation",
    "matrices": "scipy.linalg takes any square matrix; the adapter refuses what is outside the domain of each map",
    "fixed points": "linalg.solve of (I - L) q = t",
    "triangular factor": "linalg.rq: signs of the diagonal are LAPACK's; the adapter makes them positive",
}

SNIPPETS = {
    "sim3.exp": """from scipy.linalg import expm
a, b, c, x, y, z, g = {input0}
print(expm([[g, -c, b, x], [c, g, -a, y], [-b, a, g, z], [0, 0, 0, 0]]).tolist())""",
    "sim3.log": """import numpy as np, scipy
L = scipy.linalg.logm({input0})
omega = np.array([L[2, 1] - L[1, 2], L[0, 2] - L[2, 0], L[1, 0] - L[0, 1]]) / 2
print(np.array([*omega, *L[:3, 3], L.trace() / 3]).tolist())""",
    "shear.exp": """from scipy.linalg import expm
a, b, c, d, e = {input0}
print(expm([[0, a, c], [0, b, d], [0, 0, e]]).tolist())""",
    "shear.log": """from scipy.linalg import logm
logarithm = logm({input0})
print(logarithm[[0, 1, 0, 1, 2], [1, 1, 2, 2, 2]].tolist())""",
    "sym3.exp": """from scipy.linalg import expm
print(expm({input0}).tolist())""",
    "sym3.log": """import warnings; from scipy.linalg import logm
warnings.filterwarnings("error", message="The logm input matrix is exactly singular")
print(logm({input0}).tolist())""",
    "polar.decompose": """from scipy.linalg import polar
rotation, stretch = polar({input0})
print([rotation.tolist(), stretch.tolist()])""",
    "affine_lie.decompose": """import numpy as np, scipy
A = np.array({input0}); K, Q = scipy.linalg.rq(A[:3, :3]); s = np.copysign(1.0, np.diag(K)); K = K * s
rigid = [*np.c_[s[:, None] * Q, scipy.linalg.solve_triangular(K, A[:3, 3])].tolist(), [0.0, 0.0, 0.0, 1.0]]
print([rigid, (K / K[0, 0]).tolist(), K[0, 0].tolist()])""",
    "sam.log": """from scipy.linalg import logm
affine = {input0}
print(logm(affine).tolist())""",
    "sam.power": """from scipy.linalg import fractional_matrix_power
power = fractional_matrix_power({input0}, {input1})
print((power.real if abs(power.imag).max() <= 2.2e-10 * abs(power).max() else power).tolist())""",
    "sam.velocity": """import scipy
generator = scipy.linalg.logm({input0})
print((generator[:-1, :-1] @ {input1} + generator[:-1, -1]).tolist())""",
    "sam.fixed_point": """import numpy as np, scipy
A = np.array({input0})
print(scipy.linalg.solve(np.eye(len(A) - 1) - A[:-1, :-1], A[:-1, -1]).tolist())""",
    "measures.volume": """import numpy as np, scipy
print(scipy.linalg.det(np.array({input0})[:, :-1, :-1]).tolist())""",
}
SNIPPETS["sym3.power"] = SNIPPETS["sam.power"]
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""
