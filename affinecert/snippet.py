"""Snippets: one call of a map without affinecert, for those who want to see a fault in the library alone."""

from __future__ import annotations

import io
import json
import re
import warnings
from collections.abc import Sequence
from contextlib import redirect_stdout
from typing import Any

import numpy as np

from affinecert.case import from_hex
from affinecert.errors import StoredFileError


def fill(template: str, inputs: Sequence[Any], where: str) -> str:
    """The snippet with the inputs of one case in the places of ``{input0}``, ``{input1}`` ..., as nested lists.

    Each number is the shortest decimal that reads back as the same float64. Other braces are Python's own, and stay.
    Raises StoredFileError, which names ``where`` the template is from, if it asks for an input that the map lacks.
    """

    def given(found: re.Match[str]) -> str:
        number = int(found[1])
        if number >= len(inputs):
            raise StoredFileError(f"{where}: the snippet asks for {found[0]}, of {len(inputs)} inputs")
        return json.dumps(from_hex(inputs[number]).tolist())

    return re.sub(r"\{input(\d+)\}", given, template)


def printed(snippet: str) -> Any:
    """What a snippet prints on its last line, nested lists of numbers. Raises whatever the snippet raises."""
    with warnings.catch_warnings(), np.errstate(all="ignore"), redirect_stdout(io.StringIO()) as output:
        warnings.simplefilter("ignore")
        exec(compile(snippet, "snippet", "exec"), {"__name__": "snippet"})
    return eval(output.getvalue().splitlines()[-1], {"nan": np.nan, "inf": np.inf})
