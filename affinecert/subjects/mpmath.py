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
from affinecert.subjects.preconditions import require_affine
from affinecert.subjects.scipy import SHEAR_COLUMNS, SHEAR_ROWS

NEGLIGIBLE = 1e6 * np.finfo(np.float64).eps
"""An imaginary part so small, relative to the largest entry, is rounding; the same for every subject."""


def computed(function: Callable[..., Any], matrix: Array, *numbers: Array) -> Any:
    """The functions (N, n, n) of matrices (N, n, n) and numbers (N,), in 53 bits: real where all is but rounding."""
    values = []
    with mp.workprec(53):
        for index, item in enumerate(matrix):
            value = function(mp.matrix(item.tolist()), *(mp.mpf(float(number[index])) for number in numbers))
            values.append(np.array(value.tolist(), dtype=np.complex128).reshape(item.shape))
    array = np.stack(values)
    sizes = np.max(np.abs(array), axis=(1, 2), keepdims=True)
    rounding = np.all(np.abs(array.imag) <= NEGLIGIBLE * sizes, axis=(1, 2), keepdims=True)
    real = np.where(rounding, array.real, array)
    return real if np.any(real.imag) else real.real


def generator(rotation: Array, translation: Array, growth: Array) -> Array:
    """The matrices (N, 4, 4) [[g I + [omega]x, v], [0, 0]] of vectors (N, 3), (N, 3) and numbers (N,)."""
    x, y, z = rotation.T
    matrix = np.zeros((len(rotation), 4, 4))
    matrix[:, 0, 1], matrix[:, 0, 2], matrix[:, 1, 2] = -z, y, -x
    matrix[:, 1, 0], matrix[:, 2, 0], matrix[:, 2, 1] = z, -y, x
    matrix[:, :3, 3] = translation
    matrix[:, range(3), range(3)] = growth[:, None]
    return matrix


def vector(matrix: Any) -> Any:
    """The vectors (N, 3) omega of matrices (N, n, n) with [omega]x above: half the difference to the transpose."""
    return (
        np.stack(
            [matrix[:, 2, 1] - matrix[:, 1, 2], matrix[:, 0, 2] - matrix[:, 2, 0], matrix[:, 1, 0] - matrix[:, 0, 1]],
            axis=-1,
        )
        / 2
    )


def so3_exp(omega: Array) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return computed(mp.expm, generator(omega, np.zeros_like(omega), np.zeros(len(omega)))[:, :3, :3])


def so3_log(rotation: Array) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return vector(computed(mp.logm, rotation))


def se3_exp(twist: Array) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return computed(mp.expm, generator(twist[:, :3], twist[:, 3:], np.zeros(len(twist))))


def se3_log(pose: Array) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    logarithm = computed(mp.logm, pose)
    return np.concatenate([vector(logarithm), logarithm[:, :3, 3]], axis=-1)


def sim3_exp(tangent: Array) -> Any:
    """The similarities (N, 4, 4) of tangents (N, 7)."""
    return computed(mp.expm, generator(tangent[:, :3], tangent[:, 3:6], tangent[:, 6]))


def sim3_log(pose: Array) -> Any:
    """The tangents (N, 7) of similarities (N, 4, 4)."""
    logarithm = computed(mp.logm, pose)
    growth = np.trace(logarithm, axis1=1, axis2=2)[:, None] / 3
    return np.concatenate([vector(logarithm), logarithm[:, :3, 3], growth], axis=-1)


def shear_exp(shear_twist: Array) -> Any:
    """The elements (N, 3, 3) of G_A from their logarithms (N, 5)."""
    matrix = np.zeros((len(shear_twist), 3, 3))
    matrix[:, SHEAR_ROWS, SHEAR_COLUMNS] = shear_twist
    return computed(mp.expm, matrix)


def shear_log(shear: Array) -> Any:
    """The logarithms (N, 5) of elements (N, 3, 3) of G_A."""
    return computed(mp.logm, shear)[:, SHEAR_ROWS, SHEAR_COLUMNS]


def sam_log(affine: Array) -> Any:
    """The logarithms (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return computed(mp.logm, affine)


def sam_power(affine: Array, t: Array) -> Any:
    """The powers A^t (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return computed(mp.powm, affine, t)


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
        "shear.exp": shear_exp,
        "shear.log": shear_log,
        "sym3.exp": lambda matrix: computed(mp.expm, matrix),
        "sym3.log": lambda matrix: computed(mp.logm, matrix),
        "sym3.power": lambda matrix, t: computed(mp.powm, matrix, t),
        "sam.log": sam_log,
        "sam.power": sam_power,
    },
    conventions={
        "precision": "mp.prec = 53, the default; the functions work with a few bits more inside",
        "matrix exponential": "mp.expm, by its default, the Taylor series",
        "matrix logarithm": "mp.logm: a logarithm, 'not unique' by its documentation; complex if it comes out so",
        "matrix power": "mp.powm: exp(t log A), by way of mp.logm; an imaginary part below 2e-10 is dropped",
        "manifolds": "any square matrix is taken; the adapter reads the twist off, and refuses what is no affine map",
    },
    policies={"off the manifold": "expm, logm and powm are of general matrices, and take each as it is"},
    snippets=SNIPPETS,
)
