"""Subjects that are a little off, with snippets that show it, or do not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from affinecert import Subject
from affinecert.map import Array

SNIPPET = "import numpy as np\nprint((np.exp({input0}) * (1 + 1e-10)).item())"


def coarse(log_scale: Array) -> Array:
    """Exponentials with an error of 1e-10."""
    return np.asarray(np.exp(log_scale) * (1 + 1e-10))


shows = Subject("coarse", "1", {"scale.exp": coarse}, snippets={"scale.exp": SNIPPET})
shows_nothing = replace(shows, snippets={"scale.exp": SNIPPET.replace("1e-10", "0")})
raises = replace(shows, snippets={"scale.exp": "print({input0} / 0)"})
prints_nothing = replace(shows, snippets={"scale.exp": SNIPPET.replace("print", "str")})
hangs = replace(shows, snippets={"scale.exp": "while True: pass  # {input0}"})
