"""One plot a map: accuracy against speed, a point a library; worst scaled error upwards, time an item to the right."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from matplotlib.artist import Artist
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.transforms import Bbox, BboxTransform, IdentityTransform

from affinecert.compare import Point, Speed
from affinecert.reports.plots import (
    INK,
    LIMIT,
    LOWEST,
    MARKERS,
    SHADES,
    Scale,
    bounded,
    grid,
    inline,
    lettering,
    logarithms,
    placed,
    ticks,
)
from affinecert.reports.view import error, figure
from affinecert.scoring import Verdict

SIZE = (432, 234)
AREA = (28, 19, 429, 230)
"""Points: the whole plot, and what its grid spans, as left, bottom, right, top."""

LETTER, LINE = 4.5, 9.5
"""Points: about what a letter takes across, and a line of text upwards."""

LONGEST = 36
"""Characters of a label."""

REACH = (0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8, -8)
"""Lines up or down that a label may stand from its point, the nearest first."""


def plot(speed: Speed, bound: float | None) -> str:
    """The plot of a map as an SVG element; ``bound`` is that of the map's scaled error."""
    times = _scale([point.nanoseconds for point in speed.points])
    errors = _errors([point.scaled for point in speed.points], bound)
    with lettering():
        canvas = Figure(figsize=(SIZE[0] / 72, SIZE[1] / 72), dpi=72, facecolor="none")
        FigureCanvasSVG(canvas)
        to_page = placed(times, errors, AREA)
        # Half of the digits are not the same height for all libraries: some compute in float32.
        for artist in (*bounded(bound, math.inf, times, errors), *grid(times, errors)):
            artist.set_transform(to_page)
            canvas.add_artist(artist)
        for artist in (*ticks(times, errors, to_page), *_points(speed.points, times, errors, to_page)):
            canvas.add_artist(artist)
        told = "; ".join(
            f"{point.library} {figure(point.nanoseconds)} ns, {error(point.scaled)} u, {point.verdict}"
            for point in speed.points
        )
        return inline(canvas, f"speed/{speed.map}", f"Worst scaled error of {speed.map} against time: {told}", SIZE)


def _scale(times: Iterable[float]) -> Scale:
    exponents = logarithms(times) or [0.0]
    low, high = math.floor(min(exponents)), math.ceil(max(exponents))
    return Scale(low, max(high, low + 2))


def _errors(errors: Sequence[float], bound: float | None) -> Scale:
    highest = max([*logarithms(errors), math.log10(bound or 1.0) + 0.4])
    return Scale(LOWEST, max(math.ceil(highest), 2), infinity=math.inf in errors)


def _points(points: Sequence[Point], times: Scale, errors: Scale, to_page: BboxTransform) -> Iterator[Artist]:
    """A marker and a label each; a label that cannot stand beside its marker is tied to it by a line."""
    places = [to_page.transform((times.place(p.nanoseconds), errors.place(p.scaled))) for p in points]
    names = [_name(point.library) for point in points]
    labels = _labels([(float(x), float(y)) for x, y in places], names)
    for point, name, (x, y), label in zip(points, names, places, labels, strict=True):
        verdict = Verdict(point.verdict)
        middle = (label.y0 + label.y1) / 2
        near = label.x0 if label.x0 > x else label.x1
        if abs(middle - y) > LINE / 2:
            yield Line2D((x, near), (y, middle), color=LIMIT, linewidth=0.5, transform=IdentityTransform())
        yield Line2D(
            (x,),
            (y,),
            color=SHADES[verdict],
            linestyle="none",
            marker=MARKERS[verdict],
            markersize=6.0,
            markeredgewidth=0,
            transform=IdentityTransform(),
        )
        yield Text(
            near,
            middle,
            name,
            color=INK,
            parse_math=False,
            ha="left" if label.x0 > x else "right",
            va="center",
            transform=IdentityTransform(),
        )


def _name(library: str) -> str:
    """A library's label in one short line, of what Matplotlib can write."""
    line = " ".join(library.split()).encode("utf-8", "backslashreplace").decode()
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"


def _labels(places: Sequence[tuple[float, float]], names: Sequence[str]) -> list[Bbox]:
    """Where the labels stand: beside their points, and else as near as there is room, inside the plot."""
    taken = [Bbox.from_extents(x - 3, y - 3, x + 3, y + 3) for x, y in places]
    labels: list[Bbox] = []
    for (x, y), name in zip(places, names, strict=True):
        best = min(_beside(x, y, LETTER * len(name)), key=lambda box: _cost(box, x, y, taken))
        labels.append(best)
        taken.append(best)
    return labels


def _beside(x: float, y: float, width: float) -> Iterator[Bbox]:
    for lines in REACH:
        gap = 6.0 if lines == 0 else 12.0
        low = y + LINE * (lines - 0.5)
        yield Bbox.from_extents(x + gap, low, x + gap + width, low + LINE)
        yield Bbox.from_extents(x - gap - width, low, x - gap, low + LINE)


def _cost(box: Bbox, x: float, y: float, taken: Iterable[Bbox]) -> tuple[float, float]:
    """What lies under a label, or of it outside the plot; then how far it stands from its point."""
    left, bottom, right, top = AREA
    outside = max(left - box.x0, 0.0) + max(box.x1 - right, 0.0) + max(bottom - box.y0, 0.0) + max(box.y1 - top, 0.0)
    common = (Bbox.intersection(box, other) for other in taken)
    covered = sum(part.width * part.height for part in common if part is not None)
    return covered + LINE * outside, abs((box.y0 + box.y1) / 2 - y)
