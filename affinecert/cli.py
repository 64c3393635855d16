"""The command line. Nothing heavy is imported before a command needs it, so that --help is quick."""

from __future__ import annotations

import io
import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from affinecert.errors import AffinecertError, SubjectError

if TYPE_CHECKING:
    from rich.console import Console

    from affinecert.certificate import Certificate
    from affinecert.properties.claims.finding import Finding
    from affinecert.subject import Subject

WIDTH = 100
"""Columns where there is no terminal to ask."""

BAD_USE = 2
INTERRUPTED = 130
"""Exit codes: as of click for bad use, as of a shell for Ctrl-C. Findings give 1."""

KEPT = {
    "certify": ": finished cases are kept; the same command, without --fresh, goes on from them",
    "hunt": ": the trail is kept; the same command goes on from it",
}
"""What a command that is stopped leaves behind."""


class BadUse(click.ClickException):
    """What cannot be done as asked, told in one line."""

    exit_code = BAD_USE


class Commands(click.Group):
    """Tells the project's own errors, and Ctrl-C, in one line without a traceback."""

    def invoke(self, ctx: click.Context) -> Any:
        """See `click.Group.invoke`."""
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, io.TextIOWrapper):
                # A terminal that knows no "∞" gets its escape, and not a traceback.
                stream.reconfigure(errors="backslashreplace")
        try:
            return super().invoke(ctx)
        except AffinecertError as error:
            raise BadUse(str(error)) from error
        except KeyboardInterrupt:
            click.echo(f"stopped{KEPT.get(ctx.invoked_subcommand or '', '')}", err=True)
            raise click.exceptions.Exit(INTERRUPTED) from None


def _console(*, stderr: bool = False) -> Console:
    from rich.console import Console  # noqa: PLC0415

    stream = sys.stderr if stderr else sys.stdout
    width = None if stream.isatty() or "COLUMNS" in os.environ else WIDTH
    return Console(stderr=stderr, width=width, highlight=False, markup=False)


maps_option = click.option("--map", "maps", metavar="GLOB", default="*", show_default=True, help="Maps, by name.")
subject_argument = click.argument("subject", default="fast")
FOLDER = click.Path(file_okay=False, path_type=Path)
POSITIVE = click.FloatRange(min=0, min_open=True)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": WIDTH})
@click.version_option(package_name="affinecert")
def main() -> None:
    """Certify code for affine interpolation against arbitrary-precision truth.

    SUBJECT is the implementation under test: a name (fast is the built-in one; scipy, jaxlie, pinocchio and others are
    libraries), your own as module:attribute, or a program in any language as 'exec:COMMAND'. Exit codes: 0 passed,
    1 findings, 2 bad use.
    """


@main.command()
@subject_argument
@maps_option
@click.option(
    "--profile",
    type=click.Choice(["quick", "standard", "thorough"]),
    default="standard",
    show_default=True,
    help="How much is tried.",
)
@click.option("--out", type=FOLDER, help="Folder for the certificate.  [default: certificates/SUBJECT]")
@click.option("--jobs", type=click.IntRange(min=1), help="Processes.  [default: one a core]")
@click.option(
    "--limit",
    type=click.FloatRange(min=0, min_open=True),
    metavar="SECONDS",
    help="Time limit of a case, with two jobs or more.  [default: 20]",
)
@click.option("--fresh", is_flag=True, help="Do not go on from an interrupted run.")
@click.option(
    "--baseline",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="An earlier certificate.json: fail only on what got worse. Written if missing.",
)
@click.pass_context
def certify(
    ctx: click.Context,
    *,
    subject: str,
    maps: str,
    profile: str,
    out: Path | None,
    jobs: int | None,
    limit: float | None,
    fresh: bool,
    baseline: Path | None,
) -> None:
    """Certify SUBJECT against the truth.

    Every map in every regime, and every law; prints one table, the laws and the findings.

    Writes certificate.json, certificate.md and certificate.html. With a baseline the exit code is 1 only if something
    got worse: a graver verdict, a finding's error more than doubled, a map dropped, a law newly broken.
    """
    from affinecert import campaign, catalogue, ratchet, reports  # noqa: PLC0415
    from affinecert.judging import resolve  # noqa: PLC0415
    from affinecert.reports import ratchet as changes  # noqa: PLC0415
    from affinecert.reports import terminal  # noqa: PLC0415
    from affinecert.reports.progress import shown  # noqa: PLC0415

    chosen = {entry.name for entry in catalogue.matching(maps)}
    if chosen.isdisjoint(resolve(subject).maps):
        raise SubjectError(f"{subject} offers no map that matches {maps!r}")
    folder = out or Path("certificates") / re.sub(r"[^\w.-]+", ".", subject)
    reports.prepare(folder)
    before = _baseline(baseline, resolve(subject), folder) if baseline else None
    with shown(_console(stderr=True)) as update:
        certificate = campaign.certify(
            subject,
            maps=maps,
            profile=profile,
            jobs=jobs or os.cpu_count() or 1,
            fresh=fresh,
            limit=limit or campaign.CASE_SECONDS,
            progress=lambda done, total, doing: update(done / max(total, 1), doing),
        )
    console = _console()
    terminal.show(certificate, console)
    found = None
    if baseline:
        found = ratchet.ratchet(before, certificate) if before else ratchet.recorded(certificate)
        changes.show(found, certificate, console, baseline)
    for path in reports.write(certificate, folder, found):
        console.print(f"wrote {path}", style="dim", soft_wrap=True)
    if baseline and not before:
        reports.replace(baseline, reports.to_json(certificate))
    ctx.exit(0 if (found or certificate).passed else 1)


def _baseline(path: Path, subject: Subject, folder: Path) -> Certificate | None:
    """The baseline in a file, None if there is no such file: looked at before the work, as it may come to nothing."""
    from affinecert import certificate, ratchet, reports  # noqa: PLC0415

    if path.resolve() == (folder / "certificate.json").resolve():
        raise click.UsageError(f"the certificate would overwrite the baseline {path}: give another --out")
    if not path.exists():
        reports.prepare(path.parent)
        return None
    before = certificate.read(path)
    ratchet.require_same(before, subject.name, subject.dtype, str(path))
    return before


@main.command()
@click.argument("files", metavar="CERT...", nargs=-1, required=True, type=click.Path(path_type=Path))
@maps_option
@click.option("--json", "as_json", is_flag=True, help="As JSON, with every input.")
@click.option("--out", type=FOLDER, help="Folder for the comparison as Markdown and HTML.")
def compare(*, files: tuple[Path, ...], maps: str, as_json: bool, out: Path | None) -> None:
    """Compare libraries by their certificates.

    CERT is a certificate.json, or the folder that holds it. Rows are maps and regimes, columns libraries; a cell is the
    worst case there. Speeds are compared where all certificates are of one machine.

    affinecert compare certificates/* --out comparison
    """
    from affinecert import catalogue, certificate, reports  # noqa: PLC0415
    from affinecert import compare as comparing  # noqa: PLC0415
    from affinecert.reports import compare as told  # noqa: PLC0415

    if out:
        reports.prepare(out)
    read = [certificate.read(file / "certificate.json" if file.is_dir() else file) for file in files]
    chosen = None if maps == "*" else [entry.name for entry in catalogue.matching(maps)]
    found = comparing.compare(read, chosen)
    console = _console(stderr=as_json)
    if as_json:
        click.echo(told.as_json(found))
    else:
        told.show(found, console)
    for path in told.write(found, out) if out else ():
        console.print(f"wrote {path}", style="dim", soft_wrap=True)


@main.command()
@click.argument("library", metavar="MYLIB")
def init(library: str) -> None:
    """Write an adapter for the library MYLIB.

    Writes affinecert_MYLIB.py, an adapter with every map of the catalogue commented out, and
    .github/workflows/affinecert.yml, which certifies MYLIB at every push. Files that are there are not overwritten.
    """
    from affinecert.reports import adoption  # noqa: PLC0415

    adapter, workflow = adoption.adopt(library, Path())
    click.echo(f"wrote {adapter}: uncomment the maps that {library} has")
    click.echo(f"wrote {workflow}: replace {adoption.OWNER} there by the owner of affinecert's repository")
    click.echo(f"then: affinecert certify {adapter.stem}:subject")


@main.command(name="maps")
@click.option("--json", "as_json", is_flag=True, help="As JSON.")
def catalogue_(as_json: bool) -> None:
    """List the catalogue.

    Every map with its definition, source, domain and regimes.
    """
    from affinecert.catalogue import CATALOGUE  # noqa: PLC0415
    from affinecert.reports import explanation  # noqa: PLC0415

    if as_json:
        click.echo(explanation.catalogue_json(CATALOGUE.values()))
    else:
        explanation.show_catalogue(CATALOGUE.values(), _console())


@main.command()
@click.argument("map_", metavar="MAP")
@click.argument("inputs", metavar="INPUT")
@click.option("--subject", "subjects", multiple=True, help="Another subject to ask; may be repeated.")
def explain(map_: str, inputs: str, subjects: tuple[str, ...]) -> None:
    """Explain one INPUT of MAP.

    Shows the truth, what fast and other subjects answer, their errors and verdicts.

    INPUT is a JSON list of the map's arguments, or its only argument; numbers are decimal, or hexadecimal strings:

    affinecert explain so3.exp '[0.1, 0.2, "0x1.8p-2"]'
    """
    from affinecert import explain as explaining  # noqa: PLC0415
    from affinecert.reports import explanation  # noqa: PLC0415

    asked = tuple(dict.fromkeys(("fast", *subjects)))
    explanation.show(explaining.explain(map_, inputs, asked), _console())


@main.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--subject", default="fast", show_default=True, help="Who is asked.")
@click.pass_context
def replay(ctx: click.Context, file: Path, subject: str) -> None:
    """Judge the cases of FILE again.

    FILE is a corpus file (.jsonl), or a certificate (.json), of which the worst inputs are taken.
    """
    from affinecert import replay as replaying  # noqa: PLC0415
    from affinecert.judging import resolve  # noqa: PLC0415
    from affinecert.reports import explanation  # noqa: PLC0415
    from affinecert.scoring import Verdict  # noqa: PLC0415

    results = replaying.replay(replaying.load(file), resolve(subject))
    explanation.show_replay(results, _console())
    ctx.exit(1 if any(Verdict(result.verdict).is_finding for result in results) else 0)


@main.command()
@subject_argument
@click.option("--morph", metavar="GLOB", default="*", show_default=True, help="Morphs, by name.")
@click.option("--law", metavar="GLOB", default="*", show_default=True, help="Laws, by name.")
@click.option("--jobs", type=click.IntRange(min=1), help="Processes.  [default: one a core]")
@click.option("--json", "form", flag_value="json", help="As JSON, with every counterexample.")
@click.option("--markdown", "form", flag_value="markdown", help="As a table in Markdown.")
def laws(*, subject: str, morph: str, law: str, jobs: int | None, form: str | None) -> None:
    """Print which morph of SUBJECT keeps which law.

    Every cell is tried on pairs of poses from simple to complex, and confirmed by the reference. A law that a morph
    breaks is a property of the morph, and no finding. One morph, or one law, is told with its counterexamples:

    affinecert laws fast --morph linear
    """
    from affinecert import law_matrix  # noqa: PLC0415
    from affinecert.reports import markdown, matrix  # noqa: PLC0415

    cells = law_matrix.law_matrix(subject, morph=morph, law=law, jobs=jobs or os.cpu_count() or 1)
    console = _console()
    if form == "json":
        click.echo(matrix.as_json(cells))
    elif form == "markdown":
        click.echo(markdown.law_matrix(cells))
    elif len(matrix.rows(cells)) == 1 or len(matrix.columns(cells)) == 1:
        matrix.show_cells(cells, console)
    else:
        matrix.show(cells, console)


@main.command()
@click.argument("claim", metavar="[ID]", required=False)
@click.option("--paper", metavar="NAME", help="Claims of one paper.")
@click.option("--verdict", metavar="VERDICT", help="Claims that are confirmed, refuted, domain-bound or not-checkable.")
@click.option("--jobs", type=click.IntRange(min=1), help="Processes.  [default: one a core]")
@click.option("--json", "as_json", is_flag=True, help="As JSON.")
@click.option("--out", type=FOLDER, help="Folder for the ledger as JSON, Markdown and HTML, and for the errata.")
@click.pass_context
def claims(
    ctx: click.Context,
    *,
    claim: str | None,
    paper: str | None,
    verdict: str | None,
    jobs: int | None,
    as_json: bool,
    out: Path | None,
) -> None:
    """Check the claims of the papers; explain the one with that ID.

    Every statement that can be checked is held against the definition, as printed: confirmed, refuted with a
    counterexample and a correction, or holding on a domain. What is confirmed has perturbed copies, which the same
    check must refute.
    """
    from affinecert import ledger, reports  # noqa: PLC0415
    from affinecert.reports import claims as told  # noqa: PLC0415
    from affinecert.reports.progress import shown  # noqa: PLC0415

    chosen = (ledger.find(claim),) if claim else ledger.chosen(paper, verdict)
    if out:
        reports.prepare(out)
    findings: list[Finding] = []
    console = _console()

    def entries() -> tuple[told.Entry, ...]:
        return told.entries(chosen, findings)

    try:
        with shown(_console(stderr=True)) as update:
            for found in ledger.run(chosen, jobs=1 if claim else jobs or os.cpu_count() or 1):
                findings += found
                update(len(findings) / len(chosen), found[-1].claim)
    except KeyboardInterrupt:
        told.show(entries(), console)
        raise
    if as_json:
        click.echo(told.as_json(entries()))
    elif claim:
        told.show_entry(entries()[0], console)
    else:
        told.show(entries(), console)
    for path in told.write(entries(), out) if out else ():
        console.print(f"wrote {path}", style="dim", soft_wrap=True)
    ctx.exit(1 if any(finding.complaints for finding in findings) else 0)


@main.command()
@subject_argument
@maps_option
@click.option(
    "--budget",
    type=click.FloatRange(min=0, min_open=True),
    default=60.0,
    show_default=True,
    metavar="SECONDS",
    help="Time for all maps together.",
)
@click.option(
    "--evaluations", type=click.IntRange(min=1), metavar="N", help="Inputs tried of each map, instead of a budget."
)
@click.option("--seed", type=int, default=0, show_default=True)
@click.option(
    "--out", type=FOLDER, default=Path("hunts"), show_default=True, help="Folder for the catches and the trail."
)
@click.pass_context
def hunt(
    ctx: click.Context, *, subject: str, maps: str, budget: float, evaluations: int | None, seed: int, out: Path
) -> None:
    """Hunt for the worst inputs of SUBJECT.

    Climbs from the regimes and the corpus, shrinks what it catches, and keeps it in a corpus file.
    """
    from time import monotonic  # noqa: PLC0415

    from affinecert import hunt as hunting  # noqa: PLC0415
    from affinecert import reports  # noqa: PLC0415
    from affinecert.reports import explanation, view  # noqa: PLC0415
    from affinecert.reports.progress import shown  # noqa: PLC0415
    from affinecert.scoring import Verdict  # noqa: PLC0415

    reports.prepare(out)
    started = monotonic()
    with shown(_console(stderr=True)) as update:

        def told(tried: int, worst: float, doing: str) -> None:
            share = None if evaluations is not None else min((monotonic() - started) / budget, 1.0)
            update(share, f"worst {view.figure(worst)} u, {tried:,} tried, {doing}")

        found = hunting.hunt(subject, maps, budget=budget, evaluations=evaluations, seed=seed, out=out, progress=told)
    explanation.show_catches(found, subject, _console())
    ctx.exit(1 if any(Verdict(catch.verdict).is_finding for catch in found) else 0)


@main.command()
@click.option("--against", metavar="REV|FILE", required=True, help="A git revision, or a baseline file (.json).")
@maps_option
@click.pass_context
def bench(ctx: click.Context, against: str, maps: str) -> None:
    """Compare fast's speed and accuracy with another version.

    Base and head are run in turns, side by side. A baseline file that is not there yet is written.
    """
    from affinecert.benchmarks.against import compare  # noqa: PLC0415
    from affinecert.reports import benchmark  # noqa: PLC0415
    from affinecert.reports.progress import shown  # noqa: PLC0415

    with shown(_console(stderr=True)) as update:
        comparison = compare(against, maps, progress=lambda done, total, doing: update(done / max(total, 1), doing))
    benchmark.show(comparison, _console())
    ctx.exit(0 if comparison.passed else 1)


@main.command()
@click.option("--count", type=click.IntRange(min=1), default=10_000_000, show_default=True, help="Matrices tried.")
@click.option("--seed", type=int, default=0, show_default=True)
@click.option("--jobs", type=click.IntRange(min=1), help="Processes.  [default: one a core]")
@click.pass_context
def sweep(ctx: click.Context, count: int, seed: int, jobs: int | None) -> None:
    """Hold fast's sam.exists against exact truth.

    On random matrices, and on adversaries near the border of existence.
    """
    from affinecert import existence  # noqa: PLC0415
    from affinecert.reports import explanation  # noqa: PLC0415
    from affinecert.reports.progress import shown  # noqa: PLC0415

    with shown(_console(stderr=True)) as update:
        swept = existence.sweep(
            count,
            seed,
            jobs or os.cpu_count() or 1,
            lambda done, total: update(done / total, f"{done:,} matrices"),
        )
    explanation.show_sweep(swept, _console())
    ctx.exit(1 if swept.wrong else 0)
