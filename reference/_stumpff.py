"""The Stumpff functions c_k(x) = sum_j (-x)^j / (2j + k)!: exponential series of a skew matrix, summed by powers.

With x = theta^2: c_0 = cos theta, c_1 = sin theta / theta, c_2 = (1 - cos theta) / theta^2, and so on.
"""

from __future__ import annotations

from affinecert.reference._matrices import Context, Number
from affinecert.reference._precision import closeness

# Below this the series are summed: then each term adds 20 bits. Above it the closed forms lose 20 bits at most.
_SMALL = 2.0**-20


def stumpff(ctx: Context, x: Number) -> list[Number]:
    """c_0(x), ..., c_4(x) for x >= 0, to the context's relative precision, where x itself is good to that of theta.

    c_k = 1/k! - x c_(k+2) leads from c_1 and c_2 up to c_3 and c_4, which loses the bits that x is below 1; or from
    c_3 and c_4 down, which loses none for x < 1.
    """
    if x < _SMALL:
        c4, c3 = _series(ctx, x, 24, 4), _series(ctx, x, 6, 3)
        c2, c1 = ctx.mpf(0.5) - x * c4, 1 - x * c3
        return [1 - x * c2, c1, c2, c3, c4]
    with ctx.extraprec(closeness(x, ctx.one)):
        half = ctx.sqrt(x) / 2
        cosine, sine = ctx.cos_sin(half)
        sine /= half
        c1, c2 = cosine * sine, sine * sine / 2
        return [1 - x * c2, c1, c2, (1 - c1) / x, (ctx.mpf(0.5) - c2) / x]


def _series(ctx: Context, x: Number, factorial: int, k: int) -> Number:
    """The sum of (-x)^j / (2j + k)!, with k! given; it errs by less than the first term left out."""
    term = total = ctx.one / factorial
    smallest = ctx.ldexp(term, -ctx.prec - 8)
    while abs(term) > smallest:
        k += 2
        term = -term * x / (k * (k - 1))
        total += term
    return total
