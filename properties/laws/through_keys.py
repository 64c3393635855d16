"""A curve passes through its keys."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

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


def _scale(point: Answer, key: Array) -> float:
    return point.whole.misfit(precisely(np.atleast_2d(key)))


def _pose(point: Answer, key: Array) -> float:
    return point.affine.misfit(affine(key))


def _nearest(time: Array, count: int) -> int:
    """The number of the key nearest to a time: each example tries one, for truths of whole curves are dear."""
    return int(np.clip(np.rint(time), 0, count - 1))


def _at_whole_times(name: str, misfit: Callable[[Answer, Array], float], maps: Maps, keys: Array, time: Array) -> float:
    number = _nearest(time, len(keys))
    return misfit(ask(maps, name, keys, np.array(float(number))), keys[number])


def _at_halves(maps: Maps, *arguments: Array) -> float:
    *poses, time = arguments
    number = _nearest(2 * time, 3)
    return _pose(ask(maps, "curves.biarc", *poses, np.array(number / 2)), poses[number])


def _law(name: str, source: str, domain: str, residual: Callable[..., Any]) -> Law:
    return Law(
        name=f"through_keys.{name}",
        statement="the curve is at key i at the time i",
        source=source,
        domain=domain,
        needs=(name,),
        inputs=strategies.inputs(name),
        residual=residual,
    )


def _through(name: str, source: str, domain: str, misfit: Callable[[Answer, Array], float]) -> Law:
    return _law(name, source, domain, partial(_at_whole_times, name, misfit))


LAWS = (
    _through("curves.shear_curve", "bansal_tatu, section 4.1", "keys in G_A", _shear),
    _through("curves.scale_curve", "bansal_tatu, section 4.1", "positive keys", _scale),
    _through(
        "curves.affine_curve",
        "bansal_tatu, section 4.1; as printed, with the factors in the order E S A, the statement is false",
        "keys with det > 0",
        _pose,
    ),
    _through("curves.poly_sam", "rossignac_vinacua, section 5.3", "a real logarithm between each two keys", _pose),
    _law(
        "curves.biarc",
        "rossignac_vinacua, section 5.3: A, B and C at the times 0, 1/2 and 1",
        "as for curves.biarc",
        _at_halves,
    ),
)
