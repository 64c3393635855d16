"""Powers of rigid motions of space, in double-double, by the quaternion of the rotation.

The quaternion of half the angle moves through 0 to pi/2 only, where the rotation's own matrix is ambiguous at pi.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import (
    ONE,
    add,
    divide,
    multiply,
    multiply_add,
    scaled,
    square_root,
    subtract,
)
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import Numbers, cross, dot

# Below it the squared sine of half the angle has underflowed, and the motion is a translation to the last bit.
NO_TURN = 2.0**-900


@compiled
def quaternion(rotation: Numbers) -> tuple[complex, Numbers]:
    """The scalar part, not negative, and the vector part; at a half turn its first component not 0 is positive."""
    vector = np.empty(3, dtype=np.complex128)
    largest, trace = 0, add(add(rotation[0, 0], rotation[1, 1]), rotation[2, 2])
    for i in range(1, len(vector)):
        if rotation[i, i].real > rotation[largest, largest].real:
            largest = i
    i, j, k = largest, (largest + 1) % 3, (largest + 2) % 3
    skew = subtract(rotation[k, j], rotation[j, k])
    if trace.real > rotation[i, i].real:
        twice = square_root(add(trace, ONE))
        for n in range(len(vector)):
            p, q = (n + 1) % 3, (n + 2) % 3
            vector[n] = divide(scaled(subtract(rotation[q, p], rotation[p, q]), 0.5), twice)
        return scaled(twice, 0.5), vector
    twice = square_root(subtract(add(ONE, scaled(rotation[i, i], 2.0)), trace))
    scalar = divide(scaled(skew, 0.5), twice)
    vector[i] = scaled(twice, 0.5)
    vector[j] = divide(scaled(add(rotation[i, j], rotation[j, i]), 0.5), twice)
    vector[k] = divide(scaled(add(rotation[i, k], rotation[k, i]), 0.5), twice)
    sign = math.copysign(1.0, scalar.real)
    if scalar.real == 0.0:
        for n in range(2, -1, -1):
            if vector[n].real != 0.0:
                sign = math.copysign(1.0, vector[n].real)
    for n in range(len(vector)):
        vector[n] = scaled(vector[n], sign)
    return scaled(scalar, sign), vector


@compiled
def turned(cosine: complex, ratio: complex, vector: Numbers, rotation: Numbers) -> None:
    """Writes the rotation of the quaternion with that scalar part and the vector part ``ratio`` times ``vector``."""
    u = np.empty(3, dtype=np.complex128)
    for i in range(len(u)):
        u[i] = multiply(ratio, vector[i])
    diagonal = subtract(multiply(cosine, cosine), dot(u, u))
    for i in range(len(u)):
        j, k = (i + 1) % 3, (i + 2) % 3
        rotation[i, i] = multiply_add(scaled(u[i], 2.0), u[i], diagonal)
        product, turn = multiply(u[j], u[k]), multiply(cosine, u[i])
        rotation[k, j], rotation[j, k] = scaled(add(product, turn), 2.0), scaled(subtract(product, turn), 2.0)


@compiled
def carried(
    t: float, scalar: complex, vector: Numbers, cosine: complex, ratio: complex, translation: Numbers
) -> Numbers:
    """The translation of E^t for E with that translation and the rotation of the quaternion (scalar, vector).

    ``cosine`` and ``ratio`` times ``vector`` are the quaternion's power. Along the axis the translation grows by the
    factor t. In the plane across it, seen as complex with theta the angle, by

        (e^(i t theta) - 1) / (e^(i theta) - 1) = sin(t theta/2) / sin(theta/2) e^(i (t - 1) theta/2).
    """
    square = dot(vector, vector)
    along = multiply(ratio, multiply_add(cosine, scalar, multiply(ratio, square)))
    across = multiply(ratio, subtract(multiply(ratio, scalar), cosine))
    axial = 0j
    if square.real > NO_TURN:
        axial = divide(multiply(subtract(complex(t, 0.0), along), dot(vector, translation)), square)
    side = cross(vector, translation)
    result = np.empty(3, dtype=np.complex128)
    for i in range(len(result)):
        inner = multiply_add(along, translation[i], multiply(axial, vector[i]))
        result[i] = multiply_add(across, side[i], inner)
    return result
