"""The groups G_A and G_S: the bugs of divided differences."""

from __future__ import annotations

import numpy as np

from affinecert.fast import shear
from affinecert.scoring import Verdict

from .defect import Array, seeded


def matrix(one: Array, two: Array, three: Array, four: Array, five: Array) -> Array:
    """The elements [[1, α1, α3], [0, α2, α4], [0, 0, α5]] (N, 3, 3)."""
    result = np.zeros((len(one), 3, 3))
    result[:, 0, 0] = 1.0
    result[:, (0, 1, 0, 1, 2), (1, 1, 2, 2, 2)] = np.stack([one, two, three, four, five], axis=-1)
    return result


@seeded("shear.exp", "coalescing", Verdict.DEGRADED)
def naive_divided_difference(twist: Array) -> Array:
    """(exp a2 - exp a5)/(a2 - a5), by subtraction."""
    result = np.array(shear.exp(twist))
    _, a2, _, a4, a5 = twist.T
    difference = np.where(a2 == a5, np.exp(a2), (np.exp(a2) - np.exp(a5)) / (a2 - a5))
    result[:, 1, 2] = a4 * difference
    return result


@seeded("shear.exp", "coalescing", Verdict.DEGRADED)
def collapsed_too_early(twist: Array) -> Array:
    """Eigenvalues closer than 1e-6 count as one."""
    close = np.abs(twist[:, 1] - twist[:, 4]) < 1e-6
    merged = twist.copy()
    merged[close, 4] = twist[close, 1]
    return np.asarray(shear.exp(merged))


@seeded("shear.exp", "generic")
def second_difference_of_the_wrong_pair(twist: Array) -> Array:
    """α3 takes its first-order part over (a2, a5) instead of (0, a5)."""
    result = np.array(shear.exp(twist))
    _, a2, a3, _, a5 = twist.T
    right = np.expm1(a5) / a5
    wrong = np.exp(a2) * np.expm1(a5 - a2) / (a5 - a2)
    result[:, 0, 2] += a3 * (wrong - right)
    return result


@seeded("shear.log", "coalescing-with-first", Verdict.DEGRADED)
def one_within_a_millionth(element: Array) -> Array:
    """An eigenvalue α2 within 1e-6 of 1 counts as 1."""
    close = np.abs(element[:, 1, 1] - 1) < 1e-6
    result = np.array(shear.log(element))
    result[close, 0] = element[close, 0, 1]
    return result


@seeded("shear.log", "coalescing")
def naive_difference_of_logs(element: Array) -> Array:
    """(log α2 - log α5)/(α2 - α5), by subtraction."""
    result = np.array(shear.log(element))
    second, fourth, fifth = element[:, 1, 1], element[:, 1, 2], element[:, 2, 2]
    result[:, 3] = fourth * np.where(second == fifth, 1 / second, (np.log(second) - np.log(fifth)) / (second - fifth))
    return result


@seeded("shear.log", "generic")
def product_term_with_the_sign_of_exp(element: Array) -> Array:
    """α3's part with α1 α4 is added, as in the exponential."""
    without = element.copy()
    without[:, 0, 1] = 0.0
    result = np.array(shear.log(element))
    result[:, 2] = 2 * shear.log(without)[:, 2] - result[:, 2]
    return result


@seeded("scale.exp", "generic")
def quadratic_below_a_hundredth(log_scale: Array) -> Array:
    """1 + x + x²/2 below 1e-2, where the cubic term still counts."""
    return np.where(np.abs(log_scale) < 1e-2, 1 + log_scale + log_scale**2 / 2, np.exp(log_scale))


@seeded("scale.exp", "huge")
def one_added_back(log_scale: Array) -> Array:
    """expm1(x) + 1, which loses small results."""
    return np.expm1(log_scale) + 1


@seeded("scale.log", "tiny", Verdict.NON_FINITE)
def log1p_everywhere(scale: Array) -> Array:
    """log1p(s - 1), which loses small s."""
    return np.asarray(np.log1p(scale - 1))


@seeded("scale.log", "generic")
def base_ten_by_a_short_constant(scale: Array) -> Array:
    """log10(s)/0.4342945."""
    return np.asarray(np.log10(scale) / 0.4342945)
