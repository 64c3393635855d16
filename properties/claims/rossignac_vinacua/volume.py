"""Section 6.4: volume changes one way along a steady motion."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import affine, plane_rotation
from affinecert.properties.claims.precision import equals, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.listings import power
from affinecert.properties.claims.rossignac_vinacua.motions_from_identity import by, maps, singular_maps, steady_motion
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, homogeneous

STEPS = 16

LEAST = mp.mpf(10) ** -30
"""The least step of a volume that is taken for a change."""


def _trace(generator_of: Array) -> Number:
    return sam.log(mp, generator_of)[:-1, :-1].trace()


def _logarithm_of_determinant(divided: bool = False) -> Any:
    def formula(m: Context, end: Array) -> Number:
        return m.log(definitions.determinant(end[:-1, :-1])) / (len(end) - 1 if divided else 1)

    return formula


def _trace_of_logarithm(_: Context, end: Array) -> Number:
    return _trace(end)


def _maps() -> list[tuple[Array]]:
    return [(each,) for each in (*maps(), *singular_maps()[1:])]


def _timed() -> list[tuple[Array, Number]]:
    return [(end, mp.mpf(t)) for (end,), t in zip(_maps(), (0, 1, 0.5, 0.25, 2, -1, 0.75, 0, 1, 0.5), strict=True)]


def _rate(factor: bool = True) -> Any:
    """trace(log L) exp(t trace(log L)), as printed."""

    def formula(m: Context, end: Array, t: Number) -> Number:
        trace = _trace(end)
        return (trace if factor else m.one) * m.exp(t * trace)

    return formula


def _rate_of_volume(m: Context, end: Array, t: Number) -> Number:
    return definitions.derivative(m, lambda s: definitions.determinant(power(end, s)[:-1, :-1]), t)


def _grows(measure: str = "trace") -> Any:
    """Whether A increases volume: by the sign of trace(log L), or of trace(L) - n."""

    def condition(end: Array) -> bool:
        linear = end[:-1, :-1]
        return bool((_trace(end) if measure == "trace" else linear.trace() - len(linear)) > LEAST)

    return condition


def _wrong_way(condition: Any, case: tuple[Array]) -> int:
    (end,) = case
    return int(condition(end) is not bool(definitions.determinant(end[:-1, :-1]) > 1))


def _volumes(motion: Any) -> list[Number]:
    return [definitions.determinant(motion(mp.mpf(k) / STEPS)[:-1, :-1]) for k in range(STEPS + 1)]


def _both_ways(make: Any, case: tuple[Array]) -> Number:
    """The least of the total growth and the total loss of volume: one of them is 0 if it changes one way."""
    changes = [after - before for before, after in pairwise(_volumes(make(case[0])))]
    growth, loss = (sum((max(sign * each, mp.zero) for each in changes), mp.zero) for sign in (1, -1))
    return min(growth, loss) if min(growth, loss) > LEAST else mp.zero


def _triangle(first: str, second: str) -> Array:
    """A rotation by 2 after a stretch by two factors: the triangle of figure 9 is of this kind."""
    stretch = exactly([[float(first), 0], [0, float(second)]])
    return homogeneous(mp, plane_rotation(mp.mpf(2)) @ stretch, exactly([3, 1]))


def _not_as_in_figure_9(end: Array, _: None) -> int:
    """0 if the area grows and then shrinks under rARAP and under ARAP, and shrinks all the time under SAM."""
    polar = [_volumes(by(name)(end)) for name in ("rarap", "arap")]
    steady = _volumes(steady_motion(end))
    there_and_back = all(areas[1] > areas[0] and areas[-1] < areas[-2] for areas in polar)
    return int(not (there_and_back and all(after < before for before, after in pairwise(steady))))


def _larger_maps() -> list[tuple[Array]]:
    """With maps whose stretch has factors on both sides of 1."""
    return [*_maps(), (_triangle("3", "0.25"),), (affine([[0.25, 0, 0], [0, 4, 1], [0, 0, 2]], [1, 0, 0]),)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.6.4.trace",
        place="section 6.4",
        statement="trace(log L) = log(det L).",
        printed="trace(log(L)) = log(det(L))",
        verdict=Verdict.CONFIRMED,
        form=_logarithm_of_determinant(),
        cases=_maps,
        deviation=equals(_trace_of_logarithm),
        copies=(Copy("divided by the dimension", _logarithm_of_determinant(divided=True)),),
        losses=(
            Loss(
                where="log(det L) where L nearly keeps volume: of diag(1.00000001, 0.99999999)",
                formula=lambda m, linear: m.log(definitions.determinant(linear)),
                truth=lambda m, linear: m.log(linear[0, 0]) + m.log(linear[1, 1]),
                at=([[1 + 1e-8, 0], [0, 1 - 1e-8]],),
                digits=16,
            ),
        ),
    ),
    Claim(
        id="rossignac_vinacua.6.4.sign",
        place="section 6.4",
        statement="trace(log L) is positive if A increases volume, and negative if it decreases it.",
        verdict=Verdict.CONFIRMED,
        form=_grows(),
        cases=_larger_maps,
        deviation=_wrong_way,
        copies=(Copy("trace(L) - n for trace(log L)", _grows("trace of L")),),
    ),
    Claim(
        id="rossignac_vinacua.6.4.rate",
        place="section 6.4",
        statement="The volume changes at the rate trace(log L) exp(t trace(log L)).",
        printed="d/dt det(L(t)) = trace(log(L)) e^{t trace(log(L))}",
        verdict=Verdict.CONFIRMED,
        form=_rate(),
        cases=_timed,
        deviation=equals(_rate_of_volume),
        copies=(Copy("without the factor", _rate(factor=False)),),
    ),
    Claim(
        id="rossignac_vinacua.6.4.monotonic",
        place="section 6.4",
        statement="Along A^t volume grows all the time, or shrinks all the time, or is kept.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=_larger_maps,
        deviation=_both_ways,
        copies=(Copy("rARAP", by("rarap")), Copy("the linear morph", by("linear"))),
    ),
    Claim(
        id="rossignac_vinacua.figure_9.areas",
        place="figure 9",
        statement="There are triangles whose area grows and then shrinks under rARAP, and hence under ARAP, while it "
        "decreases all the time under SAM.",
        verdict=Verdict.CONFIRMED,
        form=_triangle("3", "0.25"),
        cases=lambda: [None],
        deviation=_not_as_in_figure_9,
        copies=(
            Copy("stretches by 3/4 and 1/2", _triangle("0.75", "0.5")),
            Copy("stretches by 3/2 and 1/2", _triangle("1.5", "0.5")),
        ),
        remark="The triangle of the figure is not given. (1 - t + t x)(1 - t + t y) has its maximum within if "
        "1/x + 1/y > 2 and x + y > 2, x and y being the factors of the stretch.",
    ),
)
