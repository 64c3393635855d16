"""Global interpolation of the reference: its shapes are where errors, taken by their closed forms, are stationary."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import homotopy2, mesh2
from affinecert.reference._matrices import array

from .enclosures import Numbers, context, length, numbers

BITS = 300

# Four triangles about vertex 2, the source turned and bent into the target.
SOURCE = [[0.0, 0.0], [2.0, 0.1], [0.9, 1.1], [2.1, 2.0], [-0.2, 1.9]]
TARGET = [[1.0, 0.5], [1.2, 2.4], [0.1, 1.6], [-0.7, 2.9], [-1.3, 0.2]]
TRIANGLES = [[0.0, 1.0, 2.0], [1.0, 3.0, 2.0], [3.0, 4.0, 2.0], [4.0, 0.0, 2.0]]


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def mesh(ctx: Any, t: float) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    return numbers(ctx, SOURCE), numbers(ctx, TARGET), numbers(ctx, TRIANGLES), numbers(ctx, t)


def edges(shape: Numbers, triple: list[int]) -> Numbers:
    first, second, third = (shape[i] for i in triple)
    return array([second - first, third - first]).T


def inverse(matrix: Numbers) -> Numbers:
    (a, b), (c, d) = matrix
    inverted: Numbers = array([[d, -b], [-c, a]]) / (a * d - b * c)
    return inverted


def square(matrix: Numbers) -> Any:
    return np.sum(matrix * matrix)


def frobenius(a: Numbers, b: Numbers, source: Numbers, moved: Numbers) -> Any:
    return square(a - b)


def printed(a: Numbers, b: Numbers, source: Numbers, moved: Numbers) -> Any:
    """E^R as the appendix has it."""
    product = b @ a.T
    return square(b) - (square(product) + 2 * (product[0, 0] * product[1, 1] - product[0, 1] * product[1, 0])) / square(
        a
    )


def by_points(a: Numbers, b: Numbers, source: Numbers, moved: Numbers) -> Any:
    """E^S, by the best similarity between two sets of points seen from their centroids."""
    x = (a @ (source - sum(source) / 3).T).T
    y = moved - sum(moved) / 3
    along = sum(p @ q for p, q in zip(x, y, strict=True))
    across = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(x, y, strict=True))
    return square(y) - (along**2 + across**2) / square(x)


Energy = Callable[[Numbers, Numbers, Numbers, Numbers], Any]


def total(ctx: Any, energy: Energy, source: Numbers, target: Numbers, t: Any, moved: Numbers) -> Any:
    """The sum over triangles of area times energy."""
    result = ctx.zero
    for row in TRIANGLES:
        triple = [int(i) for i in row]
        before = edges(source, triple)
        (a, b), (c, d) = before
        goal = homotopy2.exponential(ctx, edges(target, triple) @ inverse(before), t)
        linear = edges(moved, triple) @ inverse(before)
        result += (a * d - b * c) / 2 * energy(goal, linear, source[triple], moved[triple])
    return result


def assert_stationary(ctx: Any, error: Callable[[Numbers], Any], moved: Numbers, held: set[int]) -> None:
    """A step of any vertex that is not held, and the step back, change a quadratic error alike."""
    least = error(moved)
    for vertex, axis in np.ndindex(*moved.shape):
        if vertex in held:
            continue
        there, back = moved.copy(), moved.copy()
        there[vertex, axis] += 1
        back[vertex, axis] -= 1
        assert error(there) > least
        assert abs(error(there) - error(back)) <= ctx.ldexp(error(there) + error(back) - 2 * least, 60 - BITS)


@pytest.mark.parametrize("t", [0.0, 0.3, 1.0, 1.7])
@pytest.mark.parametrize(
    ("name", "energy", "held"),
    [("frobenius", frobenius, {0}), ("similarity", printed, {0, 4}), ("points", by_points, {0, 4})],
    ids=["E^F", "E^R", "E^S"],
)
def test_the_errors_are_stationary(ctx: Any, name: str, energy: Energy, held: set[int], t: float) -> None:
    source, target, triangles, time = mesh(ctx, t)
    moved = getattr(mesh2, name)(ctx, source, target, triangles, time)
    assert_stationary(ctx, lambda v: total(ctx, energy, source, target, time, v), moved, held)
    assert length(ctx, moved[0] - (source[0] * (1 - ctx.mpf(t)) + target[0] * ctx.mpf(t))) <= ctx.ldexp(1, 20 - BITS)


def test_the_balanced_errors_are_stationary(ctx: Any) -> None:
    source, target, triangles, time = mesh(ctx, 0.4)
    moved = mesh2.balanced(ctx, source, target, triangles, time, numbers(ctx, [0.25] * 4))

    def error(v: Numbers) -> Any:
        direct, similar = (total(ctx, energy, source, target, time, v) for energy in (frobenius, printed))
        return direct / 4 + similar * 3 / 4

    assert_stationary(ctx, error, moved, {0, 4})


def test_the_symmetrised_errors_are_stationary(ctx: Any) -> None:
    source, target, triangles, time = mesh(ctx, 0.375)
    moved = mesh2.symmetric(ctx, source, target, triangles, time)
    back = numbers(ctx, 0.625)

    def error(v: Numbers) -> Any:
        return total(ctx, frobenius, source, target, time, v) + total(ctx, frobenius, target, source, back, v)

    assert_stationary(ctx, error, moved, {0})
    returned = mesh2.symmetric(ctx, target, source, triangles, back)
    assert length(ctx, moved - returned) <= ctx.ldexp(length(ctx, moved), 60 - BITS)


def test_the_constrained_error_is_stationary(ctx: Any) -> None:
    source, target, triangles, time = mesh(ctx, 0.4)
    place, weight = numbers(ctx, [3.0, -1.0]), numbers(ctx, 0.75)
    moved = mesh2.constrained(ctx, source, target, triangles, time, place, weight)

    def error(v: Numbers) -> Any:
        return total(ctx, frobenius, source, target, time, v) + weight[()] * square(v[4] - place)

    assert_stationary(ctx, error, moved, {0})


@pytest.mark.parametrize("name", ["frobenius", "similarity", "points", "symmetric"])
def test_ends_are_reached(ctx: Any, name: str) -> None:
    for t, due in ((0.0, SOURCE), (1.0, TARGET)):
        moved = getattr(mesh2, name)(ctx, *mesh(ctx, t))
        assert length(ctx, moved - numbers(ctx, due)) <= ctx.ldexp(1, 60 - BITS)


def test_the_printed_closed_form_is_the_minimum_and_only_semidefinite(ctx: Any) -> None:
    """Over x and y the square |(x I + y J) A - B|^2 has the minimum printed; that is 0 for every similarity times A."""
    draw = np.random.default_rng(0)
    for _ in range(20):
        a, b = (numbers(ctx, draw.normal(size=(2, 2))) for _ in range(2))
        turned = array([-a[1], a[0]])
        # A and J A are orthogonal, and of the same length.
        x, y = (np.sum(m * b) / square(a) for m in (a, turned))
        least = square(a * x + turned * y - b)
        found = printed(a, b, b, b)
        assert abs(found - least) <= ctx.ldexp(square(b), 20 - BITS)
        assert found > 0
        image = a * b[0, 0] + turned * b[0, 1]
        assert abs(printed(a, image, b, b)) <= ctx.ldexp(square(image), 20 - BITS)


def test_similarities_of_the_target_carry_over(ctx: Any) -> None:
    """E^R does not see them: if the target is turned by g, and scaled, the shape at t is turned and scaled by g^t."""
    source, target, triangles, t = mesh(ctx, 0.5)
    quarter = numbers(ctx, [[0.0, 4.0], [-4.0, 0.0]])
    root = numbers(ctx, [[1.0, 1.0], [-1.0, 1.0]]) * ctx.sqrt(ctx.mpf(2))
    for function in (mesh2.similarity, mesh2.points):
        before = function(ctx, source, target, triangles, t)
        after = function(ctx, source, (quarter @ target.T).T, triangles, t)
        assert length(ctx, after - after[0] - (root @ (before - before[0]).T).T) <= ctx.ldexp(1, 60 - BITS)


def test_half_turns_are_told_exactly(ctx: Any) -> None:
    """By pi exactly all triangles turn to the left, whatever rounding leaves of the maps."""
    source, _, triangles, t = mesh(ctx, 0.5)
    source = source / 3
    quarter = numbers(ctx, [[0.0, -1.0], [1.0, 0.0]])
    for function in (mesh2.frobenius, mesh2.similarity, mesh2.points):
        found = function(ctx, source, -source, triangles, t)
        assert length(ctx, found - (quarter @ source.T).T) <= ctx.ldexp(1, 60 - BITS)


def changed(values: Any, index: Any, value: float) -> Any:
    array = np.array(values)
    array[index] = value
    return array


@pytest.mark.parametrize(
    ("name", "changes", "argument", "reason"),
    [
        ("frobenius", {"source": changed(SOURCE, (0, 0), np.inf)}, "source", "not finite"),
        ("frobenius", {"source": changed(SOURCE, 1, 0.0)}, "source", "a triangle without area"),
        ("frobenius", {"target": changed(TARGET, 2, 5.0)}, "target", "turned over"),
        ("frobenius", {"triangles": changed(TRIANGLES, (0, 0), 0.5)}, "triangles", "not triples"),
        ("frobenius", {"triangles": changed(TRIANGLES, (0, 0), 1.0)}, "triangles", "not triples"),
        ("frobenius", {"triangles": changed(TRIANGLES, (0, 0), 5.0)}, "triangles", "not triples"),
        ("frobenius", {"triangles": TRIANGLES[:1]}, "triangles", "not one piece with all vertices"),
    ],
)
def test_refusals(ctx: Any, name: str, changes: dict[str, Any], argument: str, reason: str) -> None:
    arguments = {"source": SOURCE, "target": TARGET, "triangles": TRIANGLES, "t": 0.5} | changes
    with pytest.raises(InputError, match=rf"^{argument}: .*{reason}"):
        getattr(mesh2, name)(ctx, *(numbers(ctx, x) for x in arguments.values()))


def test_a_similarity_needs_two_places(ctx: Any) -> None:
    """Four triangles about vertex 1, opened so far that the last vertex meets the first one."""
    source = numbers(ctx, [[1.0, 0], [0, 0], [0, 1], [-1, 0], [0, -1], [0.5, -0.5]])
    opened = numbers(ctx, [[1.0, 0], [0, 0], [0, 1], [-1, 0], [0, -1], [1, 0]])
    triangles = numbers(ctx, [[1.0, 0, 2], [1, 2, 3], [1, 3, 4], [1, 4, 5]])
    half = numbers(ctx, 0.5)
    assert mesh2.frobenius(ctx, source, opened, triangles, half).shape == (6, 2)
    for function in (mesh2.similarity, mesh2.points):
        with pytest.raises(InputError, match=r"^target: the first and the last vertex are in one place"):
            function(ctx, source, opened, triangles, half)


def test_what_is_hinged_at_a_vertex_needs_its_angles(ctx: Any) -> None:
    shape = numbers(ctx, [[0.0, 0], [1, 0], [0, 1], [-1, 0], [0, -1]])
    triangles, half = numbers(ctx, [[0.0, 1, 2], [0, 3, 4]]), numbers(ctx, 0.5)
    for function in (mesh2.similarity, mesh2.points):
        with pytest.raises(InputError, match=r"^triangles: pieces that hang together by vertices only"):
            function(ctx, shape, shape, triangles, half)
    with pytest.raises(InputError, match=r"^triangles: pieces that hang together by vertices only"):
        mesh2.balanced(ctx, shape, shape, triangles, half, numbers(ctx, [1.0, 0]))
    assert np.array_equal(mesh2.balanced(ctx, shape, shape, triangles, half, numbers(ctx, [1.0, 0.5])), shape)


@pytest.mark.parametrize(("balance", "reason"), [([0.5, 0.5, 1.5, 0.0], "not in"), ([0.5, -0.1, 1.0, 0.0], "not in")])
def test_a_balance_is_between_0_and_1(ctx: Any, balance: Any, reason: str) -> None:
    with pytest.raises(InputError, match=rf"^balance: {reason}"):
        mesh2.balanced(ctx, *mesh(ctx, 0.5), numbers(ctx, balance))


@pytest.mark.parametrize("weight", [0.0, -1.0])
def test_a_weight_is_positive(ctx: Any, weight: float) -> None:
    with pytest.raises(InputError, match=r"^weight: not positive"):
        mesh2.constrained(ctx, *mesh(ctx, 0.5), numbers(ctx, [0.0, 0.0]), numbers(ctx, weight))
