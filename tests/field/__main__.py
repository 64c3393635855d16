"""``python -m tests.field``: each thread, and the map, regimes and verdict by which its bug is caught, as Markdown."""

from __future__ import annotations

from . import page

if __name__ == "__main__":
    print(page.page(), end="")
