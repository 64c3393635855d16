"""`fast.mesh3.blend` on larger meshes, against dense least squares, and what the paper requires of it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.fast import mesh3, so3
from affinecert.fast._sparse import factored

from . import dense_meshes

Array = NDArray[Any]


def sphere() -> tuple[Array, Array]:
    """The vertices of an octahedron whose faces are cut in four twice, on the unit sphere; and its 128 triangles."""
    points = [tuple(sign * row) for row in np.eye(3) for sign in (1, -1)]
    faces = [(a, b, c) for a in (0, 1) for b in (2, 3) for c in (4, 5)]
    for _ in range(2):
        middles: dict[frozenset[int], int] = {}
        finer = []
        for i, j, k in faces:
            a, b, c = (
                middles.setdefault(frozenset(pair), len(points) + len(middles)) for pair in ((i, j), (j, k), (k, i))
            )
            finer += [(i, a, c), (j, b, a), (k, c, b), (a, b, c)]
        points += [tuple(np.mean([points[v] for v in pair], axis=0)) for pair in middles]
        faces = finer
    places = np.array(points)
    return places / np.linalg.norm(places, axis=-1, keepdims=True), np.array(faces, dtype=np.float64)


REST, TRIANGLES = sphere()
STRETCHED = REST * [1.0, 2.0, 3.0] + [5.0, 0.0, 0.0]
TWISTED = np.einsum("nij,nj->ni", so3.exp(REST[:, 2:] * [0.0, 0.0, 1.0]), REST) * [1.0, 0.5, 1.0]
TARGETS = np.array([STRETCHED, TWISTED])


@pytest.mark.parametrize("weights", [[0.3, 0.5], [-0.5, 1.5], [1.0, 1.0]])
def test_blends_are_as_dense_least_squares_have_them(weights: Any) -> None:
    found = mesh3.blend(REST, TARGETS, TRIANGLES, weights)
    due = dense_meshes.blend(REST, TARGETS, TRIANGLES, np.array(weights))
    assert np.abs(found - due).max() <= 1e-12


def test_the_shapes_given_are_interpolated() -> None:
    found = mesh3.blend(REST, TARGETS, TRIANGLES, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    assert np.abs(found - [REST, STRETCHED, TWISTED]).max() <= 1e-15


def test_the_barycentre_moves_linearly() -> None:
    weights = np.array([[0.25, 0.5], [2.0, -1.0]])
    found = mesh3.blend(REST, TARGETS, TRIANGLES, weights)
    centres = REST.mean(axis=0), TARGETS.mean(axis=1)
    assert np.allclose(found.mean(axis=1), centres[0] + weights @ (centres[1] - centres[0]), rtol=0, atol=1e-15)


def test_rotations_keep_the_shape_all_the_way() -> None:
    """Condition (V): rigid motions blend to rigid motions, where a linear blend shrinks."""
    target = REST @ so3.exp([0.0, 0.0, 2.5]).T
    half = mesh3.blend(REST, target[None], TRIANGLES, [0.5])
    assert np.abs(half - REST @ so3.exp([0.0, 0.0, 1.25]).T).max() <= 1e-15
    assert np.linalg.norm(REST + target, axis=-1).min() / 2 < 0.999
    assert np.allclose(np.linalg.norm(half, axis=-1), 1.0, rtol=0, atol=1e-15)


def test_many_weights_share_one_factorisation(monkeypatch: pytest.MonkeyPatch) -> None:
    weights = np.random.default_rng(0).uniform(-1, 2, (2, 3, 2))
    alone = [[mesh3.blend(REST, TARGETS, TRIANGLES, each) for each in row] for row in weights]
    calls = []

    def counted(matrix: Any) -> Any:
        calls.append(matrix)
        return factored(matrix)

    monkeypatch.setattr(mesh3, "factored", counted)
    together = mesh3.blend(REST, TARGETS, TRIANGLES, weights)
    assert len(calls) == 1
    assert np.array_equal(together, alone)


def test_the_item_that_is_refused_is_named() -> None:
    rest = np.stack([REST] * 3)
    first, second, _ = TRIANGLES[0].astype(int)
    rest[1, first] = rest[1, second]
    with pytest.raises(InputError, match=r"^rest\[1\]: a triangle without area"):
        mesh3.blend(rest, TARGETS, TRIANGLES, [0.5, 0.5])
    with pytest.raises(InputError, match=r"^targets\[0\]: a triangle without area"):
        mesh3.blend(REST, np.stack([[STRETCHED, TWISTED * 0.0]]), TRIANGLES, np.ones((5, 2)))
    with pytest.raises(InputError, match=r"^triangles: not one piece with all vertices"):
        mesh3.blend(REST, TARGETS, TRIANGLES[:64], [0.5, 0.5])
    with pytest.raises(InputError, match=r"^weights: shape \(3,\) where \(..., 2\) is due"):
        mesh3.blend(REST, TARGETS, TRIANGLES, [0.5, 0.5, 0.5])


def test_areas_that_rounding_cannot_tell_are_told_exactly() -> None:
    """A triangle is degenerate exactly where its corners are in line, though the vector product rounds to something."""
    place, step = np.array([0.1, 0.2, 0.3]), np.array([2.0**-40, 2.0**-41, 2.0**-39])
    straight = np.array([place, place + step, place + 2 * step])
    assert np.array_equal(straight[2] - straight[1], step)
    triangle = [[0.0, 1.0, 2.0]]
    with pytest.raises(InputError, match=r"^rest: a triangle without area"):
        mesh3.blend(straight, REST[None, :3], triangle, [0.5])
    bent = straight.copy()
    bent[1, 0] = np.nextafter(bent[1, 0], 1)
    assert np.isfinite(mesh3.blend(bent, REST[None, [0, 2, 4]], triangle, [0.5])).all()
