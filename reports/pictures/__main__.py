"""``python -m affinecert.reports.pictures [NAME ...] --out FOLDER`` draws the pictures anew; all without a name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path

import click
from matplotlib.figure import Figure

from affinecert.reports.pictures.drawing import keep

FILES: Mapping[str, str] = {
    "logarithms_of_rotations": "svg",
    "existence_region": "svg",
    "morph_strip": "png",
    "path_deviation": "svg",
    "shape_interpolation": "svg",
    "spliced_spline": "svg",
}
"""The pictures, a module each with a function ``draw``, and the kind of file each is kept in."""


@click.command()
@click.argument("names", nargs=-1, type=click.Choice(list(FILES)))
@click.option("--out", type=click.Path(path_type=Path, file_okay=False), default=Path("reports/pictures"))
def main(names: tuple[str, ...], out: Path) -> None:
    """Draws pictures, all of them if none is named, into a folder."""
    out.mkdir(parents=True, exist_ok=True)
    for name in names or FILES:
        draw: Callable[[], Figure] = import_module(f"affinecert.reports.pictures.{name}").draw
        keep(draw, out / f"{name}.{FILES[name]}")
        click.echo(out / f"{name}.{FILES[name]}")


if __name__ == "__main__":
    main()
