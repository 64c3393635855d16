"""Equations 4, 6, 7 and 8 in float64, as a reader would code them, on arrays of matrices; and what they compete with.

The approximations that the paper gives stand in for small arguments; 0/0 stays 0/0.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np
from scipy import linalg

from affinecert.map import Array

SMALL = 1e-4
"""Arguments below which the approximations of second order stand in: there both err by about 1e-13 of 1/2."""

Function = Callable[[Array], Array]


def spectra(matrices: Array) -> Array:
    """The eigenvalues of symmetric matrices by the cubic formula, the largest first, (n, 3, 3) -> (n, 3)."""
    mean = np.trace(matrices, axis1=1, axis2=2) / 3
    shifted = matrices - mean[:, None, None] * np.eye(3)
    radius = np.sqrt(np.einsum("nij,nij->n", shifted, shifted) / 6)
    (a, b, c), (_, d, e), (_, _, f) = shifted.transpose(1, 2, 0)
    determinant = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d)
    cosine = np.clip(determinant / np.where(radius > 0, 2 * radius**3, 1.0), -1.0, 1.0)
    angles = np.arccos(cosine)[:, None] / 3 + 2 * np.pi / 3 * np.array([0, 2, 1])
    return np.asarray(mean[:, None] + 2 * radius[:, None] * np.cos(angles))


def e2(x: Array) -> Array:
    """(exp x - 1 - x) / x^2, or equation 6's approximation."""
    small = np.abs(x) < SMALL
    return np.where(small, 0.5 + x / 6 + x * x / 24, (np.exp(x) - 1 - x) / np.where(small, 1.0, x) ** 2)


def l2(x: Array) -> Array:
    """(log x - (x - 1)) / (x - 1), or its Taylor polynomial of degree two."""
    d = x - 1
    small = np.abs(d) < SMALL
    return np.where(small, -d / 2 + d * d / 3, (np.log(x) - d) / np.where(small, 1.0, d))


def exponential(matrices: Array, f: Function = e2) -> Array:
    """Equation 6."""
    eigenvalues = spectra(matrices)
    center = eigenvalues[:, 1]
    one, three = eigenvalues[:, 0] - center, eigenvalues[:, 2] - center
    first, third = f(one), f(three)
    b = 1 - one * three * (first - third) / (one - three)
    c = 0.5 + (one * (2 * first - 1) - three * (2 * third - 1)) / (2 * (one - three))
    z = matrices - center[:, None, None] * np.eye(3)
    sum_of_powers = np.eye(3) + b[:, None, None] * z + c[:, None, None] * (z @ z)
    return np.asarray(np.exp(center)[:, None, None] * sum_of_powers)


def logarithm(matrices: Array, f: Function = l2) -> Array:
    """Twice equation 7: the logarithm of positive definite matrices, not of their roots."""
    eigenvalues = spectra(matrices)
    center = eigenvalues[:, 1]
    one, three = eigenvalues[:, 0] / center, eigenvalues[:, 2] / center
    first, third = f(one), f(three)
    a = -1 + (three * first - one * third) / (one - three)
    c = (first - third) / (one - three)
    z = matrices / center[:, None, None]
    constant = (a + np.log(center))[:, None, None] * np.eye(3)
    return np.asarray(constant - (a + c)[:, None, None] * z + c[:, None, None] * (z @ z))


def diagonalised(f: Function) -> Function:
    """The function f of symmetric matrices by diagonalisation, equation 11."""

    def of_matrices(matrices: Array) -> Array:
        values, vectors = np.linalg.eigh(matrices)
        return np.asarray((vectors * f(values)[:, None, :]) @ vectors.transpose(0, 2, 1))

    return of_matrices


def pade_exponential(matrices: Array) -> Array:
    """Padé approximants with scaling and squaring, as SciPy has them."""
    return np.asarray(linalg.expm(matrices))


def pade_logarithm(matrices: Array) -> Array:
    """Padé approximants after square roots, as SciPy has them; the real part, where there is no real logarithm."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return np.array([np.real(linalg.logm(matrix)) for matrix in matrices])


def rotations(skew: Array) -> Array:
    """Equation 4, its second form."""
    theta = np.sqrt(np.einsum("nij,nij->n", skew, skew) / 2)
    first, second = np.sinc(theta / np.pi), np.sinc(theta / (2 * np.pi)) ** 2 / 2
    return np.asarray(np.eye(3) + first[:, None, None] * skew + second[:, None, None] * (skew @ skew))


def skew_logarithms(turns: Array) -> Array:
    """Equation 8."""
    theta = np.arccos(np.clip((np.trace(turns, axis1=1, axis2=2) - 1) / 2, -1.0, 1.0))
    return np.asarray((turns - turns.transpose(0, 2, 1)) / (2 * np.sinc(theta / np.pi))[:, None, None])


def factors(linears: Array) -> tuple[Array, Array]:
    """The rotations A S^-1 and log S, by equations 7 and 6 of A^T A."""
    log_stretch = logarithm(linears.transpose(0, 2, 1) @ linears) / 2
    return np.asarray(linears @ exponential(-log_stretch)), log_stretch


def factors_by_higham(linears: Array) -> tuple[Array, Array]:
    """The rotations by Newton's iteration with Higham's scaling, and log S of S = R^T A by equation 7."""
    turns = linears
    for step in range(40):
        inverse = np.linalg.inv(turns).transpose(0, 2, 1)
        ratio = np.linalg.norm(inverse, axis=(1, 2)) / np.linalg.norm(turns, axis=(1, 2))
        scale = np.sqrt(ratio)[:, None, None] if step < 30 else 1.0
        turns = (scale * turns + inverse / scale) / 2
    stretch = turns.transpose(0, 2, 1) @ linears
    return np.asarray(turns), logarithm((stretch + stretch.transpose(0, 2, 1)) / 2)


def round_trip(split: Callable[[Array], tuple[Array, Array]]) -> Function:
    """Linear parts through their parameters and back, phi after psi."""

    def there_and_back(linears: Array) -> Array:
        turns, log_stretch = split(linears)
        return np.asarray(rotations(skew_logarithms(turns)) @ exponential(log_stretch))

    return there_and_back


def alexa_round_trip(linears: Array) -> Array:
    """Linear parts through their logarithms, of which the real part is kept, and back."""
    return pade_exponential(pade_logarithm(linears))
