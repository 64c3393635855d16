"""A curve passes through its keys."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import Answer
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import affine, precisely
from affinecert.properties.law import Law

UPPER = np.s_[[0, 1, 0, 1, 2], [1, 1, 2, 2, 2]]


def _shear(point: Answer, key: Array) -> float:
    return point["shear"].misfit(precisely(key[UPPER]))


def _pose(point: Answer, key: Array) -> float:
    return point.affine.misfit(affine(key))


def _at_a_key(name: str, misfit: Callable[[Answer, Array], float], maps: Maps, keys: Array, time: Array) -> float:
    # One key an example, the nearest to the time that was drawn: truths of whole curves are dear.
    number = int(np.clip(np.rint(time), 0, len(keys) - 1))
    return misfit(ask(maps, name, keys, np.array(float(number))), keys[number])


def _law(name: str, source: str, domain: str, misfit: Callable[[Answer, Array], float]) -> Law:
    return Law(
        name=f"through_keys.{name}",
        statement="the curve is at key i at the time i",
        source=source,
        domain=domain,
        needs=(name,),
        inputs=strategies.inputs(name),
        residual=partial(_at_a_key, name, misfit),
    )


LAWS = (
    _law("curves.shear_curve", "bansal_tatu, section 4.1", "keys in G_A", _shear),
    _law(
        "curves.affine_curve",
        "bansal_tatu, section 4.1; as printed, with the factors in the order E S A, the statement is false",
        "keys with det > 0",
        _pose,
    ),
    _law("curves.poly_sam", "rossignac_vinacua, section 5.3", "a real logarithm between each two keys", _pose),
)
