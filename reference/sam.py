"""Steady affine motions: logarithm and powers of affine maps of the plane and of space (Rossignac and Vinacua).

A homogeneous matrix [[L, t], [0, 1]] has the eigenvalues of L and 1, and a function f of it is [[f(L), g(L) t],
[0, f(1)]] with g(x) = f[1, x], which is smooth at 1: eigenvalues 1 of L, simple, double or defective, need no case of
their own. n is 3 in the plane and 4 in space.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from affinecert.errors import InputError
from affinecert.reference import _domain
from affinecert.reference._exact import Integers, adjugate, determinant, float_integers, integers
from affinecert.reference._existence import Logarithm, logarithm
from affinecert.reference._functions import Function, quotient, turned_logarithm
from affinecert.reference._functions import exponential as scalar_exponential
from affinecert.reference._functions import logarithm as scalar_logarithm
from affinecert.reference._functions import power as scalar_power
from affinecert.reference._matrices import Array, Context, array, homogeneous, identity, tangent
from affinecert.reference._precision import closeness, span
from affinecert.reference._spectrum import Linear, apply, exactly, extra_bits, interpolate, ratio


def exists(ctx: Context, affine: Array) -> bool:
    """Whether an affine map has a real logarithm, (n, n) -> bool, decided exactly.

    It has one if L has no negative eigenvalue, or a double one with two independent eigenvectors (Culver; section 5.1).
    Raises InputError if the last row is not 0 ... 0 1 or det L is not positive.
    """
    _domain.affine(ctx, "affine", affine)
    return _exists(integers(affine[:-1, :-1])[0])


def exists_exactly(linear: Sequence[Sequence[float]]) -> bool:
    """`exists` for the linear part alone as float64, (2, 2) or (3, 3), much faster."""
    numerators = float_integers(linear)
    if determinant(numerators) <= 0:
        raise InputError("affine", "determinant of the linear part is not positive")
    return _exists(numerators)


def log(ctx: Context, affine: Array) -> Array:
    """The real logarithm of a homogeneous matrix, (n, n) -> (n, n) with last row zero.

    Principal, with eigenvalues of imaginary part within (-pi, pi). At a half turn, a double eigenvalue -s with two
    eigenvectors, it is log s + pi J on their plane: in 2D J = [[0, -1], [1, 0]]; in 3D J = [n]x, n the unit normal of
    that plane whose first non-zero component is positive. Raises InputError if the last row is not 0 ... 0 1, det L is
    not positive or there is no real logarithm.
    """
    _domain.affine(ctx, "affine", affine)
    return tangent(ctx, *_function(ctx, "affine", exactly(affine[:-1, :-1]), affine[:-1, -1], scalar_logarithm(ctx)))


def logarithms(ctx: Context, name: str, affine: Array) -> Iterator[Array]:
    """`log`, and then, of what turns by an angle of nearly pi, the logarithm on the other side of pi."""
    _domain.affine(ctx, name, affine)
    for f in (scalar_logarithm(ctx), turned_logarithm(ctx)):
        yield tangent(ctx, *_function(ctx, name, exactly(affine[:-1, :-1]), affine[:-1, -1], f))


def exponential(ctx: Context, logarithm: Array) -> Array:
    """The affine map exp [[X, v], [0, 0]], (n, n) -> (n, n): its linear part exp X, its translation exp[0, X] v."""
    f, vector = scalar_exponential(ctx), logarithm[:-1, -1]
    tasks = (f, identity(ctx, len(vector))), (quotient(ctx, f, 0), vector)
    return homogeneous(ctx, *interpolate(ctx, exactly(logarithm[:-1, :-1]), *tasks))


def power(ctx: Context, affine: Array, t: Array) -> Array:
    """A^t = exp(t log A), (n, n), () -> (n, n), for any real t; the logarithm and the errors are those of `log`."""
    _domain.affine(ctx, "affine", affine)
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(span(t)):
        f = scalar_power(ctx, t[()])
        return homogeneous(ctx, *_function(ctx, "affine", exactly(affine[:-1, :-1]), affine[:-1, -1], f))


def morph(ctx: Context, start: Array, end: Array, t: Array) -> Array:
    """The steady affine morph A^t B, A = C B^-1, from B (start) to C (end), (n, n), (n, n), () -> (n, n); any real t.

    Raises InputError as `log` does, for B, C and A.
    """
    _domain.affine(ctx, "start", start)
    _domain.affine(ctx, "end", end)
    _domain.finite(ctx, "t", t)
    linear = ratio(end[:-1, :-1], start[:-1, :-1])
    with ctx.extraprec(span(t) + extra_bits(linear)):
        origin = start[:-1, -1]
        translation = end[:-1, -1] - linear.numbers(ctx) @ origin
        turned, moved = _function(ctx, "end", linear, translation, scalar_power(ctx, t[()]))
        return homogeneous(ctx, turned @ start[:-1, :-1], turned @ origin + moved)


def fixed_point(ctx: Context, affine: Array) -> Array:
    """The fixed point q = L q + t of an affine map, (n, n) -> (n - 1,).

    Raises InputError if 1 is an eigenvalue of L, besides the errors of `exists`.
    """
    _domain.affine(ctx, "affine", affine)
    size = len(affine) - 1
    with ctx.extraprec(2 * span(affine)):
        numerators, exponent = integers(identity(ctx, size) - affine[:-1, :-1])
        divisor = determinant(numerators)
        if divisor == 0:
            raise InputError("affine", "no single fixed point: the determinant of L - I is zero")
        with ctx.extraprec(extra_bits(Linear(numerators, 1, exponent))):
            numbers = array([[ctx.mpf(x) for x in row] for row in adjugate(numerators)])
            point: Array = numbers @ affine[:-1, -1] * ctx.ldexp(ctx.one / divisor, -exponent)
            return point


def velocity(ctx: Context, affine: Array, point: Array) -> Array:
    """The velocity log(L) p + v, log A = [[log L, v], [0, 0]], at the point p of the motion A^t, (n, n), (n - 1,).

    Steady: the same at all times (section 6). Raises InputError as `log` does.
    """
    _domain.finite(ctx, "point", point)
    matrix = log(ctx, affine)
    rate: Array = matrix[:-1, :-1] @ point + matrix[:-1, -1]
    return rate


def _exists(numerators: Integers) -> bool:
    return logarithm(numerators) is not Logarithm.NONE


def _function(ctx: Context, name: str, linear: Linear, translation: Array, f: Function) -> tuple[Array, Array]:
    """f(L) and f[1, L] t for a linear part with a real logarithm; refuses others."""
    if not _exists(linear.numerators):
        raise InputError(name, "no real logarithm: a negative eigenvalue without a second of two eigenvectors")
    unit = identity(ctx, len(translation))
    # Next to the identity log L is as small as L - I.
    nearness = closeness(max(abs(x) for x in (linear.numbers(ctx) - unit).flat), ctx.one)
    with ctx.extraprec(extra_bits(linear) + nearness):
        matrix, vector = apply(ctx, linear, (f, unit), (quotient(ctx, f), translation))
        return matrix, vector
