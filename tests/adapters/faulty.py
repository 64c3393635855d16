"""Subjects of one map, so3.exp or a morph, that answer badly."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from affinecert.case import generate
from affinecert.catalogue import CATALOGUE
from affinecert.subject import Subject

Array = NDArray[Any]


def rodrigues(omega: Array) -> Array:
    """A plain implementation, right up to rounding away from zero."""
    angle = np.linalg.norm(omega, axis=-1)[:, None, None]
    x, y, z = omega.T
    zero = np.zeros_like(x)
    turn = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(-1, 3, 3)
    half = np.sinc(angle / 2 / np.pi)
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * turn + half**2 / 2 * turn @ turn)


def subject(function: Callable[[Array], Any]) -> Subject:
    return Subject(function.__name__, "0", {"so3.exp": function})


def _raise(omega: Array) -> Array:
    raise ValueError("no rotations today")


def _raise_on_batches(omega: Array) -> Array:
    if len(omega) > 1:
        raise ValueError("one at a time")
    return rodrigues(omega)


def _none(omega: Array) -> None:
    return None


def _words(omega: Array) -> list[str]:
    return ["a rotation"] * len(omega)


def _nan(omega: Array) -> Array:
    return np.full((len(omega), 3, 3), np.nan)


def _complex(omega: Array) -> Array:
    return rodrigues(omega) + 1e-3j


def _complex_without_imaginary_part(omega: Array) -> Array:
    return rodrigues(omega).astype(np.complex128)


def _flat(omega: Array) -> Array:
    return rodrigues(omega).reshape(-1, 9)


def _one_short(omega: Array) -> Array:
    return rodrigues(omega)[:-1]


def _ragged(omega: Array) -> list[Any]:
    return [*rodrigues(omega)[:-1], [1.0]]


def _pair(omega: Array) -> tuple[Array, Array]:
    return rodrigues(omega), rodrigues(omega)


def _lists(omega: Array) -> list[Any]:
    return [[[float(x) for x in row] for row in item] for item in rodrigues(omega)]


def _scribble(omega: Array) -> Array:
    result = rodrigues(omega)
    omega[:] = 0.0
    return result


def _hang(omega: Array) -> Array:
    time.sleep(3600)
    return rodrigues(omega)


FATAL = next(generate(CATALOGUE["so3.exp"], CATALOGUE["so3.exp"].regimes[0], 8)).inputs[0]
"""The one input on which `hangs_on_one` hangs."""


def _hang_on_one(omega: Array) -> Array:
    if np.any(np.all(omega == FATAL, axis=-1)):
        time.sleep(3600)
    return rodrigues(omega)


def _die(omega: Array) -> Array:
    os._exit(3)


raises = subject(_raise)
raises_on_batches = subject(_raise_on_batches)
none = subject(_none)
words = subject(_words)
nan = subject(_nan)
complex_numbers = subject(_complex)
complex_without_imaginary_part = subject(_complex_without_imaginary_part)
flat = subject(_flat)
one_short = subject(_one_short)
ragged = subject(_ragged)
pair = subject(_pair)
lists = subject(_lists)
scribbles = subject(_scribble)
hangs = subject(_hang)
hangs_on_one = subject(_hang_on_one)
dies = subject(_die)
sound = subject(rodrigues)
no_subject = {"so3.exp": rodrigues}


def _still(start: Array, end: Array, t: Array) -> Array:
    time.sleep(1000)
    return start


def _exit(start: Array, end: Array, t: Array) -> Array:
    os._exit(1)


def _straight(start: Array, end: Array, t: Array) -> Array:
    return np.asarray((1 - t[:, None, None]) * start + t[:, None, None] * end)


still = Subject("still", "0", {"morphs.linear": _still})
exits = Subject("exits", "0", {"morphs.linear": _exit})
straight = Subject("straight", "0", {"morphs.linear": _straight})
