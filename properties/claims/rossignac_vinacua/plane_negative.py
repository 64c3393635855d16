"""Appendix A.3: negative eigenvalues in the plane, half turns, S2, and what has no logarithm, G3."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.precision import FAILS, distance, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array


def _r_and_gap(linear: Array) -> tuple[Number, Number]:
    """The numbers r and det L - r^2."""
    r = (linear[0, 0] + linear[1, 1]) / 2
    return r, determinant(linear) - r * r


def _half_turn(sign: int = -1, turn: int = 1) -> Any:
    """The printed logarithm, s the positive scaling factor."""

    def printed(m: Context, s: Number) -> Array:
        scale = m.log(sign * s)
        return array([[scale, -turn * m.pi], [turn * m.pi, scale]])

    return printed


def _not_of_a_half_turn(form: Any, case: tuple[Number]) -> Number:
    """How far the exponential is from -s I."""
    (s,) = case
    c = form(mp, s)
    value = mp.exp(c[0, 0] + mp.j * c[1, 0])
    return distance(value, -s)


def _negative(form: Any, linear: Array) -> int:
    """Whether it is told wrongly if there is a real C with exp C = L.

    Such a C has the root M = exp(C / 2) with det M = δ = sqrt(det L) > 0; by Cayley and Hamilton L + δ = τ M, τ the
    trace of M, so that trace L + 2 δ = τ² >= 0, and if that is 0, L = -δ. In the other cases M = (L + δ) / τ is a root
    of positive trace and determinant, which has a logarithm, for its eigenvalues are not negative.
    """
    trace, delta = linear.trace(), mp.sqrt(determinant(linear))
    square = trace + 2 * delta
    exists = square > FAILS or not any(abs(each) > FAILS for each in (linear + delta * array([[1, 0], [0, 1]])).flat)
    return int(form(linear) != exists)


def _without_negative(linear: Array) -> bool:
    """No negative eigenvalues, or those of S2."""
    r, gap = _r_and_gap(linear)
    return bool(gap > 0 or r > 0 or (gap == 0 and linear[0, 1] == linear[1, 0] == 0))


def _positive_trace(linear: Array) -> bool:
    return bool(linear.trace() > 0)


def _without_real_negative(linear: Array) -> bool:
    """S2 forgotten."""
    r, gap = _r_and_gap(linear)
    return bool(gap > 0 or r > 0)


def _all_kinds() -> list[Array]:
    negative = [[-1, 0], [0, -2]], [[-2, 1], [0, -2]], [[-1, 0], [0, -1]], [[-2, 0], [0, -2]], [[-3, 1], [1, -1]]
    others = [[0, -1], [1, 0]], [[-1, -1], [1, -1]], [[2, 1], [0, 2]], [[3, 1], [1, 2]], [[1, 0], [0, 1]]
    return [exactly(each) for each in (*negative, *others)]


def _rootless(form: Callable[[int], bool], case: tuple[int, int, int]) -> int:
    """Whether diag(a, b), a ≠ b negative, has a real n-th root although the form denies it, or none though it tells so.

    A root commutes with diag(a, b), and so is diagonal: it exists if a and b have real n-th roots, n odd.
    """
    a, b, n = case
    roots = [_real_root(each, n) for each in (a, b)]
    exists = all(root is not None and abs(root**n - each) < FAILS for root, each in zip(roots, (a, b), strict=True))
    return int(form(n) != exists)


def _real_root(number: int, n: int) -> Number:
    """The real n-th root of a negative number, if there is one, by the real roots of x^n - a."""
    angles = (mp.pi * (2 * k + 1) / n for k in range(n))
    modulus = mp.mpf(-number) ** (mp.one / n)
    return next((modulus * mp.cos(angle) for angle in angles if abs(mp.sin(angle)) < FAILS), None)


def _times() -> list[tuple[int, int, int]]:
    return [(-1, -8, 3), (-1, -4, 2), (-1, -2, 4), (-1, -2, 5), (-3, -5, 7)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.3.S2",
        place="appendix A.3, S2",
        statement="The logarithm of a turn by π and a scaling by the factor s is (log(-s), -π; π, log(-s)).",
        printed="(log(-s), -π; π, log(-s))",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_half_turn(),
        cases=lambda: [(mp.mpf(s),) for s in (1, 2, 0.5)],
        deviation=_not_of_a_half_turn,
        correction=Correction(
            statement="It is (log s, -π; π, log s): s > 0 is the factor, -s the eigenvalue, as in section 5.1.",
            form=_half_turn(1),
        ),
        copies=(Copy("a turn by 2π", _half_turn(1, 2)),),
        remark="As printed it is right if s is the negative eigenvalue itself, which A.5 calls a negative factor.",
    ),
    Claim(
        id="rossignac_vinacua.A.3.G3",
        place="appendix A.3, G3",
        statement="With negative eigenvalues, other than those of S2, L has no real logarithm; otherwise it has one.",
        verdict=Verdict.CONFIRMED,
        form=_without_negative,
        cases=_all_kinds,
        deviation=_negative,
        copies=(
            Copy("if the trace is positive", _positive_trace),
            Copy("S2 forgotten", _without_real_negative),
        ),
    ),
    Claim(
        id="rossignac_vinacua.A.3.no_power",
        place="appendix A.3, G3",
        statement="With negative eigenvalues it makes no sense to speak of A^t for a t that is not an integer.",
        printed="nor does it make sense to speak of A^t for any non-integer t",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=lambda n: False,
        cases=_times,
        deviation=_rootless,
        correction=Correction(
            statement="With two different negative eigenvalues A has real n-th roots for odd n, and none for even n.",
            form=lambda n: n % 2 == 1,
        ),
        copies=(Copy("roots of even order", lambda n: n % 2 == 0),),
        remark="diag(-1, -8) is the third power of diag(-1, -2): regular patterns of an odd number of steps exist, "
        "though no motion; their poses alternate in a half turn.",
    ),
)
