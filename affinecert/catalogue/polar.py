"""The catalogue of the polar decomposition, of linear maps of the plane and of space."""

from __future__ import annotations

from affinecert.catalogue import stretched_turns
from affinecert.catalogue.parts import NORM, WHOLE
from affinecert.map import Argument, Block, Map
from affinecert.reference import polar as reference

MAPS = (
    Map(
        name="polar.decompose",
        definition="(R, S) with L = R S: R a rotation, S symmetric and positive definite",
        source="kaji_ochiai, equation 3; Higham, Functions of Matrices (2008), chapter 8",
        domain="L of positive determinant, of the plane or of space",
        arguments=(Argument("linear", ("d", "d"), (NORM,), "1"),),
        outputs=(("d", "d"), ("d", "d")),
        blocks=(Block("rotation", 0, WHOLE), Block("stretch", 1, WHOLE)),
        regimes=stretched_turns.REGIMES,
        reference=reference.decompose,
        remark=(
            "the condition is that of the whole matrix by its norm: the rotation's is the norm over the sum of the two "
            "smallest singular values, and only that; one of them may vanish"
        ),
    ),
)
