"""pyquaternion: rotation vectors and matrices by way of quaternions, and slerp."""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from pyquaternion import Quaternion

from affinecert.map import Array
from affinecert.subject import Subject

OFF_MANIFOLD = 1e-6
"""How far a matrix may be from a rotation in the catalogue's domain: an argument of Quaternion(matrix=...)."""


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3), by the exponential of pure quaternions."""
    return np.stack([Quaternion.exp(Quaternion(vector=item / 2)).rotation_matrix for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    turns = [Quaternion(matrix=item, rtol=0.0, atol=OFF_MANIFOLD) for item in rotation]
    return np.stack([turn.angle * turn.axis for turn in turns])


def arc(start: Quaternion, end: Quaternion, time: float) -> Array:
    """The quaternion (4,) at a time on the shorter arc: by slerp in [0, 1], to which it clips, else by `exp_map`."""
    nearer = end if np.dot(start.elements, end.elements) >= 0.0 else -end
    if 0.0 <= time <= 1.0:
        # Given the nearer end, for slerp would turn the start round, in place.
        return np.asarray(Quaternion.slerp(start, nearer, time).elements)
    start, nearer = start.normalised, nearer.normalised
    return np.asarray(Quaternion.exp_map(start, time * Quaternion.log_map(start, nearer)).elements)


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4)."""
    triples = zip(start, end, t, strict=True)
    return np.stack([arc(Quaternion(p), Quaternion(q), float(time)) for p, q, time in triples])


SNIPPETS = {
    "so3.exp": """import numpy as np
from pyquaternion import Quaternion
print(Quaternion.exp(Quaternion(vector=np.array({input0}) / 2)).rotation_matrix.tolist())""",
    "so3.log": """import numpy as np
from pyquaternion import Quaternion
turn = Quaternion(matrix=np.array({input0}), rtol=0.0, atol=1e-6)
print((turn.angle * turn.axis).tolist())""",
    "quaternion.slerp": """from pyquaternion import Quaternion as Q
p, q, t = Q({input0}), Q({input1}), {input2}
q = q if p.elements @ q.elements >= 0 else -q
print((Q.slerp(p, q, t) if 0 <= t <= 1 else Q.exp_map(p.unit, t * Q.log_map(p.unit, q.unit))).elements.tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pyquaternion",
    version=version("pyquaternion"),
    maps={"so3.exp": so3_exp, "so3.log": so3_log, "quaternion.slerp": slerp},
    conventions={
        "quaternions": "(w, x, y, z)",
        "rotations": "columns, matrices act from the left; Quaternion(matrix=R) refuses what is no rotation",
        "rotation vectors": "angle times axis, the angle in (-pi, pi]; either sign at a half turn, as documented",
        "slerp": "for amounts in [0, 1], to which it clips, as documented; beyond, exp_map(p, t log_map(p, q))",
        "sign": "where p . q < 0 slerp goes from -p to q, the same rotations; the adapter hands on -q instead",
    },
    policies={
        "not a unit quaternion": "slerp 'will implicitly normalise the endpoints to unit quaternions'",
        "off the manifold": "Quaternion(matrix=R): orthogonal to a tolerance, rtol and atol, then taken as it is",
    },
    snippets=SNIPPETS,
)
