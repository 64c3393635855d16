"""The exponentials of the multiples of one element, and the powers of one map, are a one-parameter subgroup."""

from __future__ import annotations

from functools import partial

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.law import Law

# The roundings of s x, t x and s + t change an input relatively by u, which its map's sensitivity K counts already.


def _exponential(name: str, maps: Maps, element: Array, s: Array, t: Array) -> float:
    first, second, both = (ask(maps, name, np.asarray(time * element)) for time in (s, t, s + t))
    if name in {"se3.exp", "sim3.exp"}:
        return (first.affine @ second.affine).misfit(both.affine)
    return (first.whole @ second.whole).misfit(both.whole)


def _power(maps: Maps, matrix: Array, s: Array, t: Array) -> float:
    first, second, both = (ask(maps, "sam.power", matrix, np.asarray(time)).affine for time in (s, t, s + t))
    return (first @ second).misfit(both)


def _power_of_stretch(maps: Maps, matrix: Array, s: Array, t: Array) -> float:
    first, second, both = (ask(maps, "sym3.power", matrix, np.asarray(time)).whole for time in (s, t, s + t))
    return (first @ second).misfit(both)


def _law(name: str, elements: SearchStrategy[Array], source: str) -> Law:
    return Law(
        name=f"one_parameter.{name}",
        statement="exp(s x) exp(t x) = exp((s + t) x)",
        source=source,
        domain="every x; all real s and t",
        needs=(name,),
        inputs=st.tuples(elements, strategies.times(), strategies.times()),
        residual=partial(_exponential, name),
    )


LAWS = (
    _law("so3.exp", strategies.rotation_vectors(), "bansal_tatu, section 3.2 and A.2.1"),
    _law("se3.exp", strategies.twists(), "bansal_tatu, section 3.2 and A.2.1"),
    _law("sim3.exp", strategies.tangents(), "gallier, section 2"),
    _law("shear.exp", strategies.shear_twists(), "bansal_tatu, section 3.2 and A.2.3"),
    _law("scale.exp", strategies.log_scales(), "bansal_tatu, section 3.2 and A.2.5"),
    _law("sym3.exp", strategies.symmetric_matrices(), "kaji_ochiai, appendix A"),
    Law(
        name="one_parameter.sym3.power",
        statement="S^s S^t = S^(s + t)",
        source="kaji_ochiai, appendix A, equation 11",
        domain="every symmetric positive definite S; all real s and t",
        needs=("sym3.power",),
        inputs=st.tuples(strategies.stretches(), strategies.times(), strategies.times()),
        residual=_power_of_stretch,
    ),
    Law(
        name="one_parameter.sam.power",
        statement="A^s A^t = A^(s + t)",
        source="rossignac_vinacua, sections 2.2 and 6.1, equation 5",
        domain="A with a real logarithm, of the plane and of space; all real s and t",
        needs=("sam.power",),
        inputs=st.tuples(strategies.affine_maps(), strategies.times(), strategies.times()),
        residual=_power,
    ),
)
