"""mpmath: functions of matrices, at the precision that it has unless told otherwise, that of float64.

The truth is computed by mpmath's arithmetic too, but by none of these functions. The adapter packs twists into matrices
and back, and hands on a complex result as it is: where a real logarithm exists, a complex one is the finding.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
from mpmath import mp

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects import generators
from affinecert.subjects.preconditions import (
    require_affine,
    require_last_row,
    require_positive,
    require_principal,
    require_symmetric,
)


def computed(function: Callable[..., Any], matrix: Array, *numbers: Array) -> Any:
    """The functions (N, n, n) of matrices (N, n, n) and numbers (N,), in 53 bits: real where all is but rounding."""
    values = []
    with mp.workprec(53):
        for index, item in enumerate(matrix):
            value = function(mp.matrix(item.tolist()), *(mp.mpf(float(number[index])) for number in numbers))
            values.append(np.array(value.tolist(), dtype=np.complex128).reshape(item.shape))
    return require_principal(matrix, generators.real(np.stack(values)))


def so3_exp(omega: Array) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return computed(mp.expm, generators.similar(omega, np.zeros_like(omega), np.zeros(len(omega)))[:, :3, :3])


def so3_log(rotation: Array) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return generators.vector(computed(mp.logm, rotation))


def se3_exp(twist: Array) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return computed(mp.expm, generators.similar(twist[:, :3], twist[:, 3:], np.zeros(len(twist))))


def se3_log(pose: Array) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    logarithm = computed(mp.logm, pose)
    return np.concatenate([generators.vector(logarithm), logarithm[:, :3, 3]], axis=-1)


def sim3_exp(tangent: Array) -> Any:
    """The similarities (N, 4, 4) of tangents (N, 7)."""
    return computed(mp.expm, generators.similar(tangent[:, :3], tangent[:, 3:6], tangent[:, 6]))


def sim3_log(pose: Array) -> Any:
    """The tangents (N, 7) of similarities (N, 4, 4)."""
    return generators.tangent(computed(mp.logm, pose))


def shear_exp(shear_twist: Array) -> Any:
    """The elements (N, 3, 3) of G_A from their logarithms (N, 5)."""
    return computed(mp.expm, generators.sheared(shear_twist))


def shear_log(shear: Array) -> Any:
    """The logarithms (N, 5) of elements (N, 3, 3) of G_A."""
    return computed(mp.logm, shear)[:, generators.SHEAR_ROWS, generators.SHEAR_COLUMNS]


def sym3_exp(matrix: Array) -> Any:
    """The exponentials (N, 3, 3) of symmetric matrices (N, 3, 3)."""
    require_symmetric(matrix)
    return computed(mp.expm, matrix)


def sym3_log(matrix: Array) -> Any:
    """The logarithms (N, 3, 3) of positive definite matrices (N, 3, 3)."""
    require_positive(matrix)
    return computed(mp.logm, matrix)


def sym3_power(matrix: Array, t: Array) -> Any:
    """The powers S^t (N, 3, 3) of positive definite matrices (N, 3, 3)."""
    require_positive(matrix)
    return computed(mp.powm, matrix, t)


def sam_log(affine: Array) -> Any:
    """The logarithms (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return computed(mp.logm, affine)


def sam_power(affine: Array, t: Array) -> Any:
    """The powers A^t (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return computed(mp.powm, affine, t)


def sam_velocity(affine: Array, point: Array) -> Any:
    """The velocities (N, n - 1) at points (N, n - 1) of the flow whose time-one map is A (N, n, n)."""
    logarithm = sam_log(affine)
    return (logarithm[:, :-1, :-1] @ point[:, :, None])[:, :, 0] + logarithm[:, :-1, -1]


def number(function: Callable[..., Any], numbers: Array) -> Any:
    """The values (N,) of a function of numbers (N,), in 53 bits; complex if one is."""
    with mp.workprec(53):
        values = [function(mp.mpf(float(x))) for x in numbers]
    return np.array([complex(x) if isinstance(x, mp.mpc) else float(x) for x in values])


def volume(poses: Array) -> Array:
    """The determinants (N, k) of the linear parts of poses (N, k, n, n)."""
    for path in poses:
        require_last_row(path)
    with mp.workprec(53):
        return np.array([[float(mp.det(mp.matrix(pose[:-1, :-1].tolist()))) for pose in path] for path in poses])


def triangle_and_rotation(linear: Array) -> tuple[Array, Array]:
    """K and Q (3, 3) with L = K Q, K upper triangular of positive diagonal: J L^T J = Q' U, J the reversed axes."""
    with mp.workprec(53):
        turn, upper = (np.array(m.tolist(), dtype=np.float64) for m in mp.qr(mp.matrix(linear[::-1, ::-1].T.tolist())))
    signs = np.copysign(1.0, np.diag(upper))
    return (signs[:, None] * upper).T[::-1, ::-1], (turn * signs).T[::-1, ::-1]


def affine_lie_decompose(affine: Array) -> tuple[Array, Array, Array]:
    """Rigid (N, 4, 4), shear (N, 3, 3) and scale (N,) of affine maps (N, 4, 4)."""
    require_affine(affine)
    rigid = np.broadcast_to(np.eye(4), affine.shape).copy()
    shear = np.empty((len(affine), 3, 3))
    for item, pose, triangle in zip(affine, rigid, shear, strict=True):
        triangle[:], pose[:3, :3] = triangle_and_rotation(item[:3, :3])
        pose[:3, 3] = np.linalg.solve(triangle, item[:3, 3])
    scale = shear[:, 0, 0].copy()
    return rigid, shear / scale[:, None, None], scale


SNIPPETS = {
    "so3.exp": """import mpmath, numpy as np
x, y, z = {input0}
rotation = mpmath.expm(mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]))
print(np.array(rotation.tolist(), float).tolist())""",
    "so3.log": """import mpmath, numpy as np
L = np.array(mpmath.logm(mpmath.matrix({input0})).tolist(), complex)
vector = np.array([L[2, 1] - L[1, 2], L[0, 2] - L[2, 0], L[1, 0] - L[0, 1]]) / 2
print(np.real_if_close(vector, tol=1e6).tolist())""",
    "se3.exp": """import mpmath, numpy as np
a, b, c, x, y, z = {input0}
pose = mpmath.expm(mpmath.matrix([[0, -c, b, x], [c, 0, -a, y], [-b, a, 0, z], [0, 0, 0, 0]]))
print(np.array(pose.tolist(), float).tolist())""",
    "se3.log": """import mpmath, numpy as np
L = np.array(mpmath.logm(mpmath.matrix({input0})).tolist(), complex)
vector = np.array([L[2, 1] - L[1, 2], L[0, 2] - L[2, 0], L[1, 0] - L[0, 1]]) / 2
print(np.real_if_close([*vector, *L[:3, 3]], tol=1e6).tolist())""",
    "sim3.exp": """import mpmath, numpy as np
a, b, c, x, y, z, g = {input0}
pose = mpmath.expm(mpmath.matrix([[g, -c, b, x], [c, g, -a, y], [-b, a, g, z], [0, 0, 0, 0]]))
print(np.array(pose.tolist(), float).tolist())""",
    "sim3.log": """import mpmath, numpy as np
L = np.array(mpmath.logm(mpmath.matrix({input0})).tolist(), complex)
vector = np.array([L[2, 1] - L[1, 2], L[0, 2] - L[2, 0], L[1, 0] - L[0, 1]]) / 2
print(np.real_if_close([*vector, *L[:3, 3], np.trace(L) / 3], tol=1e6).tolist())""",
    "shear.exp": """import mpmath, numpy as np
a, b, c, d, e = {input0}
shear = mpmath.expm(mpmath.matrix([[0, a, c], [0, b, d], [0, 0, e]]))
print(np.array(shear.tolist(), float).tolist())""",
    "shear.log": """import mpmath, numpy as np
logarithm = np.array(mpmath.logm(mpmath.matrix({input0})).tolist(), complex)
print(np.real_if_close(logarithm[[0, 1, 0, 1, 2], [1, 1, 2, 2, 2]], tol=1e6).tolist())""",
    "scale.exp": """import mpmath
print(float(mpmath.exp({input0})))""",
    "scale.log": """import mpmath
print(float(mpmath.log({input0})))""",
    "affine_lie.decompose": """import mpmath, numpy as np
A = np.array({input0}); Q, U = (np.array(m.tolist(), float) for m in mpmath.qr(mpmath.matrix(A[2::-1, 2::-1].T)))
s = np.copysign(1.0, np.diag(U)); K = (s[:, None] * U).T[::-1, ::-1]; R = (Q * s).T[::-1, ::-1]
print([[*np.c_[R, np.linalg.solve(K, A[:3, 3])].tolist(), [0, 0, 0, 1]], (K / K[0, 0]).tolist(), float(K[0, 0])])""",
    "sam.velocity": """import mpmath, numpy as np
L = np.array(mpmath.logm(mpmath.matrix({input0})).tolist(), complex)
L = L.real if abs(L.imag).max() <= 2.2e-10 * abs(L).max() else L
print((L[:-1, :-1] @ {input1} + L[:-1, -1]).tolist())""",
    "measures.volume": """import mpmath, numpy as np
print([float(mpmath.det(mpmath.matrix(pose[:-1, :-1].tolist()))) for pose in np.array({input0})])""",
    "sym3.exp": """import mpmath, numpy as np
exponential = mpmath.expm(mpmath.matrix({input0}))
print(np.array(exponential.tolist(), float).tolist())""",
    "sym3.log": """import mpmath, numpy as np
L = np.array(mpmath.logm(mpmath.matrix({input0})).tolist(), complex)
print((L.real if abs(L.imag).max() <= 2.2e-10 * abs(L).max() else L).tolist())""",
    "sym3.power": """import mpmath, numpy as np
P = np.array(mpmath.powm(mpmath.matrix({input0}), mpmath.mpf({input1})).tolist(), complex)
print((P.real if abs(P.imag).max() <= 2.2e-10 * abs(P).max() else P).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""
SNIPPETS |= {"sam.log": SNIPPETS["sym3.log"], "sam.power": SNIPPETS["sym3.power"]}

subject = Subject(
    name="mpmath",
    version=mpmath.__version__,
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "sim3.exp": sim3_exp,
        "sim3.log": sim3_log,
        "scale.exp": lambda log_scale: number(mp.exp, log_scale),
        "scale.log": lambda scale: number(mp.log, scale),
        "shear.exp": shear_exp,
        "shear.log": shear_log,
        "sym3.exp": sym3_exp,
        "sym3.log": sym3_log,
        "sym3.power": sym3_power,
        "sam.log": sam_log,
        "sam.power": sam_power,
        "sam.velocity": sam_velocity,
        "affine_lie.decompose": affine_lie_decompose,
        "measures.volume": volume,
    },
    conventions={
        "precision": "mp.prec = 53, the default; the functions work with a few bits more inside",
        "matrix exponential": "mp.expm, by its default, the Taylor series",
        "matrix logarithm": "mp.logm: a logarithm, 'not unique' by its documentation; complex if it comes out so",
        "matrix power": "mp.powm: exp(t log A), by way of mp.logm; an imaginary part below 2e-10 is dropped",
        "triangular factor": "mp.qr of the transpose, axes reversed; the adapter makes the diagonal positive",
        "manifolds": "any square matrix is taken; the adapter reads the twist off, and refuses what is no affine map",
    },
    refusals={"an eigenvalue is negative": "logm: 'a logarithm', as it 'is not unique', and there a complex one"},
    policies={
        "not a rotation": "logm is of general matrices",
        "not a similarity": "logm is of general matrices",
        "last row must be": "logm is of general matrices",
        "off the manifold": "expm, logm and powm are of general matrices, and take each as it is",
    },
    snippets=SNIPPETS,
)
