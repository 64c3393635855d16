"""`fast.mesh2.interpolate` with all of its options, against dense least squares, and what the paper promises of it."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.fast import homotopy2, mesh2
from affinecert.fast._homotopy import ONE
from affinecert.fast._mesh_errors import Errors, homotopies
from affinecert.fast._triangulation import coherent_turns, twice_areas
from affinecert.fast._wide import widen
from affinecert.fast.mesh2 import Barycentre, Edge, Locus, interpolate

from . import dense_meshes

Array = NDArray[Any]

ENERGIES: tuple[mesh2.Energy, ...] = ("frobenius", "similarity", "points")


def grid(columns: int, rows: int) -> tuple[Array, Array]:
    """The vertices of a grid of unit squares, each cut into two triangles, and these."""
    places = np.array([[x, y] for y in range(rows + 1) for x in range(columns + 1)], dtype=np.float64)
    corner = np.array([x + (columns + 1) * y for y in range(rows) for x in range(columns)])
    right, above, across = corner + 1, corner + columns + 1, corner + columns + 2
    lower, upper = np.stack([corner, right, across], axis=-1), np.stack([corner, across, above], axis=-1)
    return places, np.concatenate([lower, upper])


def bent(shape: Array, angle: float) -> Array:
    """A strip along the x axis as an arc whose ends differ in direction by that angle."""
    length = np.ptp(shape[:, 0])
    radius = length / angle
    turn = (shape[:, 0] - shape[:, 0].min()) / radius
    return np.asarray(np.stack([np.sin(turn), -np.cos(turn)], axis=-1) * (radius - shape[:, 1])[:, None])


def turned(shape: Array, angle: float, scale: float = 1.0) -> Array:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.asarray(scale * shape @ np.array([[cosine, sine], [-sine, cosine]]))


@pytest.fixture(scope="module")
def small() -> tuple[Array, Array, Array]:
    """A source, a target and eight triangles."""
    draw = np.random.default_rng(1)
    places, triangles = grid(2, 2)
    source = places + draw.uniform(-0.2, 0.2, places.shape)
    target = turned(places + draw.uniform(-0.2, 0.2, places.shape), 1.0, 1.5) + np.array([3.0, -1.0])
    return source, target, triangles


STRIP, STRIP_TRIANGLES = grid(20, 2)


def at(constraints: tuple[Any, ...], t: float) -> tuple[Any, ...]:
    """The constraints with their paths' points at a time."""
    return tuple(type(each)(**{**vars(each), "path": np.asarray(each.path(t))}) for each in constraints)


HELD = (
    Locus(0, lambda t: (3 * t, -t)),
    Locus(7, lambda t: (2 + t, 1.5), 0.5),
    Edge(3, 8, lambda t: (1 - 2 * t, 2 * t + 0.5), 2.0),
    Edge(3, 4, lambda t: (1.0, 0.25), 0.125),
    Barycentre(lambda t: (1 + t, t), 3.0),
    Barycentre(lambda t: (0.0, 1.0), 0.5),
)
FLOATING = (Edge(0, 8, lambda t: (2 - 3 * t, 2.0), 0.75), Barycentre(lambda t: (t, t * t)))


@pytest.mark.parametrize("energy", ENERGIES)
@pytest.mark.parametrize("homotopy", ["linear", "polar", "exponential"])
@pytest.mark.parametrize("held", [HELD, HELD[:3], FLOATING], ids=["all", "loci", "floating"])
def test_every_option_is_as_dense_least_squares_have_it(
    small: tuple[Array, Array, Array], energy: mesh2.Energy, homotopy: mesh2.Homotopy, held: tuple[Any, ...]
) -> None:
    source, target, triangles = small
    masses = np.linspace(0.5, 2.0, len(triangles))
    for t, weights, symmetric in ((0.3, None, False), (0.6, masses, False), (1.25, None, True), (-0.5, masses, True)):
        if held is FLOATING and energy == "frobenius":
            held = (FLOATING[0], Locus(2, lambda t: (0.0, t), 0.1))
        options: dict[str, Any] = {"energy": energy, "weights": weights, "symmetric": symmetric}
        found = interpolate(source, target, triangles, t, homotopy=homotopy, constraints=held, **options)
        fixed = at(held, t)
        if held is FLOATING:
            # With nothing in its place the mean is exactly where it should be; any large weight tells that.
            fixed = (fixed[0], Barycentre(fixed[1].path, 1e7))
        kind = getattr(homotopy2, homotopy)
        due = dense_meshes.shape(source, target, triangles, t, homotopy=kind, constraints=fixed, **options)
        assert np.abs(found - due).max() <= 1e-9 * np.abs(due).max()


@pytest.mark.parametrize("symmetric", [False, True])
def test_a_balance_is_as_dense_least_squares_have_it(small: tuple[Array, Array, Array], symmetric: bool) -> None:
    source, target, triangles = small
    options: dict[str, Any] = {"energy": "similarity", "balance": 0.25, "symmetric": symmetric}
    found = interpolate(source, target, triangles, 0.4, constraints=HELD[:1], **options)
    due = dense_meshes.shape(source, target, triangles, 0.4, constraints=at(HELD[:1], 0.4), **options)
    assert np.abs(found - due).max() <= 1e-9


@pytest.mark.parametrize("energy", ENERGIES)
@pytest.mark.parametrize("symmetric", [False, True])
def test_both_ends_are_reached(energy: mesh2.Energy, symmetric: bool) -> None:
    source = STRIP + 0.1 * np.sin(7 * STRIP[:, ::-1])
    target = bent(source, 2.0)
    found = interpolate(source, target, STRIP_TRIANGLES, [0.0, 1.0], energy=energy, symmetric=symmetric)
    assert np.abs(found - [source, target]).max() <= 2e-15


@pytest.mark.parametrize("energy", ENERGIES)
def test_symmetrised_the_way_back_is_the_way_there(energy: mesh2.Energy) -> None:
    source, target = STRIP, bent(STRIP, 1.5) @ np.diag([1.0, 1.25])
    times = np.array([0.125, 0.5, 0.75])
    for symmetric, allowed in ((True, 1e-13), (False, None)):
        there = interpolate(source, target, STRIP_TRIANGLES, times, energy=energy, symmetric=symmetric)
        back = interpolate(target, source, STRIP_TRIANGLES, 1 - times, energy=energy, symmetric=symmetric)
        difference = np.abs(there - back).max()
        assert difference <= allowed if allowed else difference > 1e-5


@pytest.mark.parametrize("energy", ["similarity", "points"])
def test_similarities_of_the_target_carry_over(energy: mesh2.Energy) -> None:
    """E^R and E^S do not see them: a target turned and scaled by g turns and scales the shape at t by g^t."""
    source, target, t = STRIP, bent(STRIP, 1.5), 0.375
    plain = interpolate(source, target, STRIP_TRIANGLES, t, energy=energy)
    moved = interpolate(source, turned(target, 0.5, 4.0), STRIP_TRIANGLES, t, energy=energy)
    expected = turned(plain - plain[0], 0.5 * t, 4.0**t)
    assert np.abs(moved - moved[0] - expected).max() <= 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("energy", ENERGIES)
def test_a_similarity_moves_as_one(energy: mesh2.Energy) -> None:
    """If the target is similar to the source, so is every shape between, for all energies the same."""
    target = turned(STRIP, 2.0, 3.0) + np.array([5.0, 0.0])
    found = interpolate(STRIP, target, STRIP_TRIANGLES, 0.5, energy=energy)
    expected = turned(STRIP, 1.0, math.sqrt(3.0)) + np.array([2.5, 0.0])
    assert np.abs(found - expected).max() <= 1e-13 * np.abs(expected).max()


def test_constraints_are_met_as_their_weight_grows() -> None:
    target, place = bent(STRIP, 1.0), np.array([30.0, 5.0])

    def misses(weight: float) -> float:
        held = (Locus(0, (0.0, 0.0)), Locus(41, place, weight))
        options: dict[str, Any] = {"energy": "frobenius", "constraints": held}
        return float(np.linalg.norm(interpolate(STRIP, target, STRIP_TRIANGLES, 0.5, **options)[41] - place))

    found = [misses(weight) for weight in (1e-3, 1.0, 1e3, 1e6, 1e9)]
    assert found == sorted(found, reverse=True)
    # What is missed goes with the inverse of the weight, in the end; with an infinite one it is nothing.
    assert found[3] / found[2] == pytest.approx(1e-3, rel=0.01)
    assert found[4] / found[3] == pytest.approx(1e-3, rel=1e-5)
    assert misses(math.inf) == 0.0


def areas(shapes: Array, triangles: Array) -> Array:
    return np.array([dense_meshes.areas(shape, triangles) for shape in shapes])


def test_turns_beyond_pi() -> None:
    """Figures 3 and 5: a strip that is bent by more than pi fails with E^F, as long as its angles are principal.

    E^R, which sees no angles, and E^F with coherent ones bend it half as far, half way.
    """
    target, times = bent(STRIP, 1.75 * math.pi), np.linspace(0, 1, 9)

    def way(**options: Any) -> Array:
        return interpolate(STRIP, target, STRIP_TRIANGLES, times, **options)

    failing = way(energy="frobenius")
    assert areas(failing, STRIP_TRIANGLES).min() < 0
    loci = [Locus(0, STRIP[0] + np.multiply.outer(times, target[0] - STRIP[0])), Edge(0, 21, half_turns(times, target))]
    for shapes in (
        way(energy="frobenius", angles="coherent"),
        way(constraints=loci),
        way(energy="points", constraints=loci),
    ):
        smallest = areas(shapes, STRIP_TRIANGLES).min(axis=1)
        assert smallest.min() > 0.1
        assert np.abs(shapes[[0, -1]] - [STRIP, target]).max() <= 1e-13
        first, last = (shapes[4][i] - shapes[4][j] for i, j in ((1, 0), (20, 19)))
        turn = math.atan2(first[0] * last[1] - first[1] * last[0], first @ last)
        # Of the 20 cells 19 lie between the middles of the first and the last: 0.83 pi of 0.875 pi.
        assert 0.83 * math.pi < turn % (2 * math.pi) < 0.93 * math.pi


def test_loci_that_turn_the_other_way() -> None:
    """Figures 2 and 4: E^F turns triangles over where loci ask for another angle; E^R and E^S keep the shape."""
    angle, times = 2.5, np.linspace(0, 1, 9)
    target = turned(STRIP, angle)
    back = [(k, np.array([turned(STRIP[k], (angle - 2 * math.pi) * t) for t in times])) for k in (0, 20, 42, 62)]
    for energy in ENERGIES:
        held = [Locus(*each) for each in back]
        shapes = interpolate(STRIP, target, STRIP_TRIANGLES, times, energy=energy, constraints=held)
        if energy == "frobenius":
            assert areas(shapes, STRIP_TRIANGLES).max(axis=1).min() < 0.05
            assert areas(shapes, STRIP_TRIANGLES).min() < -0.5
        else:
            assert np.allclose(areas(shapes, STRIP_TRIANGLES), 0.5, rtol=0, atol=1e-12)


def half_turns(times: Array, target: Array) -> Array:
    """The edge at the left end of the strip, turned in proportion to the time."""
    before, after = STRIP[21] - STRIP[0], target[21] - target[0]
    angle = math.atan2(before[0] * after[1] - before[1] * after[0], before @ after)
    return np.array([turned(before, angle * t) for t in times])


def test_coherent_angles_do_not_matter_to_similarities() -> None:
    target = bent(STRIP, 1.75 * math.pi)
    for energy in ENERGIES[1:]:
        options: dict[str, Any] = {"energy": energy}
        principal = interpolate(STRIP, target, STRIP_TRIANGLES, 0.5, angles="principal", **options)
        assert np.array_equal(interpolate(STRIP, target, STRIP_TRIANGLES, 0.5, angles="coherent", **options), principal)


def test_half_turns_are_told_exactly() -> None:
    """By pi exactly all triangles turn to the left; by however little less or more, each to its side."""
    draw = np.random.default_rng(0)
    shape = np.round(STRIP * 2**20 + draw.uniform(-(2**17), 2**17, STRIP.shape)) / 2**20
    stretch = np.array([[-1.5, 0.25], [0.25, -1.0]])
    for target in (-shape, -shape * 2.0 + [1.0, 3.0], shape @ stretch):
        found = interpolate(shape, target, STRIP_TRIANGLES, 0.5, energy="frobenius")
        root = homotopy2.exponential(np.linalg.lstsq(shape - shape[0], target - target[0])[0].T, 0.5)
        assert np.allclose(found - found[0], (shape - shape[0]) @ (root * np.sign(root[1, 0])).T, rtol=0, atol=1e-13)
    triangle, tiny = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), 1e-200
    for side in (1.0, -1.0):
        target = np.array([[0.0, 0.0], [-1.0, side * tiny], [0.0, -1.0]])
        found = interpolate(triangle, target, [[0, 1, 2]], 0.5, energy="frobenius")
        assert np.allclose(found, turned(triangle, side * math.pi / 2), rtol=0, atol=1e-15)


def test_turns_of_a_spiral_and_of_pieces() -> None:
    angles = np.linspace(0, 40, 2 * 20)
    triangles = np.array([[k, k + 1, k + 2] for k in range(40)])
    wrapped = np.angle(np.exp(1j * angles))
    assert np.allclose(wrapped + 2 * math.pi * coherent_turns(wrapped, triangles), angles)
    # Two spirals that share a vertex, but no edge, start anew; a lone triangle has no neighbour.
    both = np.concatenate([triangles, triangles + 41])
    twice = coherent_turns(np.concatenate([wrapped, wrapped]), both)
    assert np.array_equal(twice, np.tile(coherent_turns(wrapped, triangles), 2))
    assert coherent_turns(wrapped[:1], triangles[:1]).tolist() == [0.0]


def test_whose_matrix_depends_on_the_time() -> None:
    """Of E^F it does not, for any maps; of E^R and E^S it does, unless all maps are similarities."""
    target = bent(STRIP, 1.0)
    for shape, similar in ((target, False), (turned(STRIP, 1.0, 2.0), True)):
        doubled = twice_areas(STRIP, STRIP_TRIANGLES), twice_areas(shape, STRIP_TRIANGLES)
        known = homotopies(STRIP, shape, STRIP_TRIANGLES, doubled, "exponential", coherent=False)
        for direct, by_points in ((1.0, False), (0.0, False), (0.0, True)):
            weights = widen(np.tile([direct, 1 - direct], (len(STRIP_TRIANGLES), 1)))
            errors = Errors(STRIP, STRIP_TRIANGLES, weights, by_points)
            start, end = (errors.blocks(known.at(time)) for time in (0.25 * ONE, 0.75 * ONE))
            assert np.allclose(start, end, rtol=0, atol=1e-13 * np.abs(start).max()) == (direct == 1.0 or similar)


def test_neither_threads_nor_company_change_a_bit() -> None:
    source, target, times = STRIP, bent(STRIP, 2.0), np.linspace(-0.5, 1.5, 6)
    for energy in ENERGIES:
        alone = interpolate(source, target, STRIP_TRIANGLES, times, energy=energy, workers=1)
        shared = interpolate(source, target, STRIP_TRIANGLES, times.reshape(2, 3), energy=energy, workers=3)
        assert np.array_equal(shared, alone.reshape(2, 3, *source.shape))
        assert np.array_equal(interpolate(source, target, STRIP_TRIANGLES, times[2], energy=energy), alone[2])
        assert interpolate(source, target, STRIP_TRIANGLES, np.empty((0, 2)), energy=energy).shape == (
            0,
            2,
            *source.shape,
        )


def test_scale_and_place_do_not_matter() -> None:
    """Shapes 2^200 times as large or as small, or 1e9 away, move alike; so do clockwise triangles."""
    source, target = STRIP + 0.125, bent(STRIP, 2.0)
    masses = np.full(len(STRIP_TRIANGLES), 0.5)
    for energy, weights in itertools.product(ENERGIES, (None, masses)):
        options: dict[str, Any] = {"energy": energy, "weights": weights}
        held = (Locus(0, source[0]), Locus(62, target[62], 2.0), Edge(3, 40, source[40] - source[3], 0.5))
        plain = interpolate(source, target, STRIP_TRIANGLES, 0.4, constraints=held, **options)
        for exponent in (-200, 200):
            # Terms of E^F and E^R have no unit of length, unless it comes with the areas.
            factor = 1.0 if weights is None or energy == "points" else 2.0 ** (-2 * exponent)
            if weights is None and energy == "points":
                factor = 2.0 ** (2 * exponent)
            scaled = tuple(
                type(each)(
                    **{**vars(each), "path": np.ldexp(np.asarray(each.path), exponent), "weight": factor * each.weight}
                )
                for each in held
            )
            shapes = np.ldexp(source, exponent), np.ldexp(target, exponent)
            found = interpolate(*shapes, STRIP_TRIANGLES, 0.4, constraints=scaled, **options)
            assert np.array_equal(np.ldexp(found, -exponent), plain)
        mirrored = tuple(type(each)(**{**vars(each), "path": np.asarray(each.path) * [1, -1]}) for each in held)
        flipped = (source * [1, -1], target * [1, -1], STRIP_TRIANGLES)
        assert np.abs(interpolate(*flipped, 0.4, constraints=mirrored, **options) * [1, -1] - plain).max() <= 1e-14
    far = 1e9 + np.round(STRIP * 1024) / 1024
    moved = interpolate(far, far @ np.array([[0.0, 1.0], [-1.0, 0.0]]), STRIP_TRIANGLES, 0.5, energy="similarity")
    assert np.abs(moved - moved[0] - turned(STRIP, math.pi / 4)).max() <= 2e-7


def test_every_vertex_may_be_held() -> None:
    held = [Locus(k, place) for k, place in enumerate(STRIP)]
    target = bent(STRIP, 1.0)
    for energy in ENERGIES:
        found = interpolate(STRIP, target, STRIP_TRIANGLES, 0.5, energy=energy, constraints=held)
        assert np.array_equal(found, STRIP)


HINGE = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])


def test_what_is_hinged_at_a_vertex_needs_its_angles() -> None:
    """Two triangles that share a vertex only: for E^R the other one may take any size and angle."""
    triangles = np.array([[0, 1, 2], [0, 3, 4]])
    for options in ({}, {"energy": "points"}, {"balance": np.array([1.0, 0.0])}):
        with pytest.raises(InputError, match=r"^triangles: pieces that hang together by vertices only"):
            interpolate(HINGE, HINGE, triangles, 0.5, **options)
    for options in ({"energy": "frobenius"}, {"balance": np.array([1.0, 0.5])}):
        assert np.allclose(interpolate(HINGE, HINGE, triangles, 0.5, **options), HINGE)


def refusal(**changes: Any) -> str:
    arguments: dict[str, Any] = {"source": STRIP, "target": STRIP, "triangles": STRIP_TRIANGLES, "t": [0.5, 0.75]}
    with pytest.raises(InputError) as caught:
        interpolate(**arguments | changes)
    return str(caught.value)


def changed(index: Any, value: Any) -> Array:
    shape = STRIP.copy()
    shape[index] = value
    return shape


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"source": STRIP[None]}, "source: shape (1, 63, 2) where (vertices, 2) is due"),
        ({"target": STRIP[:5]}, "target: shape (5, 2) where (..., 63, 2) is due"),
        ({"source": changed(3, np.nan)}, "source: not finite"),
        ({"triangles": STRIP_TRIANGLES * 1j}, "triangles: dtype complex128 where whole numbers are due"),
        ({"triangles": STRIP_TRIANGLES[0]}, "triangles: shape (3,) where (faces, 3) is due"),
        ({"triangles": STRIP_TRIANGLES - 1}, "triangles: not triples of different vertices"),
        ({"triangles": STRIP_TRIANGLES * 2}, "triangles: not triples of different vertices"),
        ({"triangles": STRIP_TRIANGLES * 1e300}, "triangles: not triples of different vertices"),
        ({"triangles": STRIP_TRIANGLES * math.nan}, "triangles: not triples of different vertices"),
        ({"triangles": STRIP_TRIANGLES + 0.5}, "triangles: not triples of different vertices"),
        ({"triangles": STRIP_TRIANGLES[:, [0, 1, 1]]}, "triangles: not triples of different vertices"),
        ({"triangles": np.delete(STRIP_TRIANGLES, [0, 40], axis=0)}, "triangles: not one piece with all vertices"),
        ({"source": changed(0, STRIP[1])}, "source: a triangle without area"),
        ({"source": changed(0, [2.0, 2.0]), "t": 0.0}, "target: a triangle without area, or turned over"),
        ({"target": STRIP * [1, -1]}, "target: a triangle without area, or turned over"),
        ({"energy": "rigid"}, "energy: 'rigid' where one of 'frobenius', 'similarity', 'points' is due"),
        ({"homotopy": "sam"}, "homotopy: 'sam' where one of 'linear', 'polar', 'exponential' is due"),
        ({"angles": "any"}, "angles: 'any' where one of 'principal', 'coherent' is due"),
        ({"weights": np.ones(3)}, "weights: shape (3,) where (80,) is due"),
        ({"weights": np.zeros(80)}, "weights: not positive and finite"),
        ({"balance": np.ones(3)}, "balance: shape (3,) where () or (80,) is due"),
        ({"balance": 1.5}, "balance: not in [0, 1]"),
        ({"balance": 0.5, "energy": "points"}, "balance: given for 'points'"),
        ({"constraints": []}, "constraints: one of them must be a Locus or a Barycentre"),
        ({"constraints": [Edge(0, 1, lambda t: (t, t))]}, "constraints: one of them must be a Locus or a Barycentre"),
        ({"constraints": [Locus(0, (0.0, 0.0))]}, "constraints: a path of shape (2,) where (2, 2) is due"),
        (
            {"energy": "frobenius", "constraints": [Locus(0, lambda t: t)]},
            "constraints: 0.5 on a path, where a point of the plane is due",
        ),
        (
            {"energy": "frobenius", "constraints": [Locus(0, lambda t: (t, math.nan))]},
            "constraints: (0.5, nan) on a path",
        ),
        ({"constraints": [Locus(63, lambda t: (t, t))]}, "constraints: no vertex has the index 63"),
        ({"constraints": [Edge(0, -1, lambda t: (t, t))]}, "constraints: no vertex has the index -1"),
        ({"constraints": [Locus(0, lambda t: (t, t), 0.0)]}, "constraints: a weight of 0.0"),
        ({"constraints": [Barycentre(lambda t: (t, t), math.inf)]}, "constraints: a weight of inf"),
        ({"constraints": [Locus(0, lambda t: (t, t))] * 2}, "constraints: a vertex is exactly in two places"),
        ({"constraints": [Locus(0, lambda t: (t, t))]}, "constraints: they must give two vertices"),
    ],
)
def test_refusals(changes: dict[str, Any], message: str) -> None:
    assert refusal(**changes).startswith(message)


def test_one_place_is_enough_where_e_f_has_a_share() -> None:
    held = [Locus(0, lambda t: (0.0, 0.0))]
    for balance in (1.0, np.linspace(0, 1, 80)):
        found = interpolate(STRIP, turned(STRIP, 1.0), STRIP_TRIANGLES, 0.5, balance=balance, constraints=held)
        assert np.allclose(found, turned(STRIP, 0.5))
