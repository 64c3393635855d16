"""T = A S E of the reference: factors, and interpolants built again from exp, log and the groups' products."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import affine_lie, scale, se3, shear
from affinecert.reference._matrices import cross, homogeneous, identity, norm, scalar

from .enclosures import Numbers, context, length, numbers

BITS = 400
LOST = 60
CANONICAL = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])
TIMES = [-1.5, 0.0, 0.3, 1.0, 4.0]


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def close(ctx: Any, found: Numbers, expected: Numbers, lost: int = LOST) -> bool:
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected), lost - BITS))


def affine_maps(count: int = 6) -> list[np.ndarray[Any, Any]]:
    draw = np.random.default_rng(3)
    maps = []
    for _ in range(count):
        affine = np.eye(4)
        affine[:3] = draw.normal(size=(3, 4)) * 10.0 ** draw.integers(-3, 4, size=(3, 1))
        affine[0, :3] *= np.sign(np.linalg.det(affine[:3, :3]))
        maps.append(affine)
    thin = np.array([[1.0, 1, 0, 5], [1, 1 + 1e-15, 1e-9, 0], [0, 0, 1e100, 1e-100], [0, 0, 0, 1]])
    return [*maps, np.eye(4), thin]


def tetrahedra(count: int, seed: int = 4) -> list[np.ndarray[Any, Any]]:
    draw = np.random.default_rng(seed)
    drawn: list[np.ndarray[Any, Any]] = []
    while len(drawn) < count:
        vertices = draw.normal(size=(4, 3))
        if np.linalg.det(vertices[1:] - vertices[0]) > 0:
            drawn.append(vertices)
    return drawn


@pytest.mark.parametrize("affine", affine_maps())
def test_decomposition_is_unique_and_composes(ctx: Any, affine: Any) -> None:
    exact = numbers(ctx, affine)
    rigid, sheared, s = affine_lie.decompose(ctx, exact)
    rotation = rigid[:3, :3]
    assert close(ctx, rotation @ rotation.T, identity(ctx, 3))
    assert np.linalg.det(rotation.astype(float)) > 0
    assert s[()] > 0 and sheared[1, 1] > 0 and sheared[2, 2] > 0
    assert np.array_equal(sheared[[0, 1, 2, 2], [0, 0, 0, 1]], numbers(ctx, [1.0, 0, 0, 0]))
    with ctx.workprec(3000):
        found = affine_lie.compose(ctx, rigid, sheared, s)
        assert close(ctx, found, exact)
        assert close(ctx, found[:3, 3], exact[:3, 3])


def factor_powers(ctx: Any, rigid: Numbers, sheared: Numbers, s: Numbers, t: float) -> tuple[Numbers, Numbers, Numbers]:
    """exp(t log E), exp(t log A), exp(t log s)."""
    time = ctx.mpf(t)
    return (
        se3.exp(ctx, se3.log(ctx, rigid) * time),
        shear.exp(ctx, shear.log(ctx, sheared) * time),
        scale.exp(ctx, scalar(scale.log(ctx, s)[()] * time)),
    )


@pytest.mark.parametrize("affine", affine_maps())
@pytest.mark.parametrize("t", TIMES)
def test_interpolation_multiplies_the_powers_of_the_factors(ctx: Any, affine: Any, t: float) -> None:
    exact = numbers(ctx, affine)
    found = affine_lie.interpolate(ctx, exact, numbers(ctx, t))
    with ctx.workprec(3000):
        expected = affine_lie.compose(ctx, *factor_powers(ctx, *affine_lie.decompose(ctx, exact), t))
    assert close(ctx, found, expected)


def by_hand(ctx: Any, rigid: Numbers, sheared: Numbers, s: Numbers, vertices: Numbers) -> Numbers:
    """A S E applied to vertices in rows."""
    return np.array([sheared @ (rigid[:3, :3] @ v + rigid[:3, 3]) * s[()] for v in vertices])


def test_representation_maps_onto_the_canonical_tetrahedron(ctx: Any) -> None:
    canonical = numbers(ctx, CANONICAL)
    for p in tetrahedra(4):
        rigid, sheared, s = affine_lie.represent(ctx, numbers(ctx, p), canonical)
        assert close(ctx, by_hand(ctx, rigid, sheared, s, numbers(ctx, p)), canonical)
        aligned = by_hand(ctx, rigid, identity(ctx, 3), scalar(ctx.one), numbers(ctx, p)).astype(float)
        assert np.allclose(aligned[0], 0) and aligned[1, 0] > 0 and aligned[2, 1] > 0 and aligned[3, 2] > 0
        assert np.allclose(aligned[[1, 1, 2], [1, 2, 2]], 0)


def test_representation_against_another_tetrahedron(ctx: Any) -> None:
    """Section 5.1: E is the same; A_p1 = A_D^-1 A_p, s_p1 = s_p / s_D; and equation 7 maps onto the new canonical."""
    for p, other in zip(tetrahedra(3), tetrahedra(3, seed=9), strict=True):
        exact, canonical = numbers(ctx, p), numbers(ctx, other)
        usual = affine_lie.represent(ctx, exact, numbers(ctx, CANONICAL))
        own = affine_lie.represent(ctx, canonical, numbers(ctx, CANONICAL))
        rigid, sheared, s = affine_lie.represent(ctx, exact, canonical)
        assert close(ctx, rigid, usual[0])
        assert close(ctx, own[1] @ sheared, usual[1])
        assert close(ctx, own[2] * s, usual[2])
        aligned = by_hand(ctx, own[0], identity(ctx, 3), scalar(ctx.one), canonical)
        assert close(ctx, by_hand(ctx, rigid, sheared, s, exact), aligned)


def inverse(ctx: Any, rigid: Numbers) -> Numbers:
    rotation = rigid[:3, :3].T
    return homogeneous(ctx, rotation, -(rotation @ rigid[:3, 3]))


def upper_inverse(ctx: Any, sheared: Numbers) -> Numbers:
    """The inverse in G_A, as the exponential of minus the logarithm."""
    return shear.exp(ctx, -shear.log(ctx, sheared))


@pytest.mark.parametrize("t", TIMES)
def test_tetrahedra_are_interpolated_in_the_group(ctx: Any, t: float) -> None:
    """Equation 4, p exp(t log p^-1 q), and vertices S^-1 A^-1 E^-1 of the canonical ones."""
    for p, q in itertools.pairwise(tetrahedra(4)):
        source, target = numbers(ctx, p), numbers(ctx, q)
        found = affine_lie.interpolate_tetrahedra(ctx, source, target, numbers(ctx, t))
        with ctx.workprec(BITS + 300):
            e_p, a_p, s_p = affine_lie.represent(ctx, source, numbers(ctx, CANONICAL))
            e_q, a_q, s_q = affine_lie.represent(ctx, target, numbers(ctx, CANONICAL))
            quotient = (inverse(ctx, e_p) @ e_q, upper_inverse(ctx, a_p) @ a_q, s_q[()] / s_p[()])
            e, a, s = factor_powers(ctx, quotient[0], quotient[1], scalar(quotient[2]), t)
            back = upper_inverse(ctx, a_p @ a) / (s_p[()] * s[()])
            expected = numbers(ctx, CANONICAL) @ back.T
            motion = inverse(ctx, e_p @ e)
            expected = expected @ motion[:3, :3].T + motion[:3, 3]
        assert close(ctx, found, expected)


def test_interpolants_start_at_the_source_and_end_at_the_target(ctx: Any) -> None:
    for p, q in itertools.pairwise(tetrahedra(4)):
        source, target = numbers(ctx, p), numbers(ctx, q)
        for t, expected in ((0.0, source), (1.0, target)):
            time = numbers(ctx, t)
            assert close(ctx, affine_lie.interpolate_tetrahedra(ctx, source, target, time), expected)
            assert close(ctx, affine_lie.interpolate_triangles(ctx, source[:3], target[:3], time), expected[:3])
            for ordering in affine_lie.interpolate_orderings(ctx, source, target, time):
                assert close(ctx, ordering, expected)


def test_triangles_are_tetrahedra_over_their_unit_normals(ctx: Any) -> None:
    for p, q in itertools.pairwise(tetrahedra(3)):
        tops: list[Numbers] = []
        for vertices in (numbers(ctx, p), numbers(ctx, q)):
            normal = cross(vertices[1] - vertices[0], vertices[2] - vertices[0])
            vertices[3] = vertices[0] + normal / norm(ctx, normal)
            tops.append(vertices)
        time = numbers(ctx, 0.3)
        whole = affine_lie.interpolate_tetrahedra(ctx, tops[0], tops[1], time)
        assert close(ctx, affine_lie.interpolate_triangles(ctx, tops[0][:3], tops[1][:3], time), whole[:3])


def test_orderings_are_the_twelve_even_ones_in_order() -> None:
    assert len(affine_lie.ORDERINGS) == 12
    assert list(affine_lie.ORDERINGS) == sorted(affine_lie.ORDERINGS)
    assert all(round(np.linalg.det(np.eye(4)[list(order)])) == 1 for order in affine_lie.ORDERINGS)


def test_orderings_interpolate_the_reordered_tetrahedra(ctx: Any) -> None:
    source, target = (numbers(ctx, p) for p in tetrahedra(2))
    time = numbers(ctx, 0.4)
    for order, found in zip(
        affine_lie.ORDERINGS, affine_lie.interpolate_orderings(ctx, source, target, time), strict=True
    ):
        expected = affine_lie.interpolate_tetrahedra(ctx, source[list(order)], target[list(order)], time)
        assert np.array_equal(found[list(order)], expected)


def test_orderings_agree_on_rigid_motions(ctx: Any) -> None:
    """Section 5.2.1; permuted axes are a rotation that the vertices carry exactly."""
    source = numbers(ctx, tetrahedra(1)[0])
    target = source @ numbers(ctx, [[0.0, 1, 0], [0, 0, 1], [1, 0, 0]]).T + numbers(ctx, [1.0, 2, 3])
    first, *others = affine_lie.interpolate_orderings(ctx, source, target, numbers(ctx, 0.4))
    assert all(close(ctx, other, first) for other in others)


def test_half_turns_go_the_way_of_so3(ctx: Any) -> None:
    """The target is the source turned by exactly pi about z, for tetrahedra in general position."""
    turn = numbers(ctx, np.diag([-1.0, -1, 1]))
    quarter = numbers(ctx, [[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    half = numbers(ctx, 0.5)
    for p in tetrahedra(6):
        source = numbers(ctx, p)
        # E_q = E_p turn^-1, so that log E_p^-1 E_q = log turn is the positive quarter turn at t = 1/2, and E_r^-1
        # turns the vertices back by it.
        found = affine_lie.interpolate_tetrahedra(ctx, source, source @ turn.T, half)
        assert close(ctx, found, source @ quarter)
        found = affine_lie.interpolate_triangles(ctx, source[:3], source[:3] @ turn.T, half)
        assert close(ctx, found, source[:3] @ quarter)
    found = affine_lie.interpolate(ctx, homogeneous(ctx, turn, numbers(ctx, [0.0, 0, 0])), half)
    assert close(ctx, found[:3, :3], quarter)


def test_interpolations_can_be_continued_beyond_half_a_turn(ctx: Any) -> None:
    half = numbers(ctx, 0.5)
    source = numbers(ctx, tetrahedra(1)[0])
    below, above = (se3.exp(ctx, numbers(ctx, [0.1, 0.2, angle, 1, 2, 3])) for angle in (3.13, 3.14))
    jumped = affine_lie.interpolate(ctx, above, half)
    base = affine_lie.interpolate(ctx, below, half)
    continued = affine_lie.continue_interpolate(ctx, base, above, half)
    assert length(ctx, jumped - base) > 1
    assert length(ctx, continued - base) < 0.1
    for interpolation, continuation in (
        (affine_lie.interpolate_tetrahedra, affine_lie.continue_interpolate_tetrahedra),
        (affine_lie.interpolate_triangles, affine_lie.continue_interpolate_triangles),
        (affine_lie.interpolate_orderings, affine_lie.continue_interpolate_orderings),
    ):
        vertices = source[:3] if interpolation is affine_lie.interpolate_triangles else source
        targets = [vertices @ motion[:3, :3].T + motion[:3, 3] for motion in (below, above)]
        base = interpolation(ctx, vertices, targets[0], half)
        assert length(ctx, interpolation(ctx, vertices, targets[1], half) - base) > 1
        assert length(ctx, continuation(ctx, base, vertices, targets[1], half) - base) < 0.1


MIRRORED = CANONICAL[[0, 2, 1, 3]]
FLAT = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 3, 0]])
LINE = np.array([[0.0, 0, 0], [0.1, 0.2, 0.3], [0.2, 0.4, 0.6]])


def test_refusals(ctx: Any) -> None:
    good, half = numbers(ctx, CANONICAL), numbers(ctx, 0.5)
    for vertices in (MIRRORED, FLAT, np.zeros((4, 3))):
        bad = numbers(ctx, vertices)
        with pytest.raises(InputError, match="tetrahedron: degenerate"):
            affine_lie.represent(ctx, bad, good)
        with pytest.raises(InputError, match="canonical: degenerate"):
            affine_lie.represent(ctx, good, bad)
        with pytest.raises(InputError, match="target: degenerate"):
            affine_lie.interpolate_tetrahedra(ctx, good, bad, half)
    with pytest.raises(InputError, match="source: degenerate"):
        affine_lie.interpolate_triangles(ctx, numbers(ctx, LINE), good[:3], half)
    with pytest.raises(InputError, match="affine: determinant"):
        affine_lie.decompose(ctx, numbers(ctx, np.diag([1.0, -1, 1, 1])))
    with pytest.raises(InputError, match="affine: last row"):
        affine_lie.interpolate(ctx, numbers(ctx, np.diag([1.0, 1, 1, 2])), half)
    with pytest.raises(InputError, match="t: not finite"):
        affine_lie.interpolate(ctx, identity(ctx, 4), numbers(ctx, np.nan))
    one = scalar(ctx.one)
    with pytest.raises(InputError, match="rigid: not a rotation"):
        affine_lie.compose(ctx, numbers(ctx, np.diag([1.0, 1, 2, 1])), identity(ctx, 3), one)
    with pytest.raises(InputError, match="scale: not positive"):
        affine_lie.compose(ctx, identity(ctx, 4), identity(ctx, 3), scalar(-ctx.one))
