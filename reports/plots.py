"""One small plot a regime: scaled error against distance to the singular set, both logarithmic, as inline SVG."""

from __future__ import annotations

import io
import logging
import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from html import escape

# Matplotlib tells the log where it finds no home folder, and when it looks for fonts: as early as it is imported.
logging.getLogger("matplotlib").setLevel(logging.ERROR)

import matplotlib as mpl  # noqa: E402
from matplotlib.artist import Artist  # noqa: E402
from matplotlib.backends.backend_svg import FigureCanvasSVG  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Rectangle  # noqa: E402
from matplotlib.text import Text  # noqa: E402
from matplotlib.transforms import Bbox, BboxTransform, IdentityTransform  # noqa: E402

from affinecert.arithmetic import Arithmetic  # noqa: E402
from affinecert.certificate import RegimeResult  # noqa: E402
from affinecert.reports.view import MapView, error, tally  # noqa: E402
from affinecert.scoring import Verdict  # noqa: E402

COLOURS: Mapping[str, str] = {
    "#000001": "var(--ink)",
    "#000002": "var(--faint)",
    "#000003": "var(--limit)",
    "#000004": "var(--beyond)",
    **{f"#0000{rank:02x}": f"var(--{verdict})" for rank, verdict in enumerate(Verdict, 16)},
}
"""Stand-ins that Matplotlib writes, and the page's own colours that take their place: light and dark by style sheet."""

INK, FAINT, LIMIT, BEYOND = list(COLOURS)[:4]
SHADES = dict(zip(Verdict, list(COLOURS)[4:], strict=True))

MARKERS: Mapping[Verdict, str] = {
    Verdict.OK: "o",
    Verdict.OTHER_BRANCH: "D",
    Verdict.ABSENT: ".",
    Verdict.DEGRADED: "^",
    Verdict.WRONG: "s",
    Verdict.NON_FINITE: "X",
    Verdict.RAISED: "P",
}
"""A shape a verdict, so that nobody needs to tell them by colour."""

WIDTH, HEIGHT = 216, 144
AREA = (28, 19, 213, 140)
GAP = 4
"""Points: the whole plot; what its grid spans, as left, bottom, right, top; and from there to the labels."""

LOWEST = -2.0
"""Decimal exponent of the lowest error told apart: below a hundredth of u an answer is simply the nearest float64."""

STEPS = (1, 2, 3, 4, 5, 8, 10, 20, 40, 50, 80, 100, 200)
"""Decades between two ticks; the last is enough for all of float64 and for a quotient of two."""

GUTTER = 0.09
"""The share of an axis that is set aside for distance 0 and for infinite errors."""


@dataclass(frozen=True)
class Scale:
    """A logarithmic axis from 10**low to 10**high, with places of their own for 0 and for infinity beside it."""

    low: float
    high: float
    zero: bool = False
    infinity: bool = False

    @property
    def _gutter(self) -> float:
        return GUTTER * (self.high - self.low)

    @property
    def limits(self) -> tuple[float, float]:
        """The ends of the axis."""
        margin = 0.03 * (self.high - self.low)
        low = self.low - (self._gutter if self.zero else 0.0)
        high = self.high + (self._gutter if self.infinity else 0.0)
        return low - margin, high + margin

    def place(self, value: float) -> float:
        """Where a number from 0 to infinity stands; one below the axis stands at its foot."""
        if math.isinf(value):
            return self.high + self._gutter
        if value == 0.0 and self.zero:
            return self.low - self._gutter
        return max(math.log10(value), self.low) if value > 0.0 else self.low

    @property
    def ticks(self) -> tuple[list[float], list[str]]:
        """At most five powers of ten, and the places of 0 and infinity."""
        step = next(step for step in STEPS if step * 4 >= self.high - self.low)
        # Counted from 10**0, so that 1 has its tick wherever it is in sight.
        exponents = range(step * math.ceil(self.low / step), math.floor(self.high) + 1, step)
        ticks = [(float(exponent), _power(exponent)) for exponent in exponents]
        if self.zero:
            ticks = [(self.place(0.0), "0"), *(tick for tick in ticks if tick[0] > self.low + self._gutter)]
        if self.infinity:
            ticks = [*(tick for tick in ticks if tick[0] < self.high - self._gutter), (self.place(math.inf), "∞")]
        return [place for place, _ in ticks], [label for _, label in ticks]


def _power(exponent: int) -> str:
    if exponent in (0, 1):
        return str(10**exponent)
    return "10" + str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def _logarithms(values: Iterable[float]) -> list[float]:
    return [math.log10(value) for value in values if 0.0 < value < math.inf]


def _error_scale(view: MapView) -> Scale:
    """Common to a map's plots: above all its errors, and above its bound."""
    errors = [scaled for result in view.results for _, scaled, _ in result.points]
    highest = max([*_logarithms(errors), math.log10(view.bound or 1.0) + 0.4])
    return Scale(LOWEST, max(math.ceil(highest), 2), infinity=math.inf in errors)


def _distance_scale(result: RegimeResult) -> Scale:
    distances = [distance for distance, _, _ in result.points]
    logarithms = _logarithms(distances) or [0.0]
    low, high = math.floor(min(logarithms)), math.ceil(max(logarithms))
    if high - low < 2:
        low, high = low - 1, high + 1
    return Scale(low, high, zero=0.0 in distances, infinity=math.inf in distances)


def plots(view: MapView, arithmetic: Arithmetic) -> tuple[str, ...]:
    """An SVG element for each regime of a map, in order, on a common scale of errors."""
    errors = _error_scale(view)
    with mpl.rc_context({"svg.fonttype": "none", "font.size": 8.0, "path.simplify": False, "text.usetex": False}):
        return tuple(_plot(result, view.bound, arithmetic.lost_half, errors) for result in view.results)


def _plot(result: RegimeResult, bound: float | None, lost_half: float, errors: Scale) -> str:
    """The plot of one regime, drawn by lines and texts alone: Matplotlib's axes would take three times as long."""
    canvas = Figure(figsize=(WIDTH / 72, HEIGHT / 72), dpi=72, facecolor="none")
    FigureCanvasSVG(canvas)
    distances = _distance_scale(result)
    (left, right), (bottom, top) = distances.limits, errors.limits
    to_page = BboxTransform(Bbox.from_extents(left, bottom, right, top), Bbox.from_extents(*AREA))
    for artist in (
        *_bound(bound, lost_half, distances, errors),
        *_grid(distances, errors),
        *_points(result, distances, errors),
    ):
        artist.set_transform(to_page)
        canvas.add_artist(artist)
    for place, label in zip(*distances.ticks, strict=True):
        x, y = to_page.transform((place, bottom))
        canvas.add_artist(Text(x, y - GAP, label, color=INK, ha="center", va="top", transform=IdentityTransform()))
    for place, label in zip(*errors.ticks, strict=True):
        x, y = to_page.transform((left, place))
        canvas.add_artist(Text(x - GAP, y, label, color=INK, ha="right", va="center", transform=IdentityTransform()))
    return _inline(canvas, f"{result.map}/{result.regime}", _label(result))


def _bound(bound: float | None, lost_half: float, distances: Scale, errors: Scale) -> Iterator[Artist]:
    """The bound as a line; what lies beyond it is shaded, and half of all digits a thinner line."""
    if not bound:  # unknown, or that of a predicate, whose answers are right or wrong
        return
    left, right = distances.limits
    height, half = math.log10(bound), math.log10(lost_half)
    yield Rectangle((left, height), right - left, errors.limits[1] - height, color=BEYOND, linewidth=0)
    yield Line2D((left, right), (height, height), color=LIMIT, linewidth=1.0)
    if half < errors.high:
        yield Line2D((left, right), (half, half), color=LIMIT, linewidth=0.7, linestyle=(0, (3, 2)))


def _grid(distances: Scale, errors: Scale) -> Iterator[Artist]:
    for place in distances.ticks[0]:
        yield Line2D((place, place), errors.limits, color=FAINT, linewidth=0.6)
    for place in errors.ticks[0]:
        yield Line2D(distances.limits, (place, place), color=FAINT, linewidth=0.6)


def _points(result: RegimeResult, distances: Scale, errors: Scale) -> Iterator[Artist]:
    """A marker a case; from the best verdict to the worst, so that the worst lies on top."""
    for verdict in Verdict:
        places = [(distances.place(d), errors.place(e)) for d, e, found in result.points if found == verdict]
        if places:
            yield Line2D(
                *zip(*places, strict=True),
                color=SHADES[verdict],
                linestyle="none",
                marker=MARKERS[verdict],
                markersize=3.0 if verdict is Verdict.OK else 4.5,
                markeredgewidth=0,
            )


def _label(result: RegimeResult) -> str:
    worst = f", worst {error(result.worst.scaled)} u" if result.worst else ""
    return f"Scaled error against {result.distance}: {tally(result.verdicts) or 'no cases'}{worst}"


def _inline(canvas: Figure, name: str, label: str) -> str:
    """The figure as an element to stand inside HTML: described, with names of its own, and in the page's colours."""
    stream = io.StringIO()
    with mpl.rc_context({"svg.hashsalt": ascii(name)}):
        canvas.savefig(stream, format="svg", metadata={"Date": None})
    text = stream.getvalue()
    text = re.sub(
        r"<metadata>.*?</metadata>|<style.*?</style>|<!--.*?-->", "", text[text.index("<svg") :], flags=re.DOTALL
    )
    head = f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(label)}">'
    text = head + text[text.index(">") + 1 :]
    # Ids that nothing refers to would stand more than once on the page.
    text = re.sub(r' id="([^"]*)"', lambda found: found[0] if f"#{found[1]}" in text else "", text)
    text = text.replace("xlink:href", "href")
    text = re.sub(r"font-family: [^;\"]*;?", "", text)
    text = re.sub(r"\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), text)
    text = re.sub(r"\s*\n\s*", " ", text)
    for stand_in, colour in COLOURS.items():
        text = text.replace(stand_in, colour)
    return text
