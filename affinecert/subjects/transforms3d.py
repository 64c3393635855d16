"""transforms3d by matrices: `transforms3d.axangles`, and `transforms3d.affines` for zooms and shears.

Its quaternions are other code: `affinecert.subjects.transforms3d_quaternions`.
"""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from transforms3d.affines import decompose44
from transforms3d.axangles import axangle2mat, mat2axangle

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.preconditions import require_affine, require_rotations


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    angle = np.linalg.norm(omega, axis=-1)
    # No axis without a rotation: any will do, and this one is what the library gives back for the identity.
    axis = np.where(angle[:, None] > 0, omega / np.where(angle > 0, angle, 1.0)[:, None], [1.0, 0.0, 0.0])
    return np.stack([axangle2mat(u, a) for u, a in zip(axis, angle, strict=True)])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    require_rotations(rotation)
    return np.stack([angle * axis for axis, angle in map(mat2axangle, rotation)])


def affine_lie_decompose(affine: Array) -> tuple[Array, Array, Array]:
    """Rigid (N, 4, 4), shear (N, 3, 3) and scale (N,) of affine maps (N, 4, 4).

    The library factors into rotation times triangle. With J the reversal of the axes, J L^T J = Q U means L = (J U^T J)
    (J Q^T J), upper triangle times rotation.
    """
    require_affine(affine)
    rigid = np.broadcast_to(np.eye(4), affine.shape).copy()
    shear = np.empty((len(affine), 3, 3))
    for item, pose, triangle in zip(affine, rigid, shear, strict=True):
        reversed_transpose = np.eye(4)
        reversed_transpose[:3, :3] = item[2::-1, 2::-1].T
        _, rotation, zooms, shears = decompose44(reversed_transpose)
        unit = np.eye(3)
        unit[np.triu_indices(3, 1)] = shears
        triangle[:] = (zooms[:, None] * unit)[::-1, ::-1].T
        pose[:3, :3] = rotation[::-1, ::-1].T
        pose[:3, 3] = np.linalg.solve(triangle, item[:3, 3])
    scale = shear[:, 0, 0].copy()
    return rigid, shear / scale[:, None, None], scale


SNIPPETS = {
    "so3.exp": """import numpy as np
from transforms3d.axangles import axangle2mat
omega = np.array({input0}); angle = np.linalg.norm(omega, axis=-1)
print(axangle2mat(omega / angle if angle > 0 else [1, 0, 0], angle).tolist())""",
    "so3.log": """import numpy as np
from transforms3d.axangles import mat2axangle
axis, angle = mat2axangle(np.array({input0}))
print((angle * axis).tolist())""",
    "affine_lie.decompose": """import numpy as np; from transforms3d.affines import decompose44
A = np.array({input0}); M = np.eye(4); M[:3, :3] = A[2::-1, 2::-1].T; _, Q, zooms, shears = decompose44(M)
U = np.eye(3); U[np.triu_indices(3, 1)] = shears; K = (zooms[:, None] * U)[::-1, ::-1].T; Q = Q[::-1, ::-1].T
print([[*np.c_[Q, np.linalg.solve(K, A[:3, 3])].tolist(), [0, 0, 0, 1]], (K / K[0, 0]).tolist(), K[0, 0].tolist()])""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="transforms3d",
    version=version("transforms3d"),
    maps={"so3.exp": so3_exp, "so3.log": so3_log, "affine_lie.decompose": affine_lie_decompose},
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "rotation vectors": "axis and angle apart, in radians; the adapter divides and multiplies",
        "branch at pi": "the axis is an eigenvector of either sign, and the angle has the sign that fits",
        "domain": "not checked by the library; the adapter refuses what is no rotation, and what turns space over",
        "triangular factor": "decompose44 has it to the right of the rotation; the adapter reverses and transposes",
    },
    policies={"off the manifold": "mat2axangle is for rotation matrices, eigenvalues within unit_thresh of theirs"},
    snippets=SNIPPETS,
)
