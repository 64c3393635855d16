"""Linear maps of the plane and of space by their eigenvalues: where these meet, reach 1, or come to the negative axis.

Most are made of the 2x2 block [[r, p], [q, r]], whose eigenvalues are r +- sqrt(p q). It is told exactly by three
floats whatever their sizes: a complex pair for p q < 0, a double eigenvalue for p q = 0, defective if p or q is not 0.
In space a third eigenvalue joins it, and couplings to it. An oblique frame mixes all entries, without rounding as long
as they have few bits and none is below 1e-9; blocks with tinier ones stay as they are.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.catalogue import turns
from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.sampling import any_rotation, eighths, oblique, off_by_ulps, permuted, short, signed, well_conditioned

Linear = tuple[Array, float]
"""A linear map, (2, 2) or (3, 3), and its distance to what makes it difficult."""


@dataclass(frozen=True)
class Spectrum:
    """What a regime draws its linear maps from, given the dimension, 2 or 3.

    ``exact`` says that rounding would change the kind: the eigenvalues are what they are by their last bits.
    """

    name: str
    distance: str
    build: Callable[[Draw, int], Linear]
    exact: bool = False
    share: float = 1.0


def _block(r: float, p: float, q: float) -> Array:
    return np.array([[r, p], [q, r]])


def _in_space(draw: Draw, block: Array, third: float) -> Array:
    """The block with a third eigenvalue, coupled or not, in any order of the coordinates."""
    matrix = np.zeros((3, 3))
    matrix[:2, :2] = block
    matrix[:2, 2] = [eighths(draw, -8, 8) * draw.choice((1.0, 0.0)) for _ in range(2)]
    matrix[2, 2] = third
    return permuted(draw, matrix)


def _third(draw: Draw) -> float:
    """A positive eigenvalue that is no multiple of 1/8: never equal to that of a block."""
    return eighths(draw, 3, 16) + 0.0625


def _completed(draw: Draw, size: int, block: Array, mixed: bool) -> Array:
    """The block, alone or with a third eigenvalue, in an oblique frame if ``mixed``."""
    matrix = block if size == 2 else _in_space(draw, block, _third(draw))
    return oblique(draw, matrix) if mixed else matrix


def _pair(draw: Draw, size: int, sign: float, product_sign: float, floor: float) -> Linear:
    """A block with these signs of r and of p q, and q down to 10**floor; the distance is sqrt |p q| / |r|."""
    mixed = draw.choice((True, False))
    r, p = sign * eighths(draw, 4, 16), draw.choice((1.0, -1.0)) * eighths(draw, 1, 16)
    # At most 0.09, so that |p q| < r^2: two real eigenvalues have the sign of r.
    q = math.copysign(short(draw.exponent(-9 if mixed else floor, -1.1)), p * product_sign)
    block = _block(r, *draw.choice(((p, q), (q, p))))
    return _completed(draw, size, block, mixed), math.sqrt(abs(p * q)) / abs(r)


def _real_or_complex_pair(draw: Draw, size: int) -> Linear:
    return _pair(draw, size, 1.0, draw.choice((1.0, -1.0)), -300)


def _complex_negative_pair(draw: Draw, size: int) -> Linear:
    # The distance is down to 1e-16, for the logarithm is known no nearer to where it ends.
    return _pair(draw, size, -1.0, -1.0, -31)


def _real_negative_pair(draw: Draw, size: int) -> Linear:
    return _pair(draw, size, -1.0, 1.0, -300)


def _negative_pair(draw: Draw, size: int) -> Linear:
    return _pair(draw, size, -1.0, draw.choice((1.0, -1.0)), -300)


def _near_minus_one(draw: Draw, size: int) -> Linear:
    mixed = draw.choice((True, False))
    r, gap = -eighths(draw, 4, 16), short(draw.exponent(-8 if mixed else -16, -0.5))
    p, q = gap * eighths(draw, 4, 8), -gap * eighths(draw, 4, 8)
    block = _block(r, *draw.choice(((p, q), (q, p))))
    return _completed(draw, size, block, mixed), gap


def _minus_one(draw: Draw, size: int) -> Linear:
    r, scale = -eighths(draw, 4, 16), draw.choice(range(-400, 401))
    matrix = _completed(draw, size, _block(r, 0.0, 0.0), mixed=True)
    return np.ldexp(matrix, scale), math.ldexp(-r, scale)


def _generic(draw: Draw, size: int) -> Linear:
    """A complex pair or two positive eigenvalues, well apart, in a well-conditioned frame."""
    middle, gap = draw.uniform(0.5, 2.0), draw.uniform(0.1, 0.4)
    angle = draw.uniform(0.1, 2.8)
    real = np.diag([middle - gap, middle + gap])
    turned = middle * np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    matrix = np.diag([draw.uniform(0.2, 3.0)] * size)
    matrix[:2, :2] = draw.choice((real, turned))
    frame = well_conditioned(draw, size)
    return frame @ matrix @ np.linalg.inv(frame), gap


def _near_identity(draw: Draw, size: int) -> Linear:
    # Within 0.4 of 1, no eigenvalue is negative.
    gap = draw.exponent(-16, -0.5)
    return np.eye(size) + gap * draw.direction(size * size).reshape(size, size), gap


def _small_step(draw: Draw, size: int) -> Linear:
    # Rounding of 1 + gap w moves gap w by u, too little to make it singular.
    gap = draw.exponent(-12, -1)
    return np.eye(size) + gap * well_conditioned(draw, size), gap


def _identity(_: Draw, size: int) -> Linear:
    return np.eye(size), 1.0


def _defective(draw: Draw, size: int) -> Linear:
    """A double, in space perhaps a triple positive eigenvalue with one eigenvector."""
    mixed = draw.choice((True, False))
    r, p = eighths(draw, 4, 16), short(signed(draw, -9 if mixed else -300, 0))
    block = _block(r, *draw.choice(((p, 0.0), (0.0, p))))
    matrix = block if size == 2 else _in_space(draw, block, draw.choice((r, _third(draw))))
    return oblique(draw, matrix) if mixed else matrix, abs(p)


def _rounded_defective(draw: Draw, size: int) -> Linear:
    """A double positive eigenvalue with one eigenvector, before rounding in a well-conditioned frame."""
    r, p = draw.uniform(0.5, 2.0), draw.exponent(-8, 0)
    block = _block(r, p, 0.0)
    matrix = block if size == 2 else _in_space(draw, block, draw.choice((r, draw.uniform(0.5, 2.0))))
    frame = well_conditioned(draw, size)
    return frame @ matrix @ np.linalg.inv(frame), p


def _double(draw: Draw, size: int) -> Linear:
    """A double positive eigenvalue with two eigenvectors."""
    r = eighths(draw, 4, 16)
    return _completed(draw, size, _block(r, 0.0, 0.0), mixed=True), abs(r - 1) or 1.0


def _unit(draw: Draw, size: int) -> Linear:
    """The eigenvalue 1 exactly: simple, double with one eigenvector, or in space double with two."""
    half = draw.choice((1.0, -1.0)) * eighths(draw, 1, 3)
    # [[r, h], [h, r]] has the eigenvalues r + h and r - h; with r = 1 - h one of them is 1, the other positive.
    simple = _block(1 - half, half, half)
    shear = _block(1.0, 8 * half, 0.0)
    blocks = (simple, shear) if size == 2 else (simple, shear, np.eye(2))
    return _completed(draw, size, draw.choice(blocks), mixed=True), abs(2 * half)


def _off_unit(draw: Draw, size: int) -> Linear:
    """A map that lengthens every vector, or shortens every one: no eigenvalue is 1."""
    factor = draw.choice((2.0 + draw.exponent(-3, 3), 0.5 / (1 + draw.exponent(-3, 3))))
    return factor * well_conditioned(draw, size), abs(factor - 1)


def _no_fixed_point(draw: Draw, size: int) -> Linear:
    """The eigenvalue 1, as above or three times: then every point is fixed, or none."""
    return draw.choice((_unit, _identity))(draw, size)


def _near_unit(draw: Draw, size: int) -> Linear:
    """An eigenvalue next to 1, above or below it by a few of its last places at least."""
    gap = signed(draw, -15, -1)
    matrix = np.triu(np.array([[eighths(draw, -8, 8) for _ in range(size)] for _ in range(size)]))
    np.fill_diagonal(matrix, [1 + gap, *(_third(draw) for _ in range(size - 1))])
    return permuted(draw, matrix), abs(gap)


def _rotation(draw: Draw, size: int) -> Linear:
    """A rotation by an angle next to 0 or to pi; in space not nearer to pi than rounding leaves the pair complex."""
    near_pi = draw.choice((True, False))
    gap = draw.exponent((-16 if size == 2 else -13) if near_pi else -100, 0)
    if size == 3:
        return (turns.short_of_pi if near_pi else turns.about)(draw.direction(3), gap, gap).matrix, gap
    cosine = -math.cos(gap) if near_pi else math.cos(gap)
    sine = draw.choice((1.0, -1.0)) * math.sin(gap)
    return np.array([[cosine, -sine], [sine, cosine]]), gap


def _similarity(draw: Draw, size: int) -> Linear:
    """A rotation by any angle but pi and its neighbourhood, times a scale other than 1."""
    # 10^(+-10^2.17) is 1e148 and 1e-148.
    scale, angle = 10.0 ** signed(draw, -1, 2.17), draw.uniform(0.0, 3.0)
    if size == 3:
        return scale * turns.about(draw.direction(3), angle, angle).matrix, scale
    cosine, sine = math.cos(angle), draw.choice((1.0, -1.0)) * math.sin(angle)
    return scale * np.array([[cosine, -sine], [sine, cosine]]), scale


def _huge_or_tiny(draw: Draw, size: int) -> Linear:
    # A power of two scales without rounding; 2^460 is 3e138.
    build = draw.choice((_generic, _real_or_complex_pair, _defective, _complex_negative_pair))
    exponent = draw.choice(range(-460, 461))
    return np.ldexp(build(draw, size)[0], exponent), 2.0**exponent


def _spread(draw: Draw, size: int) -> Linear:
    """Positive eigenvalues of very different sizes, told exactly by a triangular matrix."""
    sizes = [10.0 ** signed(draw, -1, 2) for _ in range(size)]
    pairs = [(i, j) for i in range(size) for j in range(i + 1, size)]
    matrix = np.diag(sizes)
    for i, j in pairs:
        matrix[i, j] = draw.uniform(-1, 1) * draw.choice((min, max))(sizes[i], sizes[j])
    return permuted(draw, matrix), min(sizes) / max(sizes)


def _any(draw: Draw, size: int) -> Linear:
    """A linear map of positive determinant, whether it has a logarithm or not."""
    thinness = draw.exponent(-6, 0)
    values = np.diag([thinness, *(draw.uniform(0.5, 2.0) for _ in range(size - 1))])
    return any_rotation(draw, size) @ values @ any_rotation(draw, size), thinness


def _negative_defective(draw: Draw, size: int) -> Linear:
    mixed = draw.choice((True, False))
    r, p = -eighths(draw, 4, 16), short(signed(draw, -9 if mixed else -300, 0))
    return _completed(draw, size, _block(r, *draw.choice(((p, 0.0), (0.0, p)))), mixed), abs(p)


def _no_logarithm(draw: Draw, size: int) -> Linear:
    """Two negative eigenvalues, or a double one with one eigenvector."""
    return draw.choice((_real_negative_pair, _negative_defective))(draw, size)


def _last_bits(draw: Draw, size: int) -> Linear:
    """A double negative eigenvalue, with one eigenvector or two, after a change of last bits."""
    matrix, distance = draw.choice((_minus_one, _negative_defective))(draw, size)
    return off_by_ulps(draw, matrix, 1), distance


def _not_oriented(draw: Draw, size: int) -> Linear:
    """A map that reflects or projects."""
    matrix, distance = _generic(draw, size)
    matrix[draw.choice(range(size))] *= draw.choice((-1.0, 0.0))
    return matrix, distance


GENERIC = Spectrum("generic", "gap of two eigenvalues", _generic)
ANY = Spectrum("generic", "smallest singular value", _any)
NEAR_IDENTITY = Spectrum("near-identity", "distance from the identity", _near_identity)
SMALL_STEP = Spectrum("near-identity", "distance from the identity", _small_step)
PURE_TRANSLATION = Spectrum("pure-translation", "none", _identity, exact=True)
UNIT_EIGENVALUE = Spectrum("unit-eigenvalue", "gap to another eigenvalue, or off-diagonal part", _unit, exact=True)
NEAR_UNIT_EIGENVALUE = Spectrum("near-unit-eigenvalue", "|eigenvalue - 1|", _near_unit, exact=True)
COALESCING = Spectrum("coalescing", "relative gap of two eigenvalues", _real_or_complex_pair, exact=True)
DEFECTIVE = Spectrum("defective", "off-diagonal part", _defective, exact=True)
ROUNDED_DEFECTIVE = Spectrum("off-manifold", "off-diagonal part", _rounded_defective)
DOUBLE_EIGENVALUE = Spectrum("double-eigenvalue", "|eigenvalue - 1|", _double, exact=True)
ROTATION = Spectrum("rotation", "distance of the angle from 0 or pi", _rotation, exact=True)
SIMILARITY = Spectrum("similarity", "scale", _similarity)
HUGE_OR_TINY = Spectrum("huge-or-tiny", "scale", _huge_or_tiny, exact=True)
SPREAD = Spectrum("spread", "ratio of the eigenvalues", _spread, exact=True)
BOUNDARY = Spectrum("boundary", "relative distance of a pair to the negative axis", _complex_negative_pair, exact=True)
NEAR_MINUS_ONE = Spectrum("near-minus-identity", "distance of a pair to the negative axis", _near_minus_one, exact=True)
MINUS_ONE = Spectrum("minus-identity", "scale", _minus_one, exact=True)
NEGATIVE_PAIR = Spectrum("negative-pair", "relative distance of two eigenvalues", _negative_pair, exact=True)
NEGATIVE_DEFECTIVE = Spectrum("negative-defective", "off-diagonal part", _negative_defective, exact=True)
LAST_BITS = Spectrum("last-bits", "off-diagonal part, or scale", _last_bits, exact=True)
NO_LOGARITHM = Spectrum("no-logarithm", "relative gap of two eigenvalues", _no_logarithm, exact=True, share=0.5)
OFF_UNIT = Spectrum("generic", "distance from the isometries", _off_unit)
NO_FIXED_POINT = Spectrum("no-fixed-point", "gap to another eigenvalue", _no_fixed_point, exact=True, share=0.5)
NOT_ORIENTED = Spectrum("outside", "gap of two eigenvalues", _not_oriented, share=0.25)
