"""Appendices A.1.4 and A.1.5: the proofs of Lemmas 2 and 3, on the volume during interpolation."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import components, composed, embedded, scaling, shear
from affinecert.properties.claims.bansal_tatu.steadiness_proof import interpolated
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, equals, exactly, mp
from affinecert.reference._groups import RIGID, SHEARS
from affinecert.reference._matrices import Array, Context, Number, identity

Components = tuple[Array, Array, Number]
TIMES = tuple(exactly([0.25, 0.5, 1, 1.5]))


def _components() -> list[Components]:
    return components("volumes", 8)


def _factors(power: int = 3, *, last: bool = True) -> Any:
    def printed(parts: Components) -> tuple[Number, ...]:
        _, a, s = parts
        return mp.one, s**power, a[1, 1] * (a[2, 2] if last else 1)

    return printed


def _wrong_factors(form: Any, parts: Components) -> Number:
    e, a, s = parts
    matrices = e, scaling(mp, s), embedded(mp, a)
    return distance(form(parts), tuple(map(determinant, matrices)))


def _volume(parts: Components) -> Number:
    """α2 α5 s³."""
    _, a, s = parts
    return a[1, 1] * a[2, 2] * s**3


def _kept() -> list[Components]:
    """Components of volume 1: the scale is taken so."""
    return [(e, a, mp.cbrt(1 / (a[1, 1] * a[2, 2]))) for e, a, _ in _components()]


def _volume_not_kept(form: Any, parts: Components) -> Number:
    return max(abs(determinant(form(parts, t)) - 1) for t in (*TIMES, mp.mpf(-2)))


def _linear(parts: Components, t: Number) -> Array:
    mixed: Array = identity(mp, 4) * (1 - t) + composed(mp, *parts) * t
    return mixed


def _component_wise(parts: Components, t: Number) -> Array:
    """The shear's entries in straight lines, scale and rigid motion as they are."""
    e, a, s = parts
    whole = interpolated((e, identity(mp, 3), s), t)
    mixed: Array = embedded(mp, identity(mp, 3) * (1 - t) + a * t) @ whole
    return mixed


def _matrices() -> list[tuple[Array]]:
    return [(exactly([[0, 1], [0, 0]]),), *((each,) for each in arrays("generators", 6, (4, 4), -1, 1))]


def _trace_of_logarithm(group: Any, index: int) -> Any:
    def trace(parts: Components) -> Number:
        return group.log(mp, parts[index]).trace()

    return trace


def _all_branches() -> list[Components]:
    """Shears of all five branches of the logarithm."""
    stretches = [(1, 1), (1, 2), (2, 1), (2, 2), (2, 3)]
    return [(identity(mp, 4), shear(mp, *exactly([1, a2, 2, 3, a5])), mp.one) for a2, a5 in stretches]


def _by_logarithms(power: int = 3, sign: int = 1) -> Any:
    def printed(parts: Components, t: Number) -> Number:
        _, a, s = parts
        return mp.exp(t * (mp.log(a[1, 1]) + sign * mp.log(a[2, 2]))) * mp.exp(t * mp.log(s**power))

    return printed


def _wrong_volume(form: Any, parts: Components) -> Number:
    return max(distance(form(parts, t), determinant(interpolated(parts, t))) for t in TIMES)


def _slope(shift: int = 0, *, logarithm: bool = True) -> Any:
    def printed(parts: Components, t: Number) -> Number:
        whole = _volume(parts)
        return whole ** (t - shift) * (mp.log(whole) if logarithm else t)

    return printed


def _wrong_slope(form: Any, parts: Components) -> Number:
    def volume(t: Number) -> Number:
        return determinant(interpolated(parts, t))

    # Relative to the volume, as the derivative of a volume that is kept is 0.
    slopes = ((form(parts, t), definitions.derivative(mp, volume, t), volume(t)) for t in TIMES[:2])
    return max(abs(found - slope) / size for found, slope, size in slopes)


def _not_monotone(form: Any, parts: Components) -> bool:
    """Whether the volume goes anywhere against its way, or rests, from 0 to 1."""
    volumes = [determinant(form(parts, mp.mpf(k) / 12)) for k in range(13)]
    way = determinant(composed(mp, *parts)) - 1
    return any((after - before) * way <= 0 for before, after in pairwise(volumes))


def _sheared_far() -> list[Components]:
    """Components of volume other than 1; first a rotation with much shear, which straight lines do not follow."""
    turned = components("volumes", 4)[2][0]
    far = [(turned @ turned @ turned, shear(mp, *exactly([4, 2, 0, 0, 1])), mp.mpf(1))]
    return [*far, *(parts for parts in _components() if abs(_volume(parts) - 1) > 0.01)]


def _sign_of_log(parts: Components) -> Number:
    return mp.sign(mp.log(determinant(composed(mp, *parts))))


def _wrong_sign(form: Any, parts: Components) -> bool:
    """Whether the sign is another than that of the change of volume from 1/2 on."""
    before, after = (determinant(interpolated(parts, t)) for t in (mp.mpf(1) / 2, mp.mpf(9) / 16))
    change = after - before
    return bool(form(parts) != (mp.sign(change) if abs(change) > mp.mpf(10) ** -50 else 0))


def _one_volumes() -> list[Components]:
    trivial = identity(mp, 4)
    kept = [(trivial, shear(mp, *exactly([1, 2, 0, 1, 0.5])), mp.one)]
    thinned = [(trivial, shear(mp, *exactly([0, 0.25, 1, 0, 0.25])), mp.mpf(2))]
    shrunk = [(e, a, s / 4) for e, a, s in _components()[3:]]
    return [*kept, *thinned, *_components()[1:2], *_components()[3:], *shrunk]


def _log_of_product(m: Context, a2: Number, a5: Number, s: Number) -> Number:
    return m.log(a2 * a5 * s**3)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.4.factors",
        place="appendix A.1.4",
        statement="The determinants of E, S and A.",
        printed="det(E) = det(R) = 1, det(S) = s³ and det(A) = α2 α5",
        verdict=Verdict.CONFIRMED,
        form=_factors(),
        cases=_components,
        deviation=_wrong_factors,
        copies=(Copy("s⁴ for s³", _factors(4)), Copy("α2 for α2 α5", _factors(last=False))),
    ),
    Claim(
        id="bansal_tatu.A.1.4.trace",
        place="appendix A.1.4",
        statement="The determinant of an exponential is the exponential of the trace.",
        printed="det(exp(Q)) = exp(tr(Q))",
        verdict=Verdict.CONFIRMED,
        form=lambda m, matrix: m.exp(matrix.trace()),
        cases=_matrices,
        deviation=equals(lambda m, matrix: determinant(definitions.exponential(m, matrix))),
        copies=(
            Copy("the trace of Q² / 2 besides", lambda m, q: m.exp(q.trace() + (q @ q).trace() / 2)),
            Copy("1 + tr(Q)", lambda m, q: 1 + q.trace()),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.4.trace_log_E",
        place="appendix A.1.4",
        statement="The trace of t log E is 0.",
        printed="tr(t log E) = 0",
        verdict=Verdict.CONFIRMED,
        form=_trace_of_logarithm(RIGID, 0),
        cases=_components,
        deviation=lambda form, parts: abs(form(parts)),
        copies=(Copy("A for E", _trace_of_logarithm(SHEARS, 1)),),
    ),
    Claim(
        id="bansal_tatu.A.1.4.trace_log_A",
        place="appendix A.1.4, 'the form of log A given in Appendix A'",
        statement="The trace of log A is log α2 + log α5, in all five branches.",
        verdict=Verdict.CONFIRMED,
        form=lambda parts: mp.log(parts[1][1, 1]) + mp.log(parts[1][2, 2]),
        cases=_all_branches,
        deviation=lambda form, parts: distance(form(parts), _trace_of_logarithm(SHEARS, 1)(parts)),
        copies=(Copy("log(α2 + α5)", lambda parts: mp.log(parts[1][1, 1] + parts[1][2, 2])),),
    ),
    Claim(
        id="bansal_tatu.A.1.4.determinant",
        place="appendix A.1.4, the chain of equations",
        statement="The determinant of T_t is a power of that of T.",
        printed="det(T_t) = exp(t (log α2 + log α5)) exp(t log s³) = (α2 α5 s³)^t",
        verdict=Verdict.CONFIRMED,
        form=_by_logarithms(),
        cases=_components,
        deviation=_wrong_volume,
        copies=(Copy("s² for s³", _by_logarithms(2)), Copy("- log α5", _by_logarithms(sign=-1))),
    ),
    Claim(
        id="bansal_tatu.A.1.4.volume",
        place="appendix A.1.4; Lemma 2",
        statement="If det T = 1, then det T_t = 1, for every real t.",
        verdict=Verdict.CONFIRMED,
        form=interpolated,
        cases=_kept,
        deviation=_volume_not_kept,
        copies=(
            Copy("the entries of T in straight lines", _linear),
            Copy("the entries of A in straight lines", _component_wise),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.5.derivative",
        place="appendix A.1.5",
        statement="The derivative of det T_t.",
        printed="d/dt (α2 α5 s³)^t = (α2 α5 s³)^t log(α2 α5 s³)",
        verdict=Verdict.CONFIRMED,
        form=_slope(),
        cases=lambda: _components()[:6],
        deviation=_wrong_slope,
        copies=(Copy("t - 1 for t", _slope(1)), Copy("t (...)^(t - 1), as of a power", _slope(1, logarithm=False))),
        losses=(
            Loss(
                where="log(α2 α5 s³) at det T = 1 + 1e-8",
                formula=_log_of_product,
                truth=lambda m, a2, a5, s: m.log(a2) + m.log(a5) + 3 * m.log(s),
                at=(1.7, 1 / 1.7, 1 + 3e-9),
                digits=8,
            ),
            Loss(
                where="log(α2 α5 s³) at det T = 1 + 1e-12",
                formula=_log_of_product,
                truth=lambda m, a2, a5, s: m.log(a2) + m.log(a5) + 3 * m.log(s),
                at=(1.7, 1 / 1.7, 1 + 3e-13),
                digits=11,
            ),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.5.sign",
        place="appendix A.1.5",
        statement="The sign of the derivative is that of log det T.",
        printed="sign(d/dt det(T_t)) = sign(log(α2 α5 s³)) = sign(log(det(T)))",
        verdict=Verdict.CONFIRMED,
        form=_sign_of_log,
        cases=_one_volumes,
        deviation=_wrong_sign,
        copies=(
            Copy("log s for log det T", lambda parts: mp.sign(mp.log(parts[2]))),
            Copy("log(α2 α5)", lambda parts: mp.sign(mp.log(parts[1][1, 1] * parts[1][2, 2]))),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.5.monotone",
        place="appendix A.1.5; Lemma 3",
        statement="From 0 to 1 the volume rises all the time if det T > 1, and falls all the time if det T < 1.",
        verdict=Verdict.CONFIRMED,
        form=interpolated,
        cases=_sheared_far,
        deviation=_not_monotone,
        copies=(Copy("the entries of T in straight lines", _linear),),
    ),
)
