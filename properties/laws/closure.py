"""Results lie in their groups: rotations are orthogonal, last rows are 0 ... 0 1, scales are positive."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import ROUNDINGS, Answer
from affinecert.properties.answers import Maps, ask_all
from affinecert.properties.inexact import CTX, Inexact, log_determinant, norm, precisely, ratio
from affinecert.properties.law import BadAnswer, Law


def _orthogonal(rotation: Inexact) -> float:
    log_determinant(rotation)  # refuses a determinant that is not positive
    return (rotation.T @ rotation).misfit(precisely(np.eye(len(rotation.value))))


def _shear(answer: Answer) -> float:
    array = answer.array
    if not (np.array_equal(array[:, 0], [1.0, 0.0, 0.0]) and array[2, 1] == 0 and array[1, 1] > 0 and array[2, 2] > 0):
        raise BadAnswer(f"no element of G_A: {array.tolist()}")
    return 0.0


def _positive(answer: Answer) -> float:
    if not answer.array > 0:
        raise BadAnswer(f"a scale of {answer.array}")
    return 0.0


def _symmetric(answer: Answer) -> float:
    return answer.whole.misfit(answer.whole.T)


def _stretch(answer: Answer) -> float:
    for size in range(1, len(answer.array) + 1):
        log_determinant(Inexact(answer.whole.value[:size, :size], answer.whole.error))
    return _symmetric(answer)


def _polar_factors(rotation: Answer, stretch: Answer) -> float:
    return max(_orthogonal(rotation.whole), _stretch(stretch))


def _principal(omega: Inexact) -> float:
    return ratio(norm(omega.value) - CTX.pi, omega.error)


def _affine(answer: Answer) -> float:
    log_determinant(answer.affine.linear)
    return 0.0


def _representation(rigid: Answer, shear: Answer, scale: Answer) -> float:
    return max(_orthogonal(rigid.affine.linear), _shear(shear), _positive(scale))


def _tangent(answer: Answer) -> float:
    if not np.max(np.abs(answer.array[-1])) <= ROUNDINGS * np.max(np.abs(answer.array)):
        raise BadAnswer(f"the last row is {answer.array[-1].tolist()}")
    return 0.0


def _residual(name: str, inside: Callable[..., float], maps: Maps, *inputs: Array) -> float:
    return inside(*ask_all(maps, name, *inputs))


def _law(name: str, statement: str, inside: Callable[..., float], source: str = "bansal_tatu, section 3.2") -> Law:
    return Law(
        name=f"closure.{name}",
        statement=statement,
        source=source,
        domain="the domain of the map",
        needs=(name,),
        inputs=strategies.inputs(name),
        residual=partial(_residual, name, inside),
    )


ROTATION, PRINCIPAL = "R^T R = I and det R > 0", "the angle is at most pi"
RIGID, AFFINE = f"{ROTATION}; the last row is 0 0 0 1", "the last row is 0 ... 0 1, and the determinant positive"
SHEAR = "zeros and the one are exact, a2 and a5 are positive"
STRETCH = "S = S^T, with positive leading minors"
KAJI_OCHIAI = "kaji_ochiai, equation 3"
SAM = "rossignac_vinacua, section 2.2"

LAWS = (
    _law("so3.exp", ROTATION, lambda answer: _orthogonal(answer["rotation"])),
    _law("so3.log", PRINCIPAL, lambda answer: _principal(answer["rotation_vector"])),
    _law("se3.exp", RIGID, lambda answer: _orthogonal(answer.affine.linear)),
    _law("se3.log", PRINCIPAL, lambda answer: _principal(answer["omega"])),
    _law("shear.exp", SHEAR, _shear),
    _law("scale.exp", "the scale is positive", _positive),
    _law("sym3.exp", STRETCH, _stretch, KAJI_OCHIAI),
    _law("sym3.log", "Y = Y^T", _symmetric, KAJI_OCHIAI),
    _law("sym3.power", STRETCH, _stretch, KAJI_OCHIAI),
    _law("polar.decompose", f"{ROTATION}; {STRETCH}", _polar_factors, KAJI_OCHIAI),
    _law("affine_lie.decompose", f"E: {RIGID}; A: {SHEAR}; s is positive", _representation),
    _law("affine_lie.represent", f"E: {RIGID}; A: {SHEAR}; s is positive", _representation),
    _law("affine_lie.interpolate", AFFINE, _affine, "bansal_tatu, section 4, equation 2"),
    _law("sam.log", "the last row is zero", _tangent, SAM),
    _law("sam.power", AFFINE, _affine, SAM),
    _law("sam.morph", AFFINE, _affine, SAM),
)
