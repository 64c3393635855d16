"""Polar factors, and logarithms, powers and exponentials of matrices."""

from __future__ import annotations

import math

import numpy as np

from affinecert.scoring import Verdict

from .report import Array, reported
from .sound import cross, exp, factors, log, pose, vee

TURN = np.array([[0.0, -1.0], [1.0, 0.0]])


def iterated(linear: Array, rotation: Array) -> Array:
    """The rotation that turns most like L, from a first guess, by the torque between their columns."""
    for _ in range(100):
        torque = np.cross(rotation.T, linear.T).sum(axis=0) / (abs(np.sum(rotation * linear)) + 1e-9)
        if np.linalg.norm(torque) < 1e-15:
            break
        rotation = exp(torque) @ rotation
    return rotation


@reported(
    "dimforge/nalgebra#1187",
    "`Rotation3::from_matrix` : Yields improper solution for certain matrices",
    "polar.decompose",
    factors,
)
@reported(
    "dimforge/nalgebra#1583",
    "Rotation3::from_matrix hangs when a matrix with left handed coordinate system is passed in",
    "polar.decompose",
    factors,
)
def stuck_at_the_guess(linear: Array) -> tuple[Array, Array]:
    """Iterated from the identity: a half turn has no torque there, and a left-handed matrix no end."""
    rotation = iterated(linear, np.eye(3))
    return rotation, rotation.T @ linear


@reported(
    "NVIDIA/warp#1734",
    "wp.svd2 returns wrong singular vectors for scaled rotations and reflections",
    "polar.decompose",
    factors,
)
def equal_values_for_no_turn(linear: Array) -> tuple[Array, Array]:
    """Where both singular values are equal, L is taken for a multiple of the identity."""
    gram = linear.T @ linear
    if gram[0, 1] == 0 and gram[0, 0] == gram[1, 1]:
        return np.eye(2), math.sqrt(gram[0, 0]) * np.eye(2)
    return factors(linear)


@reported(
    "NVIDIA/warp#679", "[BUG] `wp.svd2` returns NaN in `U` and `V`", "polar.decompose", factors, Verdict.NON_FINITE
)
def gap_divided(linear: Array) -> tuple[Array, Array]:
    """The singular vectors by the gap of the singular values, which is 0 for a multiple of the identity."""
    gram = linear.T @ linear
    gap = np.sqrt((gram[0, 0] - gram[1, 1]) ** 2 + 4 * gram[0, 1] ** 2)
    cosine, sine = (gram[0, 0] - gram[1, 1]) / gap, 2 * gram[0, 1] / gap
    values = np.sqrt((np.trace(gram) + np.array([gap, -gap])) / 2)
    difference = (values[0] - values[1]) / 2
    stretch = np.eye(2) * values.mean() + difference * np.array([[cosine, sine], [sine, -cosine]])
    return linear @ np.linalg.inv(stretch), stretch


@reported(
    "scipy/scipy#22417",
    "BUG: spatial.transform: `Rotation.from_matrix()` uses inaccurate orthonormalization algorithm",
    "polar.decompose",
    factors,
)
def quaternion_of_no_rotation(linear: Array) -> tuple[Array, Array]:
    """The quaternion by the formula for rotations, normalised: near them it is good, here far off."""
    vector = vee(linear) / (1 + np.trace(linear))
    rotation = exp(2 * math.atan(math.hypot(*vector)) / (math.hypot(*vector) or 1.0) * vector)
    return rotation, rotation.T @ linear


@reported(
    "scipy/scipy#22418",
    "BUG: scipy.spatial: Fix inaccurate orthonormalization in `Rotation.from_matrix()`",
    "polar.decompose",
    factors,
)
@reported(
    "gltf-rs/gltf#99",
    "Transform::decomposed is wrong for matrices with negative determinant",
    "polar.decompose",
    factors,
)
@reported("mrdoob/three.js#4272", "Matrix4 decompose bug", "polar.decompose", factors)
@reported(
    "openframeworks/openFrameworks#4317",
    "ofMatrix4x4::decompose() decomposes scale incorrectly",
    "polar.decompose",
    factors,
)
def lengths_for_the_stretch(linear: Array) -> tuple[Array, Array]:
    """The stretch is made of the columns' lengths, never negative: a reflection stays in the rotation."""
    lengths = np.linalg.norm(linear, axis=0)
    return linear / lengths, np.diag(lengths)


def spectral(linear: Array) -> Array:
    """The principal logarithm by eigenvectors, complex as it comes."""
    values, vectors = np.linalg.eig(linear)
    return np.asarray(vectors @ np.diag(np.log(values.astype(complex))) @ np.linalg.inv(vectors))


def fixed_origin(logarithm: Array) -> Array:
    """The homogeneous logarithm of a map that leaves the origin where it is."""
    size = len(logarithm)
    matrix = np.zeros((size + 1, size + 1), dtype=logarithm.dtype)
    matrix[:size, :size] = logarithm
    return matrix


def real_spectral(affine: Array) -> Array:
    """The logarithm by eigenvectors, its rounding in the imaginary part dropped."""
    return fixed_origin(spectral(affine[:-1, :-1]).real)


def turn_log(affine: Array) -> Array:
    """The logarithm of a turn of the plane or of space about the origin."""
    linear = affine[:-1, :-1]
    if len(linear) == 3:
        return fixed_origin(cross(log(linear)))
    return fixed_origin(math.atan2(linear[1, 0] - linear[0, 1], np.trace(linear)) * TURN)


@reported("scipy/scipy#6113", "scipy.linalg.logm fails for a trivial matrix", "sam.log", turn_log, Verdict.RAISED)
@reported("scipy/scipy#6378", "logm function is incomplete", "sam.log", turn_log, Verdict.RAISED)
def unwinding_number_of_nan(affine: Array) -> Array:
    """The divided difference of the logarithms of i and -i divides by their sum; a NaN has no ceiling."""
    values = np.sort_complex(np.linalg.eigvals(affine[:-1, :-1]).astype(complex))
    low, high = values[[0, 1]] if len(values) == 2 else values[np.abs(values.imag) > 0.5]
    z = (high - low) / (high + low)
    windings = math.ceil(((np.log(1 + z) - np.log(1 - z)).imag - math.pi) / (2 * math.pi))
    return turn_log(affine) if windings == 0 else np.full_like(affine, np.nan)


@reported(
    "scipy/scipy#4923",
    "logm does not aggressively convert complex outputs to float",
    "sam.log",
    real_spectral,
    Verdict.DEGRADED,
)
def imaginary_rounding(affine: Array) -> Array:
    """A real logarithm with an imaginary part of rounding."""
    return fixed_origin(spectral(affine[:-1, :-1]))


@reported("fishjojo/pyscfad#44", "Ensure real solution of logm for localized orbitals", "sam.log", turn_log)
def principal_and_complex(affine: Array) -> Array:
    """A half turn has a real logarithm; the principal logarithm of its eigenvalues is i pi."""
    return fixed_origin(spectral(affine[:-1, :-1]))


@reported("JuliaManifolds/Manifolds.jl#30", "Ensure log is defined at cutlocus", "sam.log", turn_log)
def real_part_of_i_pi(affine: Array) -> Array:
    """The real part of the complex logarithm: of a half turn of the plane nothing."""
    return fixed_origin(spectral(affine[:-1, :-1]).real)


def planar_log(affine: Array, half_cotangent: float) -> Array:
    """The logarithm of a rigid motion of the plane, given (a/2) cot(a/2)."""
    angle = math.atan2(affine[1, 0] - affine[0, 1], affine[0, 0] + affine[1, 1])
    matrix = fixed_origin(angle * TURN)
    matrix[:2, 2] = half_cotangent * affine[:2, 2] - angle / 2 * TURN @ affine[:2, 2]
    return matrix


def planar(affine: Array) -> Array:
    """The logarithm of a rigid motion of the plane."""
    half = math.atan2(affine[1, 0] - affine[0, 1], affine[0, 0] + affine[1, 1]) / 2
    return planar_log(affine, half / math.tan(half) if half else 1.0)


@reported(
    "JuliaManifolds/LieGroups.jl#44",
    "Numerical issue with exp/log on SE with small angle",
    "sam.log",
    planar,
    Verdict.NON_FINITE,
)
def sine_over_versine(affine: Array) -> Array:
    """(a/2) cot(a/2) as a sin a / (2 (1 - cos a)): the cosine of 1e-8 is 1."""
    angle = np.float64(math.atan2(affine[1, 0], affine[0, 0]))
    return planar_log(affine, angle * np.sin(angle) / (2 * (1 - np.cos(angle))))


def turn_power(affine: Array, t: float) -> Array:
    """The power of a scaled turn of the plane about the origin."""
    linear = affine[:2, :2]
    scale = math.hypot(linear[0, 0], linear[1, 0])
    angle = t * math.atan2(linear[1, 0], linear[0, 0])
    return pose(scale**t * (math.cos(angle) * np.eye(2) + math.sin(angle) * TURN), np.zeros(2))


@reported(
    "scipy/scipy#19415",
    "BUG: linalg.sqrtm results different between version 1.11.1 and 1.11.2/1.11.3",
    "sam.power",
    turn_power,
)
def small_for_zero(affine: Array, t: float) -> Array:
    """What is below 1e-8 counts as 0 beneath the diagonal: a tiny map is taken for a triangular one."""
    linear = affine[:2, :2]
    if not np.allclose(linear[1, 0], 0.0):
        return turn_power(affine, t)
    roots = np.sqrt(np.diag(linear))
    return pose(np.array([[roots[0], linear[0, 1] / roots.sum()], [0.0, roots[1]]]), np.zeros(2))


def difference(low: float, high: float) -> float:
    """(e^high - e^low)/(high - low)."""
    low, high = min(low, high), max(low, high)
    gap = high - low
    return math.exp(high) * (-math.expm1(-gap) / gap if gap else 1.0)


def shear_exp(twist: Array) -> Array:
    """The exponential of [[0, a1, a3], [0, a2, a4], [0, 0, a5]], where a1 = a3 = 0."""
    a, b, c = twist[1], twist[3], twist[4]
    return np.array([[1.0, 0.0, 0.0], [0.0, math.exp(a), b * difference(a, c)], [0.0, 0.0, math.exp(c)]])


@reported(
    "scipy/scipy#19584",
    "BUG: MATLAB expm vs scipy.linalg.expm: overflow/invalid value warnings, resulting in nan",
    "shear.exp",
    shear_exp,
    Verdict.NON_FINITE,
)
def mean_times_sinch(twist: Array) -> Array:
    """The divided difference as e^mean sinh(half the gap)/(half the gap): 0 times infinity."""
    a, b, c = twist[1], twist[3], twist[4]
    half = (c - a) / 2
    ratio = np.exp((a + c) / 2) * np.sinh(half) / half
    return np.array([[1.0, 0.0, 0.0], [0.0, np.exp(a), b * ratio], [0.0, 0.0, np.exp(c)]])


@reported(
    "JuliaArrays/StaticArrays.jl#624",
    "Avoid division by 0 in 2x2 complex exp",
    "shear.exp",
    shear_exp,
    Verdict.NON_FINITE,
)
def discriminant_divided(twist: Array) -> Array:
    """The closed form for two eigenvalues divides by the root of the discriminant, 0 where they are equal."""
    a, b, c = twist[1], twist[3], twist[4]
    root = np.sqrt((a - c) ** 2)
    return np.array(
        [
            [1.0, 0.0, 0.0],
            [0.0, np.exp(a), b * (np.exp((a + c + root) / 2) - np.exp((a + c - root) / 2)) / root],
            [0.0, 0.0, np.exp(c)],
        ]
    )


@reported(
    "wpilibsuite/allwpilib#9194",
    "[wpimath] Implement Matrix.exp() with EJML",
    "shear.exp",
    shear_exp,
)
def overscaled(twist: Array) -> Array:
    """Scaling and squaring by the norm, which one large entry makes so small that the diagonal is rounded away."""
    generator = np.array([[0.0, twist[0], twist[2]], [0.0, twist[1], twist[3]], [0.0, 0.0, twist[4]]])
    squarings = max(0, math.frexp(np.linalg.norm(generator, 1))[1] + 1)
    scaled = generator / 2**squarings
    power, total = np.eye(3), np.eye(3)
    for k in range(1, 15):
        power = power @ scaled / k
        total = total + power
    for _ in range(squarings):
        total = total @ total
    return total


def symmetric_power(matrix: Array, t: float) -> Array:
    """The power of a symmetric matrix by its eigenvectors."""
    values, vectors = np.linalg.eigh(matrix)
    return np.asarray(vectors @ np.diag(values ** float(t)) @ vectors.T)


@reported(
    "fdaPDE/fdaPDE-core#29",
    "Add checked native SPD matrices and symmetric spectral functions",
    "sym3.power",
    symmetric_power,
)
def exponent_truncated(matrix: Array, t: float) -> Array:
    """The exponent passes through an integer: the root is the power 0."""
    return symmetric_power(matrix, math.trunc(float(t)))
