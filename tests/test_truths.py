"""Truth: values as double-double, sensitivities against calculus, refusals, and the precision it finds by itself."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from affinecert import truths
from affinecert.case import generate
from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError, PrecisionError
from affinecert.map import Argument, Block, Group, Map

from .enclosures import context, numbers


def scalar_map(reference: Callable[..., Any], continuation: Callable[..., Any] | None = None, **changes: Any) -> Map:
    """A map of one number to one number."""
    return Map(
        name="test.map",
        definition="",
        source="",
        domain="",
        arguments=(Argument("x", (), (Group((), "entries"),)),),
        outputs=((),),
        blocks=(Block("y", 0, ()),),
        regimes=(),
        reference=lambda ctx, x: np.array(reference(ctx, x[()]), dtype=object),
        continuation=continuation,
        **changes,
    )


def at(entry: Map, *inputs: Any) -> truths.Truth:
    return truths.compute(entry, tuple(np.asarray(x, dtype=float) for x in inputs))


def test_value_is_nearest_float64_and_the_rest_of_it() -> None:
    found = at(CATALOGUE["scale.exp"], 1.0)
    assert found.high[0] == math.e
    ctx = context()
    assert abs(ctx.mpf(float(found.high[0])) + ctx.mpf(float(found.low[0])) - ctx.e) < ctx.ldexp(ctx.one, -105)
    assert abs(found.low[0]) <= np.spacing(math.e) / 2
    assert found.refusal is None


@pytest.mark.parametrize("x", [1e-300, 1e-5, 1.0, -3.0])
def test_sensitivity_of_a_scalar_is_its_derivative_times_its_size(x: float) -> None:
    assert at(CATALOGUE["scale.exp"], x).sensitivity == pytest.approx([abs(x) * math.exp(x)], rel=1e-6)
    assert at(CATALOGUE["scale.log"], abs(x)).sensitivity == pytest.approx([1.0], rel=1e-6)


@pytest.mark.parametrize("angle", [1e-300, 1e-8, 1.0, math.pi, 6.0, 1e3, 1e20, 1e150])
def test_sensitivity_of_so3_exp(angle: float) -> None:
    """A change of omega along the axis moves R by sqrt 2 times it, one across by less: 2 sin(theta/2) / theta."""
    assert at(CATALOGUE["so3.exp"], [0, 0, angle]).sensitivity == pytest.approx([math.sqrt(2) * angle], rel=1e-6)


def test_sensitivity_of_so3_log_near_pi_is_that_of_the_branch() -> None:
    """The entries of R sum up: two of size sin theta, two of size cos theta, each by half the slope they have."""
    for angle in (1.0, math.pi - 1e-10, math.pi):
        rotation = np.array(
            [[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1.0]]
        )
        (found,) = at(CATALOGUE["so3.log"], rotation).sensitivity
        assert found == pytest.approx(2 * abs(math.sin(angle) * math.cos(angle)), rel=1e-5)


def test_sensitivities_of_shear_blocks() -> None:
    """alpha_1 = a1 (e^a2 - 1) / a2: its own relative change counts once, that of a2 by a2 d/da2."""
    a1, a2, a5 = 1.5, 0.7, -0.4
    found = dict(
        zip(
            (block.name for block in CATALOGUE["shear.exp"].blocks),
            at(CATALOGUE["shear.exp"], [a1, a2, 0, 0, a5]).sensitivity,
            strict=True,
        )
    )
    value = a1 * math.expm1(a2) / a2
    assert found["alpha_1"] == pytest.approx(value + abs(a1 * math.exp(a2) - value), rel=1e-6)
    assert found["alpha_2"] == pytest.approx(a2 * math.exp(a2), rel=1e-6)
    assert found["alpha_5"] == pytest.approx(abs(a5) * math.exp(a5), rel=1e-6)
    assert found["alpha_3"] == found["alpha_4"] == 0


def test_norm_groups_perturb_zeros_and_count_the_worst_direction() -> None:
    """At the identity d log L = dL, whose group has norm sqrt n; and translations follow theirs."""
    for size in (3, 4):
        linear, translation = at(CATALOGUE["sam.log"], np.eye(size)).sensitivity
        assert linear == pytest.approx(math.sqrt(size - 1), rel=1e-6)
        assert translation == 0


def test_directions_that_leave_the_domain_are_skipped() -> None:
    """Next to -I every change of one entry ends the logarithm; only the translation's is left."""
    half_turn = np.diag([-1.0, -1, 1])
    linear, translation = at(CATALOGUE["sam.log"], half_turn).sensitivity
    assert (linear, translation) == (0, 0)
    half_turn[:2, 2] = [3, 4]
    assert at(CATALOGUE["sam.log"], half_turn).sensitivity[1] == pytest.approx(math.pi / 2 * 5, rel=1e-6)


def test_refusals_are_told() -> None:
    found = at(CATALOGUE["scale.log"], -1.0)
    assert found == truths.Truth((), (), (), "not positive")
    assert "not a rotation" in str(at(CATALOGUE["so3.log"], 2 * np.eye(3)).refusal)


def test_predicates_answer_1_or_0() -> None:
    for pair, expected in (([2.0, 3.0], 1.0), ([-2.0, -3.0], 0.0)):
        found = at(CATALOGUE["sam.exists"], np.diag([*pair, 1.0]))
        assert found.high[0] == expected and found.low[0] == 0 and found.sensitivity == (0,)


@pytest.mark.parametrize("bits", [300, 400])
def test_precision_rises_until_what_cancels_is_there(bits: int) -> None:
    """Of x in (x + 2**bits) - 2**bits 320 bits leave little or nothing, and 480 say so."""
    entry = scalar_map(lambda ctx, x: (x + ctx.ldexp(ctx.one, bits)) - ctx.ldexp(ctx.one, bits))
    assert at(entry, 1 / 3).high[0] == 1 / 3


def test_gives_up_where_nothing_agrees() -> None:
    entry = scalar_map(lambda ctx, x: ctx.mpf(ctx.prec))
    with pytest.raises(PrecisionError, match="do not agree"):
        at(entry, 1.0)


def test_jumps_are_continued() -> None:
    """ceil(x) - x is 0 at 1 and nearly 1 a step above it."""

    def sawtooth(ctx: Any, x: Any) -> Any:
        return ctx.ceil(x) - x

    def nearest(ctx: Any, base: Any, x: Any) -> Any:
        return np.array(
            min((sawtooth(ctx, x[()]) + k for k in (-1, 0, 1)), key=lambda y: abs(y - base[()])), dtype=object
        )

    assert at(scalar_map(sawtooth), 1.0).sensitivity[0] > 1e30
    assert at(scalar_map(sawtooth, nearest), 1.0).sensitivity == pytest.approx([1.0], rel=1e-6)


def test_values_beyond_float64_are_infinite_and_sensitivities_finite() -> None:
    found = at(CATALOGUE["scale.exp"], 1000.0)
    assert found.high[0] == math.inf and found.low[0] == 0
    assert math.isfinite(found.sensitivity[0])


def test_errors_other_than_refusals_are_not_swallowed() -> None:
    def reference(ctx: Any, x: Any) -> Any:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        at(scalar_map(reference), 1.0)


MANY_BITS = {"measures.rotation_curve_length": 1500}
"""What stands for 6000 bits in a quadrature, whose nodes grow with the bits."""

SAMPLE = [(entry, regime) for entry in CATALOGUE.values() for regime in entry.regimes]


@pytest.mark.parametrize(("entry", "regime"), SAMPLE, ids=[f"{entry.name}-{regime.name}" for entry, regime in SAMPLE])
def test_references_keep_their_precision_in_every_regime(entry: Map, regime: Any) -> None:
    """What they give at 480 bits is what they give at 6000, to 2**-130 of each block: nothing escapes both."""
    for case in generate(entry, regime, 1):
        results = []
        for bits in (480, MANY_BITS.get(entry.name, 6000)):
            ctx = context(bits)
            try:
                outputs = entry.reference(ctx, *(numbers(ctx, x) for x in case.inputs))
            except InputError as refusal:
                outputs = refusal.reason
            results.append(outputs)
        low, high = results
        if isinstance(low, (str, bool)):
            assert low == high
            continue
        low, high = (x if isinstance(x, tuple) else (x,) for x in (low, high))
        for block in entry.blocks:
            a, b = (np.ravel(x[block.output][block.where]) for x in (low, high))
            error, size = (ctx.sqrt(ctx.fsum(map(ctx.mpf, x), squared=True)) for x in (a - b, b))
            assert error <= ctx.ldexp(size, -130)
