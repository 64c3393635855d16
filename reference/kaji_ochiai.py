"""The twelve parameters of an affine map of space: translation, rotation vector and logarithm of the stretch.

Kaji and Ochiai, A concise parametrisation of affine transformation. Parameters are (l1, l2, l3, x1, x2, x3, y11, y12,
y13, y22, y23, y33): phi is the translation by l after exp([x]) exp(Y), psi its inverse by polar factors. Psi has many
values, one for each logarithm of the rotation; the principal one is meant unless another is asked for.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np

from affinecert.reference import _domain, so3
from affinecert.reference._functions import exponential, logarithm, power
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity, norm
from affinecert.reference._natural_spline import natural_spline, require_knots
from affinecert.reference._precision import span
from affinecert.reference._spectrum import exactly, extra_bits
from affinecert.reference._spectrum import interpolate as matrix_functions
from affinecert.reference.polar import gram
from affinecert.reference.sym3 import of_symmetric

UPPER = ([0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2])
"""Where the last six parameters stand in Y: its upper half, row by row."""

# Angles above this, within 0.14 of pi, are near enough to it to be continued beyond; and a rotation vector that is
# nearest to a given one by less than 1 is near enough to a tie.
NEAR_PI, NEAR_TIE = 3, 1


def parametrise(ctx: Context, affine: Array) -> Array:
    """The parameters psi(A) with the principal rotation vector, as `so3.log`, (4, 4) -> (12,).

    S = sqrt(L^T L), [x] = log(L S^-1), Y = log S (equation 3). Raises InputError if the last row is not 0 0 0 1 or the
    determinant is not positive.
    """
    return next(_determinations(ctx, "affine", affine))


def continue_parametrise(ctx: Context, base: Array, affine: Array) -> Array:
    """`parametrise` with the rotation vector nearest to that of the parameters ``base``: continued through angle pi."""
    return _near(ctx, "affine", affine, base)


def parametrise_near(ctx: Context, affine: Array, near: Array) -> Array:
    """The parameters psi(A) with the rotation vector nearest to that of other parameters, (4, 4), (12,) -> (12,).

    Algorithm 1; ties and the identity as `so3.log_near`. Translation and stretch of ``near`` do not count. Raises
    InputError as `parametrise` does.
    """
    _domain.finite(ctx, "near", near)
    with ctx.extraprec(2 * span(near[3:6])):
        return _near(ctx, "affine", affine, near)


def continue_parametrise_near(ctx: Context, base: Array, affine: Array, near: Array) -> Array:
    """`parametrise_near`, continued: as `so3.continue_log_near`."""
    angle = _logarithms(ctx, "affine", affine)[1]
    if angle == 0 and any(near[3:6]):
        continued = base.copy()
        continued[3:6] = near[3:6] * (norm(ctx, base[3:6]) / norm(ctx, near[3:6]))
        return continued
    return _near(ctx, "affine", affine, base)


def realise(ctx: Context, parameters: Array) -> Array:
    """The affine map phi(l, x, y) = [exp([x]) exp(Y), l], (12,) -> (4, 4). Equation 2."""
    _domain.finite(ctx, "parameters", parameters)
    return _realised(ctx, ctx.prec, tuple(parameters))


def blend(ctx: Context, affines: Array, weights: Array, near: Array | None = None) -> Array:
    """The affine map phi(sum of w_i psi(A_i)), (count, 4, 4), (count,) -> (4, 4). Equation 9.

    Weights are any numbers. Given ``near``, of the logarithms next to angle pi those that bring the result nearest to
    it. Raises InputError as `parametrise` does.
    """
    _domain.finite(ctx, "weights", weights)
    poses = [list(_determinations(ctx, "affines", affine)) for affine in affines]
    return _nearest(ctx, near, (realise(ctx, weights @ array(chosen)) for chosen in itertools.product(*poses)))


def interpolate(ctx: Context, poses: Array, knots: Array, t: Array, near: Array | None = None) -> Array:
    """The affine map at t of the natural cubic spline of the parameters, (keys, 4, 4), (keys,), () -> (4, 4).

    Section 5.4. The rotation vector of the first pose is principal, each other the nearest to the one before it.
    Outside of the knots the cubics at the ends go on. Given ``near``, other logarithms where they nearly tie, as in
    `blend`. Raises InputError as `parametrise` does, for fewer than two knots, and for knots that do not increase.
    """
    _domain.finite(ctx, "knots", knots)
    _domain.finite(ctx, "t", t)
    require_knots(knots)
    with ctx.extraprec(2 * span(knots, t)):
        first = _determinations(ctx, "poses", poses[0])
        chains = itertools.chain.from_iterable(_chains(ctx, [start], poses[1:]) for start in first)
        return _nearest(ctx, near, (realise(ctx, natural_spline(knots, chain, t[()])) for chain in chains))


def deform(ctx: Context, points: Array, probes: Array, weights: Array, near: Array | None = None) -> Array:
    """Each point u moved by the blend of the probes with its weights, (points, 3), (probes, 4, 4), (points, probes).

    Section 5.2: u is taken to Blend(w_1(u), ..., w_n(u), A_1, ..., A_n) u, (points, 3). ``near`` and errors as in
    `blend`.
    """
    _domain.finite(ctx, "points", points)
    _domain.finite(ctx, "weights", weights)
    poses = [list(_determinations(ctx, "probes", probe)) for probe in probes]

    def moved(chosen: Sequence[Array]) -> Array:
        maps = [realise(ctx, own @ array(chosen)) for own in weights]
        return array([blended[:3, :3] @ u + blended[:3, 3] for blended, u in zip(maps, points, strict=True)])

    return _nearest(ctx, near, (moved(chosen) for chosen in itertools.product(*poses)))


def continue_blend(ctx: Context, base: Array, affines: Array, weights: Array) -> Array:
    """`blend`, continued through angle pi."""
    return blend(ctx, affines, weights, base)


def continue_interpolate(ctx: Context, base: Array, poses: Array, knots: Array, t: Array) -> Array:
    """`interpolate`, continued through angle pi of the first pose, and through ties of the others."""
    return interpolate(ctx, poses, knots, t, base)


def continue_deform(ctx: Context, base: Array, points: Array, probes: Array, weights: Array) -> Array:
    """`deform`, continued through angle pi."""
    return deform(ctx, points, probes, weights, base)


def _nearest(ctx: Context, near: Array | None, candidates: Iterator[Array]) -> Array:
    """The first candidate; or given ``near``, the one nearest to it."""
    if near is None:
        return next(candidates)
    return min(candidates, key=lambda candidate: norm(ctx, (candidate - near).flat))


def _determinations(ctx: Context, name: str, affine: Array) -> Iterator[Array]:
    """The parameters of an affine map with the principal rotation vector, and near pi with that on the other side."""
    axis, angle, stretch = _logarithms(ctx, name, affine)
    for theta in (angle, angle - 2 * ctx.pi) if angle > NEAR_PI else (angle,):
        yield np.concatenate([affine[:3, 3], axis * theta, stretch])


def _near(ctx: Context, name: str, affine: Array, near: Array) -> Array:
    """The parameters of an affine map with the rotation vector nearest to that of other parameters."""
    axis, angle, stretch = _logarithms(ctx, name, affine)
    return np.concatenate([affine[:3, 3], so3.vector_near(ctx, axis, angle, near[3:6]), stretch])


def _chains(ctx: Context, chain: list[Array], poses: Array) -> Iterator[list[Array]]:
    """The parameters of a sequence of poses, each nearest to those before it; then also with those that nearly tie."""
    if not len(poses):
        yield chain
        return
    parameters = _near(ctx, "poses", poses[0], chain[-1])
    yield from _chains(ctx, [*chain, parameters], poses[1:])
    omega, goal = parameters[3:6], chain[-1][3:6]
    if length := norm(ctx, omega):
        for turns in (1, -1):
            other = omega * (1 + turns * 2 * ctx.pi / length)
            if norm(ctx, other - goal) - norm(ctx, omega - goal) < NEAR_TIE:
                tied = np.concatenate([parameters[:3], other, parameters[6:]])
                yield from _chains(ctx, [*chain, tied], poses[1:])


def _logarithms(ctx: Context, name: str, affine: Array) -> tuple[Array, Number, Array]:
    """The axis and angle of the rotation of an affine map, and the logarithm of its stretch."""
    _domain.affine(ctx, name, affine)
    return _polar_logarithms(ctx, ctx.prec, tuple(affine[:3, :3].flat))


# One pose of several is perturbed at a time when a condition is taken: the others' parameters are kept.
@lru_cache(maxsize=64)
def _polar_logarithms(ctx: Context, precision: int, entries: tuple[Number, ...]) -> tuple[Array, Number, Array]:
    linear = array(entries).reshape(3, 3)
    square, unit = gram(linear), identity(ctx, 3)
    with ctx.workprec(precision + 2 * span(linear) + 2 * extra_bits(square)):
        half = ctx.one / 2
        inverse, log = matrix_functions(ctx, square, (power(ctx, -half), unit), (logarithm(ctx), unit))
        return *so3.axis_angle(ctx, linear @ inverse), (log / 2)[UPPER]


@lru_cache(maxsize=64)
def _realised(ctx: Context, precision: int, parameters: tuple[Number, ...]) -> Array:
    translation, omega, y = (array(part) for part in (parameters[:3], parameters[3:6], parameters[6:]))
    logarithm = np.empty((3, 3), dtype=object)
    logarithm[UPPER] = logarithm.T[UPPER] = y
    with ctx.workprec(precision + 4 * span(omega) + 4 * span(y)):
        stretch = of_symmetric(ctx, exactly(logarithm), exponential(ctx))
        return homogeneous(ctx, so3.exponential_series(ctx, omega, 0) @ stretch, translation)
