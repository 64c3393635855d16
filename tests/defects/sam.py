"""Steady affine motions: existence decided in floating point, and logarithms that forget the singular cases."""

from __future__ import annotations

import numpy as np

from affinecert.fast import sam
from affinecert.scoring import Verdict

from .defect import Array, column, homogeneous, parts, seeded, times


@seeded("sam.exists", "negative-pair-2d")
def determinant_only(affine: Array) -> Array:
    """A positive determinant is taken to be enough."""
    return np.asarray(np.linalg.det(parts(affine)[0]) > 0)


@seeded("sam.exists", "near-minus-identity-2d")
def imaginary_part_above_a_tolerance(affine: Array) -> Array:
    """Eigenvalues whose imaginary part is below 1e-8 count as real."""
    eigenvalues = np.linalg.eigvals(parts(affine)[0])
    return np.asarray(~np.any((np.abs(eigenvalues.imag) < 1e-8) & (eigenvalues.real < 0), axis=-1))


@seeded("sam.exists", "negative-defective-2d")
def eigenvalues_as_rounded(affine: Array) -> Array:
    """Eigenvalues as LAPACK rounds them."""
    eigenvalues = np.linalg.eigvals(parts(affine)[0])
    return np.asarray(~np.any((eigenvalues.imag == 0) & (eigenvalues.real < 0), axis=-1))


@seeded("sam.exists", "minus-identity-2d")
def double_negative_forgotten(affine: Array) -> Array:
    """-s I, and its like in space, have a logarithm."""
    linear = parts(affine)[0]
    symmetric = np.all(linear == np.swapaxes(linear, -1, -2), axis=(-2, -1))
    negative = np.min(np.linalg.eigvalsh((linear + np.swapaxes(linear, -1, -2)) / 2), axis=-1) < 0
    return np.asarray(sam.exists(affine) & ~(symmetric & negative))


def by_eigenvectors(affine: Array, function: np.ufunc) -> Array:
    """A function of matrices by their eigenvectors."""
    values, vectors = np.linalg.eig(affine)
    return np.asarray(((vectors * function(values.astype(complex))[:, None]) @ np.linalg.inv(vectors)).real)


@seeded("sam.log", "defective-3d")
def logarithm_by_eigenvectors(affine: Array) -> Array:
    """X log(Λ) X⁻¹, though X may be singular."""
    return by_eigenvectors(affine, np.log)


@seeded("sam.log", "unit-eigenvalue-2d", Verdict.RAISED)
def translation_by_solving(affine: Array) -> Array:
    """v = log(L) (L - I)⁻¹ t, though L - I may be singular."""
    linear, translation = parts(affine)
    generator = np.array(sam.log(affine))
    shifted = linear - np.eye(linear.shape[-1])
    generator[:, :-1, -1] = times(generator[:, :-1, :-1], np.linalg.solve(shifted, translation[..., None])[..., 0])
    return generator


@seeded("sam.log", "generic-3d")
def translation_left_alone(affine: Array) -> Array:
    """The translation's part of the logarithm is t itself."""
    generator = np.array(sam.log(affine))
    generator[:, :-1, -1] = affine[:, :-1, -1]
    return generator


@seeded("sam.log", "minus-identity-2d")
def turned_the_other_way(affine: Array) -> Array:
    """A double negative eigenvalue is turned by -π."""
    generator = np.array(sam.log(affine))
    linear = parts(affine)[0]
    symmetric = np.all(linear == np.swapaxes(linear, -1, -2), axis=(-2, -1))
    other = np.swapaxes(generator[:, :-1, :-1], -1, -2)
    generator[:, :-1, :-1] = np.where(symmetric[:, None, None], other, generator[:, :-1, :-1])
    return generator


@seeded("sam.power", "generic-3d")
def translation_in_proportion(affine: Array, t: Array) -> Array:
    """L^t, and t times the translation."""
    return homogeneous(np.asarray(sam.power(affine, t))[:, :-1, :-1], column(t) * affine[:, :-1, -1])


@seeded("sam.power", "defective-3d")
def power_by_eigenvectors(affine: Array, t: Array) -> Array:
    """X Λ^t X⁻¹, though X may be singular."""
    values, vectors = np.linalg.eig(affine)
    raised = vectors * (values.astype(complex) ** column(t))[:, None]
    return np.asarray((raised @ np.linalg.inv(vectors)).real)


@seeded("sam.power", "generic-3d")
def time_in_single_precision(affine: Array, t: Array) -> Array:
    """t passes through float32."""
    return np.asarray(sam.power(affine, t.astype(np.float32).astype(np.float64)))


@seeded("sam.morph", "generic-3d")
def quotient_on_the_other_side(start: Array, end: Array, t: Array) -> Array:
    """B (B⁻¹ C)^t is right and (C B⁻¹)^t B is right; (B⁻¹ C)^t B is neither."""
    return np.asarray(np.asarray(sam.power(np.linalg.inv(start) @ end, t)) @ start)


@seeded("sam.morph", "generic-3d")
def entries_in_proportion(start: Array, end: Array, t: Array) -> Array:
    """(1 - t) B + t C."""
    weight = t[:, None, None]
    return np.asarray((1 - weight) * start + weight * end)


@seeded("sam.fixed_point", "near-unit-eigenvalue-2d", Verdict.DEGRADED)
def pseudo_inverse(affine: Array) -> Array:
    """Singular values of I - L below 1e-8 count as zero."""
    linear, translation = parts(affine)
    return times(np.linalg.pinv(np.eye(linear.shape[-1]) - linear, rcond=1e-8), translation)


@seeded("sam.fixed_point", "spread-3d", Verdict.DEGRADED)
def normal_equations(affine: Array) -> Array:
    """MᵀM p = Mᵀt with M = I - L, which squares the condition."""
    linear, translation = parts(affine)
    shifted = np.eye(linear.shape[-1]) - linear
    across = np.swapaxes(shifted, -1, -2)
    return np.asarray(np.linalg.solve(across @ shifted, (across @ translation[..., None]))[..., 0])


@seeded("sam.fixed_point", "generic-3d")
def sign_of_the_shift(affine: Array) -> Array:
    """(L - I) p = t for (I - L) p = t."""
    return -np.asarray(sam.fixed_point(affine))


@seeded("sam.velocity", "generic-3d")
def translation_forgotten(affine: Array, point: Array) -> Array:
    """log(L) p, without v."""
    return times(np.asarray(sam.log(affine))[:, :-1, :-1], point)


@seeded("sam.velocity", "generic-3d")
def displacement_for_velocity(affine: Array, point: Array) -> Array:
    """A p - p: the way to the next frame, in a straight line."""
    linear, translation = parts(affine)
    return np.asarray(times(linear, point) + translation - point)
