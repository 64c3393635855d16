"""Asking a subject: a whole batch at once, and case by case where the batch fails."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from affinecert.case import Case
from affinecert.errors import SubjectError
from affinecert.map import Array
from affinecert.scoring import Answer
from affinecert.subject import Subject

SHOWN = 200
"""Characters of a subject's complaint that are kept."""


def complaint(error: BaseException) -> str:
    """What a subject raised, in a line."""
    return f"{type(error).__name__}: {error}"[:SHOWN]


def _call(function: Callable[..., Any], inputs: Sequence[Array], dtype: str) -> tuple[Array, ...]:
    """One call with copies, so that a subject that writes into its inputs spoils nobody else's."""
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        result = function(*(array.astype(dtype) for array in inputs))
    outputs = result if isinstance(result, tuple) else (result,)
    arrays = tuple(np.asarray(output) for output in outputs)
    for array in arrays:
        if array.dtype.kind not in "biufc":
            raise TypeError(f"an output of dtype {array.dtype} where numbers are due")
        if array.ndim == 0 or len(array) != len(inputs[0]):
            raise ValueError(f"an output of shape {array.shape} for a batch of {len(inputs[0])}")
    return tuple(array if np.iscomplexobj(array) else array.astype(np.float64) for array in arrays)


def _item(output: Array, index: int) -> Array:
    """One item of a batch: real where its imaginary part is zero, though a neighbour made the batch complex."""
    item = output[index]
    return np.asarray(item.real if np.iscomplexobj(item) and not np.any(item.imag) else item)


def _single(function: Callable[..., Any], inputs: Sequence[Array], dtype: str) -> Answer:
    try:
        return Answer(tuple(_item(output, 0) for output in _call(function, [array[None] for array in inputs], dtype)))
    except SubjectError as error:
        return Answer(None, complaint(error), broken=True)
    except Exception as error:
        return Answer(None, complaint(error))


def answers(subject: Subject, cases: Sequence[Case]) -> list[Answer]:
    """The subject's answers to cases of one map and of one shape, in their order."""
    function = subject.maps[cases[0].map]
    batch = [np.stack(arrays) for arrays in zip(*(case.inputs for case in cases), strict=True)]
    try:
        outputs = _call(function, batch, subject.dtype)
    except Exception:
        return [_single(function, case.inputs, subject.dtype) for case in cases]
    return [Answer(tuple(_item(output, index) for output in outputs)) for index in range(len(cases))]
