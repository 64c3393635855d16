"""The little YAML that workflows and actions are written in: mappings, lists, blocks of text, and plain words."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

Lines = list[tuple[int, str]]
"""Lines without comments and blank ones, each with its indent; blocks of text are kept as they are."""


def load(text: str) -> Any:
    """What a text holds; every scalar is a string."""
    return _value(list(_lines(text)))


def _lines(text: str) -> Iterator[tuple[int, str]]:
    block = None
    for line in text.splitlines():
        indent = len(line) - len(line.lstrip())
        if block is not None and (indent > block or not line.strip()):
            yield max(indent, block + 1), line
            continue
        block = None
        word = line.strip()
        if not word or word.startswith("#"):
            continue
        if word.endswith(": |"):
            block = indent
        yield indent, word.partition(" #")[0].rstrip()


def _value(lines: Lines) -> Any:
    if lines[0][1].startswith("- "):
        return [_value([(indent + 2, word[2:]), *rest]) for (indent, word), rest in _groups(lines)]
    found = {}
    for (_, word), rest in _groups(lines):
        key, _, scalar = word.partition(":")
        scalar = scalar.strip()
        if scalar == "|":
            indent = rest[0][0]
            found[key] = "".join(f"{line[indent:]}\n" for _, line in rest).rstrip("\n") + "\n"
        else:
            found[key] = _value(rest) if rest else _scalar(scalar)
    return found


def _groups(lines: Lines) -> Iterator[tuple[tuple[int, str], Lines]]:
    """Each line of the least indent with those that follow it further in."""
    starts = [number for number, (indent, _) in enumerate(lines) if indent == lines[0][0]]
    for start, end in zip(starts, [*starts[1:], len(lines)], strict=True):
        yield lines[start], lines[start + 1 : end]


def _scalar(word: str) -> Any:
    if word.startswith("["):
        return [_scalar(item.strip()) for item in word[1:-1].split(",")]
    return word[1:-1] if word[:1] in {"'", '"'} else word
