"""The catalogue of the symmetric matrices of space: exponential, logarithm and powers."""

from __future__ import annotations

from dataclasses import replace

from affinecert.catalogue import stretches
from affinecert.catalogue.parts import ENTRIES, TIME, WHOLE
from affinecert.catalogue.times import about_time, timed
from affinecert.map import Argument, Block, Map
from affinecert.reference import sym3 as reference

MATRIX = Argument("matrix", (3, 3), (ENTRIES,), "1", manifold="symmetric matrices")

SYMMETRIC = "within 1e-6 of symmetric, in the Frobenius norm; the symmetric part counts"
POSITIVE_DEFINITE = f"positive definite, and {SYMMETRIC}"
GRADED = (
    "the condition is that of each entry, so that coordinates of very different units cost nothing; a method that "
    "reduces the matrix to a diagonal all at once keeps to its norm only, and loses small eigenvalues of a graded one"
)

REGIMES = tuple(kind.regime() for kind in stretches.POSITIVE_DEFINITE)

MAPS = (
    Map(
        name="sym3.exp",
        definition="exp Y, Y symmetric",
        source="kaji_ochiai, equation 6 and appendix B",
        domain=SYMMETRIC,
        arguments=(MATRIX,),
        outputs=((3, 3),),
        blocks=(Block("exponential", 0, WHOLE),),
        regimes=tuple(kind.regime() for kind in stretches.SYMMETRIC),
        reference=reference.exp,
        inverse="sym3.log",
        cost=6.0,
        remark=GRADED,
    ),
    Map(
        name="sym3.log",
        definition="the symmetric matrix log S, S symmetric and positive definite",
        source="kaji_ochiai, equation 7 and appendix B",
        domain=POSITIVE_DEFINITE,
        arguments=(MATRIX,),
        outputs=((3, 3),),
        blocks=(Block("logarithm", 0, WHOLE),),
        regimes=REGIMES,
        reference=reference.log,
        inverse="sym3.exp",
        cost=6.0,
        remark=GRADED,
    ),
    Map(
        name="sym3.power",
        definition="S^t = exp(t log S), S symmetric and positive definite",
        source="kaji_ochiai, appendix B",
        domain=f"{POSITIVE_DEFINITE}; every t",
        arguments=(MATRIX, TIME),
        outputs=((3, 3),),
        blocks=(Block("power", 0, WHOLE),),
        regimes=tuple(
            replace(regime, share=0.5 * regime.share) for regime in (*timed(REGIMES), *about_time(REGIMES[0]))
        ),
        reference=reference.power,
        cost=6.0,
        remark=GRADED,
    ),
)
