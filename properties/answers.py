"""Asking a subject for single items, and knowing how large an error each answer may have."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from affinecert import truths
from affinecert.answering import complaint
from affinecert.catalogue import CATALOGUE, find
from affinecert.manifold import distance
from affinecert.map import Array, Block, Map
from affinecert.properties.answer import Answer
from affinecert.properties.carrying import carried, several
from affinecert.properties.inexact import CTX, UNIT, exact, norm
from affinecert.properties.law import BadAnswer, OutOfDomain
from affinecert.scoring import announced
from affinecert.subject import Subject
from affinecert.truths import Truth

Maps = Mapping[str, Callable[..., Any]]
"""Map names to functions of single items (no batch axis), float64 arrays in and out."""

SMALLEST_NORMAL = CTX.mpf(2) ** -1022
"""Below it float64 keeps no relative accuracy; sizes of truths are taken as at least this, as in the scores."""


def _single(outputs: tuple[Array, ...]) -> Array | tuple[Array, ...]:
    return outputs if len(outputs) > 1 else outputs[0]


def singly(subject: Subject) -> Maps:
    """The subject's functions, taking and giving single items.

    OutOfDomain where it documents to refuse one, or to take one as it is though that is off its manifold.
    """

    def one(entry: Map, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Array) -> Any:
            if distance(entry, arguments, subject.policies) > entry.bound * subject.arithmetic.unit:
                raise OutOfDomain("off the manifold, and taken as it is")
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                try:
                    result = function(*(np.array(argument, dtype=np.float64)[None] for argument in arguments))
                except Exception as error:
                    why = announced(complaint(error), subject.refusals)
                    if why is None:
                        raise
                    raise OutOfDomain(f"refused, as documented: {why}") from error
            return _single(tuple(np.asarray(output)[0] for output in several(result)))

        return call

    return {name: one(CATALOGUE[name], function) for name, function in subject.maps.items() if name in CATALOGUE}


def exactly() -> Maps:
    """The truths themselves, rounded to float64, as a subject: the one that every law has to let pass."""

    def one(name: str) -> Callable[..., Any]:
        return lambda *arguments: _single(tuple(high.copy() for high in truth(name, *arguments).high))

    return {name: one(name) for name in CATALOGUE}


@lru_cache(maxsize=4096)
def _truth(name: str, key: tuple[tuple[tuple[int, ...], bytes], ...]) -> Truth:
    return truths.compute(find(name), tuple(np.frombuffer(data).reshape(shape).copy() for shape, data in key))


def truth(name: str, *inputs: Array) -> Truth:
    """The truth of a map at an input; OutOfDomain where the map refuses it, or its value exceeds float64."""
    found = _truth(name, tuple((np.shape(array), np.ascontiguousarray(array).tobytes()) for array in inputs))
    if found.refusal is not None:
        raise OutOfDomain(found.refusal)
    if not all(np.all(np.isfinite(high)) for high in found.high):
        raise OutOfDomain("a value beyond float64")
    return found


def ask(maps: Maps, name: str, *arguments: Array | Answer) -> Answer:
    """The one output of a map: see `ask_all`."""
    (answer,) = ask_all(maps, name, *arguments)
    return answer


def ask_all(maps: Maps, name: str, *arguments: Array | Answer) -> tuple[Answer, ...]:
    """The outputs of a map, each block with the error u (|truth| + K) it may have, K the map's sensitivity.

    An argument that is itself an answer brings its own errors, which are carried through the map to first order.
    Raises BadAnswer where the subject raises, or gives what is no answer at all; OutOfDomain for a complex one where a
    rounding of the inputs changes the whole value, as beside a double negative eigenvalue: values next to it do not
    exist, or are complex as well.
    """
    inputs = tuple(argument.array if isinstance(argument, Answer) else argument for argument in arguments)
    known = truth(name, *inputs)
    outputs = _outputs(maps, name, inputs, known)
    parts: list[dict[str, tuple[Any, Any]]] = [{} for _ in outputs]
    blocks = find(name).blocks
    for block, sensitivity, more in zip(blocks, known.sensitivity, carried(name, arguments), strict=True):
        parts[block.output][block.name] = (block.where, UNIT * (_size(known, block) + CTX.mpf(sensitivity)) + more)
    return tuple(Answer(array, part) for array, part in zip(outputs, parts, strict=True))


def _size(known: Truth, block: Block) -> Any:
    return max(norm(exact(known.high[block.output][block.where])), SMALLEST_NORMAL)


def _undecided(name: str, known: Truth) -> bool:
    """Whether a rounding of the inputs changes a whole block, as in the scores."""
    blocks = zip(find(name).blocks, known.sensitivity, strict=True)
    return any(UNIT * CTX.mpf(sensitivity) >= _size(known, block) for block, sensitivity in blocks)


def _rounding(name: str, known: Truth, outputs: Sequence[Array]) -> Iterator[bool]:
    """Of each block, whether its imaginary part is no more than a score allows the block to err by."""
    entry = find(name)
    for block, sensitivity in zip(entry.blocks, known.sensitivity, strict=True):
        part = outputs[block.output][block.where].imag + 0.0
        allowed = entry.bound * UNIT * (_size(known, block) + CTX.mpf(sensitivity))
        yield bool(np.all(np.isfinite(part))) and norm(exact(part)) <= allowed


def _outputs(maps: Maps, name: str, inputs: tuple[Array, ...], known: Truth) -> list[Array]:
    try:
        outputs = [np.asarray(output) for output in several(maps[name](*(np.array(array) for array in inputs)))]
    except OutOfDomain:
        raise
    except Exception as error:
        raise BadAnswer(f"{name} raises {type(error).__name__}: {error}") from error
    if [output.shape for output in outputs] != [high.shape for high in known.high]:
        raise BadAnswer(f"{name} gives {', '.join(f'an array of shape {output.shape}' for output in outputs)}")
    if any(map(np.iscomplexobj, outputs)):
        if _undecided(name, known):
            raise OutOfDomain(f"{name} is complex, as values are at inputs that rounding cannot tell from this one")
        if all(_rounding(name, known, outputs)):
            outputs = [output.real for output in outputs]
    for output in outputs:
        if output.dtype.kind not in "biuf" or not np.all(np.isfinite(output)):
            raise BadAnswer(f"{name} gives {output.tolist()}")
    return [output.astype(np.float64) for output in outputs]
