"""Interpolation of unit quaternions along the shorter arc."""

from __future__ import annotations

import math

import numpy as np

from affinecert.scoring import Verdict

from .report import Array, reported
from .sound import slerp


def along(start: Array, end: Array, t: float, angle: float) -> Array:
    """The arc at that angle, which nobody asks whether it is 0."""
    weights = np.sin((1 - t) * angle) / np.sin(angle), np.sin(t * angle) / np.sin(angle)
    return np.asarray(weights[0] * start + weights[1] * end)


@reported(
    "playcanvas/engine#39",
    "pc.Quat.slerp() with return NaNs if slerping between identical quats",
    "quaternion.slerp",
    slerp,
    Verdict.NON_FINITE,
)
@reported(
    "mosra/magnum#117",
    "Quaternion::slerp returns invalid Quaternion given two identity Quaternions",
    "quaternion.slerp",
    slerp,
    Verdict.NON_FINITE,
)
@reported(
    "dfki-ric/pytransform3d#45",
    "Quaternion SLERP fails for identical Quaternions",
    "quaternion.slerp",
    slerp,
    Verdict.NON_FINITE,
)
@reported("Dav1dde/gl3n#29", "slerp issues", "quaternion.slerp", slerp, Verdict.NON_FINITE)
def zero_by_zero(start: Array, end: Array, t: float) -> Array:
    """The weights are quotients of sines, 0/0 for equal ends; and acos of a product beyond 1 is NaN."""
    return along(start, end, t, np.arccos(start @ end))


@reported(
    "KieranWynn/pyquaternion#6",
    "Quaternion exponents appear to be broken with python 3.6.2 and numpy 1.12.1",
    "quaternion.slerp",
    slerp,
    Verdict.NON_FINITE,
)
def power_of_one(start: Array, end: Array, t: float) -> Array:
    """start (start^-1 end)^t, where the power divides the imaginary part by its length."""
    w = start @ end
    p, q = start[1:], end[1:]
    vector = start[0] * q - end[0] * p - np.cross(p, q)
    axis = vector / np.linalg.norm(vector)
    angle = t * np.arccos(w)
    imaginary = np.sin(angle) * axis
    real = start[0] * np.cos(angle) - p @ imaginary
    return np.array([real, *(start[0] * imaginary + np.cos(angle) * p + np.cross(p, imaginary))])


@reported(
    "iory/scikit-robot#807",
    "Fix quaternion_slerp raising on identical quaternions",
    "quaternion.slerp",
    slerp,
    Verdict.RAISED,
)
def dead_guard(start: Array, end: Array, t: float) -> Array:
    """The guard asks whether a distance is below 0; math.acos then refuses a product one ulp above 1."""
    p, q = start / np.linalg.norm(start), end / np.linalg.norm(end)
    product = float(p @ q)
    if abs(abs(product) - 1.0) < 0.0:
        return np.asarray(p)
    return along(p, q, t, math.acos(product))


@reported("redorav/hlslpp#68", "Quaternion slerp returning nan values", "quaternion.slerp", slerp, Verdict.NON_FINITE)
@reported(
    "bulletphysics/bullet3#446",
    "fix: btQuaternion.slerp() may result in NaN-quaternions",
    "quaternion.slerp",
    slerp,
    Verdict.NON_FINITE,
)
@reported(
    "boostorg/qvm#20", "Quaternion slerp() using incorrect precision", "quaternion.slerp", slerp, Verdict.NON_FINITE
)
def angle_in_single_precision(start: Array, end: Array, t: float) -> Array:
    """The angle between close ends in single precision: 0, or of a product beyond 1."""
    product = np.float32(start.astype(np.float32) @ end.astype(np.float32))
    return along(start, end, t, float(np.arccos(np.abs(product))))


@reported("g-truc/glm#901", "quaternion::mix handle cosTheta == -1", "quaternion.slerp", slerp, Verdict.NON_FINITE)
def equal_ends_only(start: Array, end: Array, t: float) -> Array:
    """Equal ends are mixed linearly; opposite ones, whose product is beyond -1, are not."""
    product = start @ end
    if product > 1 - 1e-7:
        return np.asarray((1 - t) * start + t * end)
    return along(start, end, t, np.arccos(product))


@reported("rustgd/cgmath#515", "Fixed opposite quaternion slerp bug", "quaternion.slerp", slerp)
def opposite_ends(start: Array, end: Array, t: float) -> Array:
    """Opposite ends have an angle of nearly pi, no arc between them, and weights by a sine that is rounding."""
    return along(start, end, t, math.acos(max(-1.0, min(1.0, float(start @ end)))))


@reported("go-gl/mathgl#90", "Quaternion Slerp honors closest distance.", "quaternion.slerp", slerp)
@reported("ebassi/graphene#157", "graphene_quaternion_slerp: Always use the shortest path", "quaternion.slerp", slerp)
@reported("bitshifter/glam-rs#282", "Ensure a positive dot product in `Quat::slerp`", "quaternion.slerp", slerp)
@reported(
    "fu5ha/ultraviolet#152", "Slerp between Rotor3's doesn't always takes shortest path", "quaternion.slerp", slerp
)
@reported("boostorg/qvm#43", "Issue with slerp'ing quaternions", "quaternion.slerp", slerp)
@reported(
    "untoldengine/UntoldEngine#118", "The quaternion Slerp method does not have a threshold", "quaternion.slerp", slerp
)
def the_long_arc(start: Array, end: Array, t: float) -> Array:
    """A negative product is left as it is: the long way round."""
    return along(start, end, t, math.acos(max(-1.0, min(1.0, float(start @ end)))))


@reported(
    "spnda/fastgltf#108",
    "math::slerp is not choosing the shortest rotation between two quaternions",
    "quaternion.slerp",
    slerp,
)
def both_negated(start: Array, end: Array, t: float) -> Array:
    """With a negative product both ends are negated, and the way between them is the same long one."""
    sign = -1.0 if start @ end < 0 else 1.0
    return along(sign * start, sign * end, t, math.acos(float(start @ end)))


@reported(
    "google/filament#3478",
    'Quaternion slerp: ensure "short path" when falling back to lerp.',
    "quaternion.slerp",
    slerp,
)
@reported("KieranWynn/pyquaternion#24", "Bug in Slerp Interpolation", "quaternion.slerp", slerp)
def linear_before_the_sign(start: Array, end: Array, t: float) -> Array:
    """Close ends are mixed linearly before one of them is negated: opposite ones cancel."""
    product = float(start @ end)
    if abs(product) > 0.99:
        mixed = (1 - t) * start + t * end
        return np.asarray(mixed / np.linalg.norm(mixed))
    return slerp(start, end, t)


@reported("rbdl/rbdl#27", "Quaternion slerp bug", "quaternion.slerp", slerp)
def cosine_not_negated(start: Array, end: Array, t: float) -> Array:
    """One end is negated, but the angle is still that of the negative product."""
    product = float(start @ end)
    angle = math.acos(max(-1.0, min(1.0, product)))
    return along(start, -end if product < 0 else end, t, angle)


@reported(
    "bitshifter/glam-rs#356",
    "Quat::slerp dot threshold prevents extrapolation when difference in angle is smaller than about π / 49.65",
    "quaternion.slerp",
    slerp,
)
@reported("mrdoob/three.js#32541", "Quaternion - Support extrapolation in slerp methods", "quaternion.slerp", slerp)
def linear_above_a_threshold(start: Array, end: Array, t: float) -> Array:
    """Beyond a product of 0.9995 the ends are mixed linearly and normalised, which cannot go on beyond them."""
    end = -end if start @ end < 0 else end
    if start @ end > 0.9995:
        mixed = (1 - t) * start + t * end
        return np.asarray(mixed / np.linalg.norm(mixed))
    return slerp(start, end, t)


@reported("mrdoob/three.js#14258", "Problem with slerp, and possible solution", "quaternion.slerp", slerp)
@reported("mrdoob/three.js#14349", "fix Quaternion.slerp for small angles", "quaternion.slerp", slerp)
def averaged(start: Array, end: Array, t: float) -> Array:
    """Close ends are averaged, whatever t."""
    if math.sqrt(max(0.0, 1 - float(start @ end) ** 2)) < 1e-3:
        return np.asarray((start + end) / 2)
    return slerp(start, end, t)


@reported("w3c/csswg-drafts#896", "Make Rotation Less Weird", "quaternion.slerp", slerp, Verdict.NON_FINITE)
def opposite_divided(start: Array, end: Array, t: float) -> Array:
    """The weights divide by sqrt(1 - product^2), 0 for opposite ends, and only a product of 1 is asked for."""
    product = max(-1.0, min(1.0, float(start @ end)))
    if product == 1.0:
        return start
    angle = np.arccos(product)
    second = np.sin(t * angle) / np.sqrt(1 - product**2)
    return np.asarray((np.cos(t * angle) - product * second) * start + second * end)


@reported(
    "w3c/csswg-drafts#483",
    "[css-transforms] Bunch of bugs in the interpolation algorithms",
    "quaternion.slerp",
    slerp,
    Verdict.NON_FINITE,
)
def always_opposite(start: Array, end: Array, t: float) -> Array:
    """The clamp uses the limits the wrong way round: every product is -1."""
    product = np.float64(min(max(float(start @ end), 1.0), -1.0))
    angle = np.arccos(product)
    second = np.sin(t * angle) / np.sqrt(1 - product**2)
    return np.asarray((np.cos(t * angle) - product * second) * start + second * end)


@reported("toji/gl-matrix#66", "A typo in quat.slerp", "quaternion.slerp", slerp)
def last_component_of_the_first(start: Array, end: Array, t: float) -> Array:
    """One component of the end is that of the start."""
    end = np.array([start[0], *end[1:]])
    return along(start, end, t, math.acos(min(1.0, float(start @ end))))


@reported("g-truc/glm#210", "fixed bug in quaternion slerp", "quaternion.slerp", slerp)
def equal_but_for_the_sign(start: Array, end: Array, t: float) -> Array:
    """The product is made positive for the angle, and close ends are mixed as they are: opposite ones cancel."""
    if abs(float(start @ end)) > 1 - 1e-9:
        return np.asarray((1 - t) * start + t * end)
    return slerp(start, end, t)
