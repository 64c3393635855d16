"""jaxlie, SO3 and SE3: in float64, and in the float32 that JAX computes in unless told otherwise.

JAX rounds what it is given to float32, silently, unless its switch for float64 is on; here it is on for the calls of
the one subject and off for those of the other, whatever the program around has set.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version
from typing import Any

import jax
import numpy as np
from jax import numpy as jnp
from jaxlie import SE3, SO3, manifold

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.rotors import normalised


def swapped(twist: Any) -> Any:
    """The twist (v, omega) of (omega, v), and the other way about."""
    return jnp.concatenate([twist[..., 3:], twist[..., :3]], axis=-1)


def so3_exp(omega: Any) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return SO3.exp(omega).as_matrix()


def so3_log(rotation: Any) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return SO3.from_matrix(rotation).log()


def se3_exp(twist: Any) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return SE3.exp(swapped(twist)).as_matrix()


def se3_log(pose: Any) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return swapped(SE3.from_matrix(pose).log())


def between(start: Any, end: Any, t: Any) -> Any:
    """The elements at the times t (N,) of the geodesics of elements: B exp(t log(B^-1 C))."""
    return manifold.rplus(start, t[:, None] * manifold.rminus(start, end))


def slerp(start: Any, end: Any, t: Any) -> Any:
    """The quaternions (N, 4) between unit quaternions (N, 4)."""
    return between(SO3(start), SO3(end), t).wxyz


def sclerp(start: Any, end: Any, t: Any) -> Any:
    """The poses (N, 4, 4) on the screw motions between poses (N, 4, 4)."""
    return between(SE3.from_matrix(start), SE3.from_matrix(end), t).as_matrix()


def rotors(function: Callable[..., Array]) -> Callable[..., Array]:
    """The function of unit quaternions (N, 4) and times (N,), on quaternions that are normalised first."""
    return lambda start, end, t: function(normalised(start), normalised(end), t)


def numbers(function: Callable[..., Any], wide: bool) -> Callable[..., Array]:
    """The function on NumPy's arrays, computed in float64 if ``wide``, else in float32."""

    def evaluate(*inputs: Array) -> Array:
        with jax.enable_x64(wide):
            return np.asarray(function(*(jnp.asarray(array) for array in inputs)))

    return rotors(evaluate) if function is slerp else evaluate


MAPS: dict[str, Callable[..., Any]] = {
    "so3.exp": so3_exp,
    "so3.log": so3_log,
    "se3.exp": se3_exp,
    "se3.log": se3_log,
    "quaternion.slerp": slerp,
    "morphs.sclerp": sclerp,
}

CONVENTIONS = {
    "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1, not looked at",
    "rotations": "SO3: quaternions (w, x, y, z), of unit length if the user sees to it",
    "branch": "log takes the shorter rotation vector, whatever the quaternion's sign",
    "branch at pi": "the sign of log at exactly pi is that of the quaternion found, documented nowhere",
    "twists": "(vx, vy, vz, omega_x, omega_y, omega_z): translation first, swapped here",
    "interpolation": "manifold.rplus(b, t manifold.rminus(b, c)), that is b exp(t log(b^-1 c))",
    "planar groups": "SO2 and SE2 are left out: the catalogue has no map of the rigid motions of the plane alone",
}

POLICIES = {
    "not a rotation": "from_matrix is for rotation matrices, and does not check them",
    "last row must be": "from_matrix is for homogeneous matrices, whose last row it does not look at",
    "off the manifold": "from_matrix is for rotation matrices: it neither checks them nor orthogonalises",
}

SNIPPETS = {
    "so3.exp": """import jax, jaxlie
with jax.enable_x64(True):
    print(jaxlie.SO3.exp(jax.numpy.array({input0})).as_matrix().tolist())""",
    "so3.log": """import jax, jaxlie
with jax.enable_x64(True):
    print(jaxlie.SO3.from_matrix(jax.numpy.array({input0})).log().tolist())""",
    "se3.exp": """import jax, jaxlie
with jax.enable_x64(True):
    print(jaxlie.SE3.exp(jax.numpy.roll(jax.numpy.array({input0}), 3)).as_matrix().tolist())""",
    "se3.log": """import jax, jaxlie
with jax.enable_x64(True):
    print(jax.numpy.roll(jaxlie.SE3.from_matrix(jax.numpy.array({input0})).log(), 3).tolist())""",
    "quaternion.slerp": """import jax, jaxlie, numpy as np
with jax.enable_x64(True):
    p, q = (jaxlie.SO3(jax.numpy.array(np.array(x) / np.linalg.norm(x, axis=-1))) for x in ({input0}, {input1}))
    print(jaxlie.manifold.rplus(p, {input2} * jaxlie.manifold.rminus(p, q)).wxyz.tolist())""",
    "morphs.sclerp": """import jax, jaxlie
with jax.enable_x64(True):
    b, c = (jaxlie.SE3.from_matrix(jax.numpy.array(pose)) for pose in ({input0}, {input1}))
    print(jaxlie.manifold.rplus(b, {input2} * jaxlie.manifold.rminus(b, c)).as_matrix().tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="jaxlie",
    version=version("jaxlie"),
    maps={name: numbers(function, wide=True) for name, function in MAPS.items()},
    conventions={**CONVENTIONS, "numbers": "float64, jax_enable_x64 being on"},
    policies=POLICIES,
    snippets=SNIPPETS,
)

subject32 = Subject(
    name="jaxlie32",
    version=version("jaxlie"),
    maps={name: numbers(function, wide=False) for name, function in MAPS.items()},
    conventions={**CONVENTIONS, "numbers": "float32, JAX's default"},
    policies=POLICIES,
    dtype="float32",
    snippets={name: snippet.replace("True", "False") for name, snippet in SNIPPETS.items()},
)
