"""Functions of real 2x2 and 3x3 matrices of positive determinant, by interpolation at their eigenvalues.

The matrix comes exactly, so its characteristic polynomial is exact, and the eigenvalues are wanted only as nodes. Two
of them form a pair a +- sqrt(-b2): complex for b2 > 0, real for b2 < 0, equal for b2 = 0. In space the third, r away
from the mean of the pair, is the real one furthest from the mean of all. In Newton's form with M = L - a,

    f(L) = alpha + beta M + gamma (M^2 + b2),

where alpha + beta (x - a) interpolates f at the pair, and gamma is the second divided difference.
"""

from __future__ import annotations

from dataclasses import dataclass

from affinecert.reference._exact import Integers, adjugate, determinant, integers, product
from affinecert.reference._existence import Logarithm, characteristic, double_root, logarithm
from affinecert.reference._functions import Function
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, norm
from affinecert.reference._precision import closeness


@dataclass(frozen=True)
class Linear:
    """The matrix ``numerators`` 2**``exponent`` / ``denominator`` exactly; the denominator is positive."""

    numerators: Integers
    denominator: int
    exponent: int

    def numbers(self, ctx: Context) -> Array:
        """The matrix in the context's numbers."""
        unit = self.unit(ctx)
        return array([[ctx.mpf(x) * unit for x in row] for row in self.numerators])

    def unit(self, ctx: Context) -> Number:
        """What the numerators are multiples of."""
        return ctx.ldexp(ctx.one / self.denominator, self.exponent)


def exactly(matrix: Array) -> Linear:
    """A matrix of mpf, exactly."""
    numerators, exponent = integers(matrix)
    return Linear(numerators, 1, exponent)


def ratio(matrix: Array, by: Array) -> Linear:
    """The quotient C B^-1 of two matrices of mpf, det B > 0, exactly."""
    c, c_exponent = integers(matrix)
    b, b_exponent = integers(by)
    return Linear(product(c, adjugate(b)), determinant(b), c_exponent - b_exponent)


@dataclass(frozen=True)
class Nodes:
    """The eigenvalues a +- sqrt(-b2) and, in space, a + r; ``w`` is r^2 + b2."""

    a: Number
    b2: Number
    r: Number | None = None
    w: Number | None = None


def nodes(ctx: Context, linear: Linear) -> Nodes:
    """The eigenvalues of a matrix; b2, r and w each to the context's relative precision, and a if nothing cancels."""
    unit = linear.unit(ctx)
    if len(linear.numerators) == 2:
        trace, det = characteristic(linear.numerators)
        return Nodes(ctx.mpf(trace) / 2 * unit, ctx.mpf(4 * det - trace * trace) / 4 * unit**2)
    c2, c1, c0 = characteristic(linear.numerators)
    # With y = 3 x - c2 the characteristic polynomial x^3 - c2 x^2 + c1 x - c0 becomes (y^3 + p y + q) / 27.
    p, q = 9 * c1 - 3 * c2 * c2, 9 * c1 * c2 - 2 * c2**3 - 27 * c0
    y = _outermost_root(ctx, p, q)
    slope = 3 * y * y + p  # the product of the distances of y to the pair
    # The discriminant, known exactly, is -4 b2 slope^2: so b2 is exact where 3/4 y^2 + p would cancel.
    b2 = ctx.mpf(4 * p**3 + 27 * q * q) / (4 * slope * slope) if slope else ctx.zero
    return Nodes((c2 - y / 2) / 3 * unit, b2 / 9 * unit**2, y / 2 * unit, slope / 9 * unit**2)


def _outermost_root(ctx: Context, p: int, q: int) -> Number:
    """The real root of y^3 + p y + q of the largest modulus, which is simple unless 0 is triple.

    It has the sign of -q. For q < 0 it lies below both max(sqrt(2|p|), cbrt(2|q|)) and, if p > 0, -q / p; above it the
    cubic rises and is convex, so that Newton's steps from there come down to it.
    """
    if q == 0:
        return ctx.sqrt(ctx.mpf(-p)) if p < 0 else ctx.zero
    slope, value = ctx.mpf(p), ctx.mpf(-abs(q))
    y = ctx.ldexp(ctx.one, max((p.bit_length() + 2) // 2, (q.bit_length() + 3) // 3))
    if p > 0:
        y = min(y, -value / slope)
    while True:
        square = y * y
        step = ((square + slope) * y + value) / (3 * square + slope)
        y -= step
        if step <= ctx.ldexp(y, 4 - ctx.prec):
            return y if q < 0 else -y


def extra_bits(linear: Linear) -> int:
    """Bits that eigenvalues and the Newton form may cancel: what the determinant falls short of the entries' power.

    For the eigenvalues are at most three times the largest entry, and their product is the determinant.
    """
    largest = max(abs(x) for row in linear.numerators for x in row).bit_length()
    size = len(linear.numerators)
    return size * largest - int(determinant(linear.numerators)).bit_length() + 16


def apply(ctx: Context, linear: Linear, *tasks: tuple[Function, Array]) -> list[Array]:
    """The products f(L) X, X a vector or a matrix, of a matrix with a real logarithm.

    f is real on the positive reals. At a double negative eigenvalue -s of two eigenvectors, a half turn, f(L) is
    Re f(-s) + Im f(-s) J on their plane, J a quarter turn in it.
    """
    if logarithm(linear.numerators) is Logarithm.HALF_TURN:
        return [_half_turn(ctx, linear, f, operand) for f, operand in tasks]
    return interpolate(ctx, linear, *tasks)


def interpolate(ctx: Context, linear: Linear, *tasks: tuple[Function, Array]) -> list[Array]:
    """The products f(L) X, X a vector or a matrix, of any matrix, for f that are real on its real eigenvalues."""
    with ctx.workprec(64):
        rough = nodes(ctx, linear)
        size = rough.a * rough.a + abs(rough.b2)
        lost = closeness(rough.b2, size) + (closeness(rough.w, size) if rough.w is not None else 0)
    with ctx.extraprec(lost):
        matrix, at = linear.numbers(ctx), nodes(ctx, linear)
        terms = {id(operand): _newton_terms(matrix, at, operand) for _, operand in tasks}
        return [_newton_form(ctx, at, f, terms[id(operand)]) for f, operand in tasks]


def _newton_terms(matrix: Array, at: Nodes, operand: Array) -> tuple[Array, ...]:
    """X, M X and, in space, (M^2 + b2) X."""
    once = matrix @ operand - operand * at.a
    if at.r is None:
        return operand, once
    return operand, once, matrix @ once - once * at.a + operand * at.b2


def _newton_form(ctx: Context, at: Nodes, f: Function, terms: tuple[Array, ...]) -> Array:
    alpha, beta = _line(ctx, f, at)
    result: Array = terms[0] * alpha + terms[1] * beta
    if at.r is not None:
        gamma = (f(at.a + at.r, 0)[0] - alpha - beta * at.r) / at.w if at.w else f(at.a, 2)[2]
        result += terms[2] * gamma
    return result


def _line(ctx: Context, f: Function, at: Nodes) -> tuple[Number, Number]:
    """The alpha and beta of the line alpha + beta (x - a) through f at the pair a +- sqrt(-b2)."""
    if at.b2 > 0:
        b = ctx.sqrt(at.b2)
        value = f(ctx.mpc(at.a, b), 0)[0]
        return value.real, value.imag / b
    if at.b2 < 0:
        b = ctx.sqrt(-at.b2)
        above, below = f(at.a + b, 0)[0], f(at.a - b, 0)[0]
        return (above + below) / 2, (above - below) / (2 * b)
    value, slope = f(at.a, 1)
    return value, slope


def _half_turn(ctx: Context, linear: Linear, f: Function, operand: Array) -> Array:
    """The product f(L) X at a half turn.

    In the plane J = [[0, -1], [1, 0]]. In space the plane of -s is orthogonal to the unit left eigenvector n of the
    third eigenvalue, whose first non-zero component is positive, and J = [n]x.
    """
    n, unit = linear.numerators, linear.unit(ctx)
    if len(n) == 2:
        value = f(ctx.mpc(n[0][0] * unit, 0), 0)[0]
        in_plane: Array = operand * value.real + array([-operand[1], operand[0]]) * value.imag
        return in_plane
    trace, minors, det = characteristic(n)
    numerator, denominator = double_root(trace, minors, det)
    # L + s = (mu + s) u n^T, in integers: any row of it that is not zero is a multiple of n^T.
    rows = [[denominator * x - (numerator if i == j else 0) for j, x in enumerate(row)] for i, row in enumerate(n)]
    row = next(row for row in rows if any(row))
    sign = 1 if next(x for x in row if x) > 0 else -1
    normal = array([ctx.mpf(sign * x) for x in row])
    normal = normal / norm(ctx, normal)
    double = ctx.mpf(numerator) / denominator
    third = trace - 2 * double
    along = array([[ctx.mpf(x) for x in row] for row in rows]) @ operand / (denominator * (third - double))
    across = operand - along
    value = f(ctx.mpc(double * unit, 0), 0)[0]
    turned = cross_matrix(ctx, normal) @ across
    result: Array = along * f(third * unit, 0)[0] + across * value.real + turned * value.imag
    return result
