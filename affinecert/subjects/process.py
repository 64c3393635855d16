"""A subject in another process, in whatever language: a protocol of JSON by the line, with hexadecimal floats.

    affinecert certify 'exec:./my_subject --flag'

The program reads one request a line from stdin and writes one answer a line to stdout, in JSON, and nothing else there;
it flushes after each, and ends when stdin does. It is started, without a shell, once in every process that asks it, and
again after it broke down. Asked first who it is, ``{"hello": 1}``, where 1 is the version of this protocol, it answers

    {"name": "mylib", "version": "1.2", "maps": ["so3.exp", "so3.log"], "conventions": {"twists": "rotation first"}}

with names of `affinecert maps`; "conventions", "policies" and "refusals" (as of `affinecert.Subject`) and "dtype"
("float64" or "float32") may be left out. Then it gets batches of inputs of one map, all of one shape, and answers with
as many outputs, in their order:

    {"map": "so3.log", "inputs": [[[["0x1p+0", "0x0p+0", "0x0p+0"], ...]], ...]}
    {"outputs": [[["0x0p+0", "0x0p+0", "0x0p+0"]], null, ...]}

An input is the list of the map's arguments, an output the list of its results; each of these is a number, or nested
lists of numbers, row by row. A number is a string as of C's ``printf("%a")``: hexadecimal, or nan, inf, -inf. Where
there is no value, null refuses one item, and ``{"error": "why"}`` the batch; what is refused is asked item by item.

A program that dies, writes anything else, or gives too few outputs has broken down, which is a finding at any input; it
is told with the last line that the program wrote to stderr. One that hangs is ended by the time limit of a case. The
timings of such a subject include the way there and back.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from threading import Lock
from typing import Any

import numpy as np

from affinecert import catalogue
from affinecert.arithmetic import ARITHMETICS
from affinecert.case import to_hex
from affinecert.errors import SubjectError, UnknownNameError
from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.program import Program, shown

Command = tuple[str, ...]

PROTOCOL = 1

HELLO_SECONDS = 20.0
"""A program that has not said by then who it is hangs."""

NUMBER = re.compile(r"[+-]?(0x[0-9a-f]+(\.[0-9a-f]*)?(p[+-]?[0-9]+)?|nan|inf)", re.IGNORECASE)

TOLD = {"timings": "those of a program include the way there and back, as text"}
"""What a certificate says of any subject of this kind."""


class _Conversation:
    """What one process and a program say to each other; a program that broke down is started anew."""

    def __init__(self, command: Command) -> None:
        self.command = command
        self.program: Program | None = None
        self.lock = Lock()

    def hello(self) -> dict[str, Any]:
        """What the program, started anew, says of itself."""
        with self.lock:
            if self.program is not None:
                self.program.stop()
            return self._start()

    def ask(self, request: Mapping[str, Any]) -> dict[str, Any]:
        """The answer to a request."""
        with self.lock:
            if self.program is None:
                self._start()
            return self._exchange(request)

    def broken(self, what: str) -> SubjectError:
        """The error for an answer that is none; what the program would go on with is not trusted."""
        assert self.program is not None
        program, self.program = self.program, None
        return program.breakdown(what)

    def _start(self) -> dict[str, Any]:
        self.program = Program(self.command)
        return self._exchange({"hello": PROTOCOL}, HELLO_SECONDS)

    def _exchange(self, request: Mapping[str, Any], seconds: float | None = None) -> dict[str, Any]:
        assert self.program is not None
        try:
            line = self.program.exchange(json.dumps(request).encode(), seconds)
        except SubjectError:
            self.program = None
            raise
        try:
            answer = json.loads(line)
        except (ValueError, RecursionError):
            answer = None
        if not isinstance(answer, dict):
            raise self.broken(f"wrote {shown(line)} where a JSON object is due")
        return answer


@cache
def _conversation(command: Command, process: int) -> _Conversation:
    """The conversation with that program in this process: a forked one must not listen in on its parent's."""
    return _Conversation(command)


def _number(text: Any) -> float:
    if not isinstance(text, str) or not NUMBER.fullmatch(text):
        raise ValueError(f"{text!r} where a hexadecimal number is due, as a string")
    return float.fromhex(text)


def _numbers(value: Any) -> Any:
    return [_numbers(item) for item in value] if isinstance(value, list) else _number(value)


@dataclass(frozen=True)
class Asked:
    """A map of a program, as a callable on batches; it finds the program of the process that it is called in."""

    command: Command
    map: str

    @property
    def sources(self) -> tuple[Path, ...]:
        """The files that the command line names, first of all the program's."""
        words = (shutil.which(self.command[0]) or "", *self.command[1:])
        return tuple(Path(word) for word in words if Path(word).is_file())

    def __call__(self, *inputs: Array) -> Array | tuple[Array, ...]:
        """The outputs; SubjectError if the program breaks down, ValueError if it refuses an item or the batch."""
        conversation = _conversation(self.command, os.getpid())
        batch = [list(arguments) for arguments in zip(*map(to_hex, inputs), strict=True)]
        answer = conversation.ask({"map": self.map, "inputs": batch})
        if set(answer) == {"error"}:
            raise ValueError(answer["error"])
        items = answer.get("outputs")
        if set(answer) != {"outputs"} or not isinstance(items, list):
            raise conversation.broken(f"answered {self.map} with {sorted(answer)} where outputs or an error are due")
        if len(items) != len(batch):
            raise conversation.broken(f"gave {len(items)} outputs of {self.map} where {len(batch)} are due")
        if None in items:
            raise ValueError("refused")
        if not all(isinstance(item, list) for item in items):
            raise conversation.broken(f"gave an output of {self.map} that is no list of results")
        try:
            rows = [[np.array(_numbers(result)) for result in item] for item in items]
        except (ValueError, OverflowError, RecursionError) as error:
            raise conversation.broken(f"gave an output of {self.map} that is not understood: {error}") from error
        outputs = tuple(np.stack(results) for results in zip(*rows, strict=True))
        return outputs if len(outputs) != 1 else outputs[0]


def _words(value: Any) -> bool:
    """Whether these are words by name."""
    return isinstance(value, dict) and all(isinstance(word, str) for word in value.values())


DUE: Mapping[str, Callable[[Any], bool]] = {
    "name": lambda value: isinstance(value, str) and value != "",
    "version": lambda value: isinstance(value, str) and value != "",
    "maps": lambda value: isinstance(value, list) and value != [] and all(isinstance(name, str) for name in value),
    "conventions": _words,
    "policies": _words,
    "refusals": _words,
    "dtype": lambda value: value in [*ARITHMETICS],
}
"""What a program may say of itself, and what is right there."""

REQUIRED = ("name", "version", "maps")


def load(line: str) -> Subject:
    """The subject that is run by a command line; SubjectError if it does not start, or says nothing sensible."""
    try:
        command = tuple(shlex.split(line))
    except ValueError as error:
        raise SubjectError(f"exec:{line}: not a command line: {error}") from error
    if not command or shutil.which(command[0]) is None:
        raise SubjectError(f"exec:{line}: there is no program {command[0] if command else ''!r} that can be run")
    conversation = _conversation(command, os.getpid())
    try:
        told = conversation.hello()
        for key in REQUIRED:
            if key not in told:
                raise conversation.broken(f"does not tell its {key}")
        for key, value in told.items():
            if key not in DUE or not DUE[key](value):
                raise conversation.broken(f"tells of itself what is not understood, {key}: {value!r}")
        maps = {name: Asked(command, catalogue.find(name).name) for name in told["maps"]}
    except (SubjectError, UnknownNameError) as error:
        raise SubjectError(f"exec:{line}: {error}") from error
    return Subject(
        name=told["name"],
        version=told["version"],
        maps=maps,
        conventions=TOLD | told.get("conventions", {}),
        policies=told.get("policies", {}),
        refusals=told.get("refusals", {}),
        dtype=told.get("dtype", "float64"),
    )
