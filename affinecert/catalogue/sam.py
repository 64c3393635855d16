"""The catalogue of steady affine motions: existence, logarithm, powers, morphs, fixed point and velocity.

Each regime comes twice: in the plane (its name ends in -2d) and in space (-3d).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from affinecert.catalogue import spectra
from affinecert.catalogue.parts import LINEAR, LINEAR_BLOCKS, NORM, TIME, TRANSLATION, WHOLE
from affinecert.catalogue.spectra import Spectrum
from affinecert.catalogue.times import about_time, timed
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import sam as reference
from affinecert.sampling import homogeneous, quarter_turns, vector, well_conditioned

Inputs = Callable[[Draw, Spectrum, Array], tuple[Array, ...]]
"""How the inputs of a map are made of a linear part of some spectrum."""


def _regimes(kinds: Iterable[Spectrum], inputs: Inputs, name: str = "{}") -> tuple[Regime, ...]:
    """A regime for each spectrum, in the plane and in space; ``name`` may add to the spectrum's."""

    def regime(kind: Spectrum, size: int) -> Regime:
        def build(draw: Draw) -> Point:
            linear, distance = kind.build(draw, size)
            return Point(inputs(draw, kind, linear), distance)

        return Regime(f"{name.format(kind.name)}-{size}d", build, kind.distance, kind.share)

    return tuple(regime(kind, size) for kind in kinds for size in (2, 3))


def _about_time(inputs: Inputs) -> tuple[Regime, ...]:
    return tuple(
        regime
        for untimed in _regimes((spectra.GENERIC,), inputs)
        for regime in about_time(untimed, untimed.name.removeprefix("generic"))
    )


def _placed(draw: Draw, linear: Array, low: float = -3, high: float = 3) -> Array:
    """The affine map of that linear part, with a translation of size 10**e, e in [low, high]."""
    return homogeneous(linear, vector(draw, low, high, len(linear)))


def _alone(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    return (_placed(draw, linear),)


def _carried_far(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    return (_placed(draw, linear, -140, 140),)


def _ends(draw: Draw, kind: Spectrum, linear: Array) -> tuple[Array, ...]:
    """B and C = A B. Where rounding would change the kind of A, B permutes the columns and scales them by 2^k."""
    size = len(linear)
    start = well_conditioned(draw, size)
    if kind.exact:
        start = draw.choice(quarter_turns(size)) * np.array([2.0 ** draw.choice(range(-8, 9)) for _ in range(size)])
    return _placed(draw, start), _placed(draw, linear @ start)


def _same_ends(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    pose = _placed(draw, linear)
    return pose, pose.copy()


def _thin_ends(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    # Rounding of C moves A by u / thinness, too little to bring its eigenvalues to the negative axis.
    thinness = np.array([draw.exponent(-8, 0), *[1.0] * (len(linear) - 1)])
    start = well_conditioned(draw, len(linear)) * thinness
    return _placed(draw, start), _placed(draw, linear @ start)


def _with_point(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    return _placed(draw, linear), vector(draw, size=len(linear))


def _with_far_point(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    return _placed(draw, linear, -100, 100), vector(draw, -140, 140, len(linear))


def _with_fixed_point(draw: Draw, _: Spectrum, linear: Array) -> tuple[Array, ...]:
    """A point next to the fixed one, whose velocity is nearly zero."""
    size, affine = len(linear), _placed(draw, linear)
    fixed = np.linalg.lstsq(np.eye(size) - linear, affine[:-1, -1])[0]
    return affine, fixed + vector(draw, -16, 0, size)


REFUSED = (spectra.NO_LOGARITHM, spectra.NOT_ORIENTED)

EXISTENCE = (
    spectra.ANY,
    spectra.NEGATIVE_PAIR,
    spectra.NEAR_MINUS_ONE,
    spectra.MINUS_ONE,
    spectra.NEGATIVE_DEFECTIVE,
    spectra.LAST_BITS,
    spectra.COALESCING,
    spectra.DEFECTIVE,
    spectra.ROTATION,
    spectra.HUGE_OR_TINY,
    spectra.SPREAD,
    spectra.NOT_ORIENTED,
)

LOGARITHM = (
    spectra.GENERIC,
    spectra.NEAR_IDENTITY,
    spectra.PURE_TRANSLATION,
    spectra.UNIT_EIGENVALUE,
    spectra.NEAR_UNIT_EIGENVALUE,
    spectra.COALESCING,
    spectra.DEFECTIVE,
    spectra.ROUNDED_DEFECTIVE,
    spectra.DOUBLE_EIGENVALUE,
    spectra.ROTATION,
    spectra.SIMILARITY,
    spectra.HUGE_OR_TINY,
    spectra.SPREAD,
    spectra.BOUNDARY,
    spectra.NEAR_MINUS_ONE,
    spectra.MINUS_ONE,
    *REFUSED,
)

POWER = (
    spectra.GENERIC,
    spectra.NEAR_IDENTITY,
    spectra.PURE_TRANSLATION,
    spectra.UNIT_EIGENVALUE,
    spectra.COALESCING,
    spectra.DEFECTIVE,
    spectra.ROTATION,
    spectra.HUGE_OR_TINY,
    spectra.BOUNDARY,
    spectra.MINUS_ONE,
    *REFUSED,
)

MORPH = (
    spectra.GENERIC,
    spectra.NEAR_IDENTITY,
    spectra.PURE_TRANSLATION,
    spectra.UNIT_EIGENVALUE,
    spectra.COALESCING,
    spectra.DEFECTIVE,
    spectra.ROTATION,
    spectra.HUGE_OR_TINY,
    spectra.BOUNDARY,
    spectra.MINUS_ONE,
    *REFUSED,
)

VELOCITY = (
    spectra.GENERIC,
    spectra.NEAR_IDENTITY,
    spectra.UNIT_EIGENVALUE,
    spectra.DEFECTIVE,
    spectra.BOUNDARY,
    *REFUSED,
)

FIXED_POINT = (
    spectra.OFF_UNIT,
    spectra.SMALL_STEP,
    spectra.NEAR_UNIT_EIGENVALUE,
    spectra.SIMILARITY,
    spectra.SPREAD,
    spectra.NO_FIXED_POINT,
    spectra.NOT_ORIENTED,
)


def _affine(name: str) -> Argument:
    """An affine map; a perturbation moves its linear part as a whole, and its translation."""
    return Argument(name, ("n", "n"), (Group(LINEAR), Group(TRANSLATION)), "1, length")


AFFINE = _affine("affine")
POINT = Argument("point", ("n-1",), (NORM,), "length")

MAPS = (
    Map(
        name="sam.exists",
        definition="1 if log L is real: no negative eigenvalue, or a double one with two eigenvectors; else 0",
        source="rossignac_vinacua, section 5.1 (Culver 1966)",
        domain="det L > 0; last row 0 ... 0 1",
        arguments=(AFFINE,),
        outputs=((),),
        blocks=(Block("exists", 0, WHOLE),),
        regimes=_regimes(EXISTENCE, _alone),
        reference=reference.exists,
        exact=True,
        accuracy=0.0,
        bound=0.0,
        cost=0.5,
    ),
    Map(
        name="sam.log",
        definition="log A = [[log L, v], [0, 0]], v = log(L) (L - I)^-1 t; a double -s turns by pi as in so3.log",
        source="rossignac_vinacua, equation 2 and appendix A",
        domain="det L > 0 and sam.exists; last row 0 ... 0 1",
        arguments=(AFFINE,),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=(
            *_regimes(LOGARITHM, _alone),
            *_regimes((spectra.NEAR_IDENTITY,), _carried_far, "tiny-next-to-huge"),
        ),
        reference=reference.log,
        accuracy=8.0,
        cost=4.0,
    ),
    Map(
        name="sam.power",
        definition="A^t = exp(t log A)",
        source="rossignac_vinacua, equations 1 and 2, appendix A",
        domain="A as for sam.log, every t",
        arguments=(AFFINE, TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=(*timed(_regimes(POWER, _alone)), *_about_time(_alone)),
        reference=reference.power,
        accuracy=8.0,
        cost=4.0,
    ),
    Map(
        name="sam.morph",
        definition="(C B^-1)^t B, the steady motion from B to C",
        source="rossignac_vinacua, sections 1 and 2.2",
        domain="det B > 0, det C > 0, and sam.exists of C B^-1; every t",
        arguments=(_affine("start"), _affine("end"), TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=(
            *timed(
                (
                    *_regimes(MORPH, _ends),
                    *_regimes((spectra.GENERIC,), _same_ends, "identity"),
                    *_regimes((spectra.GENERIC,), _thin_ends, "thin"),
                )
            ),
            *_about_time(_ends),
        ),
        reference=reference.morph,
        accuracy=8.0,
        cost=8.0,
    ),
    Map(
        name="sam.fixed_point",
        definition="the point q = L q + t",
        source="rossignac_vinacua, appendix A.1 and A.4",
        domain="det L > 0, and 1 is no eigenvalue of L",
        arguments=(
            Argument("affine", ("n", "n"), (Group(LINEAR, "entries"), Group(TRANSLATION, "entries")), "1, length"),
        ),
        outputs=(("n-1",),),
        blocks=(Block("point", 0, WHOLE),),
        regimes=_regimes(FIXED_POINT, _alone),
        reference=reference.fixed_point,
        accuracy=8.0,
        cost=1.2,
    ),
    Map(
        name="sam.velocity",
        definition="log(L) p + v, the constant velocity at the point p of the motion A^t",
        source="rossignac_vinacua, section 6.2",
        domain="A as for sam.log, every point",
        arguments=(AFFINE, POINT),
        outputs=(("n-1",),),
        blocks=(Block("velocity", 0, WHOLE),),
        regimes=(
            *_regimes(VELOCITY, _with_point),
            *_regimes((spectra.GENERIC,), _with_fixed_point, "fixed-point"),
            *_regimes((spectra.GENERIC,), _with_far_point, "tiny-next-to-huge"),
        ),
        reference=reference.velocity,
        accuracy=8.0,
        cost=4.0,
    ),
)
