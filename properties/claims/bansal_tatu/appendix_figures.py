"""Figures 8, 10 and 11, which are printed within the appendix: pictures of paths."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Verdict

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.figure_8.smoother",
        place="figure 8",
        statement="With the transformations at t = 1/2 as further keys, the curves of section 4.1 look smoother.",
        verdict=Verdict.UNCHECKABLE,
        reason="The sequences of transformations are in pictures only, and smoother to the eye is not measured.",
    ),
    Claim(
        id="bansal_tatu.figure_10.ordering",
        place="figure 10",
        statement="For vertices moved on circles, the path changes more with the vertex ordering for more shear.",
        verdict=Verdict.UNCHECKABLE,
        reason="Neither the targets nor the three orderings are given; figure 9 has the measurement.",
    ),
    Claim(
        id="bansal_tatu.figure_11.ordering",
        place="figure 11",
        statement="For vertices moved along lines, the path changes more with the vertex ordering for more shear.",
        verdict=Verdict.UNCHECKABLE,
        reason="Neither the targets nor the three orderings are given; figure 9 has the measurement.",
    ),
)
