"""What a library needs to be certified in its own CI: an adapter to fill in, and a workflow."""

from __future__ import annotations

import keyword
import re
import textwrap
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined

from affinecert.catalogue import FAMILIES
from affinecert.errors import InputError, StoredFileError
from affinecert.map import Map
from affinecert.reports import prepare, replace

WIDTH = 120
"""Columns of the adapter."""

OWNER = "OWNER"
"""Stands in the workflow for whoever keeps affinecert's repository, which the package cannot know: to be replaced."""


def arguments(entry: Map) -> str:
    """The names of a map's arguments."""
    return ", ".join(argument.name for argument in entry.arguments)


def _shape(sizes: tuple[int | str, ...]) -> str:
    return f"({', '.join(map(str, sizes))}{',' if len(sizes) == 1 else ''})"


def signature(entry: Map) -> str:
    """The arguments with their shapes, and the shapes of what a map gives."""
    taken = ", ".join(f"{argument.name} {_shape(argument.shape)}" for argument in entry.arguments)
    return f"{taken} -> {', '.join(map(_shape, entry.outputs))}"


def comment(line: str, indent: int) -> str:
    """A comment in as many lines as it takes, those that follow indented as far as the first."""
    blanks = " " * indent
    hang = re.match("# *", line)
    return textwrap.fill(
        line,
        WIDTH,
        initial_indent=blanks,
        subsequent_indent=blanks + (hang[0] if hang else "# "),
        break_long_words=False,
        break_on_hyphens=False,
    )


def offer(entry: Map, library: str, indent: int) -> str:
    """A map in the adapter's table, commented out, in as many lines as it takes."""
    taken, function = arguments(entry), f"{library}.{entry.name.replace('.', '_')}"
    asked = f"lambda {taken}: {function}"
    forms = (
        (f'"{entry.name}": each({asked}({taken})),',),
        (f'"{entry.name}": each(', f"    {asked}({taken})", "),"),
        (f'"{entry.name}": each(', f"    {asked}(", f"        {taken}", "    )", "),"),
    )
    commented = [[f"{' ' * indent}# {line}" for line in form] for form in forms]
    return "\n".join(next((form for form in commented if max(map(len, form)) <= WIDTH), commented[-1]))


def _title(docstring: str | None) -> str:
    """What a family of the catalogue is of, as its docstring tells in its first line."""
    title = (docstring or "").partition("\n")[0].removeprefix("The catalogue of ").removesuffix(".")
    return title[:1].upper() + title[1:]


def rendered(library: str) -> Mapping[Path, str]:
    """The files by name: the adapter, and the workflow. Raises InputError for a name that cannot be imported."""
    if not library.isidentifier() or keyword.iskeyword(library):
        near = re.sub(r"\W", "_", library)
        hint = f"; {near} could be one" if near != library and near.isidentifier() else ""
        raise InputError("MYLIB", f"{library!r} is no name that Python can import{hint}")
    environment = Environment(
        loader=PackageLoader("affinecert.reports", "."),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=False,
    )
    environment.filters["comment"] = comment
    environment.globals.update(offer=offer, signature=signature)
    module = f"affinecert_{library}"
    told = {
        "library": library,
        "module": module,
        "families": [(_title(family.__doc__), family.MAPS) for family in FAMILIES],
        "owner": OWNER,
        "tag": f"v{version('affinecert')}",
    }
    names = {
        Path(f"{module}.py"): "adapter.py.jinja",
        Path(".github", "workflows", "affinecert.yml"): "workflow.yml.jinja",
    }
    return {path: environment.get_template(name).render(told) for path, name in names.items()}


def adopt(library: str, folder: Path) -> tuple[Path, ...]:
    """Writes the files into a library's folder. Raises InputError, or StoredFileError where one is there already."""
    files = {folder / path: text for path, text in rendered(library).items()}
    for path in files:
        if path.exists():
            raise StoredFileError(f"{path} is there already; it is not overwritten, and nothing is written")
    for path in files:
        prepare(path.parent)
    return tuple(replace(path, text) for path, text in files.items())
