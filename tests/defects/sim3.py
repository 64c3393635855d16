"""Similarities: the bugs of V where the scale or the angle is next to nothing, of its inverse, and of choosing logs."""

from __future__ import annotations

import numpy as np

from affinecert.fast import se3, sim3, so3
from affinecert.scoring import Verdict
from affinecert.subjects import printed

from .defect import Array, block, column, homogeneous, parts, seeded, skew, times


def v(tangent: Array) -> Array:
    """V, applied to the three unit vectors."""
    moved = np.repeat(tangent[:, None], 3, axis=1)
    moved[:, :, 3:6] = np.eye(3)
    return np.swapaxes(sim3.exp(moved)[..., :3, 3], -1, -2)


def exp(tangent: Array, v_matrix: Array) -> Array:
    """The pose with a given V."""
    linear, _ = parts(sim3.exp(tangent))
    return homogeneous(linear, times(v_matrix, tangent[:, 3:6]))


def solved(omega: Array, growth: Array, pose: Array) -> Array:
    """The tangent of that rotation vector and growth, v solving V v = w."""
    tangent = np.concatenate([omega, np.zeros_like(omega), column(growth)], axis=1)
    tangent[:, 3:6] = np.linalg.solve(v(tangent), pose[:, :3, 3, None])[..., 0]
    return tangent


def generator(tangent: Array) -> Array:
    """lambda I + [omega]."""
    return np.asarray(block(tangent[:, 6]) * np.eye(3) + skew(tangent[:, :3]))


@seeded("sim3.exp", "angle-by-growth")
def closed_form_as_printed(tangent: Array) -> Array:
    """V by Theorem 2.3, whose first quotient is (e^λ - 1)/λ by subtraction."""
    return np.stack([printed.sim3_exp(item) for item in tangent])


@seeded("sim3.exp", "generic")
def growth_forgotten_in_v(tangent: Array) -> Array:
    """V is that of the rotation alone."""
    linear, _ = parts(sim3.exp(tangent))
    return homogeneous(linear, parts(se3.exp(tangent[:, :6]))[1])


@seeded("sim3.exp", "both-near-zero")
def series_of_three_terms(tangent: Array) -> Array:
    """V = I + Γ/2 + Γ²/6 wherever both are below 1."""
    gamma = generator(tangent)
    small = np.linalg.norm(gamma, axis=(-2, -1)) < 1.0
    return exp(tangent, np.where(block(small), np.eye(3) + gamma / 2 + gamma @ gamma / 6, v(tangent)))


@seeded("sim3.exp", "generic")
def scaled_translation(tangent: Array) -> Array:
    """The scale is applied to the translation as well."""
    pose = sim3.exp(tangent)
    pose[:, :3, 3] *= column(np.exp(tangent[:, 6]))
    return np.asarray(pose)


@seeded("sim3.exp", "no-growth", Verdict.NON_FINITE)
def divided_by_the_growth(tangent: Array) -> Array:
    """(e^λ - 1)/λ is evaluated at λ = 0."""
    growth = tangent[:, 6]  # the quotient is right elsewhere, and divided out again
    quotient = np.expm1(growth) / growth
    return exp(tangent, v(tangent) * block(quotient / quotient))


@seeded("sim3.log", "generic")
def volume_for_scale(pose: Array) -> Array:
    """λ = log det, not a third of it."""
    tangent = sim3.log(pose)
    return solved(tangent[:, :3], 3 * tangent[:, 6], pose)


@seeded("sim3.log", "off-manifold", Verdict.DEGRADED)
def scale_of_the_first_column(pose: Array) -> Array:
    """The scale is the length of the first column, whatever the others are."""
    growth = np.log(np.linalg.norm(pose[:, :3, 0], axis=-1))
    return solved(sim3.log(pose)[:, :3], growth, pose)


@seeded("sim3.log", "generic")
def v_of_the_rotation(pose: Array) -> Array:
    """v by the inverse of the rigid motion's V."""
    tangent = np.array(sim3.log(pose))
    turn = homogeneous(so3.exp(tangent[:, :3]), pose[:, :3, 3])
    tangent[:, 3:6] = se3.log(turn)[:, 3:]
    return tangent


@seeded("sim3.log", "angle-by-growth", Verdict.DEGRADED)
def inverse_of_the_printed_form(pose: Array) -> Array:
    """V of Theorem 2.3, solved for v."""
    pairs = zip(sim3.log(pose), pose, strict=True)
    return np.stack([printed.with_velocity(tangent[:3], tangent[6], item) for tangent, item in pairs])


@seeded("sim3.log_next", "beyond-pi")
def previous_ignored(pose: Array, previous: Array) -> Array:
    """The principal logarithm, always."""
    return np.asarray(sim3.log(pose))


@seeded("sim3.log_next", "beyond-pi")
def velocity_of_the_principal(pose: Array, previous: Array) -> Array:
    """The rotation vector is changed, v left as it was."""
    tangent = np.array(sim3.log_next(pose, previous))
    tangent[:, 3:6] = sim3.log(pose)[:, 3:6]
    return tangent


@seeded("sim3.log_next", "beyond-pi")
def the_same_way_round(pose: Array, previous: Array) -> Array:
    """(2π - θ) w/θ, without the sign."""
    tangent, principal = sim3.log_next(pose, previous), sim3.log(pose)
    other = np.any(tangent[:, :3] != principal[:, :3], axis=-1)
    return solved(np.where(column(other), -tangent[:, :3], tangent[:, :3]), tangent[:, 6], pose)


@seeded("sim3.log_near", "generic")
def turns_ignored(pose: Array, near: Array) -> Array:
    """Strategy 1 for strategy 2."""
    return np.asarray(sim3.log_next(pose, near))


@seeded("sim3.log_near", "whole-turns", Verdict.DEGRADED)
def inverse_by_elimination(pose: Array, near: Array) -> Array:
    """v by solving with a V that is all but singular."""
    tangent = sim3.log_near(pose, near)
    return solved(tangent[:, :3], tangent[:, 6], pose)


@seeded("sim3.log_near", "at-identity")
def no_rotation_has_no_turns(pose: Array, near: Array) -> Array:
    """The identity takes 0, as by strategy 1."""
    principal = sim3.log(pose)
    still = np.all(principal[:, :3] == 0, axis=-1)
    return np.where(column(still), principal, sim3.log_near(pose, near))


@seeded("sim3.condition", "generic")
def ratio_of_squares(tangent: Array) -> Array:
    """The condition number of V^T V."""
    return np.asarray(sim3.condition(tangent) ** 2)


@seeded("sim3.condition", "near-2pi", Verdict.DEGRADED)
def singular_values_computed(tangent: Array) -> Array:
    """By the singular values of V, of which the least is lost beside the others."""
    return np.asarray(np.linalg.cond(v(tangent)))


@seeded("sim3.condition", "generic")
def growth_ignored(tangent: Array) -> Array:
    """Of the rotation alone."""
    return np.asarray(sim3.condition(np.concatenate([tangent[:, :6], np.zeros((len(tangent), 1))], axis=1)))
