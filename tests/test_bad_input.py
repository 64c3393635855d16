"""Bad input to `affinecert.fast`: each kind, to each argument of each function, and the message it gives."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.catalogue import CATALOGUE
from affinecert.errors import AffinecertError, InputError
from affinecert.truths import compute

Array = NDArray[np.float64]


def plane(linear: Any, translation: Any = (0.5, -1.0)) -> Array:
    return np.block([[np.array(linear, float), np.array(translation, float)[:, None]], [np.zeros(2), np.ones(1)]])


def space(linear: Any, translation: Any = (0.5, -1.0, 2.0)) -> Array:
    return np.block([[np.array(linear, float), np.array(translation, float)[:, None]], [np.zeros(3), np.ones(1)]])


IDENTITY = np.eye(3)
TURN = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
STRETCH = np.array([[2.0, 1, 0], [0, 1, 1], [0, 0, 3]])
SYMMETRIC = np.array([[2.0, 1, 0], [1, 2, -1], [0, -1, 3]])
SHEAR = np.array([[1.0, 0.5, -1], [0, 2, 1], [0, 0, 0.5]])
CANONICAL = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])
TETRAHEDRON = np.array([[1.0, 1, 1], [3, 1, 1], [2, 4, 1], [1, 2, 3]])
HALF = np.array(0.5)
PLANE = plane([[2, 1], [0, 3]])
SPACE = space(STRETCH @ TURN)
POINTS = np.arange(14.0).reshape(7, 2) % 5
KEYS = np.stack([space(IDENTITY), space(2 * TURN), space(TURN @ TURN)])
STEADY = plane([[1, 1], [0, 2]])
SPIRAL = plane([[0, -1], [1, 1]])
PATH = np.stack([PLANE, IDENTITY, plane([[1, 0], [1, 2]]), plane([[0, -1], [1, 0]])])
AFFINES = np.stack([np.eye(4), SPACE, space(STRETCH)])
SQUARE = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
PUSHED = np.array([[0.0, 0], [2, 0.5], [3, 2], [0.5, 1]])
HALVES = np.array([[0.0, 1, 2], [0, 2, 3]])
MESH = (SQUARE, PUSHED, HALVES, HALF)
FOLDED = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]])
PARAMETERS = np.arange(12.0) / 4 - 1

MORPHS = tuple(name for name, entry in CATALOGUE.items() if entry.family == "morphs")
RIGID_MORPHS = ("morphs.sclerp", "morphs.dual_quaternion_linear")
AFFINE_MORPHS = tuple(name for name in MORPHS if name not in (*RIGID_MORPHS, "morphs.sim"))

GOOD: dict[str, tuple[Array, ...]] = {
    "so3.exp": (np.array([1.0, -2, 0.5]),),
    "so3.log": (TURN,),
    "so3.log_near": (TURN, np.array([0.0, 0, 7])),
    "se3.exp": (np.array([1.0, -2, 0.5, 3, 2, 1]),),
    "se3.log": (space(TURN),),
    "sim3.exp": (np.array([1.0, -2, 0.5, 3, 2, 1, 0.5]),),
    "sim3.log": (space(2 * TURN),),
    "sim3.log_next": (space(2 * TURN), np.array([0.0, 0, -5, 1, 2, 3, 0.5])),
    "sim3.log_near": (space(2 * TURN), np.array([0.0, 0, 7, 1, 2, 3, 0.5])),
    "sim3.condition": (np.array([1.0, -2, 0.5, 3, 2, 1, 0.5]),),
    "shear.exp": (np.array([1.0, 0.5, -1, 2, -0.5]),),
    "shear.log": (SHEAR,),
    "scale.exp": (np.array(0.5),),
    "scale.log": (np.array(2.0),),
    "sym3.exp": (SYMMETRIC,),
    "sym3.log": (SYMMETRIC,),
    "sym3.power": (SYMMETRIC, HALF),
    "polar.decompose": (STRETCH @ TURN,),
    "affine_lie.decompose": (SPACE,),
    "affine_lie.compose": (space(TURN), SHEAR, np.array(2.0)),
    "affine_lie.interpolate": (SPACE, HALF),
    "affine_lie.represent": (TETRAHEDRON, CANONICAL),
    "affine_lie.interpolate_tetrahedra": (CANONICAL, TETRAHEDRON, HALF),
    "affine_lie.interpolate_triangles": (CANONICAL[:3], TETRAHEDRON[:3], HALF),
    "affine_lie.interpolate_orderings": (CANONICAL, TETRAHEDRON, HALF),
    "sam.exists": (SPACE,),
    "sam.log": (PLANE,),
    "sam.power": (PLANE, HALF),
    "sam.morph": (PLANE, plane([[1, 1], [0, 2]]), HALF),
    "sam.fixed_point": (PLANE,),
    "sam.velocity": (PLANE, np.array([1.0, 2.0])),
    "splines.de_boor": (POINTS, np.array([4.0, 3.0])),
    "splines.evaluate": (POINTS, np.array([4.0, 3.0]), HALF),
    "splines.motion": (KEYS, HALF),
    "splines.smooth_motion": (KEYS, HALF),
    "curves.shear_curve": (np.stack([SHEAR, np.eye(3)]), HALF),
    "curves.scale_curve": (np.array([1.0, 2.0]), HALF),
    "curves.rigid_curve": (np.stack([space(TURN), np.eye(4)]), HALF),
    "curves.affine_curve": (np.stack([SPACE, np.eye(4)]), HALF),
    "curves.subdivided_curve": (np.stack([SPACE, np.eye(4)]), HALF),
    "curves.poly_sam": (np.stack([PLANE, STEADY]), HALF),
    "curves.bezier_quadratic": (IDENTITY, PLANE, STEADY, HALF),
    "curves.bezier_cubic": (IDENTITY, PLANE, STEADY, IDENTITY, HALF),
    "curves.biarc": (IDENTITY, PLANE, STEADY, HALF),
    "curves.four_point": (np.stack([IDENTITY, PLANE, STEADY]),),
    "curves.patch": (IDENTITY, PLANE, STEADY, IDENTITY, HALF, HALF),
    "curves.regular_pattern": (PLANE, STEADY),
    "curves.grazing_parameter": (SPIRAL, np.array([1.0, 2.0]), np.array([1.0, 0.0]), np.array([0.0, 1.0])),
    "measures.average_relative_acceleration": (PATH, np.array([[0.0, 1], [1, 0], [2, 2]])),
    "measures.volume": (PATH,),
    "measures.degeneracy": (PATH,),
    "measures.path_deviation": (CANONICAL, TETRAHEDRON, np.array([0.25, 0.5])),
    "measures.rotation_curve_length": (np.array([1.0, -2, 0.5]), np.array([0.5, 0, 3])),
    "quaternion.slerp": (np.array([0.6, 0, 0.8, 0]), np.array([0.0, 1, 0, 0]), HALF),
    "kaji_ochiai.parametrise": (SPACE,),
    "kaji_ochiai.parametrise_near": (SPACE, PARAMETERS),
    "kaji_ochiai.realise": (PARAMETERS,),
    "kaji_ochiai.blend": (AFFINES, np.array([0.5, 0.25, 0.25])),
    "kaji_ochiai.interpolate": (AFFINES, np.array([0.0, 1, 3]), HALF),
    "kaji_ochiai.deform": (TETRAHEDRON, AFFINES, np.arange(12.0).reshape(4, 3) / 12),
    **dict.fromkeys(AFFINE_MORPHS, (PLANE, plane([[1, 1], [0, 2]]), HALF)),
    **dict.fromkeys(RIGID_MORPHS, (space(TURN), space(TURN.T), HALF)),
    "morphs.sim": (space(2 * TURN), space(TURN.T), HALF),
    "homotopy2.linear": (STRETCH[:2, :2], HALF),
    "homotopy2.polar": (STRETCH[:2, :2], HALF),
    "homotopy2.exponential": (STRETCH[:2, :2], HALF),
    "mesh2.frobenius": MESH,
    "mesh2.points": MESH,
    "mesh2.similarity": MESH,
    "mesh2.balanced": (*MESH, np.array([0.5, 1.0])),
    "mesh2.constrained": (*MESH, np.array([0.0, 2.0]), np.array(3.0)),
    "mesh2.symmetric": MESH,
    "mesh3.blend": (FOLDED, np.stack([FOLDED * 2, FOLDED @ TURN]), HALVES, np.array([0.5, 0.25])),
}
"""Good inputs of every map, one item each."""

ARGUMENTS = [(name, number) for name, entry in CATALOGUE.items() for number in range(len(entry.arguments))]
MATRICES = [(name, number) for name, number in ARGUMENTS if GOOD[name][number].ndim > 0]


def function(name: str) -> Callable[..., Any]:
    family, _, attribute = name.partition(".")
    return getattr(importlib.import_module(f"affinecert.fast.{family}"), attribute)  # type: ignore[no-any-return]


def with_argument(name: str, number: int, value: Any) -> tuple[Any, ...]:
    """The good inputs with one argument replaced."""
    good = GOOD[name]
    return (*good[:number], value, *good[number + 1 :])


def refused(name: str, inputs: tuple[Any, ...]) -> InputError:
    with pytest.raises(InputError) as caught:
        function(name)(*inputs)
    assert isinstance(caught.value, AffinecertError)
    assert isinstance(caught.value, ValueError)
    assert str(caught.value).startswith(caught.value.argument)
    return caught.value


def test_the_table_of_good_inputs_is_complete() -> None:
    assert set(GOOD) == set(CATALOGUE)


@pytest.mark.parametrize("name", GOOD)
def test_good_inputs_are_taken(name: str) -> None:
    outputs = function(name)(*GOOD[name])
    for output in outputs if isinstance(outputs, tuple) else (outputs,):
        assert np.all(np.isfinite(output))


@pytest.mark.parametrize(("name", "number"), ARGUMENTS)
@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.longdouble, np.int64, np.bool_, np.complex128, object])
def test_other_dtypes_are_refused(name: str, number: int, dtype: Any) -> None:
    error = refused(name, with_argument(name, number, GOOD[name][number].astype(dtype)))
    assert error.argument == CATALOGUE[name].arguments[number].name
    assert "dtype" in error.reason
    assert "float64" in error.reason


@pytest.mark.parametrize(("name", "number"), ARGUMENTS)
@pytest.mark.parametrize("value", ["a rotation", None, [["a"]], {}, object()])
def test_what_is_no_array_is_refused(name: str, number: int, value: Any) -> None:
    assert refused(name, with_argument(name, number, value)).argument == CATALOGUE[name].arguments[number].name


def fits(shape: tuple[int, ...], declared: tuple[int | str, ...]) -> bool:
    """Whether arrays of that shape are arguments, some of whose sizes may be any number of things."""
    dimensions = {"n": (3, 4), "n-1": (2, 3), "d": (2, 3)}
    free = [size for size in declared if isinstance(size, str) and size not in dimensions]
    item = shape[len(shape) - len(declared) :] if len(shape) >= len(declared) else ()
    return bool(free and item) and all(
        due in {size, *free} or size in dimensions.get(str(due), ()) for size, due in zip(item, declared, strict=True)
    )


@pytest.mark.parametrize(("name", "number"), MATRICES)
def test_wrong_shapes_are_refused(name: str, number: int) -> None:
    good = GOOD[name][number]
    for bad in (good[..., :-1], good[:-1], np.array(1.0), np.zeros((0,)), np.zeros((11, 11))):
        if fits(bad.shape, CATALOGUE[name].arguments[number].shape):
            continue
        error = refused(name, with_argument(name, number, bad))
        assert "shape" in error.reason
        assert str(bad.shape) in error.reason


@pytest.mark.parametrize(("name", "number"), MATRICES)
def test_ragged_lists_are_refused(name: str, number: int) -> None:
    error = refused(name, with_argument(name, number, [[1.0, 2.0], [3.0]]))
    assert "shape" in error.reason
    assert error.argument == CATALOGUE[name].arguments[number].name


@pytest.mark.parametrize("name", [name for name, entry in CATALOGUE.items() if len(entry.arguments) > 1])
def test_batches_that_do_not_broadcast_are_refused(name: str) -> None:
    first, second, *rest = GOOD[name]
    error = refused(name, (np.stack([first] * 2), np.stack([second] * 3), *rest))
    assert "shape" in error.reason
    assert "broadcast" in error.reason


@pytest.mark.parametrize(("name", "number"), ARGUMENTS)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_numbers_that_are_not_finite_are_refused_with_their_index(name: str, number: int, bad: float) -> None:
    batch = np.stack([GOOD[name][number]] * 6).reshape(2, 3, *GOOD[name][number].shape)
    batch[(1, 2, *(0,) * GOOD[name][number].ndim)] = bad
    error = refused(name, with_argument(name, number, batch))
    assert (error.argument, error.index) == (CATALOGUE[name].arguments[number].name, (1, 2))
    assert "not finite" in error.reason
    assert str(error) == f"{error.argument}[1, 2]: {error.reason}"


@pytest.mark.parametrize("name", GOOD)
@pytest.mark.parametrize("batch", [(0,), (3, 0), (0, 2)])
def test_empty_batches_are_taken(name: str, batch: tuple[int, ...]) -> None:
    outputs = function(name)(*(np.zeros((*batch, *array.shape)) for array in GOOD[name]))
    alone = function(name)(*GOOD[name])
    if not isinstance(alone, tuple):
        outputs, alone = (outputs,), (alone,)
    for output, item in zip(outputs, alone, strict=True):
        assert np.shape(output) == (*batch, *np.shape(item))


def last_row(matrix: Array) -> Array:
    bad = matrix.copy()
    bad[-1, 0] = 1e-300
    return bad


def flat(vertices: Array) -> Array:
    bad = vertices.copy()
    bad[-1] = bad[0] + (bad[1] - bad[0]) * 0.5
    return bad


def mirrored(matrix: Array) -> Array:
    bad = matrix.copy()
    bad[:, 0] *= -1
    return bad


def singular(affine: Array) -> Array:
    bad = affine.copy()
    bad[0, :-1] = 0.0
    return bad


def with_last(pose: Array) -> Array:
    return np.stack([*KEYS[:-1], pose])


SPLINES, MOTIONS = ("splines.de_boor", "splines.evaluate"), ("splines.motion", "splines.smooth_motion")


def with_pose(number: int, pose: Array) -> Array:
    path = PATH.copy()
    path[number] = pose
    return path


BAD_POSES = ((mirrored, "determinant"), (singular, "determinant"), (last_row, "last row"))

OFF = IDENTITY + 1e-5 * np.eye(3)[[1, 2, 0]]
NO_LOGARITHM = (
    plane([[-1, 0], [0, -2]]),
    plane([[-1, 1], [0, -1]]),
    space([[-1, 0, 0], [0, -2, 0], [0, 0, 3]]),
    space([[-1, 1, 0], [0, -1, 0], [0, 0, 1]]),
)

SIMILARITIES = ("sim3.log", "sim3.log_next", "sim3.log_near")

OUTSIDE: list[tuple[str, int, Array, str]] = [
    ("so3.log", 0, mirrored(TURN), "not a rotation"),
    ("so3.log", 0, 2 * TURN, "not a rotation"),
    ("so3.log", 0, OFF, "not a rotation"),
    ("so3.log", 0, np.zeros((3, 3)), "not a rotation"),
    ("so3.log_near", 0, mirrored(TURN), "not a rotation"),
    ("so3.log_near", 0, OFF, "not a rotation"),
    ("se3.log", 0, space(mirrored(TURN)), "not a rotation"),
    ("se3.log", 0, space(OFF), "not a rotation"),
    ("se3.log", 0, last_row(space(TURN)), "last row"),
    *((name, 0, space(mirrored(TURN)), "not a similarity") for name in SIMILARITIES),
    *((name, 0, space(STRETCH), "not a similarity") for name in SIMILARITIES),
    *((name, 0, space(OFF), "not a similarity") for name in SIMILARITIES),
    *((name, 0, space(np.zeros((3, 3))), "not a similarity") for name in SIMILARITIES),
    *((name, 0, last_row(space(TURN)), "last row") for name in SIMILARITIES),
    ("shear.log", 0, np.diag([1.0, -1, 1]), "not positive"),
    ("shear.log", 0, np.diag([1.0, 1, 0]), "not positive"),
    ("shear.log", 0, np.diag([1.0, 1, -0.0]), "not positive"),
    ("shear.log", 0, 2 * SHEAR, "not a shear"),
    ("shear.log", 0, SHEAR + 1e-300 * np.eye(3)[::-1], "not a shear"),
    ("scale.log", 0, np.array(0.0), "not positive"),
    ("scale.log", 0, np.array(-1.0), "not positive"),
    ("scale.log", 0, np.array(-5e-324), "not positive"),
    ("affine_lie.compose", 0, last_row(space(TURN)), "last row"),
    ("affine_lie.compose", 0, space(mirrored(TURN)), "not a rotation"),
    ("affine_lie.compose", 1, np.diag([1.0, -1, 1]), "not positive"),
    ("affine_lie.compose", 2, np.array(0.0), "not positive"),
    ("affine_lie.compose", 2, np.array(-2.0), "not positive"),
    ("affine_lie.represent", 0, flat(TETRAHEDRON), "degenerate"),
    ("affine_lie.represent", 0, mirrored(TETRAHEDRON), "degenerate"),
    ("affine_lie.represent", 1, flat(CANONICAL), "degenerate"),
    ("affine_lie.represent", 1, mirrored(CANONICAL), "degenerate"),
    ("affine_lie.interpolate_tetrahedra", 0, flat(CANONICAL), "degenerate"),
    ("affine_lie.interpolate_tetrahedra", 1, mirrored(TETRAHEDRON), "degenerate"),
    ("affine_lie.interpolate_orderings", 0, flat(CANONICAL), "degenerate"),
    ("affine_lie.interpolate_orderings", 1, mirrored(TETRAHEDRON), "degenerate"),
    ("affine_lie.interpolate_triangles", 0, flat(CANONICAL[:3]), "degenerate"),
    ("affine_lie.interpolate_triangles", 1, np.zeros((3, 3)), "degenerate"),
    ("sym3.exp", 0, SYMMETRIC + 1e-5 * np.eye(3)[[1, 2, 0]], "not symmetric"),
    ("sym3.log", 0, SYMMETRIC + 1e-5 * np.eye(3)[[1, 2, 0]], "not symmetric"),
    ("sym3.log", 0, -SYMMETRIC, "not positive definite"),
    ("sym3.log", 0, np.ones((3, 3)), "not positive definite"),
    ("sym3.power", 0, np.diag([1.0, 0, 1]), "not positive definite"),
    ("polar.decompose", 0, mirrored(STRETCH), "determinant is not positive"),
    ("polar.decompose", 0, np.ones((3, 3)), "determinant is not positive"),
    ("kaji_ochiai.interpolate", 1, np.array([0.0, 0, 3]), "not strictly increasing"),
    ("kaji_ochiai.interpolate", 1, np.array([0.0, 2, 1]), "not strictly increasing"),
    ("kaji_ochiai.parametrise", 0, last_row(SPACE), "last row"),
    ("kaji_ochiai.parametrise_near", 0, mirrored(SPACE), "determinant"),
    ("kaji_ochiai.blend", 0, np.stack([SPACE, last_row(SPACE), SPACE]), "last row"),
    ("kaji_ochiai.interpolate", 0, np.stack([SPACE, SPACE, singular(SPACE)]), "determinant"),
    ("kaji_ochiai.deform", 1, np.stack([SPACE, mirrored(SPACE), SPACE]), "determinant"),
    ("homotopy2.polar", 0, np.diag([1.0, -2]), "determinant is not positive"),
    ("homotopy2.exponential", 0, np.ones((2, 2)), "determinant is not positive"),
    *(
        (f"mesh2.{name}", number, bad, reason)
        for name in ("frobenius", "points", "similarity", "balanced", "constrained", "symmetric")
        for number, bad, reason in (
            (0, SQUARE[[0, 1, 2, 2]], "a triangle without area"),
            (1, SQUARE[::-1], "a triangle without area, or turned over"),
            (2, HALVES + 1, "not triples of different vertices"),
            (2, HALVES[[0, 0]], "not one piece with all vertices"),
        )
    ),
    ("mesh2.balanced", 4, np.array([0.5, -0.5]), "not in [0, 1]"),
    ("mesh2.constrained", 5, np.array(0.0), "not positive"),
    ("mesh3.blend", 0, FOLDED[[0, 1, 2, 2]], "a triangle without area"),
    ("mesh3.blend", 1, np.stack([FOLDED, 0 * FOLDED]), "a triangle without area"),
    ("mesh3.blend", 2, HALVES / 2, "not triples of different vertices"),
    ("mesh3.blend", 2, HALVES[[0, 0]], "not one piece with all vertices"),
    *((name, 0, singular(SPACE), "determinant") for name in ("affine_lie.decompose", "affine_lie.interpolate")),
    *((name, 0, mirrored(SPACE), "determinant") for name in ("affine_lie.decompose", "affine_lie.interpolate")),
    *((name, 0, last_row(SPACE), "last row") for name in ("affine_lie.decompose", "affine_lie.interpolate")),
    *((name, 0, singular(PLANE), "determinant") for name in ("sam.exists", "sam.log", "sam.power", "sam.velocity")),
    *((name, 0, mirrored(PLANE), "determinant") for name in ("sam.exists", "sam.log", "sam.power", "sam.velocity")),
    *((name, 0, last_row(PLANE), "last row") for name in ("sam.exists", "sam.log", "sam.power", "sam.velocity")),
    *((name, 0, bad, "no real logarithm") for name in ("sam.log", "sam.power") for bad in NO_LOGARITHM),
    *(("sam.velocity", 0, bad, "no real logarithm") for bad in NO_LOGARITHM[:2]),
    ("sam.morph", 0, singular(PLANE), "determinant"),
    ("sam.morph", 1, mirrored(PLANE), "determinant"),
    ("sam.morph", 0, last_row(PLANE), "last row"),
    ("sam.morph", 1, last_row(PLANE), "last row"),
    ("sam.morph", 1, plane(np.array(PLANE)[:2, :2] @ [[-1, 0], [0, -2]]), "no real logarithm"),
    ("quaternion.slerp", 0, np.zeros(4), "not a unit quaternion"),
    ("quaternion.slerp", 1, np.array([0.6, 0, 0.8, 0.002]), "not a unit quaternion"),
    *((name, 0, mirrored(PLANE), "determinant") for name in AFFINE_MORPHS),
    *((name, 1, singular(PLANE), "determinant") for name in AFFINE_MORPHS),
    *((name, number, last_row(PLANE), "last row") for name in AFFINE_MORPHS for number in (0, 1)),
    *(("morphs.alexa_2002", number, bad, "no real logarithm") for number in (0, 1) for bad in NO_LOGARITHM[:2]),
    *((name, 0, space(mirrored(TURN)), "not a rotation") for name in RIGID_MORPHS),
    *((name, 1, space(OFF), "not a rotation") for name in RIGID_MORPHS),
    *((name, 1, last_row(space(TURN)), "last row") for name in RIGID_MORPHS),
    ("morphs.sim", 0, space(mirrored(TURN)), "determinant"),
    ("morphs.sim", 0, space(OFF), "not a similarity"),
    ("morphs.sim", 1, space(STRETCH), "not a similarity"),
    ("morphs.sim", 1, last_row(space(TURN)), "last row"),
    ("sam.fixed_point", 0, plane(np.eye(2)), "fixed point"),
    ("sam.fixed_point", 0, space([[1, 0, 0], [0, 2, 0], [0, 0, 3]]), "fixed point"),
    ("sam.fixed_point", 0, last_row(PLANE), "last row"),
    *((name, 1, np.array(bad), "whole numbers") for name in SPLINES for bad in ([3.5, 3.5], [1.0, 6.0], [-2.0, 9.0])),
    *((name, 1, np.array([3.0, 3.0]), "their sum") for name in SPLINES),
    *((name, 0, with_last(space(mirrored(TURN))), "not a similarity") for name in MOTIONS),
    *((name, 0, with_last(space(STRETCH)), "not a similarity") for name in MOTIONS),
    *((name, 0, with_last(last_row(space(TURN))), "last row") for name in MOTIONS),
    ("curves.shear_curve", 0, np.stack([SHEAR, 2 * SHEAR]), "not a shear"),
    ("curves.shear_curve", 0, np.stack([SHEAR, np.diag([1.0, -1, 1])]), "not positive"),
    ("curves.scale_curve", 0, np.array([1.0, -5e-324]), "not positive"),
    ("curves.rigid_curve", 0, np.stack([space(TURN), space(mirrored(TURN))]), "not a rotation"),
    ("curves.rigid_curve", 0, np.stack([space(OFF), space(TURN)]), "not a rotation"),
    ("curves.rigid_curve", 0, np.stack([space(TURN), last_row(space(TURN))]), "last row"),
    *(
        (name, 0, np.stack([SPACE, bad]), reason)
        for name in ("curves.affine_curve", "curves.subdivided_curve")
        for bad, reason in ((singular(SPACE), "determinant"), (last_row(SPACE), "last row"))
    ),
    ("curves.poly_sam", 0, np.stack([PLANE, mirrored(PLANE)]), "determinant"),
    ("curves.poly_sam", 0, np.stack([last_row(PLANE), PLANE]), "last row"),
    ("curves.poly_sam", 0, np.stack([IDENTITY, NO_LOGARITHM[0]]), "no real logarithm"),
    ("curves.four_point", 0, np.stack([IDENTITY, NO_LOGARITHM[1], PLANE]), "no real logarithm"),
    ("curves.four_point", 0, np.stack([IDENTITY, PLANE, singular(PLANE)]), "determinant"),
    *(
        row
        for name in ("bezier_quadratic", "bezier_cubic", "biarc", "patch")
        for row in (
            (f"curves.{name}", 0, mirrored(PLANE), "determinant"),
            (f"curves.{name}", 1, last_row(PLANE), "last row"),
            (f"curves.{name}", 1, NO_LOGARITHM[0], "no real logarithm"),
            (f"curves.{name}", 1, NO_LOGARITHM[1], "no real logarithm"),
        )
    ),
    ("curves.regular_pattern", 0, singular(PLANE), "determinant"),
    ("curves.regular_pattern", 1, last_row(PLANE), "last row"),
    ("curves.regular_pattern", 1, plane(np.array(PLANE)[:2, :2] @ [[-1, 0], [0, -2]]), "no real logarithm"),
    *(("curves.grazing_parameter", 0, bad, "no real logarithm") for bad in NO_LOGARITHM[:2]),
    ("curves.grazing_parameter", 0, mirrored(PLANE), "determinant"),
    ("curves.grazing_parameter", 0, last_row(PLANE), "last row"),
    ("curves.grazing_parameter", 0, plane(np.eye(2)), "degenerate"),
    ("curves.grazing_parameter", 0, plane(2 * np.eye(2)), "degenerate"),
    *(("measures.average_relative_acceleration", 0, with_pose(2, bad(PLANE)), reason) for bad, reason in BAD_POSES),
    ("measures.volume", 0, with_pose(2, last_row(PLANE)), "last row"),
    ("measures.degeneracy", 0, with_pose(1, last_row(PLANE)), "last row"),
    ("measures.degeneracy", 0, with_pose(0, singular(PLANE)), "of an end is not positive"),
    ("measures.degeneracy", 0, with_pose(-1, mirrored(PLANE)), "of an end is not positive"),
    ("measures.path_deviation", 0, mirrored(CANONICAL), "degenerate"),
    ("measures.path_deviation", 1, flat(TETRAHEDRON), "degenerate"),
    ("measures.rotation_curve_length", 0, np.array([64.0, 1e-6, 0]), "longer than 64 radians"),
    ("measures.rotation_curve_length", 1, np.array([0.0, 0, -1e300]), "longer than 64 radians"),
]
"""Inputs outside the domain: map, number of the argument, its value, and what the message says."""


@pytest.mark.parametrize(("name", "number", "value", "reason"), OUTSIDE)
def test_outside_the_domain_fast_refuses_and_names_the_item(name: str, number: int, value: Array, reason: str) -> None:
    inputs = with_argument(name, number, value)
    error = refused(name, inputs)
    assert reason in error.reason
    assert error.index == ()
    # sam.log is given a plane map elsewhere in the table; a batch must be of one kind.
    good = GOOD[name] if GOOD[name][number].shape == value.shape else inputs
    if good is not inputs:
        batch = tuple(np.stack([one, one, two]) for one, two in zip(good, inputs, strict=True))
        error = refused(name, batch)
        assert reason in error.reason
        assert error.index == (2,)


@pytest.mark.parametrize(("name", "number", "value", "reason"), OUTSIDE)
def test_outside_the_domain_the_reference_refuses_for_the_same_reason(
    name: str, number: int, value: Array, reason: str
) -> None:
    refusal = compute(CATALOGUE[name], with_argument(name, number, value)).refusal
    assert refusal is not None
    assert reason in refusal


def test_numbers_and_lists_of_numbers_are_taken() -> None:
    np.testing.assert_array_equal(function("so3.exp")([1, 0, 0]), function("so3.exp")(np.array([1.0, 0.0, 0.0])))
    np.testing.assert_array_equal(function("scale.log")(2), np.log(2.0))
