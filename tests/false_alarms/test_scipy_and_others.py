"""What libraries answer that must be acquitted: SciPy, PyPose, and the subjects that go by quaternions.

Ties, documented policies, and the refusals that adapters make in a library's stead, which are to refuse no more than
what is outside the domain. Findings that stand are written up in `reports/findings`.
"""

from __future__ import annotations

import numpy as np
import pytest

from affinecert.map import Array
from affinecert.scoring import Verdict
from affinecert.subjects.preconditions import require_positive, require_similarities
from tests.false_alarms.libraries import ACQUITTED, HALF_TURNS, verdict

QUATERNIONS = tuple(
    f"affinecert.subjects.{name}:subject"
    for name in ("kornia_quaternion", "pytransform3d_quaternions", "spatialmath_quaternion")
)
"""Subjects that go by quaternions, by their modules."""


@pytest.mark.parametrize("name", QUATERNIONS)
@pytest.mark.parametrize("axis", HALF_TURNS)
def test_either_rotation_vector_of_a_half_turn(name: str, axis: str) -> None:
    assert verdict(name, "so3.log", HALF_TURNS[axis]) in ACQUITTED


@pytest.mark.parametrize("name", ["scipy", "pypose"])
@pytest.mark.parametrize("end", [(0.0, 0.0, 0.6, 0.8), (-5e-324, 0.0, 0.6, 0.8), (0.0, -1.0, 0.0, 0.0)])
def test_either_arc_between_orthogonal_quaternions(name: str, end: tuple[float, ...]) -> None:
    assert verdict(name, "quaternion.slerp", np.eye(4)[0], np.array(end), np.asarray(0.25)) in ACQUITTED


@pytest.mark.parametrize(
    ("name", "map"),
    [
        ("scipy", "morphs.sclerp"),
        ("scipy", "morphs.dual_quaternion_linear"),
        ("pypose", "morphs.sclerp"),
        (QUATERNIONS[1], "morphs.sclerp"),
        (QUATERNIONS[1], "morphs.dual_quaternion_linear"),
    ],
)
@pytest.mark.parametrize("axis", HALF_TURNS)
def test_either_way_between_poses_half_a_turn_apart(name: str, map: str, axis: str) -> None:
    end = np.eye(4)
    end[:3, :3], end[:3, 3] = HALF_TURNS[axis], (1.0, -2.0, 3.0)
    # 1/4 is a float32, to which SciPy rounds the time (a finding).
    assert verdict(name, map, np.eye(4), end, np.asarray(0.25)) in ACQUITTED


def test_a_fixed_point_that_a_rounding_makes_out_of_none() -> None:
    sheared = np.array([[1.1, 0.3, 1.0], [0.1, 1.3, 2.0], [0.0, 0.0, 1.0]])
    sheared[1, 1] = 1.0 + (sheared[0, 1] * sheared[1, 0]) / (sheared[0, 0] - 1.0)
    assert verdict("scipy", "sam.fixed_point", sheared) == Verdict.OK
    assert verdict("scipy", "sam.fixed_point", np.eye(3)) == Verdict.OK


@pytest.mark.parametrize("name", ["scipy", "torch", "torch_batch", "mpmath"])
def test_an_adapter_refuses_what_is_not_symmetric(name: str) -> None:
    assert verdict(name, "sym3.exp", np.triu(np.ones((3, 3)))) == Verdict.OK


GRADED = np.array([[1.0, 1e-71, 0.0], [1e-71, 1e-140, 1e-181], [0.0, 1e-181, 1e-220]])
"""Positive definite, by minors that rounding does not tell from 0 beside the largest entry."""


@pytest.mark.parametrize("size", [1e-20, 1.0, 1e120])
def test_positive_definite_matrices_are_not_refused(size: float) -> None:
    require_positive(size * np.stack([np.eye(3), np.diag([1.0, 1e-20, 1e-40]), GRADED]))


@pytest.mark.parametrize(
    ("matrix", "message"),
    [
        (GRADED * np.where(np.arange(9).reshape(3, 3) == 8, -1.0, 1.0), "not positive definite"),
        (np.ones((3, 3)), "not positive definite"),
        (np.zeros((3, 3)), "not positive definite"),
        (GRADED + np.diag([1e-3, 0.0], 1), "not symmetric"),
    ],
    ids=["last-one-negative", "singular", "zero", "askew"],
)
def test_others_are(matrix: Array, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        require_positive(matrix[None])


@pytest.mark.parametrize("size", [1e-200, 1.0, 1e200])
def test_similarities_of_all_sizes_are_not_refused(size: float) -> None:
    pose = np.eye(4)
    pose[:3, :3] = size * np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
    require_similarities(pose[None])
    pose[0, 0] *= 1.01
    with pytest.raises(ValueError, match="not a rotation"):
        require_similarities(pose[None])


FROM_FLOAT32 = np.array(
    [[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]], dtype=np.float32
).astype(np.float64)  # fmt: skip
"""A rotation in float32, which is none in float64 by 2e-8."""


@pytest.mark.parametrize(
    "name",
    ["jaxlie", "kornia", "kornia_liegroup", "pinocchio", "pinocchio_quaternion", "pypose", "pyquaternion", "roma"],
)
def test_a_rotation_from_float32_taken_as_it_is(name: str) -> None:
    assert verdict(name, "so3.log", FROM_FLOAT32) == Verdict.OK


def test_refusals_that_the_documentation_announces() -> None:
    assert verdict("spatialmath", "so3.log", FROM_FLOAT32) == Verdict.ABSENT
    assert verdict("spatialmath", "quaternion.slerp", np.eye(4)[0], np.eye(4)[1], np.array(1.5)) == Verdict.ABSENT
    assert verdict("scipy", "sam.log", np.diag([-1.0, -1.0, 1.0])) == Verdict.ABSENT


def test_a_matrix_that_is_symmetric_but_for_rounding_taken_as_it_is() -> None:
    nearly = np.array([[2.0, 1.0, 0.0], [1.0 + 1e-8, 3.0, 0.5], [0.0, 0.5, 1.0]])
    for name in ("scipy", "torch", "torch_batch"):
        assert verdict(name, "sym3.exp", nearly) == Verdict.OK
