"""Laws are just where a map jumps, and beside the end of its domain: what a rounding decides breaks none of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from affinecert.map import Array
from affinecert.properties.answers import Maps, exactly, singly
from affinecert.properties.check import check
from affinecert.properties.law import BadAnswer, Law, OutOfDomain
from affinecert.properties.laws import LAWS
from affinecert.subject import Subject

TIME = np.array(0.25)


def law_named(name: str) -> Law:
    (law,) = (law for law in LAWS if law.name == name)
    return law


BY_I = np.array([[0.0, -1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 1.0, 0.0]])
"""What i takes quaternions to, multiplied from the left."""

GREAT_ARCS: Mapping[str, tuple[Array, ...]] = {"great_arcs.reversibility": (), "great_arcs.invariance": (BY_I,)}


def choosing(answer: Callable[[Array, Array], float]) -> Maps:
    """Slerp from p to q with the sign of q that is answered, whatever p . q says."""
    slerp = exactly()["quaternion.slerp"]

    def chosen(start: Array, end: Array, t: Array) -> Array:
        arc = slerp(start, end, t)
        along = (arc @ start) / (start @ start)
        return np.asarray(arc if answer(start, end) * (start @ end or 1.0) > 0 else 2 * along * start - arc)

    return {"quaternion.slerp": chosen}


def by_chance(start: Array, end: Array) -> float:
    """A sign that depends on which quaternion comes first, and on where it is seen from."""
    return float(np.sign(start[0] - start[1]))


P = np.array([0.6, 0.0, 0.0, 0.8])
BESIDE = np.array([0.0, 0.6, 0.8, 0.0])


@pytest.mark.parametrize("name", GREAT_ARCS)
@pytest.mark.parametrize("product", [0.0, 1e-17, -1e-17])
def test_either_arc_between_orthogonal_quaternions_keeps_the_laws(name: str, product: float) -> None:
    with pytest.raises(OutOfDomain, match="orthogonal, where either arc is the shorter"):
        law_named(name).residual(choosing(by_chance), P, BESIDE + product * P, TIME, *GREAT_ARCS[name])


@pytest.mark.parametrize("name", GREAT_ARCS)
@pytest.mark.parametrize("product", [1e-12, -1e-12, 1e-3])
def test_the_longer_arc_breaks_them_where_no_rounding_makes_the_choice(name: str, product: float) -> None:
    law, end = law_named(name), BESIDE + product * P
    assert law.residual(choosing(by_chance), P, end, TIME, *GREAT_ARCS[name]) > law.bound
    assert law.residual(exactly(), P, end, TIME, *GREAT_ARCS[name]) <= 1.0


@pytest.mark.parametrize("name", GREAT_ARCS)
def test_an_answer_is_due_between_orthogonal_quaternions_too(name: str) -> None:
    with pytest.raises(BadAnswer, match=r"quaternion.slerp gives \[nan"):
        law_named(name).residual(
            {"quaternion.slerp": lambda *arguments: np.full(4, np.nan)}, P, BESIDE, TIME, *GREAT_ARCS[name]
        )


def plane(a: float, b: float, c: float, d: float) -> Array:
    return np.array([[a, b, 1.0], [c, d, -2.0], [0.0, 0.0, 1.0]])


def in_complex_numbers(matrix: Array, *time: Array) -> Any:
    """What a general matrix function gives beside negative eigenvalues."""
    return matrix + 1j * np.eye(3)


COMPLEX: Mapping[str, tuple[Array, ...]] = {"closure.sam.log": (), "closure.sam.power": (TIME,)}
MATRIX_FUNCTIONS = {"sam.log": in_complex_numbers, "sam.power": in_complex_numbers}


@pytest.mark.parametrize("name", COMPLEX)
def test_a_complex_answer_breaks_no_law_where_rounding_may_have_left_the_domain(name: str) -> None:
    # The eigenvalues are -1 +- 1e-15 i; a rounding away they are two negative ones, without a real logarithm.
    with pytest.raises(OutOfDomain, match="is complex, as values are at inputs that rounding cannot tell"):
        law_named(name).residual(MATRIX_FUNCTIONS, plane(-1.0, 1.0, -1e-30, -1.0), *COMPLEX[name])


@pytest.mark.parametrize("name", COMPLEX)
@pytest.mark.parametrize("beside", [1e-3, 1.0])
def test_a_complex_answer_breaks_a_law_elsewhere(name: str, beside: float) -> None:
    with pytest.raises(BadAnswer, match="gives"):
        law_named(name).residual(MATRIX_FUNCTIONS, plane(-1.0, 1.0, -beside, -1.0), *COMPLEX[name])


FRAME = np.array([[-2.0, 0.25, 4.0], [-7.0, 0.75, -2.0], [0.0, 0.0, 1.0]])


def triangles_alone(matrix: Array, time: Array) -> Array:
    if matrix[0, 1]:
        raise ValueError("not an orientation-preserving affine map")
    return np.asarray(exactly()["sam.power"](matrix, time))


@pytest.mark.parametrize(("first", "due"), [(1e-20, OutOfDomain), (0.5, BadAnswer)])
def test_in_a_frame_where_rounding_may_have_flattened_a_map_nothing_is_asked(
    first: float, due: type[Exception]
) -> None:
    with pytest.raises(due):
        law_named("equivariance.sam.power").residual(
            {"sam.power": triangles_alone}, plane(first, 0.0, 0.12, 2.16), TIME, FRAME
        )


def exponential(size: float) -> Subject:
    """Exponentials, refused above a size."""

    def exp(log_scale: Array) -> Array:
        if np.any(np.abs(log_scale) > size):
            raise ValueError("beyond the table")
        return np.exp(log_scale)

    return Subject("table", "1", {"scale.exp": exp, "scale.log": np.log})


@pytest.mark.parametrize(("size", "documented"), [(1e-3, "passed"), (-1.0, "absent")])
def test_a_documented_refusal_breaks_no_law(size: float, documented: str) -> None:
    law, subject = law_named("exp_log.scale.log"), exponential(size)
    assert check(law, singly(subject), 10).verdict == "failed"
    found = check(law, singly(replace(subject, refusals={"beyond the table": "the table ends"})), 10)
    assert found.verdict == documented
    assert found.note == ("the subject refuses every example, as documented" if documented == "absent" else "")


@pytest.mark.parametrize(("imaginary", "keeps"), [(1e-16, True), (1e-10, False)])
def test_an_imaginary_part_of_rounding_breaks_no_law(imaginary: float, keeps: bool) -> None:
    subject = Subject(
        "complex", "1", {"scale.exp": np.exp, "scale.log": lambda scale: np.log(scale) * (1 + 1j * imaginary)}
    )
    assert (check(law_named("exp_log.scale.log"), singly(subject), 10).verdict == "passed") == keeps
