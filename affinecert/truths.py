"""Truth: the reference's value of a map at one input, far more exact than float64, and how it answers to its input.

The reference runs at two precisions, and at higher ones until they agree (Ziv's strategy). The sensitivity of an output
block is its condition before the division by the value: how far the block moves per unit of relative perturbation of
the input groups that the catalogue names. It is taken by one-sided differences, with steps far below float64's spacing
and far above the reference's error.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from affinecert.errors import InputError, PrecisionError
from affinecert.map import Array, Group, Map

Numbers = NDArray[np.object_]  # mpf of one context

# The relative steps of the differences are 2**-step: two float64 spacings squared, so that what curvature adds is as
# small against the derivative; finer where the value turns faster than that (the sine of 1e150 radians, the verge of a
# singularity), which shows by a change over the step of more than 2**-RESOLVED of the value.
STEPS = (106, 318, 954)
RESOLVED = 20
# Two precisions, BASE and half as much again, must agree to 24 bits below the step, which a difference quotient then
# keeps. BASE leaves the reference 190 bits to lose; where it loses more, it is doubled, up to MOST.
SPARE = 24
BASE = 320
MOST = 32 * BASE
# A value alone is as good as certain if two precisions agree to so many bits: more than a pair of float64 holds.
VALUE = 128
# Below the smallest normal float64, 2**FLOOR, agreement is absolute.
FLOOR = -1022
# Pairs of changes by which a jump beside an input is looked for.
SWAYS = 2
# Where such changes leave the domain, as those of float32 leave the matrices within 1e-6 of a rotation, shorter ones
# are tried: a bound of 16 u comes down to u / 4, which still crosses what a rounding decides.
NEARER = (1.0, 0.125, 2.0**-6)
# A logarithm that changes by more than 2**-JUMP of itself over one step has jumped to another branch, or is as
# sensitive as if it had; then it is continued instead.
JUMP = 40


@dataclass(frozen=True)
class Truth:
    """The value of a map at one input, ``high + low`` for each output, and the sensitivity of each block.

    ``high`` is the float64 nearest to the value, ``low`` the one nearest to the rest. ``sensitivity`` sums, over the
    input groups, the absolute sensitivity of a block: for a group perturbed by its norm, the spectral norm of the
    block's Jacobian times the norm of the group; for one perturbed by entries, the lengths of the Jacobian's columns
    times the sizes of the entries. ``refusal`` is the reference's reason outside the domain; the rest is empty then.
    """

    high: tuple[Array, ...]
    low: tuple[Array, ...]
    sensitivity: tuple[float, ...]
    refusal: str | None


def compute(map: Map, inputs: tuple[Array, ...]) -> Truth:
    """The truth of a map at one input: its arguments as float64 arrays, without a batch axis."""
    ctx = _context()
    at = _Input(ctx, map, tuple(_numbers(ctx, x) for x in inputs))
    try:
        value, sensitivity = _exactly(at) if map.exact else _resolved(at)
    except InputError as error:
        return Truth((), (), (), error.reason)
    high, low = _halved(ctx, value)
    return Truth(high, low, tuple(min(float(k), sys.float_info.max) for k in sensitivity), None)


def value(map: Map, inputs: tuple[Array, ...]) -> Truth:
    """The truth of a map at one input without the sensitivities, which take most of the time to compute."""
    ctx = _context()
    at = _Input(ctx, map, tuple(_numbers(ctx, x) for x in inputs))
    try:
        ctx.prec = BASE + BASE // 2
        fine = None if map.exact else at.outputs()
        ctx.prec = BASE
        coarse = None if map.exact else at.outputs()
    except InputError as error:
        return Truth((), (), (), error.reason)
    if (
        fine is None
        or coarse is None
        or any(
            _norm(ctx, np.ravel(f - c)) > ctx.ldexp(_norm(ctx, np.ravel(f)), -VALUE)
            for f, c in zip(fine, coarse, strict=True)
        )
    ):
        return replace(compute(map, inputs), sensitivity=())
    return Truth(*_halved(ctx, fine), (), None)


def principal(map: Map, inputs: tuple[Array, ...], outputs: tuple[Array, ...]) -> bool:
    """Whether the value itself is the determination nearest to the outputs, which are then inaccurate and no other."""
    ctx = _context()
    ctx.prec = BASE
    at = _Input(ctx, map, tuple(_numbers(ctx, x) for x in inputs))
    near = at.outputs_near(tuple(_numbers(ctx, output) for output in outputs))
    return all(_norm(ctx, n - v) <= ctx.ldexp(_norm(ctx, v), -JUMP) for n, v in zip(near, at.outputs(), strict=True))


def across(map: Map, inputs: tuple[Array, ...], truth: Truth, reach: float) -> Iterator[Truth]:
    """The values at an input beyond a jump that changes of the input by ``reach``, relative to its groups, cross.

    There the choice between determinations is that of a rounding: at a half turn the way to turn, where quaternions are
    orthogonal the sign of one. None for a map that does not jump, or where no jump is so near.
    """
    if map.continuation is None:
        return
    ctx = _context()
    ctx.prec = BASE
    at = _Input(ctx, map, tuple(_numbers(ctx, x) for x in inputs))
    for shorter in NEARER:
        refused = False
        for moved in _swayed(at, reach * shorter):
            try:
                outputs = at.outputs_on(moved.outputs())
            except InputError:
                refused = True
                continue
            high, low = _halved(ctx, outputs)
            if any(np.any(there != here) for there, here in zip(high, truth.high, strict=True)):
                yield Truth(high, low, truth.sensitivity, None)
        if not refused:
            return


@cache
def _context() -> Any:
    """A context of our own, made once: making one takes as long as the truth of a cheap map."""
    return mpmath.MPContext()


@dataclass(frozen=True)
class _Input:
    """A map and its input in numbers of a context, whose precision holds for what is computed next."""

    ctx: Any
    map: Map
    arguments: tuple[Numbers, ...]

    def outputs(self) -> tuple[Numbers, ...]:
        """What the reference returns."""
        return self._outputs(self.map.reference(self.ctx, *self.arguments))

    def outputs_near(self, base: tuple[Numbers, ...]) -> tuple[Numbers, ...]:
        """What the reference returns, on the branch of the outputs ``base`` at an input close by."""
        value = self.outputs()
        if self.map.continuation is None or all(
            _norm(self.ctx, v - b) <= self.ctx.ldexp(_norm(self.ctx, b), -JUMP)
            for v, b in zip(value, base, strict=True)
        ):
            return value
        return self.outputs_on(base)

    def outputs_on(self, base: tuple[Numbers, ...]) -> tuple[Numbers, ...]:
        """The values on the branch of the outputs ``base``, for a map that has branches."""
        assert self.map.continuation is not None
        return self._outputs(self.map.continuation(self.ctx, base if len(base) > 1 else base[0], *self.arguments))

    def moved(self, argument: int, place: int, change: Any) -> _Input:
        """The input with one entry of one argument changed."""
        entries = self.arguments[argument].copy()
        entries.flat[place] += change
        return replace(self, arguments=(*self.arguments[:argument], entries, *self.arguments[argument + 1 :]))

    def blocks(self, outputs: tuple[Numbers, ...]) -> list[Numbers]:
        """The entries of each block of the outputs, as a vector."""
        return [np.ravel(outputs[block.output][block.where]) for block in self.map.blocks]

    def _outputs(self, result: Any) -> tuple[Numbers, ...]:
        return result if isinstance(result, tuple) else (result,)


def _exactly(at: _Input) -> tuple[tuple[Numbers, ...], list[Any]]:
    """The answers of a predicate as 1 or 0; no perturbation is small against them."""
    at.ctx.prec = BASE
    return tuple(np.array(at.ctx.mpf(int(x)), dtype=object) for x in at.outputs()), [at.ctx.zero] * len(at.map.blocks)


def image(map: Map, truth: Truth) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
    """Where ``map`` takes the value that a truth of another map holds, as the high and the low parts of each output."""
    ctx = _context()
    ctx.prec = BASE
    halves = zip(truth.high, truth.low, strict=True)
    held = (np.asarray(_numbers(ctx, high) + _numbers(ctx, low), dtype=object) for high, low in halves)
    return _halved(ctx, _Input(ctx, map, tuple(held)).outputs())


def _halved(ctx: Any, value: tuple[Numbers, ...]) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
    """Each output as the nearest float64, and the nearest float64 to the rest."""
    high = tuple(_floats(x) for x in value)
    return high, tuple(_floats(_rest(ctx, x, h)) for x, h in zip(value, high, strict=True))


def _resolved(at: _Input) -> tuple[tuple[Numbers, ...], list[Any]]:
    """The outputs and the sensitivities of the blocks, these with steps fine enough for the input."""
    for step in STEPS:
        value, sensitivities = _agreed(at, step)
        limits = [at.ctx.ldexp(_norm(at.ctx, block), step - RESOLVED) for block in at.blocks(value)]
        if all(k <= limit or not limit for k, limit in zip(sensitivities, limits, strict=True)):
            break
    return value, sensitivities


def _agreed(at: _Input, step: int) -> tuple[tuple[Numbers, ...], list[Any]]:
    """The outputs at the first precision that a higher one confirms, and the sensitivities taken with one step."""
    ctx = at.ctx
    precision = BASE + step - STEPS[0]
    while precision <= MOST:
        ctx.prec = precision + precision // 2
        fine = at.outputs()
        ctx.prec = precision
        coarse = at.outputs()
        errors = [_norm(ctx, f - c) for f, c in zip(at.blocks(fine), at.blocks(coarse), strict=True)]
        sensitivities = _sensitivities(at, coarse, step)
        # A value that cancels, down to nothing perhaps, is measured against what it is made of.
        sizes = [_norm(ctx, f) + k for f, k in zip(at.blocks(fine), sensitivities, strict=True)]
        floor = ctx.ldexp(ctx.one, FLOOR)
        if all(e <= ctx.ldexp(s + floor, -step - SPARE) for e, s in zip(errors, sizes, strict=True)):
            return fine, sensitivities
        precision *= 2
    raise PrecisionError(f"{at.map.name}: two precisions do not agree even at {MOST} bits")


def _sensitivities(at: _Input, base: tuple[Numbers, ...], step: int) -> list[Any]:
    """The sensitivity of each block, summed over the groups of each argument."""
    total = [at.ctx.zero] * len(at.map.blocks)
    for number, argument in enumerate(at.map.arguments):
        for group in argument.groups:
            columns = list(_columns(at, number, group, base, step))
            for b in range(len(total)):
                total[b] += _size(at.ctx, [column[b] for column in columns], group)
    return total


def _columns(at: _Input, argument: int, group: Group, base: tuple[Numbers, ...], step: int) -> Iterator[list[Numbers]]:
    """For each entry of a group the derivative of every block, times the norm of the group or the entry's own size.

    An entry is moved down where moving it up leaves the domain, and left out where both do.
    """
    ctx, entries, before = at.ctx, at.arguments[argument], at.blocks(base)
    places = np.arange(entries.size).reshape(entries.shape)[group.where].ravel()
    whole = _norm(ctx, entries.flat[places])
    for place in places:
        size = whole if group.mode == "norm" else abs(entries.flat[place])
        if not size:
            continue
        step_up = ctx.ldexp(ctx.one, ctx.mag(size) - step)  # a power of two keeps the perturbed input short
        for change in (step_up, -step_up):
            try:
                after = at.moved(argument, place, change).outputs_near(base)
            except InputError:
                continue
            yield [(a - b) * (size / change) for a, b in zip(at.blocks(after), before, strict=True)]
            break


def _swayed(at: _Input, reach: float) -> Iterator[_Input]:
    """The input with all entries changed at once, this way and that.

    In pairs of opposites, one of which passes a jump; of drawn signs, always the same, lest they keep a symmetry.
    """
    signs = np.random.default_rng(0)
    for _ in range(SWAYS):
        draws = [signs.choice((-1, 1), size=argument.shape) for argument in at.arguments]
        for way in (1, -1):
            swayed = []
            for argument, entries, drawn in zip(at.map.arguments, at.arguments, draws, strict=True):
                changed = entries.copy()
                for group in argument.groups:
                    part = entries[group.where]
                    size = _norm(at.ctx, part) if group.mode == "norm" else abs(part)
                    changed[group.where] = part + way * drawn[group.where] * (size * reach)
                swayed.append(changed)
            yield replace(at, arguments=tuple(swayed))


def _size(ctx: Any, columns: Sequence[Numbers], group: Group) -> Any:
    """What a group adds to the sensitivity: the spectral norm of its columns together, or the sum of their lengths."""
    if group.mode == "entries":
        return sum((_norm(ctx, column) for column in columns), ctx.zero)
    largest = max((abs(x) for column in columns for x in column), default=ctx.zero)
    if not largest:
        return ctx.zero
    # Scaled to entries of at most 1: as they are they may be beyond float64.
    scaled = np.array([[float(x / largest) for x in column] for column in columns])
    return largest * float(np.linalg.norm(scaled, 2))


def _norm(ctx: Any, numbers: Numbers) -> Any:
    return ctx.sqrt(ctx.fsum(np.ravel(numbers), squared=True))


def _numbers(ctx: Any, values: Array) -> Numbers:
    return np.array([ctx.mpf(x) for x in np.ravel(values).tolist()], dtype=object).reshape(np.shape(values))


def _floats(numbers: Numbers) -> Array:
    """The nearest float64."""
    return np.array([float(x) for x in numbers.flat], dtype=np.float64).reshape(numbers.shape)


def _rest(ctx: Any, value: Numbers, high: Array) -> Numbers:
    """What ``high`` leaves of the value; nothing where the value is beyond float64."""
    rest: Numbers = np.where(np.isfinite(high), value - _numbers(ctx, np.nan_to_num(high)), ctx.zero)
    return rest
