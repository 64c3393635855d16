"""The twelve parameters in float64: exact decisions at pi, splines, and the ends of the range.

The errors in every regime are held in `test_fast_accuracy`, what all functions promise of batches in
`test_fast_kernels`.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from affinecert.case import generate
from affinecert.catalogue import find, stretches
from affinecert.draw import UniformDraw
from affinecert.errors import InputError
from affinecert.fast import kaji_ochiai, so3
from affinecert.fast._exact import half_turn
from affinecert.fast._natural_spline import natural_spline_weights
from affinecert.sampling import half_turns


def drawn(name: str, regime: str, count: int) -> list[tuple[np.ndarray[Any, Any], ...]]:
    entry = find(name)
    (chosen,) = (candidate for candidate in entry.regimes if candidate.name == regime)
    return [case.inputs for case in generate(entry, chosen, count)]


def uniform(seed: int) -> UniformDraw:
    return UniformDraw(iter(np.random.default_rng(seed).random, None))


@pytest.mark.parametrize(
    "kind", [stretches.GENERIC, stretches.ILL_CONDITIONED, stretches.LAST_BITS], ids=lambda kind: kind.name
)
def test_half_turns_are_told_exactly_however_ill_conditioned(kind: stretches.Stretches) -> None:
    for seed, turn in enumerate(half_turns()):
        affine = np.eye(4)
        affine[:3, :3] = turn @ kind.build(uniform(seed))[0]
        omega = kaji_ochiai.parametrise(affine)[3:6]
        axis = omega / np.pi
        assert half_turn(affine[:3, :3], axis) == (np.diag(turn) == -1).tolist()
        assert np.allclose(2 * np.outer(axis, axis) - np.eye(3), turn, atol=1e-12)
        assert omega[np.flatnonzero(omega)[0]] > 0


HALF_TURNS: list[tuple[Any, bool]] = [
    (np.diag([-1.0, -2, 3]), True),
    ([[-1.0, 0.5, 0], [0.5, -2, 0], [0, 0, 3]], True),
    # The skew part turns about the axis itself.
    ([[-1.0, 1e-300, 0], [0, -2, 0], [0, 0, 3]], False),
    ([[-1.0, 1e-20, 0], [-1e-20, -1, 0], [0, 0, 1]], False),
    # A stretch of other axes before the half turn: the skew part is across the axis, and then as much as 2^-52 off it.
    ([[-2.0, 1, 0], [1, -3, -0.5], [0, 0.5, 1]], True),
    ([[-2.0, 1, 0], [1, -3, -0.5], [0, 0.5 + 2.0**-53, 1]], False),
    ([[-2.0, 1, 0], [1 + 2.0**-52, -3, -0.5], [0, 0.5, 1]], False),
]


@pytest.mark.parametrize(("linear", "half"), HALF_TURNS)
def test_half_turns_and_what_is_next_to_them(linear: Any, half: bool) -> None:
    assert half_turn(np.array(linear), np.array([0.0, 0.0, 1.0])) == ([True, True, False] if half else None)


@pytest.mark.parametrize("count", [2, 3, 4, 7])
def test_weights_of_the_natural_spline_are_exact_at_knots_and_sum_to_one(count: int) -> None:
    draw = np.random.default_rng(count)
    knots = np.cumsum(draw.uniform(0.1, 2.0, count))
    for i, knot in enumerate(knots):
        weights = natural_spline_weights(knots, knot)[0]
        assert np.array_equal(weights[:, 0], np.eye(count)[i])
        assert not weights[:, 1].any()
    values = draw.normal(size=(count, 2))
    known = CubicSpline(knots, values, bc_type="natural")
    for t in draw.uniform(knots[0] - 1, knots[-1] + 1, 5):
        weights = natural_spline_weights(knots, t)[0]
        assert np.allclose(weights[:, 0] @ values, known(t), rtol=1e-12, atol=1e-12)
        exact = [Fraction(high) + Fraction(low) for high, low in weights.tolist()]
        assert abs(sum(exact, Fraction(-1))) < Fraction(1, 2**95)
        # A straight line is its own spline.
        line = [w * Fraction(x) for w, x in zip(exact, knots.tolist(), strict=True)]
        assert abs(sum(line, -Fraction(float(t)))) < Fraction(1, 2**90)


def test_an_interpolation_passes_the_poses() -> None:
    for poses, knots, _ in drawn("kaji_ochiai.interpolate", "generic", 6):
        assert np.array_equal(kaji_ochiai.interpolate(poses, knots, knots), poses)


def test_motions_of_several_turns_come_back_as_such() -> None:
    parameters = np.zeros(12)
    parameters[3:6] = [0.0, 17.0, 1.0]
    affine = kaji_ochiai.realise(parameters)
    assert np.linalg.norm(kaji_ochiai.parametrise(affine)[3:6]) < np.pi
    assert np.allclose(kaji_ochiai.parametrise_near(affine, parameters), parameters, atol=1e-14)


def test_beyond_the_range() -> None:
    parameters = np.zeros(12)
    parameters[[6, 9, 11]] = [800.0, -800.0, 0.0]
    parameters[3] = 0.5
    affine = kaji_ochiai.realise(parameters)
    assert np.array_equal(affine[:, 0], [np.inf, 0.0, 0.0, 0.0])
    assert not affine[:3, 1].any()
    assert np.allclose(affine[:3, 2], so3.exp([0.5, 0.0, 0.0])[:, 2])
    # A turn that is not known to a radian is still a turn.
    parameters[3:6], parameters[6:] = 1e300, 0.0
    rotation = kaji_ochiai.realise(parameters)[:3, :3]
    assert np.allclose(rotation.T @ rotation, np.eye(3))


def test_the_refused_item_is_named_in_its_own_batch() -> None:
    poses = np.broadcast_to(np.eye(4), (2, 3, 4, 4)).copy()
    poses[1, 2, 0] *= -1
    weights = np.ones((5, 1, 3))
    with pytest.raises(InputError, match=r"^affines\[1\]: the determinant"):
        kaji_ochiai.blend(poses, weights)
    with pytest.raises(InputError, match=r"^probes\[1\]: the determinant"):
        kaji_ochiai.deform(np.zeros((2, 4, 3)), poses, np.zeros((2, 4, 3)))
    with pytest.raises(InputError, match=r"^knots\[1\]: not strictly increasing"):
        kaji_ochiai.interpolate(poses[0], np.array([[0.0, 1, 2], [0, 2, 2]]), [0.5, 0.5])
    with pytest.raises(InputError, match=r"^knots: shape \(1,\): fewer than two"):
        kaji_ochiai.interpolate(poses[0, :1], [0.0], 0.5)
