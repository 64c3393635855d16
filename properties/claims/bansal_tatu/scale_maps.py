"""Appendices A.2.5 and A.2.6: exponential and logarithm of scales, and of shears and scales as 4x4 matrices."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import components, embedded, scaling
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import numbers
from affinecert.properties.claims.precision import distance, equals, mp
from affinecert.reference._groups import SHEARS
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity, tangent


def _exponential(m: Context, x: Number) -> Number:
    return definitions.exponential(m, array([[x]]))[0, 0]


def _logarithms() -> list[tuple[Number]]:
    return [(x,) for x in (mp.zero, mp.one, *numbers("log scales", 5, -3, 3))]


def _no_logarithm(form: Any, case: tuple[Number]) -> Number:
    return distance(_exponential(mp, form(mp, *case)), case[0])


def _algebra() -> list[tuple[Array]]:
    """Logarithms of scales and shears, 3x3."""
    parts = components("embedded", 7)
    return [(each,) for _, a, s in parts for each in (SHEARS.log(mp, a), identity(mp, 3) * mp.log(s))]


def _group() -> list[tuple[Array, Array]]:
    """Scales and shears as 4x4 matrices, with their logarithms, 3x3."""
    parts = components("embedded", 7)
    scales = [(scaling(mp, s), identity(mp, 3) * mp.log(s)) for _, _, s in parts]
    return [*scales, *((embedded(mp, a), SHEARS.log(mp, a)) for _, a, _ in parts)]


def _bordered(linear: Array) -> Array:
    """The matrix in the upper left block of the zero matrix."""
    return tangent(mp, linear, array([mp.zero] * 3))


def _below(linear: Array, first: Number = mp.zero) -> Array:
    """The matrix in the lower right block, below the first entry."""
    matrix = homogeneous(mp, identity(mp, 3) * first, array([mp.zero] * 3))
    matrix[1:, 1:] = linear
    return matrix


def _wrong_exponential(embed: Callable[[Array], Array], case: tuple[Array]) -> Number:
    """How far the embedded exponential is from the exponential of the generator without a fourth axis."""
    return distance(embed(definitions.exponential(mp, case[0])), definitions.exponential(mp, _bordered(case[0])))


def _wrong_logarithm(embed: Callable[[Array], Array], case: tuple[Array, Array]) -> Number:
    matrix, logarithm = case
    return distance(definitions.exponential(mp, embed(logarithm)), matrix)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.2.5.exponential",
        place="appendix A.2.5",
        statement="The exponential from g_S, all real numbers, to G_S, the positive ones, is that of numbers.",
        printed="exponential and logarithm maps coincide with usual scalar exponential and logarithm maps",
        verdict=Verdict.CONFIRMED,
        form=lambda m, x: m.exp(x),
        cases=_logarithms,
        deviation=equals(_exponential),
        copies=(
            Copy("the base 2", lambda m, x: m.power(2, x)),
            Copy("1 + x", lambda m, x: 1 + x),
        ),
    ),
    Claim(
        id="bansal_tatu.A.2.5.logarithm",
        place="appendix A.2.5",
        statement="The logarithm from G_S to g_S is that of numbers, and defined for every scale.",
        verdict=Verdict.CONFIRMED,
        form=lambda m, s: m.log(s),
        cases=lambda: [(mp.one,), (mp.mpf(2),), *((mp.exp(x),) for (x,) in _logarithms()[2:])],
        deviation=_no_logarithm,
        copies=(Copy("the logarithm to the base 10", lambda m, s: m.log10(s)), Copy("s - 1", lambda m, s: s - 1)),
    ),
    Claim(
        id="bansal_tatu.A.2.6.exponential",
        place="appendix A.2.6, exponentials",
        statement="An exponential of a shear or scale becomes a 4x4 matrix in the upper left block of I_4.",
        verdict=Verdict.CONFIRMED,
        form=lambda linear: embedded(mp, linear),
        cases=_algebra,
        deviation=_wrong_exponential,
        copies=(
            Copy("of the zero matrix", _bordered),
            Copy("in the lower right block, of I_4", lambda linear: _below(linear, mp.one)),
        ),
    ),
    Claim(
        id="bansal_tatu.A.2.6.logarithm",
        place="appendix A.2.6, logarithms",
        statement="A logarithm of a shear or scale becomes a 4x4 matrix in the upper left block of I_4.",
        printed="embedding them in the top-left 3×3 block of the 4×4 identity matrix",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=lambda linear: embedded(mp, linear),
        cases=_group,
        deviation=_wrong_logarithm,
        correction=Correction(
            statement="A logarithm goes to the upper left block of the 4x4 zero matrix.", form=_bordered
        ),
        copies=(Copy("in the lower right block", _below),),
        remark="Of a 1 in the last place the exponential is e: homogeneous coordinates would be scaled. No harm is "
        "done where only exponentials are embedded.",
    ),
)
