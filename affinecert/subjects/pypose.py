"""PyPose: the Lie tensors SO3, SE3, Sim3 and RxSO3 with their exponentials and logarithms."""

from __future__ import annotations

import warnings
from typing import Any

import torch

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors

with warnings.catch_warnings():
    # On import PyPose 0.9.5 has torch compile by means that torch calls outdated.
    warnings.simplefilter("ignore", DeprecationWarning)
    import pypose as pp

ROTATION_FIRST = (3, 4, 5, 0, 1, 2)
"""Where a twist (omega, v), and the same way back, stands in PyPose's (v, omega)."""


@on_tensors
def so3_exp(omega: Any) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return pp.so3(omega).Exp().matrix()


@on_tensors
def so3_log(rotation: Any) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return pp.mat2SO3(rotation).Log().tensor()


@on_tensors
def se3_exp(twist: Any) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return pp.se3(twist[:, ROTATION_FIRST]).Exp().matrix()


@on_tensors
def se3_log(pose: Any) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return pp.mat2SE3(pose).Log().tensor()[:, ROTATION_FIRST]


@on_tensors
def sim3_exp(tangent: Any) -> Any:
    """The similarities (N, 4, 4) of tangents (N, 7)."""
    return pp.sim3(tangent[:, (*ROTATION_FIRST, 6)]).Exp().matrix()


@on_tensors
def sim3_log(pose: Any) -> Any:
    """The tangents (N, 7) of similarities (N, 4, 4)."""
    return pp.mat2Sim3(pose).Log().tensor()[:, (*ROTATION_FIRST, 6)]


@on_tensors
def scale_exp(log_scale: Any) -> Any:
    """The scales (N,) of their logarithms, as similarities that do not turn."""
    return pp.rxso3(log_scale[:, None] * log_scale.new_tensor([0.0, 0.0, 0.0, 1.0])).Exp().scale()[:, 0]


@on_tensors
def scale_log(scale: Any) -> Any:
    """The logarithms of scales (N,), as similarities that do not turn."""
    unit = scale.new_tensor([0.0, 0.0, 0.0, 1.0]).expand(len(scale), 4)
    return pp.RxSO3(torch.cat([unit, scale[:, None]], -1)).Log().tensor()[:, 3]


SNIPPETS = {
    "so3.exp": """import pypose, torch
omega = pypose.so3(torch.tensor({input0}, dtype=torch.float64))
print(omega.Exp().matrix().tolist())""",
    "so3.log": """import pypose, torch
rotation = pypose.mat2SO3(torch.tensor({input0}, dtype=torch.float64))
print(rotation.Log().tensor().tolist())""",
    "se3.exp": """import pypose, torch
twist = pypose.se3(torch.tensor({input0}, dtype=torch.float64).roll(3))
print(twist.Exp().matrix().tolist())""",
    "se3.log": """import pypose, torch
pose = pypose.mat2SE3(torch.tensor({input0}, dtype=torch.float64))
print(pose.Log().tensor().roll(3).tolist())""",
    "sim3.exp": """import pypose, torch
tangent = torch.tensor({input0}, dtype=torch.float64)[[3, 4, 5, 0, 1, 2, 6]]
print(pypose.sim3(tangent).Exp().matrix().tolist())""",
    "sim3.log": """import pypose, torch
pose = pypose.mat2Sim3(torch.tensor({input0}, dtype=torch.float64))
print(pose.Log().tensor()[[3, 4, 5, 0, 1, 2, 6]].tolist())""",
    "scale.exp": """import pypose, torch
tangent = pypose.rxso3(torch.tensor([0, 0, 0, {input0}], dtype=torch.float64))
print(tangent.Exp().scale().item())""",
    "scale.log": """import pypose, torch
stretch = pypose.RxSO3(torch.tensor([0, 0, 0, 1, {input0}], dtype=torch.float64))
print(stretch.Log().tensor()[3].item())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pypose",
    version=pp.__version__,
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "sim3.exp": sim3_exp,
        "sim3.log": sim3_log,
        "scale.exp": scale_exp,
        "scale.log": scale_log,
    },
    conventions={
        "quaternions": "(x, y, z, w); taken from matrices by mat2SO3, mat2SE3 and mat2Sim3 with their checks",
        "twists": "(v, omega), and (v, omega, log of the scale): the adapter swaps",
        "similarities": "s R and t, as here; of its documented two conventions the first",
        "branch at pi": "the sign of Log at exactly pi is that of the quaternion found, documented nowhere",
    },
    policies={
        "off the manifold": "mat2SO3, mat2SE3, mat2Sim3: legal within rtol and atol of 1e-5, and taken as it is",
        "last row must be": "mat2SE3, mat2Sim3: the last row is not used, and a warning tells that it is not 0 0 0 1",
    },
    snippets=SNIPPETS,
)
