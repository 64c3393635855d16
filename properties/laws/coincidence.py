"""Morphs that differ are one and the same between poses of the right kind."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import Answer, near_rigid, near_similarity
from affinecert.properties.answers import Maps, ask
from affinecert.properties.law import Law

# They turn by at most 3 radians: what morphs do at pi is a convention, and beside it the rounding of the poses decides.
RIGID_PAIRS = strategies.regime("morphs.lie", "rigid-3d")

Pairs = SearchStrategy[tuple[Array, ...]]
"""Of start, end and time."""


@st.composite
def _scaled(draw: st.DrawFn, pairs: Pairs) -> tuple[Array, ...]:
    """Rigid poses, each scaled by a power of two, which is exact."""
    start, end, time = draw(pairs)
    for pose in (start, end):
        pose[:-1, :-1] *= 2.0 ** draw(st.integers(-10, 10))
    return start, end, time


def _same(
    first: str, second: str, kind: Callable[[Array], Array | Answer]
) -> Callable[[Maps, Array, Array, Array], float]:
    """The misfit of two morphs between poses that stand for the nearest ones of a kind."""

    def residual(maps: Maps, start: Array, end: Array, time: Array) -> float:
        one, other = (ask(maps, name, kind(start), kind(end), time).affine for name in (first, second))
        return one.misfit(other)

    return residual


def _alexa(maps: Maps, matrix: Array, time: Array) -> float:
    whole = ask(maps, "morphs.alexa_2002", np.eye(len(matrix)), matrix, time).affine
    return whole.misfit(ask(maps, "sam.power", matrix, time).affine)


def _arap(maps: Maps, matrix: Array, time: Array) -> float:
    one, other = (
        ask(maps, name, np.eye(len(matrix)), matrix, time).affine for name in ("morphs.arap", "morphs.shoemake_duff")
    )
    return one.misfit(other)


def _asap(maps: Maps, linear: Array, time: Array) -> float:
    pose = np.eye(3)
    pose[:2, :2] = linear
    whole = ask(maps, "morphs.asap", np.eye(3), pose, time)
    return whole["linear"].misfit(ask(maps, "homotopy2.exponential", linear, time).whole)


def _blend(maps: Maps, start: Array, end: Array, time: Array) -> float:
    # The rounding of 1 - t changes a weight relatively by u, which its sensitivity counts already.
    blend = ask(maps, "kaji_ochiai.blend", np.stack([start, end]), np.array([1.0 - time, time]))
    return ask(maps, "morphs.polar_exponential", start, end, time).affine.misfit(blend.affine)


LAWS = (
    Law(
        name="coincidence.sclerp",
        statement="between rigid motions sclerp is the steady morph",
        source="rossignac_vinacua, section 2.3 (5)",
        domain="rigid motions of space, to within the rounding of their entries, turned by at most 3 radians against "
        "each other; all real t",
        needs=("morphs.sclerp", "sam.morph"),
        inputs=RIGID_PAIRS,
        residual=_same("morphs.sclerp", "sam.morph", near_rigid),
    ),
    Law(
        name="coincidence.lie",
        statement="between rigid motions the morph of tetrahedra is sclerp",
        source="bansal_tatu, equation 4 and Theorem 1: A and S are the identity, and the aligned frames the poses",
        domain="as for coincidence.sclerp",
        needs=("morphs.lie", "morphs.sclerp"),
        inputs=RIGID_PAIRS,
        residual=_same("morphs.lie", "morphs.sclerp", near_rigid),
    ),
    Law(
        name="coincidence.log_spiral",
        statement="between similarities the logarithmic spiral is the steady morph",
        source="rossignac_vinacua, section 2.4 (c): the linear residue is the identity",
        domain="similarities of space, to within the rounding of their entries, turned by at most 3 radians against "
        "each other; all real t",
        needs=("morphs.log_spiral", "sam.morph"),
        inputs=_scaled(RIGID_PAIRS),
        residual=_same("morphs.log_spiral", "sam.morph", near_similarity),
    ),
    Law(
        name="coincidence.alexa_2002",
        statement="from the identity exp((1 - t) log B + t log C) is C^t",
        source="rossignac_vinacua, section 3.3.2: where B and C commute",
        domain="C with a real logarithm, of the plane and of space; all real t for which C^t is within float64",
        needs=("morphs.alexa_2002", "sam.power"),
        inputs=st.tuples(strategies.affine_maps(), strategies.times()),
        residual=_alexa,
    ),
    Law(
        name="coincidence.arap",
        statement="from the identity Alexa, Cohen-Or and Levin's morph is that of Shoemake and Duff",
        source="rossignac_vinacua, section 3.3.2",
        domain="det C > 0, of the plane and of space; all real t",
        needs=("morphs.arap", "morphs.shoemake_duff"),
        inputs=st.tuples(strategies.affine_maps(), strategies.times()),
        residual=_arap,
    ),
    Law(
        name="coincidence.asap",
        statement="from the identity the linear part of asap is the exponential homotopy",
        source="kaji_2d, equation 3; rossignac_vinacua, section 3.3.2",
        domain="linear maps of the plane, det > 0; all real t",
        needs=("morphs.asap", "homotopy2.exponential"),
        inputs=strategies.inputs("homotopy2.exponential"),
        residual=_asap,
    ),
    Law(
        name="coincidence.polar_exponential",
        statement="the polar exponential morph is the blend of both poses with the weights 1 - t and t",
        source="kaji_ochiai, equation 9",
        domain="det B > 0 and det C > 0, in space; all real t",
        needs=("morphs.polar_exponential", "kaji_ochiai.blend"),
        inputs=strategies.inputs("morphs.polar_exponential").filter(lambda arguments: len(arguments[0]) == 4),
        residual=_blend,
    ),
)
