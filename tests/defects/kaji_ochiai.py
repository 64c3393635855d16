"""The twelve parameters: formulas that fail at pi or near singular maps, wrong orders of factors, other averages."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from scipy.interpolate import CubicSpline

from affinecert.fast import kaji_ochiai, polar, so3, sym3
from affinecert.scoring import Verdict

from .defect import Array, block, column, homogeneous, parts, seeded, skew, times, unskew
from .sym3 import by_eigenvectors

UPPER = np.triu_indices(3)


def symmetric(parameters: Array) -> Array:
    """The symmetric matrices (N, 3, 3) that the last six parameters tell."""
    matrix = np.zeros((len(parameters), 3, 3))
    matrix[:, *UPPER] = matrix[:, *UPPER[::-1]] = parameters[:, 6:]
    return matrix


def rotated(affine: Array, rotation_vector: Callable[[Array], Array]) -> Array:
    """The parameters with another logarithm of the rotation."""
    parameters = kaji_ochiai.parametrise(affine)
    parameters[:, 3:6] = rotation_vector(polar.decompose(parts(affine)[0]).rotation)
    return parameters


@seeded("kaji_ochiai.parametrise", "near-pi", Verdict.DEGRADED)
def arccosine_of_the_trace(affine: Array) -> Array:
    """log R = θ / (2 sin θ) (R - Rᵀ), θ from the trace: equation 8 as it stands."""

    def logarithm(rotation: Array) -> Array:
        angle = np.arccos(np.clip((np.trace(rotation, axis1=-2, axis2=-1) - 1) / 2, -1.0, 1.0))
        return column(np.where(angle > 0, 1 / np.sinc(angle / np.pi), 1.0)) * unskew(rotation)

    return rotated(affine, logarithm)


@seeded("kaji_ochiai.parametrise", "nearly-singular", Verdict.DEGRADED)
def logarithm_of_the_square(affine: Array) -> Array:
    """log S = log(LᵀL)/2, LᵀL being formed: equation 7 as it stands."""
    parameters = kaji_ochiai.parametrise(affine)
    linear, _ = parts(affine)
    square = np.swapaxes(linear, -1, -2) @ linear
    logarithm = by_eigenvectors(square, lambda values: np.log(np.abs(values)) / 2)
    parameters[:, 6:] = logarithm[:, *UPPER]
    return parameters


@seeded("kaji_ochiai.parametrise", "generic")
def stretch_on_the_left(affine: Array) -> Array:
    """The S of L = S R."""
    parameters = kaji_ochiai.parametrise(affine)
    linear, _ = parts(affine)
    rotation, _ = polar.decompose(linear)
    left = linear @ np.swapaxes(rotation, -1, -2)
    parameters[:, 6:] = sym3.log((left + np.swapaxes(left, -1, -2)) / 2)[:, *UPPER]
    return parameters


@seeded("kaji_ochiai.parametrise", "outside")
def last_row_ignored(affine: Array) -> Array:
    """The last row is not looked at."""
    return np.asarray(kaji_ochiai.parametrise(homogeneous(*parts(affine))))


@seeded("kaji_ochiai.parametrise_near", "several-turns")
def turns_forgotten(affine: Array, near: Array) -> Array:
    """The principal logarithm, always."""
    return np.asarray(kaji_ochiai.parametrise(affine))


@seeded("kaji_ochiai.parametrise_near", "several-turns")
def same_number_of_turns(affine: Array, near: Array) -> Array:
    """As many whole turns as the goal has, cut off, on the principal logarithm."""

    def logarithm(rotation: Array) -> Array:
        omega = so3.log(rotation)
        angle = np.linalg.norm(omega, axis=-1)
        axis = omega / column(np.where(angle > 0, angle, 1.0))
        turns = np.trunc(np.sum(axis * near[:, 3:6], axis=-1) / (2 * np.pi))
        return np.asarray(omega + column(2 * np.pi * turns) * axis)

    return rotated(affine, logarithm)


@seeded("kaji_ochiai.realise", "generic")
def stretch_after_the_rotation(parameters: Array) -> Array:
    """exp(Y) exp(X)."""
    linear = sym3.exp(symmetric(parameters)) @ so3.exp(parameters[:, 3:6])
    return homogeneous(linear, parameters[:, :3])


@seeded("kaji_ochiai.realise", "generic")
def one_exponential(parameters: Array) -> Array:
    """exp(X + Y), which is exp(X) exp(Y) where X and Y commute."""
    generator = skew(parameters[:, 3:6]) + symmetric(parameters)
    power, term = np.zeros_like(generator) + np.eye(3), np.zeros_like(generator) + np.eye(3)
    for k in range(1, 60):
        term = term @ generator / k
        power = power + term
    return homogeneous(power, parameters[:, :3])


@seeded("kaji_ochiai.realise", "near-identity")
def second_order_for_small_angles(parameters: Array) -> Array:
    """I + X + X²/2 for angles below 0.01."""
    turn = skew(parameters[:, 3:6])
    small = np.linalg.norm(parameters[:, 3:6], axis=-1) < 0.01
    rotation = np.where(block(small), np.eye(3) + turn + turn @ turn / 2, so3.exp(parameters[:, 3:6]))
    return homogeneous(rotation @ sym3.exp(symmetric(parameters)), parameters[:, :3])


@seeded("kaji_ochiai.blend", "generic")
def mean_of_the_matrices(affines: Array, weights: Array) -> Array:
    """The weighted mean of the entries."""
    return np.asarray(np.einsum("nk,nkij->nij", weights, affines))


@seeded("kaji_ochiai.blend", "extrapolation")
def weights_normalised(affines: Array, weights: Array) -> Array:
    """The weights are divided by their sum."""
    return np.asarray(kaji_ochiai.blend(affines, weights / weights.sum(axis=-1, keepdims=True)))


@seeded("kaji_ochiai.blend", "generic")
def relative_to_the_first(affines: Array, weights: Array) -> Array:
    """A_1 times the blend of the A_1⁻¹ A_i: it would be the same if blends were invariant from the left."""
    first = affines[:, :1]
    return np.asarray(affines[:, 0] @ kaji_ochiai.blend(np.linalg.inv(first) @ affines, weights))


def splined(poses: Array, knots: Array, t: Array, ends: Literal["natural", "not-a-knot", "clamped"]) -> Array:
    """The cubic spline of the parameters, by SciPy, with those conditions at its ends."""
    chains = [kaji_ochiai.parametrise(poses[:, 0])]
    for key in range(1, poses.shape[1]):
        chains.append(kaji_ochiai.parametrise_near(poses[:, key], chains[-1]))
    values = [
        CubicSpline(own, chain, bc_type=ends)(time)
        for own, chain, time in zip(knots, np.stack(chains, axis=1), t, strict=True)
    ]
    return np.asarray(kaji_ochiai.realise(np.array(values)))


@seeded("kaji_ochiai.interpolate", "generic")
def not_a_knot(poses: Array, knots: Array, t: Array) -> Array:
    """The spline that SciPy takes unasked: of one cubic across the second knot and the last but one."""
    return splined(poses, knots, t, "not-a-knot")


@seeded("kaji_ochiai.interpolate", "generic")
def at_rest_at_the_ends(poses: Array, knots: Array, t: Array) -> Array:
    """The spline of slope 0 at both ends."""
    return splined(poses, knots, t, "clamped")


@seeded("kaji_ochiai.interpolate", "twisting")
def principal_logarithms(poses: Array, knots: Array, t: Array) -> Array:
    """Each pose has its principal logarithm, however far from the one before it."""
    values = [
        CubicSpline(own, kaji_ochiai.parametrise(pose), bc_type="natural")(time)
        for own, pose, time in zip(knots, poses, t, strict=True)
    ]
    return np.asarray(kaji_ochiai.realise(np.array(values)))


@seeded("kaji_ochiai.interpolate", "extrapolation")
def times_clamped(poses: Array, knots: Array, t: Array) -> Array:
    """Before the first knot the first pose, after the last knot the last."""
    return np.asarray(kaji_ochiai.interpolate(poses, knots, np.clip(t, knots[:, 0], knots[:, -1])))


@seeded("kaji_ochiai.deform", "generic")
def mean_of_the_images(points: Array, probes: Array, weights: Array) -> Array:
    """The weighted mean of where the probes take a point: linear blend skinning."""
    linear, translation = probes[..., :3, :3], probes[..., :3, 3]
    images = np.einsum("nkij,npj->npki", linear, points) + translation[:, None]
    return np.asarray(np.einsum("npk,npki->npi", weights, images))


@seeded("kaji_ochiai.deform", "far-away")
def about_the_origin_only(points: Array, probes: Array, weights: Array) -> Array:
    """The blended translation alone: the point stays relative to it."""
    blended = kaji_ochiai.blend(probes[:, None], weights)
    return np.asarray(points + blended[..., :3, 3])


@seeded("kaji_ochiai.deform", "generic")
def weights_of_the_first_point(points: Array, probes: Array, weights: Array) -> Array:
    """All points have the weights of the first."""
    blended = kaji_ochiai.blend(probes, weights[:, 0])
    images = (times(blended[:, :3, :3], place) + blended[:, :3, 3] for place in np.moveaxis(points, 1, 0))
    return np.stack(list(images), axis=1)
