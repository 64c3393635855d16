"""The catalogue: entries that fit together, and regimes that build what they claim, the same bits every time."""

from __future__ import annotations

import importlib
import itertools
import math
import random
import re
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from affinecert.case import generate
from affinecert.catalogue import CATALOGUE, find, matching, spectra, turns
from affinecert.draw import UniformDraw
from affinecert.errors import InputError, UnknownNameError
from affinecert.inputs import check_shapes, extent
from affinecert.map import Array, Map, Point, Regime
from affinecert.reference._existence import Logarithm, logarithm
from affinecert.sampling import oblique

REFUSED = ("outside", "mirrored", "no-logarithm", "no-fixed-point")
"""Regimes of these names lie outside the domain; all others inside."""

COUNT = 5
"""How many there are of what a shape names."""

CORNERS = (0.0, 0.25, 0.5, 0.75, 1 - 2.0**-53)
"""Uniform numbers at which choices, angles and directions become special."""

every_map = pytest.mark.parametrize("entry", CATALOGUE.values(), ids=CATALOGUE)


def uniforms(seed: str, corners: float) -> Iterator[float]:
    """Uniform numbers, that fraction of them at the corners."""
    generator = random.Random(seed)
    while True:
        yield generator.choice(CORNERS) if generator.random() < corners else generator.random()


def points(entry: Map, regime: Regime, count: int) -> Iterator[Point]:
    """Points of a regime, from ordinary and from special draws."""
    for index in range(count):
        yield regime.build(UniformDraw(uniforms(f"{entry.name} {regime.name} {index}", (0.0, 0.3, 0.8)[index % 3])))


def shape(declared: tuple[int | str, ...], n: int) -> tuple[int, ...]:
    return tuple(int(extent(size, {re.split("[+-]", str(size))[0]: COUNT, "n": n, "d": n - 1})) for size in declared)


def whole_numbers(matrix: Array) -> list[list[int]]:
    """The matrix times the least power of two that makes it whole."""
    rows = [[Fraction(x) for x in row] for row in matrix.tolist()]
    denominator = max(x.denominator for row in rows for x in row)
    return [[int(x * denominator) for x in row] for row in rows]


def test_the_catalogue_has_its_maps_in_order() -> None:
    families = [family for family, _ in itertools.groupby(entry.family for entry in CATALOGUE.values())]
    assert families == [
        "so3",
        "se3",
        "scale",
        "shear",
        "sym3",
        "polar",
        "affine_lie",
        "sam",
        "kaji_ochiai",
        "homotopy2",
        "mesh2",
        "mesh3",
    ]
    assert all(name == entry.name for name, entry in CATALOGUE.items())


def test_maps_are_found_by_name_and_by_pattern() -> None:
    assert find("se3.log").name == "se3.log"
    assert [entry.name for entry in matching("se3.*")] == ["se3.exp", "se3.log"]
    assert matching("*") == tuple(CATALOGUE.values())
    with pytest.raises(UnknownNameError, match=r"did you mean se3\.log"):
        find("se3.lgo")
    with pytest.raises(UnknownNameError, match=r"no map is named 'nothing\.\*'"):
        matching("nothing.*")


def test_importing_the_catalogue_is_cheap() -> None:
    script = "import sys, affinecert.catalogue; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True).stdout.split()
    assert not {"numba", "scipy", "matplotlib", "hypothesis"}.intersection(loaded)


@every_map
def test_an_entry_is_complete(entry: Map) -> None:
    assert all((entry.definition, entry.source, entry.domain))
    assert "\n" not in entry.definition + entry.source + entry.domain
    assert entry.inverse is None or entry.inverse in CATALOGUE
    names = [regime.name for regime in entry.regimes]
    assert len(set(names)) == len(names) >= 4
    assert names[0].startswith("generic")


@every_map
def test_reference_and_fast_have_the_map_under_its_name(entry: Map) -> None:
    family, _, function = entry.name.partition(".")
    reference = importlib.import_module(f"affinecert.reference.{family}")
    assert getattr(reference, function) is entry.reference
    assert callable(getattr(importlib.import_module(f"affinecert.fast.{family}"), function))


@every_map
def test_blocks_and_groups_divide_outputs_and_arguments(entry: Map) -> None:
    for n in (3, 4):
        taken = [np.zeros(shape(output, n), dtype=int) for output in entry.outputs]
        for block in entry.blocks:
            taken[block.output][block.where] += 1
        assert all(np.max(count) == 1 for count in taken), "a block of every output, and no entry in two blocks"
        for argument in entry.arguments:
            moved = np.zeros(shape(argument.shape, n), dtype=int)
            for group in argument.groups:
                moved[group.where] += 1
            assert np.max(moved) == bool(argument.groups)
    assert len({block.name for block in entry.blocks}) == len(entry.blocks)


@every_map
def test_regimes_build_finite_inputs_of_the_right_shape(entry: Map) -> None:
    for regime in entry.regimes:
        due = None
        for point in points(entry, regime, 12):
            check_shapes(entry, point.inputs)
            shapes = [array.shape for array in point.inputs]
            due = due or shapes
            assert shapes == due, regime.name
            assert all(array.dtype == np.float64 and np.all(np.isfinite(array)) for array in point.inputs), regime.name
            assert 0 <= point.distance < math.inf, regime.name


@every_map
def test_regimes_build_the_same_bits_again(entry: Map) -> None:
    for regime in entry.regimes:
        once, again = ([case.key for case in generate(entry, regime, 4)] for _ in range(2))
        assert once == again


@every_map
def test_regimes_are_in_the_domain_and_those_outside_are_not(entry: Map) -> None:
    ctx = mpmath.MPContext()
    ctx.prec = 200
    # Where a truth takes long, it is that of several things, each refused for the same reasons as one.
    count = 9 if entry.cost >= 10 else 90
    for regime in entry.regimes:
        outside = regime.name.removesuffix("-2d").removesuffix("-3d") in REFUSED
        for point in points(entry, regime, count):
            assert refuses(ctx, entry, point) == outside, (regime.name, point)


def refuses(ctx: Any, entry: Map, point: Point) -> bool:
    numbers = [np.array([ctx.mpf(x) for x in a.ravel().tolist()] + [None])[:-1].reshape(a.shape) for a in point.inputs]
    try:
        entry.reference(ctx, *numbers)
    except InputError:
        return True
    return False


@pytest.mark.parametrize("size", [2, 3])
def test_an_oblique_frame_keeps_every_bit(size: int) -> None:
    for index in range(50):
        draw = UniformDraw(uniforms(f"oblique {index}", 0.2))
        matrix = np.array([[draw.choice((1.0, -1.5, 2.0**-34, 2.0)) for _ in range(size)] for _ in range(size)])
        traces = [sum(Fraction(x) for x in np.diag(m).tolist()) for m in (matrix, oblique(draw, matrix))]
        assert traces[0] == traces[1]


@pytest.mark.parametrize("size", [2, 3])
@pytest.mark.parametrize(
    ("spectrum", "kinds"),
    [
        (spectra.MINUS_ONE, {Logarithm.HALF_TURN}),
        (spectra.BOUNDARY, {Logarithm.PRINCIPAL}),
        (spectra.NEAR_MINUS_ONE, {Logarithm.PRINCIPAL}),
        (spectra.NEGATIVE_DEFECTIVE, {Logarithm.NONE}),
        (spectra.NO_LOGARITHM, {Logarithm.NONE}),
        (spectra.NEGATIVE_PAIR, {Logarithm.PRINCIPAL, Logarithm.NONE}),
        (spectra.LAST_BITS, {Logarithm.PRINCIPAL, Logarithm.NONE}),
    ],
    ids=lambda value: value.name if isinstance(value, spectra.Spectrum) else "",
)
def test_spectra_are_on_the_side_of_the_border_they_claim(
    spectrum: spectra.Spectrum, kinds: set[Logarithm], size: int
) -> None:
    found = set()
    for index in range(200):
        linear, _ = spectrum.build(UniformDraw(uniforms(f"{spectrum.name} {index}", 0.0)), size)
        found.add(logarithm(whole_numbers(linear)))
    assert found - {Logarithm.HALF_TURN} == kinds - {Logarithm.HALF_TURN}
    assert Logarithm.HALF_TURN in found or Logarithm.HALF_TURN not in kinds


@pytest.mark.parametrize("kind", [turns.AT_PI, turns.ONE_TINY_COMPONENT_AT_PI, turns.COORDINATE_AXIS_AT_PI])
def test_half_turns_are_exactly_symmetric(kind: turns.Turns) -> None:
    for index in range(50):
        matrix = kind.build(UniformDraw(uniforms(f"half turn {index}", 0.2))).matrix
        assert np.array_equal(matrix, matrix.T)


def test_a_morph_between_exact_ends_keeps_the_spectrum_of_its_regime() -> None:
    regime = next(regime for regime in find("sam.morph").regimes if regime.name == "minus-identity-3d")
    for index in range(50):
        start, end, _ = regime.build(UniformDraw(uniforms(f"morph {index}", 0.2))).inputs
        quotient = end[:3, :3] @ np.linalg.inv(start[:3, :3])
        assert logarithm(whole_numbers(quotient)) is Logarithm.HALF_TURN
