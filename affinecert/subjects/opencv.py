"""OpenCV by its Python module: `cv2.Rodrigues`, both ways, `cv2.RQDecomp3x3`, and its `exp`, `log` and `determinant`.

Its templates Affine3, Quat and DualQuat, which have more of the catalogue's maps, are open to C++ alone.
"""

from __future__ import annotations

import cv2
import numpy as np

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.preconditions import require_affine, require_last_row, require_rotations


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([cv2.Rodrigues(item)[0] for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    require_rotations(rotation)
    return np.stack([cv2.Rodrigues(item)[0][:, 0] for item in rotation])


def affine_lie_decompose(affine: Array) -> tuple[Array, Array, Array]:
    """Rigid (N, 4, 4), shear (N, 3, 3) and scale (N,) of affine maps (N, 4, 4), by the RQ factorisation.

    It leaves the signs of the triangle's diagonal free; here they are made positive.
    """
    require_affine(affine)
    rigid = np.broadcast_to(np.eye(4), affine.shape).copy()
    shear = np.empty((len(affine), 3, 3))
    for item, pose, normal in zip(affine, rigid, shear, strict=True):
        _, triangle, rotation, *_ = cv2.RQDecomp3x3(item[:3, :3].copy())
        signs = np.copysign(1.0, np.diag(triangle))
        pose[:3, :3] = signs[:, None] * rotation
        normal[:] = triangle * signs
        pose[:3, 3] = np.linalg.solve(normal, item[:3, 3])
    scale = shear[:, 0, 0].copy()
    return rigid, shear / scale[:, None, None], scale


def scale_exp(log_scale: Array) -> Array:
    """The scales (N,) of their logarithms."""
    return np.asarray(cv2.exp(log_scale)).reshape(log_scale.shape)


def scale_log(scale: Array) -> Array:
    """The logarithms of scales (N,)."""
    if np.any(scale <= 0):
        raise ValueError("not positive")
    return np.asarray(cv2.log(scale)).reshape(scale.shape)


def volume(poses: Array) -> Array:
    """The determinants (N, k) of the linear parts of poses (N, k, n, n)."""
    for path in poses:
        require_last_row(path)
    return np.array([[cv2.determinant(pose[:-1, :-1].copy()) for pose in path] for path in poses])


SNIPPETS = {
    "so3.exp": """import cv2, numpy as np
rotation, _ = cv2.Rodrigues(np.array({input0}))
print(rotation.tolist())""",
    "so3.log": """import cv2, numpy as np
omega, _ = cv2.Rodrigues(np.array({input0}))
print(omega[:, 0].tolist())""",
    "affine_lie.decompose": """import cv2, numpy as np
A = np.array({input0}); _, K, Q, *_ = cv2.RQDecomp3x3(A[:3, :3].copy()); s = np.copysign(1.0, np.diag(K)); K = K * s
rigid = [*np.c_[s[:, None] * Q, np.linalg.solve(K, A[:3, 3])].tolist(), [0.0, 0.0, 0.0, 1.0]]
print([rigid, (K / K[0, 0]).tolist(), K[0, 0].tolist()])""",
    "scale.exp": """import cv2, numpy as np
print(cv2.exp(np.array([{input0}])).ravel()[0].tolist())""",
    "scale.log": """import cv2, numpy as np
print(cv2.log(np.array([{input0}])).ravel()[0].tolist())""",
    "measures.volume": """import cv2, numpy as np
print([cv2.determinant(pose[:-1, :-1].copy()) for pose in np.array({input0})])""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="opencv",
    version=cv2.__version__,
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "scale.exp": scale_exp,
        "scale.log": scale_log,
        "affine_lie.decompose": affine_lie_decompose,
        "measures.volume": volume,
    },
    conventions={
        "vectors": "columns; matrices act from the left",
        "rotation vectors": "in radians, of angle in [0, pi]",
        "branch at pi": "in the source: the last of the axis's components that differ from zero is positive",
        "rotations off the manifold": "Rodrigues takes the nearest orthogonal matrix, by its source; its documentation "
        "asks for a rotation, and the adapter refuses what is none",
        "logarithm": "cv2.log: undefined by its documentation where a number is not positive; the adapter refuses that",
        "triangular factor": "RQDecomp3x3: the diagonal is positive but for the first; the adapter makes all positive",
    },
    snippets=SNIPPETS,
)
