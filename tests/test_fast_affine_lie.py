"""The affine maps' decomposition and interpolation in float64: ends, half turns, sizes, degeneracy and refusals.

The errors in every regime are held in `test_fast_accuracy`, what all functions promise of batches in
`test_fast_kernels`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import permutations
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError
from affinecert.fast import affine_lie, se3, shear
from affinecert.scoring import block_score
from affinecert.truths import compute

Matrix = NDArray[np.float64]

CANONICAL = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])


def affine(linear: Any, translation: Any = (1, 2, 3)) -> Matrix:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, translation
    return matrix


def random_maps(count: int) -> Matrix:
    draw = np.random.default_rng(count)
    maps = [affine(draw.normal(size=(3, 3)), draw.normal(size=3)) for _ in range(count)]
    return np.stack([m @ np.diag([np.sign(np.linalg.det(m)), 1, 1, 1]) for m in maps])


def tetrahedra(count: int) -> Matrix:
    draw = np.random.default_rng(count + 1)
    vertices = draw.normal(size=(count, 4, 3))
    volume = np.linalg.det(vertices[:, 1:] - vertices[:, :1])
    return np.where((volume > 0)[:, None, None], vertices, vertices[:, [0, 2, 1, 3]])


def scaled_errors(name: str, inputs: Sequence[Any], outputs: Any) -> list[float]:
    entry = CATALOGUE[name]
    truth = compute(entry, tuple(np.asarray(x, dtype=float) for x in inputs))
    assert truth.refusal is None
    given = outputs if isinstance(outputs, tuple) else (outputs,)
    return [
        block_score(
            block.name,
            np.asarray(given[block.output][block.where]),
            truth.high[block.output][block.where],
            truth.low[block.output][block.where],
            k,
        ).scaled
        for block, k in zip(entry.blocks, truth.sensitivity, strict=True)
    ]


def test_the_factors_give_the_map_back() -> None:
    maps = random_maps(50)
    factors = affine_lie.decompose(maps)
    assert np.allclose(affine_lie.compose(*factors), maps, rtol=0, atol=1e-12)
    rotation = factors.rigid[:, :3, :3]
    assert np.allclose(rotation @ np.swapaxes(rotation, 1, 2), np.eye(3), rtol=0, atol=1e-15)
    assert (factors.shear[:, [1, 2], [1, 2]] > 0).all()
    assert (factors.shear[:, [1, 2, 2], [0, 0, 1]] == 0).all()
    assert (factors.shear[:, 0, 0] == 1).all()


HARD: dict[str, Any] = {
    "rows of sizes 1e-80 to 1e80": np.diag([1e80, 1, 1e-80]) @ [[1, 2, 3], [-1, 1, 2], [-3, -1, 1]],
    "a row nearly along another": [[1, 2, 3], [1, 1, 1 + 2.0**-52], [1, 1, 1]],
    "a row nearly in the plane of others": [[4, 5, 6 - 2.0**-50], [1, 2, 3], [3, 3, 3]],
    "a row that is along another but for 1e-40": [[0, 1, 1e-40], [0, 0, 1e-40], [1, 0, 0]],
    "equal nodes": [[1, 2, 3], [0, 1, 4], [0, 0, 1]],
    "nodes 1e-8 apart": [[1, 2e8, 3], [0, 1 + 1e-8, 4e8], [0, 0, 1 - 1e-8]],
    "two nodes near, one far": [[1e-20, 2, 3], [0, 1, 4], [0, 0, 1 + 1e-12]],
    "nodes in ratio 2": [[1, 2, 3], [0, 2, 4], [0, 0, 4]],
    "small turn": [[1, -1e-200, 0], [1e-200, 1, 1e-100], [0, -1e-100, 1]],
    "short of a half turn by 1e-30": [[-1, -1e-30, 0], [1e-30, -1, 0], [0, 0, 1]],
    "past a half turn by 1e-30": [[-1, 1e-30, 0], [-1e-30, -1, 0], [0, 0, 1]],
    "half turn": [[-1, 0, 0], [0, -1, 0], [0, 0, 1]],
}


@pytest.mark.parametrize("name", HARD)
def test_hard_maps(name: str) -> None:
    matrix = affine(HARD[name])
    assert max(scaled_errors("affine_lie.decompose", (matrix,), affine_lie.decompose(matrix))) <= 4.0
    for t in (0.4, 2.0, -0.5, 1e-20, 1.0 - 2.0**-53):
        assert max(scaled_errors("affine_lie.interpolate", (matrix, t), affine_lie.interpolate(matrix, t))) <= 4.0


def test_interpolants_end_exactly() -> None:
    maps, (source, target) = random_maps(5), (tetrahedra(5), tetrahedra(6)[:5])
    for t, ends in ((0.0, (np.broadcast_to(np.eye(4), maps.shape), source)), (1.0, (maps, target))):
        assert np.array_equal(affine_lie.interpolate(maps, t), ends[0])
        assert np.array_equal(affine_lie.interpolate_tetrahedra(source, target, t), ends[1])
        assert np.array_equal(
            affine_lie.interpolate_triangles(source[:, :3], target[:, :3], t), np.asarray(ends[1])[:, :3]
        )
        for k in range(12):
            assert np.array_equal(affine_lie.interpolate_orderings(source, target, t)[:, k], ends[1])


@pytest.mark.parametrize("t", [-0.5, 0.3, 1.7])
def test_interpolants_are_products_of_powers(t: float) -> None:
    maps = random_maps(20)
    factors = affine_lie.decompose(maps)
    powers = (
        se3.exp(t * se3.log(factors.rigid)),
        shear.exp(t * shear.log(factors.shear)),
        factors.scale**t,
    )
    found = affine_lie.interpolate(maps, t)
    assert np.allclose(found, affine_lie.compose(*powers), rtol=0, atol=1e-12 * np.abs(found).max())


def test_a_half_turn_is_about_the_axis_that_begins_positive() -> None:
    quarter = affine_lie.interpolate(affine(np.diag([-2.0, 2.0, -2.0])), 0.5)[:3, :3] / math.sqrt(2)
    assert np.allclose(quarter, [[0, 0, 1], [0, 1, 0], [-1, 0, 0]], rtol=0, atol=1e-15)


def test_representation_against_the_canonical_tetrahedron() -> None:
    vertices = tetrahedra(20)
    factors = affine_lie.represent(vertices, CANONICAL)
    maps = affine_lie.compose(*factors)
    images = vertices @ np.swapaxes(maps[:, :3, :3], 1, 2) + maps[:, None, :3, 3]
    assert np.allclose(images, CANONICAL, rtol=0, atol=1e-12)
    alone = affine_lie.represent(CANONICAL, CANONICAL)
    assert [part.tolist() for part in alone] == [np.eye(4).tolist(), np.eye(3).tolist(), 1.0]


def test_orderings_are_interpolants_of_reordered_vertices() -> None:
    source, target = tetrahedra(3), tetrahedra(4)[:3]
    even = [order for order in permutations(range(4)) if np.linalg.det(np.eye(4)[list(order)]) > 0]
    found = affine_lie.interpolate_orderings(source, target, [0.1, 0.5, 0.9])
    assert found.shape == (3, 12, 4, 3)
    for k, order in enumerate(map(list, even)):
        due = affine_lie.interpolate_tetrahedra(source[:, order], target[:, order], [0.1, 0.5, 0.9])
        assert np.array_equal(found[:, k][:, order], due)


def test_a_triangle_moves_as_the_tetrahedron_on_its_normal() -> None:
    first, last = tetrahedra(10), tetrahedra(11)[:10]
    for vertices in (first, last):
        normal = np.cross(vertices[:, 1] - vertices[:, 0], vertices[:, 2] - vertices[:, 0])
        vertices[:, 3] = vertices[:, 0] + normal / np.linalg.norm(normal, axis=1, keepdims=True)
    whole = affine_lie.interpolate_tetrahedra(first, last, 0.3)
    face = affine_lie.interpolate_triangles(first[:, :3], last[:, :3], 0.3)
    assert np.allclose(face, whole[:, :3], rtol=0, atol=1e-13)


# Of whole numbers: the fourth vertex in the plane of the others, the third one on the first edge.
FLAT = np.array([[1.0, 2, 3], [2, 4, 7], [4, 3, 2], [5, 5, 6]])
LINE = np.array([[1.0, 2, 3], [2, 4, 7], [4, 8, 15], [5, 5, 6]])


def test_degenerate_tetrahedra_are_told_exactly() -> None:
    thin = FLAT.copy()
    thin[3, 0] = np.nextafter(thin[3, 0], 9)
    lifted = thin if np.linalg.det(thin[1:] - thin[0]) > 0 else thin[[0, 2, 1, 3]]
    assert max(scaled_errors("affine_lie.represent", (lifted, CANONICAL), affine_lie.represent(lifted, CANONICAL))) <= 4
    for bad in (FLAT, LINE, CANONICAL[[0, 2, 1, 3]]):
        with pytest.raises(InputError, match=r"^tetrahedron\[1\]: degenerate, or negatively oriented"):
            affine_lie.represent(np.stack([CANONICAL, bad]), CANONICAL)
        with pytest.raises(InputError, match=r"^canonical: degenerate, or negatively oriented"):
            affine_lie.represent(CANONICAL, bad)
        with pytest.raises(InputError, match=r"^target\[0, 1\]: degenerate, or negatively oriented"):
            affine_lie.interpolate_tetrahedra(CANONICAL, np.stack([CANONICAL, bad])[None], 0.5)
        with pytest.raises(InputError, match=r"^source: degenerate, or negatively oriented"):
            affine_lie.interpolate_orderings(bad, CANONICAL, 0.5)
    with pytest.raises(InputError, match=r"^source: degenerate: the triangle has no area"):
        affine_lie.interpolate_triangles(LINE[:3], CANONICAL[:3], 0.5)


def test_singular_maps_are_told_exactly() -> None:
    nearly = affine([[1, 2, 3], [4, 5, 6], [7, 8, np.nextafter(9.0, 0.0)]])
    assert max(scaled_errors("affine_lie.decompose", (nearly,), affine_lie.decompose(nearly))) <= 4.0
    for bad in ([[1, 2, 3], [4, 5, 6], [7, 8, 9]], np.diag([1, -1, 1]), np.zeros((3, 3))):
        with pytest.raises(InputError, match=r"^affine\[1\]: the determinant"):
            affine_lie.decompose(np.stack([np.eye(4), affine(bad)]))
        with pytest.raises(InputError, match=r"^affine\[0\]: the determinant"):
            affine_lie.interpolate(affine(bad)[None], np.zeros((4, 1)))
    with pytest.raises(InputError, match=r"^affine: the last row"):
        affine_lie.decompose(np.ones((4, 4)))


def test_what_is_no_factor_is_refused() -> None:
    unit = np.eye(4)
    mirror, stretched, slanted = affine(np.diag([1, 1, -1])), affine(np.diag([1, 1, 1.00001])), np.ones((4, 4))
    for bad, reason in ((mirror, "not a rotation"), (stretched, "not a rotation"), (slanted, "the last row")):
        with pytest.raises(InputError, match=rf"^rigid\[1\]: {reason}"):
            affine_lie.compose(np.stack([unit, bad]), np.eye(3), 1.0)
    for bad, reason in ((np.ones((3, 3)), "not a shear"), (np.diag([1.0, -1, 1]), "the diagonal is not positive")):
        with pytest.raises(InputError, match=rf"^shear\[1\]: {reason}"):
            affine_lie.compose(unit, np.stack([np.eye(3), bad]), 1.0)
    with pytest.raises(InputError, match=r"^scale\[1\]: not positive"):
        affine_lie.compose(unit, np.eye(3), [1.0, 0.0])
