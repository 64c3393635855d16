"""Each law can fail: a mapping broken for the purpose is refuted. And what `check` does with every kind of subject."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from affinecert.case import from_hex
from affinecert.map import Array
from affinecert.properties.answers import Maps, exactly
from affinecert.properties.check import SHRINKS, check
from affinecert.properties.law import Law
from affinecert.properties.laws import LAWS
from affinecert.tier import PROFILES

EXAMPLES = PROFILES["quick"].examples
"""As many as `certify` tries at least: what it takes more of to break the law would pass for right there."""

Function = Callable[..., Any]
Break = Callable[[Maps], Function]
"""Makes a broken function from the right ones."""


@cache
def right() -> Maps:
    return exactly()


def in_time(name: str, change: Callable[[Array], Array]) -> Break:
    """The map at another time than the one asked for."""
    return lambda maps: lambda *arguments: maps[name](*arguments[:-1], np.asarray(change(arguments[-1])))


def scaled(name: str, factor: float) -> Break:
    return lambda maps: lambda *arguments: factor * maps[name](*arguments)


def nudged(name: str, index: Any, amount: float) -> Break:
    """The map with one entry of its output moved."""

    def broken(maps: Maps) -> Function:
        def function(*arguments: Array) -> Array:
            output: Array = np.array(maps[name](*arguments))
            output[index] += amount
            return output

        return function

    return broken


def straight(maps: Maps) -> Function:
    """Interpolates a matrix entry by entry."""
    return lambda matrix, time: (1 - time) * np.eye(len(matrix)) + time * matrix


def straight_translation(maps: Maps) -> Function:
    """Interpolates the linear part as it should be, and the translation in a straight line."""

    def power(matrix: Array, time: Array) -> Array:
        result: Array = maps["sam.power"](matrix, time)
        result[:-1, -1] = time * matrix[:-1, -1]
        return result

    return power


def canonical_on_the_wrong_side(maps: Maps) -> Function:
    """Divides the shear by the canonical tetrahedron's from the right instead of from the left."""
    standard = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])

    def represent(solid: Array, canonical: Array) -> tuple[Array, Array, Array]:
        rigid, _, scale = maps["affine_lie.represent"](solid, canonical)
        shear = maps["affine_lie.represent"](solid, standard)[1]
        own = maps["affine_lie.represent"](canonical, standard)[1]
        return rigid, np.triu(shear @ np.linalg.inv(own)), scale

    return represent


def sheared_wrongly(maps: Maps) -> Function:
    """The decomposition with a shear that is off by one part in 1e12."""

    def decompose(matrix: Array) -> tuple[Array, Array, Array]:
        rigid, shear, scale = maps["affine_lie.decompose"](matrix)
        return rigid, shear * (1 + 1e-12 * (np.arange(3) > 0)), scale

    return decompose


def unscaled_rotation(maps: Maps) -> Function:
    """The decomposition that leaves the scale in the rotation."""

    def decompose(*arguments: Array) -> tuple[Array, Array, Array]:
        name = "affine_lie.represent" if len(arguments) == 2 else "affine_lie.decompose"
        rigid, shear, scale = maps[name](*arguments)
        rigid[:3, :3] *= scale
        return rigid, shear, scale

    return decompose


def on_the_left(maps: Maps) -> Function:
    """The polar factors of L = S R, and these with an S that is not symmetric."""

    def decompose(linear: Array) -> tuple[Array, Array]:
        rotation, _ = maps["polar.decompose"](linear)
        return rotation, linear @ rotation

    return decompose


def in_another_order(maps: Maps) -> Function:
    """The product E A S for A S E."""

    def compose(rigid: Array, shear: Array, scale: Array) -> Array:
        linear = np.eye(4)
        linear[:3, :3] = scale * shear
        return rigid @ linear

    return compose


def transposed(maps: Maps) -> Function:
    return lambda omega: maps["so3.exp"](omega).T


def first_order(maps: Maps) -> Function:
    """I + [omega]x."""
    return lambda omega: np.eye(3) + np.cross(np.eye(3), -omega)


def of_the_cube(name: str) -> Break:
    """The exponential of the element times its squared length."""
    return lambda maps: lambda element: maps[name](np.asarray(element * np.sum(element**2)))


def without_junctions(maps: Maps) -> Function:
    """The de Boor points of segments that do not know of each other."""

    def de_boor(points: Array, lengths: Array) -> Array:
        pieces = np.split(points, np.cumsum(lengths.astype(int))[:-1])
        return np.concatenate([maps["splines.de_boor"](x, np.array([float(len(x))])) for x in pieces])

    return de_boor


def without_translation(maps: Maps) -> Function:
    """The velocity of the linear part alone."""

    def velocity(matrix: Array, point: Array) -> Array:
        linear = matrix.copy()
        linear[:-1, -1] = 0.0
        return np.asarray(maps["sam.velocity"](linear, point))

    return velocity


def by_first_entry(name: str) -> Break:
    """The map times 1 and a little of its first entry, which depends on the frame and on the sense of time."""
    return lambda maps: lambda *arguments: maps[name](*arguments) * (1 + 1e-9 * arguments[0].flat[0])


def principal_always(maps: Maps) -> Function:
    return lambda pose, previous: maps["sim3.log"](pose)


def principal(maps: Maps) -> Function:
    """The principal parameters, whatever is near."""
    return lambda affine, near: maps["kaji_ochiai.parametrise"](affine)


def in_the_printed_order(maps: Maps) -> Function:
    """The curve through affine maps with its factors composed as E S A."""

    def curve(affines: Array, time: Array) -> Array:
        rigid, shear, scale = maps["affine_lie.decompose"](maps["curves.affine_curve"](affines, time))
        upper = np.eye(4)
        upper[:3, :3] = scale * shear
        return np.asarray(rigid @ upper)

    return curve


def always(maps: Maps) -> Function:
    return lambda matrix: np.array(1.0)


def negative(name: str) -> Break:
    return scaled(name, -1.0)


BROKEN: Mapping[str, tuple[str, Break]] = {
    "volume_monotone.affine_lie": ("affine_lie.interpolate", straight),
    "volume_monotone.sam": ("sam.power", straight),
    "volume_kept.affine_lie": ("affine_lie.interpolate", straight),
    "volume_kept.sam": ("sam.power", straight),
    "isometry.affine_lie": ("affine_lie.interpolate", straight),
    "isometry.sam": ("sam.power", straight),
    "reversibility.affine_lie.interpolate_tetrahedra": (
        "affine_lie.interpolate_tetrahedra",
        in_time("affine_lie.interpolate_tetrahedra", np.square),
    ),
    "reversibility.affine_lie.interpolate_triangles": (
        "affine_lie.interpolate_triangles",
        in_time("affine_lie.interpolate_triangles", np.square),
    ),
    "reversibility.sam.morph": ("sam.morph", in_time("sam.morph", np.square)),
    "canonical_tetrahedron.invariance": ("affine_lie.represent", canonical_on_the_wrong_side),
    "canonical_tetrahedron.representation": ("affine_lie.represent", canonical_on_the_wrong_side),
    "steadiness.affine_lie": ("affine_lie.interpolate", in_time("affine_lie.interpolate", np.square)),
    "steadiness.sam": ("sam.velocity", without_translation),
    "existence.culver": ("sam.exists", always),
    "existence.region": ("sam.exists", always),
    "decomposition.existence": ("affine_lie.decompose", sheared_wrongly),
    "decomposition.composition": ("affine_lie.compose", in_another_order),
    "decomposition.polar": ("polar.decompose", on_the_left),
    "decomposition.uniqueness": ("affine_lie.decompose", sheared_wrongly),
    "exp_log.so3.log": ("so3.exp", transposed),
    "exp_log.so3.exp": ("so3.exp", transposed),
    "exp_log.so3.log_near": ("so3.log_near", scaled("so3.log_near", 1 + 1e-12)),
    "exp_log.se3.log": ("se3.log", scaled("se3.log", 1 + 1e-12)),
    "exp_log.se3.exp": ("se3.log", scaled("se3.log", 1 + 1e-12)),
    "exp_log.sim3.log": ("sim3.log", scaled("sim3.log", 1 + 1e-12)),
    "exp_log.sim3.exp": ("sim3.log", scaled("sim3.log", 1 + 1e-12)),
    "exp_log.sim3.log_next": ("sim3.log_next", principal_always),
    "exp_log.shear.log": ("shear.log", scaled("shear.log", 1 + 1e-12)),
    "exp_log.shear.exp": ("shear.log", scaled("shear.log", 1 + 1e-12)),
    "exp_log.scale.log": ("scale.log", scaled("scale.log", 1 + 1e-12)),
    "exp_log.scale.exp": ("scale.log", scaled("scale.log", 1 + 1e-12)),
    "exp_log.sym3.log": ("sym3.log", scaled("sym3.log", 1 + 1e-12)),
    "exp_log.sym3.exp": ("sym3.log", scaled("sym3.log", 1 + 1e-12)),
    "exp_log.sam.log": ("sam.power", in_time("sam.power", np.square)),
    "one_parameter.so3.exp": ("so3.exp", of_the_cube("so3.exp")),
    "one_parameter.se3.exp": ("se3.exp", of_the_cube("se3.exp")),
    "one_parameter.sim3.exp": ("sim3.exp", of_the_cube("sim3.exp")),
    "similarity.sim3.exp": ("sim3.exp", scaled("sim3.exp", 1 + 1e-12)),
    "similarity.rigid.exp": ("sim3.exp", of_the_cube("sim3.exp")),
    "similarity.rigid.log": ("sim3.log", scaled("sim3.log", 1 + 1e-12)),
    "one_parameter.shear.exp": ("shear.exp", of_the_cube("shear.exp")),
    "one_parameter.scale.exp": ("scale.exp", of_the_cube("scale.exp")),
    "one_parameter.sym3.exp": ("sym3.exp", scaled("sym3.exp", 1 + 1e-12)),
    "one_parameter.sym3.power": ("sym3.power", scaled("sym3.power", 1 + 1e-12)),
    "one_parameter.sam.power": ("sam.power", straight_translation),
    "closure.so3.exp": ("so3.exp", first_order),
    "closure.so3.log": ("so3.log", scaled("so3.log", 2.0)),
    "closure.se3.exp": ("se3.exp", nudged("se3.exp", (3, 0), 1e-14)),
    "closure.se3.log": ("se3.log", scaled("se3.log", 2.0)),
    "closure.shear.exp": ("shear.exp", nudged("shear.exp", (2, 1), 1e-300)),
    "closure.scale.exp": ("scale.exp", negative("scale.exp")),
    "closure.sym3.exp": ("sym3.exp", nudged("sym3.exp", (0, 1), 1.0)),
    "closure.sym3.log": ("sym3.log", nudged("sym3.log", (0, 1), 1.0)),
    "closure.sym3.power": ("sym3.power", nudged("sym3.power", (0, 1), 1.0)),
    "closure.polar.decompose": ("polar.decompose", on_the_left),
    "closure.affine_lie.decompose": ("affine_lie.decompose", unscaled_rotation),
    "closure.affine_lie.represent": ("affine_lie.represent", unscaled_rotation),
    "closure.affine_lie.interpolate": ("affine_lie.interpolate", nudged("affine_lie.interpolate", (3, 3), 1e-14)),
    "closure.sam.log": ("sam.log", nudged("sam.log", (-1, -1), 1e-14)),
    "closure.sam.power": ("sam.power", nudged("sam.power", (-1, 0), 1e-14)),
    "closure.sam.morph": ("sam.morph", nudged("sam.morph", (-1, 0), 1e-14)),
    "equivariance.sam.power": ("sam.power", straight_translation),
    "equivariance.polar.decompose": ("polar.decompose", on_the_left),
    "equivariance.sam.morph": ("sam.morph", nudged("sam.morph", (0, -1), 1e-3)),
    "endpoints.affine_lie.interpolate": (
        "affine_lie.interpolate",
        in_time("affine_lie.interpolate", lambda t: t * (1 + 1e-12)),
    ),
    "endpoints.affine_lie.interpolate_tetrahedra": (
        "affine_lie.interpolate_tetrahedra",
        in_time("affine_lie.interpolate_tetrahedra", lambda t: t * (1 + 1e-12)),
    ),
    "endpoints.affine_lie.interpolate_triangles": (
        "affine_lie.interpolate_triangles",
        in_time("affine_lie.interpolate_triangles", lambda t: t * (1 + 1e-12)),
    ),
    "endpoints.sam.power": ("sam.power", in_time("sam.power", lambda t: t * (1 + 1e-12))),
    "fixed_point.sam": ("sam.fixed_point", scaled("sam.fixed_point", 1 + 1e-12)),
    "splicing.equations": ("splines.de_boor", without_junctions),
    "splicing.keys.motion": ("splines.motion", in_time("splines.motion", lambda t: t + 1e-9)),
    "splicing.keys.smooth_motion": ("splines.smooth_motion", in_time("splines.smooth_motion", lambda t: t + 1e-9)),
    "splicing.one_segment": ("splines.smooth_motion", in_time("splines.smooth_motion", lambda t: t + 1e-9)),
    "reversibility.splines.evaluate": ("splines.evaluate", in_time("splines.evaluate", np.square)),
    "equivariance.splines.motion": ("splines.motion", nudged("splines.motion", (0, -1), 1e-3)),
    "parametrisation.realise": ("kaji_ochiai.parametrise", nudged("kaji_ochiai.parametrise", 3, 1e-3)),
    "parametrisation.parametrise_near": (
        "kaji_ochiai.parametrise_near",
        nudged("kaji_ochiai.parametrise_near", 3, 1e-3),
    ),
    "subclasses.parametrise": ("kaji_ochiai.parametrise", nudged("kaji_ochiai.parametrise", 7, 1e-9)),
    "subclasses.realise": ("kaji_ochiai.realise", nudged("kaji_ochiai.realise", (0, 1), 1e-9)),
    "subclasses.blend": ("kaji_ochiai.blend", nudged("kaji_ochiai.blend", (0, 1), 1e-9)),
    "subclasses.interpolate": ("kaji_ochiai.interpolate", nudged("kaji_ochiai.interpolate", (0, 1), 1e-9)),
    "determinant.homotopy2.polar": ("homotopy2.polar", scaled("homotopy2.polar", 1 + 1e-12)),
    "determinant.homotopy2.exponential": (
        "homotopy2.exponential",
        in_time("homotopy2.exponential", lambda t: t * (1 + 1e-12)),
    ),
    "volume_monotone.homotopy2": ("homotopy2.exponential", straight),
    "isometry.homotopy2.polar": ("homotopy2.polar", straight),
    "isometry.homotopy2.exponential": ("homotopy2.exponential", straight),
    "endpoints.homotopy2.polar": ("homotopy2.polar", in_time("homotopy2.polar", lambda t: t * (1 + 1e-12))),
    "endpoints.homotopy2.exponential": (
        "homotopy2.exponential",
        in_time("homotopy2.exponential", lambda t: t * (1 + 1e-12)),
    ),
    "endpoints.mesh2.frobenius": ("mesh2.frobenius", in_time("mesh2.frobenius", lambda t: t * (1 + 1e-12))),
    "reversibility.mesh2.symmetric": ("mesh2.symmetric", lambda maps: maps["mesh2.frobenius"]),
    "equivariance.mesh2.similarity": ("mesh2.similarity", nudged("mesh2.similarity", (0, 0), 1e-3)),
    "endpoints.sam.morph": ("sam.morph", in_time("sam.morph", lambda t: t * (1 + 1e-12))),
    "coincidence.sclerp": ("morphs.sclerp", nudged("morphs.sclerp", (0, 0), 1e-3)),
    "coincidence.lie": ("morphs.lie", nudged("morphs.lie", (0, 0), 1e-3)),
    "coincidence.log_spiral": ("morphs.log_spiral", nudged("morphs.log_spiral", (0, 0), 1e-3)),
    "coincidence.alexa_2002": ("morphs.alexa_2002", nudged("morphs.alexa_2002", (0, 0), 1e-3)),
    "coincidence.arap": ("morphs.arap", nudged("morphs.arap", (0, 0), 1e-3)),
    "coincidence.asap": ("morphs.asap", nudged("morphs.asap", (0, 0), 1e-3)),
    "coincidence.polar_exponential": ("morphs.polar_exponential", nudged("morphs.polar_exponential", (0, 0), 1e-3)),
    "great_arcs.reversibility": ("quaternion.slerp", in_time("quaternion.slerp", np.square)),
    "great_arcs.invariance": ("quaternion.slerp", nudged("quaternion.slerp", 0, 1e-3)),
    "through_keys.curves.shear_curve": ("curves.shear_curve", in_time("curves.shear_curve", lambda t: t + 1e-9)),
    "through_keys.curves.affine_curve": ("curves.affine_curve", in_the_printed_order),
    "through_keys.curves.poly_sam": ("curves.poly_sam", in_time("curves.poly_sam", lambda t: t * (1 + 1e-9))),
    "grazing.curves": ("curves.grazing_parameter", negative("curves.grazing_parameter")),
    "reversibility.curves.bezier_quadratic": (
        "curves.bezier_quadratic",
        in_time("curves.bezier_quadratic", np.square),
    ),
    "equivariance.curves.bezier_quadratic": (
        "curves.bezier_quadratic",
        nudged("curves.bezier_quadratic", (0, -1), 1e-3),
    ),
    "curve_length.bounds": ("measures.rotation_curve_length", scaled("measures.rotation_curve_length", 1.5)),
    "path_invariance.average_relative_acceleration": (
        "measures.average_relative_acceleration",
        by_first_entry("measures.average_relative_acceleration"),
    ),
    "path_invariance.volume": ("measures.volume", by_first_entry("measures.volume")),
    "path_invariance.degeneracy": ("measures.degeneracy", by_first_entry("measures.degeneracy")),
}
"""For each law a map that it needs, and how it is broken."""


def law_named(name: str) -> Law:
    (law,) = (law for law in LAWS if law.name == name)
    return law


def test_every_law_has_its_own_name_and_its_own_break() -> None:
    assert sorted(law.name for law in LAWS) == sorted(BROKEN)


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_a_broken_mapping_is_refuted(law: Law) -> None:
    name, make = BROKEN[law.name]
    result = check(law, {**right(), name: make(right())}, EXAMPLES)
    assert result.verdict == "failed"
    assert result.worst > law.bound
    assert result.note
    # The counterexample is stored bit by bit, and breaks the law again.
    inputs = tuple(from_hex(value) for value in result.inputs)
    assert all(array.dtype == np.float64 for array in inputs)


ISOMETRY = law_named("isometry.sam")
ROUND_TRIP = law_named("exp_log.so3.log")


def test_a_counterexample_is_shrunk_to_a_readable_one() -> None:
    result = check(ROUND_TRIP, {**right(), "so3.exp": transposed(right())}, EXAMPLES)
    (omega,) = (from_hex(value) for value in result.inputs)
    assert np.count_nonzero(omega) == 1
    assert float(np.abs(omega).max()) in {0.1, 1.0}


def test_shrinking_ends_when_its_tries_are_spent() -> None:
    drawn: list[tuple[Array, ...]] = []

    def noted(inputs: tuple[Array, ...]) -> tuple[Array, ...]:
        drawn.append(inputs)
        return inputs

    law = law_named("volume_monotone.sam")
    result = check(replace(law, inputs=law.inputs.map(noted)), {**right(), "sam.power": straight(right())}, 2)
    assert result.verdict == "failed"
    assert result.examples == 2 + 2 * SHRINKS
    # Left to itself Hypothesis goes on for hundreds.
    assert len(drawn) <= 50


def test_the_same_run_gives_the_same_result() -> None:
    broken = {**right(), "sam.power": straight(right())}
    assert check(ISOMETRY, broken, EXAMPLES) == check(ISOMETRY, broken, EXAMPLES)
    assert check(ISOMETRY, right(), EXAMPLES) == check(ISOMETRY, right(), EXAMPLES)


def test_a_law_without_its_maps_is_absent_and_speaks_against_nobody() -> None:
    result = check(ROUND_TRIP, {"so3.exp": right()["so3.exp"]}, EXAMPLES)
    assert (result.verdict, result.note, result.passed) == ("absent", "without so3.log", True)


def raising(*arguments: Array) -> Array:
    raise RuntimeError("no such thing here")


@pytest.mark.parametrize(
    ("function", "note"),
    [
        (raising, "sam.power raises RuntimeError: no such thing here"),
        (lambda matrix, time: np.full_like(matrix, np.nan), "sam.power gives [[nan"),
        (lambda matrix, time: np.zeros((2, 2)), "sam.power gives an array of shape (2, 2)"),
        (lambda matrix, time: np.eye(len(matrix)) + 1e-3j, "sam.power gives [[(1+0.001j)"),
        (lambda matrix, time: (matrix, matrix), "sam.power gives an array of shape ("),
        (lambda matrix, time: "matrix", "sam.power gives an array of shape ()"),
    ],
    ids=["raises", "nan", "shape", "complex", "two outputs", "text"],
)
def test_an_answer_that_is_none_breaks_the_law(function: Function, note: str) -> None:
    result = check(ISOMETRY, {"sam.power": function}, EXAMPLES)
    assert result.verdict == "failed"
    assert result.worst == np.inf
    assert result.note.startswith(note)


def test_examples_are_counted_only_inside_the_domain() -> None:
    result = check(ISOMETRY, right(), EXAMPLES)
    assert 0 < result.examples <= EXAMPLES
    assert result.worst <= 1.0
