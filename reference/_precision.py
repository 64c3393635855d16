"""How much precision an input needs, and when a computed number counts as zero."""

from __future__ import annotations

from affinecert.reference._matrices import Array, Context, Number


def magnitude(number: Number) -> int | None:
    """The e with 2**(e-1) <= |number| < 2**e; None for zero."""
    mantissa, exponent = number.man_exp
    return int(exponent + mantissa.bit_length()) if mantissa else None


def span(*arrays: Array) -> int:
    """Bits between the largest and the smallest of the non-zero entries and 1.

    For the smallest term of a sum of products of k entries to be seen, the sum needs k times that beyond the bits
    wanted.
    """
    magnitudes = [1, *(e for a in arrays for x in a.flat if (e := magnitude(x)) is not None)]
    return max(magnitudes) - min(magnitudes)


def closeness(number: Number, scale: Number) -> int:
    """Bits by which ``number`` lies below ``scale`` (0 if it does not, or is 0): what dividing by it loses."""
    e, s = magnitude(number), magnitude(scale)
    return max(0, s - e) if e is not None and s is not None else 0


def negligible(ctx: Context, number: Number, scale: Number) -> bool:
    """Whether ``number`` is zero next to ``scale``, as far as half the precision can tell.

    Rounding leaves a true zero near 2**-prec. With at least 320 bits, and the span of the input on top of them twice,
    a number made of a few products of float64 that is not zero stays far above 2**(-prec/2); one that does not is
    found out when the precision is doubled.
    """
    return bool(abs(number) <= ctx.ldexp(abs(scale), -(ctx.prec // 2)))
