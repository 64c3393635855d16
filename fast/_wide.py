"""Maps made of several steps, computed in double-double throughout and rounded once: the arithmetic and the matrices.

A map such as "the polar factors of this, the logarithm of one of them, a multiple, the exponential" loses bits in every
step, and more where one step magnifies the errors of the one before. With 106 bits in between, what is left of them
after the last rounding is that rounding. So such a map is written like this:

    pose = wide.widen(checked float64 input)            # pairs, with low parts 0
    ... functions of pairs, on whole batches ...
    return wide.rounded(result)                         # float64 again

A number is a pair (high, low), its value high + low, high being the value rounded. Pairs are the last axis of float64
arrays: numbers are (..., 2), vectors (..., d, 2), matrices (..., k, l, 2), homogeneous ones (..., d + 1, d + 1, 2) for
d = 2 or 3, with any leading batch; everything broadcasts, and an item has the same bits alone as in a batch. To negate
pairs, or to multiply them by a power of two, is plain NumPy. But for `_wide_rotation.require_rotation` nothing checks
or refuses: the functions that users call do.

This module has the elementwise functions (the arithmetic in NumPy, which compiles nothing; the others as kernels), and
products and inverses of matrices. `_wide_rotation` has rotations, their logarithms, exponentials and powers, and
`_wide_affine` the same for affine maps. Inside of kernels a double-double is a complex number, and the functions are
those of `_double_double`, `_elementary` and `_numbers`.

Elementwise results are within 2^-102 of themselves, also next to their zeros, as far as the pairs given tell them;
products of matrices are within 2^-101 of the product of their norms, inverses within 2^-100 of |A^-1|^2 |A|. Numbers
may be between 1e-140 and 1e140 in size; beyond, low parts or products leave the range of float64.

Source of the arithmetic: see `affinecert.fast._double_double`.
"""

from __future__ import annotations

import numpy as np

from affinecert.fast import _elementary, _exact
from affinecert.fast._double_double import multiply_add
from affinecert.fast._inverse import homogeneous_inverse
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._numbers import Numbers, numbers, store
from affinecert.fast._stages import run

NUMBER = (2,)

# Splits a float64 in two halves, whose products are exact (Veltkamp, Dekker).
SPLITTER = 2.0**27 + 1.0


def widen(x: Array) -> Array:
    """Pairs of numbers as they stand, (...) -> (..., 2)."""
    return np.stack([x, np.zeros_like(x)], axis=-1)


def rounded(w: Array) -> Array:
    """The numbers rounded to float64, (..., 2) -> (...)."""
    return w[..., 0].copy()


def _sum(x: Array, y: Array) -> tuple[Array, Array]:
    high = x + y
    part = high - x
    return high, (x - (high - part)) + (y - part)


def _product(x: Array, y: Array) -> tuple[Array, Array]:
    """The product exactly, without a fused multiplication, which NumPy has not (Dekker 1971)."""
    high = x * y
    x_part, y_part = SPLITTER * x, SPLITTER * y
    x_high, y_high = x_part - (x_part - x), y_part - (y_part - y)
    x_low, y_low = x - x_high, y - y_high
    return high, x_low * y_low - (((high - x_high * y_high) - x_low * y_high) - x_high * y_low)


def _pair(high: Array, low: Array) -> Array:
    """The pair of a sum whose second term is the smaller one."""
    total = high + low
    return np.stack([total, low - (total - high)], axis=-1)


@np.errstate(all="ignore")
def add(a: Array, b: Array) -> Array:
    """The sum a + b."""
    high, low = _sum(a[..., 0], b[..., 0])
    tail, rest = _sum(a[..., 1], b[..., 1])
    total = _pair(high, low + tail)
    return _pair(total[..., 0], total[..., 1] + rest)


def subtract(a: Array, b: Array) -> Array:
    """The difference a - b."""
    return add(a, -b)


@np.errstate(all="ignore")
def multiply(a: Array, b: Array) -> Array:
    """The product a b."""
    high, low = _product(a[..., 0], b[..., 0])
    return _pair(high, low + (a[..., 0] * b[..., 1] + a[..., 1] * b[..., 0]))


@np.errstate(all="ignore")
def times(a: Array, x: Array | float) -> Array:
    """The product of pairs a and float64 numbers x, (..., 2) and (...)."""
    factor = np.asarray(x, dtype=np.float64)
    high, low = _product(a[..., 0], factor)
    return _pair(high, low + a[..., 1] * factor)


@np.errstate(all="ignore")
def divide(a: Array, b: Array) -> Array:
    """The quotient a / b."""
    first = a[..., 0] / b[..., 0]
    rest = subtract(a, times(b, first))
    return _pair(first, rest[..., 0] / b[..., 0])


@np.errstate(all="ignore")
def square_root(a: Array) -> Array:
    """The square root; 0 for numbers that are not positive."""
    positive = a[..., 0] > 0.0
    value = np.where(positive, a[..., 0], 1.0)
    root = np.sqrt(value)
    square, low = _product(root, root)
    correction = (((value - square) - low) + a[..., 1]) / (2.0 * root)
    return np.where(positive[..., None], _pair(root, correction), 0.0)


@compiled
def _number(pair: Array) -> complex:
    return complex(pair[0], pair[1])


@kernel(inputs={"x": NUMBER}, outputs=(NUMBER,))
def _exponential(x: Array, power: Array, _status: Array) -> None:
    value = _elementary.exponential(_number(x))
    power[0], power[1] = value.real, value.imag


def exponential(x: Array) -> Array:
    """The numbers e^x."""
    return run(_exponential, x)[0]


@kernel(inputs={"x": NUMBER}, outputs=(NUMBER,))
def _logarithm(x: Array, exponent: Array, _status: Array) -> None:
    value = _elementary.logarithm(_number(x))
    exponent[0], exponent[1] = value.real, value.imag


def logarithm(x: Array) -> Array:
    """The natural logarithms; minus infinity at 0, nan below."""
    return run(_logarithm, x)[0]


@kernel(inputs={"angle": NUMBER}, outputs=(NUMBER, NUMBER))
def _sine_cosine(angle: Array, sine: Array, cosine: Array, _status: Array) -> None:
    first, second = _elementary.sine_cosine(_number(angle))
    sine[0], sine[1] = first.real, first.imag
    cosine[0], cosine[1] = second.real, second.imag


def sine_cosine(angle: Array) -> tuple[Array, Array]:
    """The sines and the cosines of angles in radians, up to 2^52 in size."""
    sine, cosine = run(_sine_cosine, angle)
    return sine, cosine


@kernel(inputs={"y": NUMBER, "x": NUMBER}, outputs=(NUMBER,))
def _arctangent2(y: Array, x: Array, angle: Array, _status: Array) -> None:
    value = _elementary.arctangent2(_number(y), _number(x))
    angle[0], angle[1] = value.real, value.imag


def arctangent2(y: Array, x: Array) -> Array:
    """The angles of the points (x, y), in (-pi, pi]; 0 at the origin, pi at y = -0."""
    return run(_arctangent2, y, x)[0]


@compiled
def matrix_product(a: Numbers, b: Numbers) -> Numbers:
    """The product of two matrices."""
    result = np.zeros((a.shape[0], b.shape[1]), dtype=np.complex128)
    for i in range(a.shape[0]):
        for j in range(b.shape[1]):
            for k in range(b.shape[0]):
                result[i, j] = multiply_add(a[i, k], b[k, j], result[i, j])
    return result


@kernel(inputs={"a": ("k", "l", 2), "b": ("l", "m", 2)}, outputs=(("k", "m", 2),))
def _matrix_product(a: Array, b: Array, result: Array, _status: Array) -> None:
    store(matrix_product(numbers(a), numbers(b)), result)


def product(a: Array, b: Array) -> Array:
    """The matrices a b, (..., k, l, 2) and (..., l, m, 2)."""
    return run(_matrix_product, a, b)[0]


def image(a: Array, x: Array) -> Array:
    """The vectors a x, (..., k, l, 2) and (..., l, 2); or the images of points (..., l - 1, 2), a being homogeneous."""
    if x.shape[-2] == a.shape[-2]:
        return product(a, x[..., None, :])[..., 0, :]
    return add(product(linear_part(a), x[..., None, :])[..., 0, :], translation(a))


def transposed(a: Array) -> Array:
    """The transposed matrices."""
    return np.swapaxes(a, -3, -2)


@kernel(inputs={"a": ("n", "n", 2)}, outputs=(("n", "n", 2), ()))
def _inverse(a: Array, inverse: Array, sign: Array, _status: Array) -> None:
    """The inverse, and the sign of the determinant, 0 if not sure."""
    result, sign[0] = homogeneous_inverse(numbers(a))
    store(result, inverse)


def inverse(a: Array) -> Array:
    """The inverse matrices, (..., n, n, 2): linear ones of the plane and of space, and homogeneous ones.

    The last row of a homogeneous inverse is exactly 0 ... 0 1. Not finite where a matrix is singular.
    """
    return run(_inverse, a)[0]


def right_quotient(c: Array, b: Array) -> Array:
    """The quotients C B^-1."""
    return product(c, inverse(b))


def left_quotient(b: Array, c: Array) -> Array:
    """The quotients B^-1 C."""
    return product(inverse(b), c)


def _exact_sign(a: Array) -> float:
    """The sign of the determinant of a linear matrix of pairs, (d, d, 2), in integers."""
    determinant = _exact.determinant(_exact.integers_of_sum(a[..., 0], a[..., 1]))
    return float((determinant > 0) - (determinant < 0))


def determinant_sign(a: Array) -> Array:
    """The signs of the determinants, -1, 0 or 1: always right for the pairs given, decided in integers where need be.

    Matrices (..., n, n, 2) as of `inverse`; the determinant is that of the linear part of a homogeneous one.
    """
    sign = run(_inverse, a)[1]
    linear = linear_part(a) if a.shape[-2] == 4 else a
    for index in map(tuple, np.argwhere(sign == 0.0)):
        sign[index] = _exact_sign(linear[index])
    return sign


def homogeneous(linear: Array, translation: Array) -> Array:
    """The homogeneous matrices of linear parts (..., d, d, 2) and translations (..., d, 2), (..., d + 1, d + 1, 2)."""
    matrix = tangent(linear, translation)
    matrix[..., -1, -1, 0] = 1.0
    return matrix


def tangent(linear: Array, translation: Array) -> Array:
    """The same with a last row of zeros: derivatives and logarithms of homogeneous matrices."""
    size = translation.shape[-2]
    batch = np.broadcast_shapes(linear.shape[:-3], translation.shape[:-2])
    matrix = np.zeros((*batch, size + 1, size + 1, 2))
    matrix[..., :-1, :-1, :] = linear
    matrix[..., :-1, -1, :] = translation
    return matrix


def linear_part(a: Array) -> Array:
    """The linear parts of homogeneous matrices."""
    return a[..., :-1, :-1, :]


def translation(a: Array) -> Array:
    """The translations of homogeneous matrices."""
    return a[..., :-1, -1, :]
