"""Exponentials and logarithms of similarities."""

from __future__ import annotations

import math

import numpy as np

from .report import Array, reported
from .sound import cubic_ratio, exp, log, pose, sim3_exp, sim3_log, unwound, versine_ratio


@reported("kornia/kornia-rs#1069", "fix(algebra): Sim3 exp and log were not mutual inverses", "sim3.exp", sim3_exp)
def growth_apart(tangent: Array) -> Array:
    """The coefficients of SE(3) carry v, as if turning and growing did not go on together."""
    omega, v, growth = tangent[:3], tangent[3:6], float(tangent[6])
    return pose(math.exp(growth) * exp(omega), exp(omega, versine_ratio, cubic_ratio) @ v)


@reported("kornia/kornia-rs#1069", "fix(algebra): Sim3 exp and log were not mutual inverses", "sim3.log", sim3_log)
def growth_apart_inverted(matrix: Array) -> Array:
    """The same in the logarithm."""
    growth = float(np.log(np.linalg.det(matrix[:3, :3])) / 3)
    omega = log(matrix[:3, :3] / math.exp(growth))
    return np.concatenate([omega, unwound(omega, matrix[:3, 3]), [growth]])


@reported("borglab/gtsam#2046", "Similarity2 Expmap/Logmap are incorrect", "sim3.exp", sim3_exp)
def not_an_exponential(tangent: Array) -> Array:
    """Turn, translation and scale are taken from the tangent one by one."""
    return pose(math.exp(tangent[6]) * exp(tangent[:3]), tangent[3:6])


@reported("borglab/gtsam#2046", "Similarity2 Expmap/Logmap are incorrect", "sim3.log", sim3_log)
def not_a_logarithm(matrix: Array) -> Array:
    """And written back one by one."""
    tangent = sim3_log(matrix)
    return np.concatenate([tangent[:3], matrix[:3, 3], tangent[6:]])


@reported("ethz-asl/minkindr#54", "Fixed log operator (and added ==) for Sim3", "sim3.log", sim3_log)
def scale_for_its_logarithm(matrix: Array) -> Array:
    """The seventh coefficient is the scale."""
    tangent = sim3_log(matrix)
    return np.concatenate([tangent[:6], np.exp(tangent[6:])])
