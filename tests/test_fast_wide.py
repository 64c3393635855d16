"""Double-double arrays: every function against mpmath at 60 digits, on inputs chosen to be hard; and what fails."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.fast import _wide as wide
from affinecert.fast import _wide_affine as affine
from affinecert.fast import _wide_rotation as space
from affinecert.fast._spectrum import HALF_TURN, NONE, NOT_ORIENTED, PRIMARY
from affinecert.reference import sam, so3

from .enclosures import Numbers, context, length, numbers

Array = NDArray[np.float64]

CTX = context(200)  # 60 digits
COUNT = 150


def exactly(pairs: Array) -> Numbers:
    total: Numbers = numbers(CTX, pairs[..., 0]) + numbers(CTX, pairs[..., 1])
    return total


def pairs(values: Any) -> Array:
    """The numbers of the context, rounded to pairs."""
    values = np.asarray(values, dtype=object)
    high = values.astype(float)
    return np.stack([high, np.asarray(values - numbers(CTX, high), dtype=float)], axis=-1)


def drawn(draw: np.random.Generator, high: Any) -> Array:
    """Pairs with that high part and any low part."""
    high = np.asarray(high, dtype=float)
    low = high * 2.0**-53 * draw.uniform(-0.5, 0.5, high.shape)
    return np.stack([high + low, low - ((high + low) - high)], axis=-1)


def generator(seed: int = 0) -> np.random.Generator:
    return np.random.default_rng(seed)


def any_size(draw: np.random.Generator, least: float, most: float, count: int = COUNT) -> Array:
    """Numbers of both signs with sizes from 10^least to 10^most."""
    return draw.choice([-1.0, 1.0], count) * 10.0 ** draw.uniform(least, most, count)


def error(found: Array, due: Any) -> Any:
    """The largest relative error of a number."""
    due = np.asarray(due, dtype=object)
    assert found.shape == (*due.shape, 2)
    assert (found[..., 0] == found[..., 0] + found[..., 1]).all()
    errors: list[Any] = [
        abs(x - y) / abs(y) if y else abs(x) for x, y in zip(exactly(found).flat, due.flat, strict=True)
    ]
    return max(errors)


def distances(found: Array, due: Any, dimensions: int) -> Numbers:
    """The norms of the differences of vectors (1) or matrices (2)."""
    difference = exactly(found) - np.asarray(due, dtype=object)
    flat = difference.reshape(*difference.shape[: difference.ndim - dimensions], -1)
    return np.array([length(CTX, item) for item in flat.reshape(-1, flat.shape[-1])], dtype=object)


def relative(found: Array, due: Numbers, dimensions: int) -> Any:
    """The largest error of a vector or matrix, relative to its norm."""
    sizes = distances(np.zeros_like(found), due, dimensions)
    return max(e / s if s else e for e, s in zip(distances(found, due, dimensions), sizes, strict=True))


def bits(number: Any) -> float:
    return float(CTX.log(number, 2)) if number else -math.inf


def elementwise(function: Callable[..., Any], *arguments: Array) -> Numbers:
    return np.array([function(*items) for items in zip(*map(exactly, arguments), strict=True)], dtype=object)


ARITHMETIC: tuple[tuple[Callable[..., Array], Callable[..., Any]], ...] = (
    (wide.add, lambda x, y: x + y),
    (wide.subtract, lambda x, y: x - y),
    (wide.multiply, lambda x, y: x * y),
    (wide.divide, lambda x, y: x / y),
)


@pytest.mark.parametrize(("operation", "exact"), ARITHMETIC)
def test_arithmetic(operation: Callable[..., Array], exact: Callable[..., Any]) -> None:
    draw = generator()
    a, b = (drawn(draw, any_size(draw, -140, 140)) for _ in range(2))
    near = drawn(draw, a[:, 0] * draw.choice([-1.0, 1.0], COUNT))  # sums that cancel down to the low parts
    for y in (b, near):
        assert error(operation(a, y), elementwise(exact, a, y)) <= 2.0**-103


def test_multiples_and_roots() -> None:
    draw = generator()
    a, x = drawn(draw, any_size(draw, -140, 140)), any_size(draw, -140, 140)
    assert error(wide.times(a, x), exactly(a) * numbers(CTX, x)) <= 2.0**-103
    root = wide.square_root(a)
    positive = a[:, 0] > 0.0
    assert error(root[positive], elementwise(CTX.sqrt, a[positive])) <= 2.0**-103
    assert (root[~positive] == 0.0).all()
    assert (wide.rounded(wide.widen(x)) == x).all()


def test_exponential() -> None:
    draw = generator()
    x = drawn(
        draw, np.concatenate([draw.uniform(-320, 320, COUNT), any_size(draw, -140, 2), math.log(2) * np.r_[-9:9]])
    )
    assert error(wide.exponential(x), elementwise(CTX.exp, x)) <= 2.0**-102
    beyond = wide.exponential(wide.widen(np.array([800.0, -800.0, np.inf, -np.inf, 0.0])))
    assert wide.rounded(beyond).tolist() == [np.inf, 0.0, np.inf, 0.0, 1.0]


def test_logarithm() -> None:
    draw = generator()
    next_to_one = np.concatenate([1 + any_size(draw, -16, -0.2), math.sqrt(0.5) * (1 + any_size(draw, -16, -3))])
    below_one_ulp = np.stack([np.ones(COUNT), any_size(draw, -40, -16.1)], axis=-1)
    x = np.concatenate([drawn(draw, np.abs(any_size(draw, -140, 140))), drawn(draw, next_to_one), below_one_ulp])
    assert error(wide.logarithm(x), elementwise(CTX.log, x)) <= 2.0**-102
    beyond = wide.logarithm(wide.widen(np.array([0.0, -1.0, np.inf, 1.0])))
    assert wide.rounded(beyond).tolist() == pytest.approx([-np.inf, np.nan, np.inf, 0.0], abs=0.0, nan_ok=True)


def test_sine_and_cosine() -> None:
    draw = generator()
    quarters = numbers(CTX, np.arange(-700, 700, 5)) * CTX.pi / 2 + numbers(CTX, any_size(draw, -20, -1, 280))
    eighths = np.arange(-99, 99) * np.pi / 4
    angles = np.concatenate([draw.uniform(-1000, 1000, COUNT), any_size(draw, -140, 10), eighths])
    x = np.concatenate([drawn(draw, angles), pairs(quarters)])
    for found, function in zip(wide.sine_cosine(x), (CTX.sin, CTX.cos), strict=True):
        assert error(found, elementwise(function, x)) <= 2.0**-102


def test_arctangent() -> None:
    draw = generator()
    y, x = (
        drawn(draw, np.concatenate([any_size(draw, *sizes), any_size(draw, -2, 2)])) for sizes in ((-130, 9), (-9, 130))
    )
    assert error(wide.arctangent2(y, x), elementwise(CTX.atan2, y, x)) <= 2.0**-102
    y, x = np.array([0.0, -0.0, 0.0, -0.0, 1e-300, 1.0]), np.array([-1.0, -1.0, 0.0, 2.0, -1.0, 0.0])
    due = [CTX.pi, CTX.pi, 0, 0, CTX.pi, CTX.pi / 2]
    assert error(wide.arctangent2(wide.widen(y), wide.widen(x)), due) <= 2.0**-104


def matrices(draw: np.random.Generator, *shape: int, size: float = 0.0) -> Array:
    """Matrices with entries of size 1 whose rows and columns are multiplied by numbers from 10^-size to 10^size."""
    rows, columns = (10.0 ** draw.uniform(-size, size, (*shape[:-2], n)) for n in shape[-2:])
    return drawn(draw, draw.normal(size=shape) * rows[..., :, None] * columns[..., None, :])


def homogeneous(draw: np.random.Generator, count: int, d: int, size: float = 0.0) -> Array:
    return wide.homogeneous(matrices(draw, count, d, d, size=size), drawn(draw, draw.normal(size=(count, d))))


def test_products_and_images() -> None:
    draw = generator()
    a, b = matrices(draw, 20, 3, 4), matrices(draw, 4, 2)
    sizes = np.array([length(CTX, x) for x in exactly(a)]) * length(CTX, exactly(b))
    assert (distances(wide.product(a, b), exactly(a) @ exactly(b), 2) <= 2.0**-101 * sizes).all()
    pose, x = homogeneous(draw, 20, 3), drawn(draw, draw.normal(size=(20, 3)))
    due = (exactly(pose)[:, :3, :3] @ exactly(x)[..., None])[..., 0] + exactly(pose)[:, :3, 3]
    assert (distances(wide.image(pose, x), due, 1) <= 2.0**-98).all()
    assert (distances(wide.image(wide.linear_part(pose), x), due - exactly(pose)[:, :3, 3], 1) <= 2.0**-98).all()
    assert (wide.transposed(a)[:, 1, 2] == a[:, 2, 1]).all()


@pytest.mark.parametrize(("d", "size"), [(2, 0.0), (3, 0.0), (2, 60.0), (3, 60.0)])
def test_inverses(d: int, size: float) -> None:
    draw = generator(d)
    for a in (matrices(draw, 20, d, d, size=size), homogeneous(draw, 20, d, size)):
        inverse = wide.inverse(a)
        for x, y in zip(exactly(a), exactly(inverse), strict=True):
            # By entries: rows and columns are of any size.
            defect = abs(x @ y - np.eye(len(x), dtype=int))
            assert (defect <= 2.0**-94 * (abs(x) @ abs(y))).all()
        assert len(a[0]) == d or (inverse[:, -1] == wide.widen(np.eye(d + 1))[-1]).all()
    b, c = homogeneous(draw, 20, d), homogeneous(draw, 20, d)
    assert relative(wide.product(wide.right_quotient(c, b), b), exactly(c), 2) <= 2.0**-90
    assert relative(wide.product(b, wide.left_quotient(b, c)), exactly(c), 2) <= 2.0**-90


def test_signs_of_determinants() -> None:
    draw = generator()
    axes = np.stack([np.eye(3)[list(order)] for order in itertools.permutations(range(3))])
    due = np.round(np.linalg.det(axes))
    for scale in (1.0, 1e140, 1e-140):
        assert (wide.determinant_sign(wide.widen(scale * axes)) == due).all()
    flat = draw.integers(-9, 9, (20, 3, 3)).astype(float)
    flat[:, 2] = flat[:, 0] + flat[:, 1]
    nearly = wide.widen(flat)
    nearly[..., 0, 0, 1] = 1e-50  # times the cofactor
    assert (wide.determinant_sign(wide.widen(flat)) == 0.0).all()
    cofactor = flat[:, 1, 1] * flat[:, 2, 2] - flat[:, 1, 2] * flat[:, 2, 1]
    assert (wide.determinant_sign(nearly) == np.sign(cofactor)).all()
    pose = wide.homogeneous(wide.widen(-np.eye(3)), wide.widen(np.ones(3)))
    assert wide.determinant_sign(pose) == -1.0


def axes(draw: np.random.Generator, count: int) -> Numbers:
    """Unit vectors with components of any size."""
    vectors = numbers(CTX, draw.normal(size=(count, 3)) * 10.0 ** draw.uniform(-30, 0, (count, 3)))
    return np.array([x / length(CTX, x) for x in vectors])


def angles(kind: str, draw: np.random.Generator) -> list[Any]:
    if kind == "small":
        return [CTX.mpf(x) for x in [*np.abs(any_size(draw, -140, 0, 20)), 1e-12]]
    if kind == "next to pi":
        return [CTX.pi - CTX.mpf(x) for x in [*np.abs(any_size(draw, -26, 0, 20)), 1e-12]]
    return [CTX.mpf(x) for x in draw.uniform(0, math.pi, 20)]


@pytest.mark.parametrize("kind", ["any", "small", "next to pi"])
def test_rotations_and_their_vectors(kind: str) -> None:
    draw = generator()
    turns = angles(kind, draw)
    omega = pairs(axes(draw, len(turns)) * np.array(turns)[:, None])
    due = np.array([so3.exp(CTX, x) for x in exactly(omega)])
    rotation = pairs(due)
    assert max(distances(space.rotation(omega), due, 2)) <= 2.0**-101
    assert relative(space.rotation_vector(rotation), exactly(omega), 1) <= 2.0**-102
    t = draw.uniform(-10, 10, len(turns))
    powers = np.array([so3.exp(CTX, x * CTX.mpf(y)) for x, y in zip(exactly(omega), t, strict=True)])
    assert max(distances(space.rotation_power(rotation, t), powers, 2)) <= 2.0**-98
    # Products carry rounding that a rotation vector near pi or 0 must not magnify.
    other = space.rotation(drawn(draw, draw.normal(size=(len(turns), 3))))
    product = wide.product(space.rotation(omega), wide.product(other, wide.transposed(other)))
    assert max(distances(space.rotation_vector(product), exactly(omega), 1)) <= 2.0**-99


def test_long_rotation_vectors() -> None:
    draw = generator()
    omega = pairs(axes(draw, 20) * numbers(CTX, draw.uniform(-1000, 1000, (20, 1))))
    due = np.array([so3.exp(CTX, x) for x in exactly(omega)])
    assert max(distances(space.rotation(omega), due, 2)) <= 1000 * 2.0**-104
    near = wide.add(omega, drawn(draw, draw.normal(size=(20, 3))))
    nearest = np.array([so3.log_near(CTX, r, x) for r, x in zip(due, exactly(near), strict=True)])
    assert relative(space.rotation_vector_near(pairs(due), near), nearest, 1) <= 2.0**-101


HALF = np.diag([-1.0, -1.0, 1.0])


@pytest.mark.parametrize(
    ("rotation", "near"),
    [
        (np.eye(3), (0, 0, 0)),
        (np.eye(3), (0, 0, 3)),
        (np.eye(3), (0, -7, 0)),
        (np.eye(3), (1e-200, 0, 0)),
        (HALF, (0, 0, 0)),
        (HALF, (0, 5, 0)),
        (HALF, (0, 0, 1e-9)),
        (HALF, (0, 0, -1e-9)),
        (HALF, (0, 0, 6)),
        (HALF, (0, 0, -20)),
    ],
)
def test_rotation_vectors_nearest_to_another_at_no_turn_and_at_half_a_turn(rotation: Any, near: Any) -> None:
    near = np.array(near, dtype=float)
    due = so3.log_near(CTX, numbers(CTX, rotation), numbers(CTX, near))
    assert distances(space.rotation_vector_near(wide.widen(rotation), wide.widen(near)), due, 1)[0] <= 2.0**-100
    # The same when rounding has been at it.
    noise = generator().normal(size=(9, 3, 3)) * 2.0**-103
    blurred = wide.add(wide.widen(rotation), wide.widen(noise))
    found = space.rotation_vector_near(blurred, wide.widen(near))
    assert max(distances(found, np.array([due] * 9), 1)) <= 2.0**-94


def test_a_half_turn_as_near_to_one_vector_as_to_the_other_takes_the_principal_one() -> None:
    turn = space.rotation(pairs([CTX.pi, 0, 0]))
    assert space.rotation_vector(turn)[0, 0] == math.pi
    assert space.rotation_vector_near(turn, wide.widen(np.zeros(3)))[0, 0] == math.pi
    # Between pi and 3 pi the shorter one, and between -pi and -3 pi.
    for side in (1, -1):
        found = space.rotation_vector_near(turn, pairs([2 * side * CTX.pi, 0, 0]))
        assert found[0, 0] == side * math.pi
    # Without any turn, between 2 pi and 4 pi.
    found = space.rotation_vector_near(wide.widen(np.eye(3)), pairs([0, 3 * CTX.pi, 0]))
    assert found[1, 0] == 2 * math.pi


def test_the_nearest_rotation() -> None:
    draw = generator()
    exact = np.array([so3.exp(CTX, numbers(CTX, x)) for x in draw.normal(size=(20, 3))])
    matrix = exact.astype(float) + draw.normal(size=(20, 3, 3)) * 1e-7
    due = np.array([so3.project(CTX, "rotation", numbers(CTX, x)) for x in matrix])
    assert max(distances(space.nearest_rotation(matrix), due, 2)) <= 2.0**-101
    space.require_rotation("rotation", matrix)
    for bad, reason in ((2 * np.eye(3), "is above 1e-6"), (np.full((3, 3), 1e200), "is above"), (-HALF, "negative")):
        matrix[7] = bad
        with pytest.raises(InputError, match=rf"^rotation\[7\]: not a rotation: .*{reason}"):
            space.require_rotation("rotation", matrix)


def test_rotations_of_the_plane() -> None:
    draw = generator()
    inner = drawn(draw, np.concatenate([any_size(draw, -140, 0.4), [3.14, -3.14, math.pi - 1e-12]]))
    rotation = space.plane_rotation(inner)
    due = [[[CTX.cos(x), -CTX.sin(x)], [CTX.sin(x), CTX.cos(x)]] for x in exactly(inner)]
    assert error(rotation, due) <= 2.0**-102
    assert error(space.angle(rotation), exactly(inner)) <= 2.0**-101
    half = space.angle(np.stack([wide.widen(-np.eye(2)), space.plane_rotation(pairs(-CTX.pi))]))
    assert error(half, [CTX.pi, CTX.pi]) <= 2.0**-104


def conjugated(draw: np.random.Generator, linear: Any) -> Array:
    """The matrix in an oblique basis."""
    basis = np.eye(len(linear)) + 0.3 * draw.normal(size=(len(linear),) * 2)
    return basis @ linear @ np.linalg.inv(basis)  # type: ignore[no-any-return]


def turn_and_growth(d: int, angle: float, growth: float) -> Array:
    linear = np.eye(d)
    linear[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
    return growth * linear


def hard_linear_parts(draw: np.random.Generator, d: int) -> Iterator[tuple[str, Array, float]]:
    """Linear parts, and how near they are to what makes errors larger than the condition does."""
    noise = draw.normal(size=(d, d))
    yield "any", np.eye(d) + 0.2 * noise, 1.0
    yield "positive", np.diag([0.3, 2.0, 9.0][:d]), 1.0
    yield "identity", np.eye(d), 1.0
    for size in (1e-3, 1e-12):
        yield f"{size} from the identity", np.eye(d) + size * noise, 1.0
    for size in (1e130, 1e-130):
        yield f"{size} times any", size * (np.eye(d) + 0.2 * noise), 1.0
    for gap in (1e-3, 1e-8, 1e-14):
        yield f"eigenvalues {gap} apart", np.diag([2.0, 2.0 + gap, 3.0][:d]) + np.eye(d, k=1), 1.0
        yield f"oblique, eigenvalues {gap} apart", conjugated(draw, np.diag([2.0, 2.0 + gap, 3.0][:d])), 1.0
    yield "defective", 2 * np.eye(d) + np.eye(d, k=1), 1.0
    yield "rows of sizes 1e8", np.diag([1e-8, 1.0, 1e8][:d]) + np.triu(np.ones((d, d)), 1), 1.0
    for short in (1e-2, 1e-4, 1e-6):
        # The squared difference of the two eigenvalues is that of numbers of size 1.
        yield f"{short} short of a half turn", conjugated(draw, turn_and_growth(d, math.pi - short, 2.0)), short


def parts(matrix: Any) -> tuple[Any, Any]:
    """Linear part and translation."""
    return matrix[:-1, :-1], matrix[:-1, -1]


def scaled_error(found: Array, function: Callable[[Numbers], Numbers], matrix: Numbers) -> Any:
    """The larger error of linear part and translation, next to its norm and its condition.

    The condition is the largest change next to a change of the parts of the matrix relative to their norms.
    """
    draw, change, value = generator(5), 2.0**-90, function(matrix)
    due = [length(CTX, part) for part in parts(value)]
    conditions = [CTX.zero, CTX.zero]
    for _ in range(3):
        other = matrix.copy()
        for part in parts(other):
            part[...] = part + numbers(CTX, change * draw.normal(size=part.shape)) * length(CTX, part)
        changed = [length(CTX, part) / change for part in parts(function(other) - value)]
        conditions = [max(pair) for pair in zip(conditions, changed, strict=True)]
    errors = [length(CTX, part) for part in parts(exactly(found) - value)]
    return max(e / (n + k) if e else e for e, n, k in zip(errors, due, conditions, strict=True))


@pytest.mark.parametrize("d", [2, 3])
def test_logarithms_powers_and_exponentials_of_affine_maps(d: int) -> None:
    draw = generator(d)
    for name, linear, short in hard_linear_parts(draw, d):
        a = wide.homogeneous(drawn(draw, linear), drawn(draw, draw.normal(size=d) * 10.0 ** draw.uniform(-8, 8)))
        exact = exactly(a)
        found, existence = affine.affine_logarithm(a)
        assert existence == PRIMARY, name
        assert scaled_error(found, partial(sam.log, CTX), exact) <= 2.0**-98 / short, name
        log = sam.log(CTX, exact)
        size = max(1.0, float(length(CTX, log[:-1, :-1])))
        for t in (0.3, -2.0, 1e-20):
            found, _ = affine.affine_power(a, np.array(t))
            power = partial(sam.power, CTX, t=np.array(CTX.mpf(t), dtype=object))
            assert scaled_error(found, power, exact) <= 2.0**-98 / short * max(1.0, abs(t) * size), name
        for part, due in zip(parts(exactly(affine.affine_exponential(pairs(log)))), parts(exact), strict=True):
            assert length(CTX, part - due) <= 2.0**-96 * size * length(CTX, due), name


@pytest.mark.parametrize("size", [1e-200, 1e-12, 1.0, 300.0])
def test_exponentials_of_any_size(size: float) -> None:
    draw = generator()
    linear = size * np.array([[0.3, -1.0, 0.1], [0.9, 0.2, 0.0], [0.0, 0.1, -0.7]])
    for translation in (1e-100, 1.0, 1e100):
        x = wide.tangent(drawn(draw, linear), drawn(draw, translation * draw.normal(size=3)))
        due = numbers(CTX, np.zeros((4, 4)))
        with CTX.workprec(2000):
            due[:] = np.array(CTX.expm(CTX.matrix(exactly(x).tolist()), method="taylor").tolist())
        found, limit = affine.affine_exponential(x), 2.0**-100 * max(1.0, size)
        assert distances(found[:3, :3], due[:3, :3], 2)[0] <= limit * length(CTX, due[:3, :3])
        assert distances(found[:3, 3], due[:3, 3], 1)[0] <= limit * length(CTX, due[:3, 3])
        assert (found[3] == wide.widen(np.eye(4))[3]).all()


@pytest.mark.parametrize("shear", [1e10, 1e60, 1e140])
def test_exponentials_of_large_shears(shear: float) -> None:
    # exp [[a, s], [0, b]] = [[e^a, s (e^a - e^b)/(a - b)], [0, e^b]]
    x = wide.tangent(wide.widen(np.array([[3.0, shear], [0.0, -2.0]])), np.zeros((2, 2)))
    found, a, b = affine.affine_exponential(x), CTX.exp(3), CTX.exp(-2)
    assert error(found[:2, :2], [[a, shear * (a - b) / 5], [0, b]]) <= 2.0**-96


HALF_TURNS = (
    -3 * np.eye(2),
    np.diag([-2.0, -2.0, 0.5]),
    2 * np.outer([1, 2, 2], [1, 2, 2]) - 9 * np.eye(3),
    np.array([[-5.0, 0, 0], [0, -5, 0], [4, 8, 3]]),
)


@pytest.mark.parametrize("linear", HALF_TURNS, ids=str)
def test_half_turns_with_and_without_rounding(linear: Any) -> None:
    d = len(linear)
    a = wide.homogeneous(wide.widen(linear), wide.widen(np.arange(1.0, d + 1)))
    due = sam.log(CTX, exactly(a))
    found, existence = affine.affine_logarithm(a)
    assert existence == HALF_TURN
    assert distances(found, due, 2)[0] <= 2.0**-98 * length(CTX, due)
    draw = generator()
    b = homogeneous(draw, 9, d)
    blurred = wide.right_quotient(wide.product(a, b), b)
    found, existence = affine.affine_logarithm(blurred)
    assert (existence == HALF_TURN).all()
    assert max(distances(found, np.array([due] * 9), 2)) <= 2.0**-88 * length(CTX, due)


def test_what_has_no_logarithm_is_told() -> None:
    linear = np.stack([np.diag([-1.0, -2.0]), -np.eye(2) + np.eye(2, k=1), np.diag([1.0, -1.0]), np.eye(2), -np.eye(2)])
    a = wide.homogeneous(wide.widen(linear), np.zeros((2, 2)))
    due = [NONE, NONE, NOT_ORIENTED, PRIMARY, HALF_TURN]
    for matrix, existence in (affine.affine_logarithm(a), affine.affine_power(a, np.full(5, 0.5))):
        assert existence.tolist() == due
        assert np.isnan(matrix).all(axis=(1, 2, 3)).tolist() == [True, True, True, False, False]
    # Complex by a low part alone, and real by it.
    for low, kind in ((-1e-40, PRIMARY), (1e-40, NONE)):
        linear = wide.widen(-np.eye(2) + np.eye(2, k=1))
        linear[1, 0, 1] = linear[1, 0, 0] = low
        linear[1, 0, 1] = 1e-60
        assert affine.affine_logarithm(wide.homogeneous(linear, np.zeros((2, 2))))[1] == kind


def test_powers_are_exact_at_the_ends() -> None:
    draw = generator()
    for d in (2, 3):
        a = wide.homogeneous(drawn(draw, np.eye(d) + 0.2 * draw.normal(size=(d, d))), drawn(draw, draw.normal(size=d)))
        powers, _ = affine.affine_power(a, np.array([0.0, 1.0]))
        assert (powers[0] == wide.widen(np.eye(d + 1))).all()
        assert (powers[1] == a).all()


def inputs() -> Iterator[tuple[Callable[..., Any], tuple[Array, ...]]]:
    draw = generator()
    x, y = (drawn(draw, draw.uniform(0.5, 3.0, 4)) for _ in range(2))
    for pair in (wide.add, wide.subtract, wide.multiply, wide.divide, wide.arctangent2):
        yield pair, (x, y)
    for single in (wide.square_root, wide.exponential, wide.logarithm, wide.sine_cosine, space.plane_rotation):
        yield single, (x,)
    omega, t = drawn(draw, draw.normal(size=(4, 3))), draw.normal(size=4)
    rotation = space.rotation(omega)
    a = wide.homogeneous(drawn(draw, np.eye(3) + 0.2 * draw.normal(size=(4, 3, 3))), omega)
    yield space.rotation, (omega,)
    yield space.rotation_vector, (rotation,)
    yield space.rotation_vector_near, (rotation, drawn(draw, 5 * draw.normal(size=(4, 3))))
    yield space.rotation_power, (rotation, t)
    yield space.angle, (space.plane_rotation(x),)
    yield space.nearest_rotation, (rotation[..., 0],)
    yield wide.times, (x, t)
    yield wide.inverse, (a,)
    yield wide.determinant_sign, (a,)
    for quotient in (wide.product, wide.left_quotient, wide.right_quotient):
        yield quotient, (a, a[::-1])
    yield wide.image, (a, omega)
    yield affine.affine_logarithm, (a,)
    yield affine.affine_power, (a, t)
    yield affine.affine_exponential, (wide.tangent(wide.linear_part(a), omega),)


def as_tuple(result: Any) -> tuple[Array, ...]:
    return result if isinstance(result, tuple) else (result,)


def test_batches() -> None:
    for function, arguments in inputs():
        name = function.__name__
        whole = as_tuple(function(*arguments))
        for i in range(4):
            for part, item in zip(whole, as_tuple(function(*(x[i] for x in arguments))), strict=True):
                assert part[i].tobytes() == np.asarray(item).tobytes(), name
        for part, item in zip(whole, as_tuple(function(*(x[None, :0] for x in arguments))), strict=True):
            assert item.shape == (1, 0, *part.shape[1:]), name
        if len(arguments) > 1:
            first, *others = arguments
            outer = as_tuple(function(first[:, None], *others))[0]
            assert outer.shape == (4, *whole[0].shape), name
            assert all(outer[i, i].tobytes() == whole[0][i].tobytes() for i in range(4)), name
