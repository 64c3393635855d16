"""Sections 1, 2 and 6 with table 2: which parametrisation has which of the properties that are asked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.kaji_ochiai import charts
from affinecert.properties.claims.kaji_ochiai.charts import PARAMETRISATIONS
from affinecert.properties.claims.kaji_ochiai.conditions import COLUMNS, dimensions

Cells = tuple[bool | None, ...]
"""A row: whether a parametrisation has each property of `COLUMNS`; None where that is not said."""


@cache
def _found(name: str, column: str) -> bool:
    return COLUMNS[column](PARAMETRISATIONS[name])


def _contradicted(cells: Cells, case: tuple[str, str]) -> int:
    """Whether a cell is said, and not what is found."""
    said = dict(zip(COLUMNS, cells, strict=True))[case[1]]
    return int(said is not None and said is not _found(*case))


def _flipped(cells: Cells) -> Iterator[Copy[Cells]]:
    """The row with one cell of those that are said flipped, for each of them."""
    for k, (column, said) in enumerate(zip(COLUMNS, cells, strict=True)):
        if said is not None:
            yield Copy(f"{column}: {_word(not said)}", (*cells[:k], not said, *cells[k + 1 :]))


def _word(cell: bool | None) -> str:
    return {True: "yes", False: "no", None: "-"}[cell]


def _short(column: str) -> str:
    return column.partition(" ")[0] if column.startswith("(") else column


def _told(cells: Iterable[bool | None]) -> str:
    return ", ".join(f"{column} {_word(cell)}" for column, cell in zip(COLUMNS, cells, strict=True) if cell is not None)


def _table() -> Mapping[str, str]:
    """The whole table: of each parametrisation the dimensions, and each cell, ours and the paper's."""
    rows = {}
    for name, printed in PRINTED.items():
        space, group = dimensions(PARAMETRISATIONS[name])
        pairs = [f"{_short(c)} {_word(_found(name, c))}/{_word(p)}" for c, p in zip(COLUMNS, printed, strict=True)]
        rows[f"{name} (ours/the paper's)"] = f"{space} for {group} dimensions; " + ", ".join(pairs)
    return rows


NO, YES = False, True

PRINTED: Mapping[str, Cells] = {
    "matrices": (NO, None, None, YES, NO, NO, None, None),
    "Euler angles": (None, None, NO, None, None, None, None, None),
    "invertible quaternions": (NO, None, YES, NO, None, None, None, None),
    "unit quaternions": (NO, None, None, YES, None, None, None, None),
    "invertible dual quaternions": (NO, None, None, NO, None, None, None, None),
    "unit dual quaternions": (NO, None, None, YES, None, None, None, None),
    "Lie algebra of the rotations": (YES, YES, YES, YES, YES, None, None, None),
    charts.SHOEMAKE.name: (NO, None, YES, None, None, None, NO, None),
    charts.POLAR_DUAL.name: (NO, None, None, None, None, None, None, None),
    charts.POLAR_GRASSIA.name: (NO, None, None, None, None, None, None, None),
    "Lie algebra of the affine maps": (YES, YES, NO, YES, YES, None, YES, None),
    "the paper's": (YES, YES, YES, YES, YES, YES, NO, YES),
}
"""The table as the paper tells it in prose; the cells of its own are lost."""


def _row(name: str, place: str, slug: str, printed: str, remark: str = "", **other: Any) -> Claim[Any, Any]:
    """The entry of a row, confirmed unless told otherwise."""
    cells = PRINTED[name]
    stated: dict[str, Any] = {"verdict": Verdict.CONFIRMED, "copies": tuple(_flipped(cells)), **other}
    return Claim(
        id=f"kaji_ochiai.comparison.{slug}",
        place=place,
        statement=f"Of parametrisations, {name}: {_told(cells)}.",
        printed=printed,
        form=cells,
        cases=lambda: [(name, column) for column in COLUMNS],
        deviation=_contradicted,
        remark=remark,
        **stated,
    )


_ALL: Cells = (YES,) * 8

CLAIMS: tuple[Claim[Any, Any], ...] = (
    _row(
        "matrices",
        "section 6, matrices; section 3, equation 1",
        "matrices",
        "addition and scalar multiplication are not closed; the operations do not restrict to the important subclasses",
    ),
    _row(
        "Euler angles",
        "section 2, Euler angles",
        "euler_angles",
        "it suffers from the gimbal lock; the condition (III) is not satisfied",
        "What is not said: all else but (V) they have; rotations about an axis, unless one of the three, are no "
        "linear subspace.",
    ),
    _row(
        "invertible quaternions",
        "section 2, invertible quaternions",
        "invertible_quaternions",
        "greater by one than that of SO(3); almost Euclidean, except the origin",
    ),
    _row(
        "unit quaternions",
        "section 2, unit quaternions",
        "unit_quaternions",
        "the parameter space of the same dimension as SO(3); however, non-Euclidean",
        "A whole turn is -1 about every axis: they do not tell large rotations.",
    ),
    _row(
        "invertible dual quaternions",
        "section 6, Clifford algebras",
        "invertible_dual_quaternions",
        "the parameter space is not Euclidean; it generally has greater dimension",
    ),
    _row(
        "unit dual quaternions",
        "section 2, dual quaternions",
        "unit_dual_quaternions",
        "the space of the unit dual quaternions is the semi-direct product of the unit quaternions and R³",
        '"Generally greater dimension", section 6, is not of these: they have 6, as SE(3).',
    ),
    _row(
        "Lie algebra of the rotations",
        "section 6, Lie algebras of compact groups; section 2, Grassia",
        "rotation_vectors",
        "surjective and gives a parametrisation by a Euclidean space of the same dimension, which satisfies (II) and "
        "(IV); (V) is also satisfied",
        "The local inverse is that of parameters shorter than 2π: at a whole turn the differential has rank 1.",
    ),
    _row(
        charts.SHOEMAKE.name,
        "section 2, Shoemake; section 6, Shoemake; table 2",
        "shoemake",
        "to cover the entire Aff+(3); none of these parameter spaces is Euclidean; associativity, missing in [40]",
        "With spherical and linear joins multiples are associative as long as the stretch stays positive definite, "
        "so for all weights in [0, 1].",
    ),
    _row(
        charts.POLAR_DUAL.name,
        "section 4.4, table 2, Polar+DQ",
        "polar_dual_quaternions",
        "the positive definite symmetric matrices: not Euclidean",
        "What is not said: surjective with a local inverse, of the same dimension; no extrapolation, associativity, "
        "large rotation.",
    ),
    _row(
        charts.POLAR_GRASSIA.name,
        "sections 4.4 and 6, table 2, Polar+Grassia",
        "polar_rotation_vectors",
        "the positive definite symmetric matrices: not Euclidean",
        "What is not said: surjective with a local inverse, of the same dimension, large rotation; no extrapolation, "
        "no associativity.",
    ),
    _row(
        "Lie algebra of the affine maps",
        "sections 2 and 6, Alexa; table 2, Alexa/SAM",
        "alexa",
        "a Euclidean parameter space; differentiable; the condition (III) does not hold; (V) is also satisfied; "
        "associativity",
        "(III) fails at half turns too: they have logarithms, but eigenvalues of these are 2πi apart, so that the "
        "differential is singular. Whole turns it tells apart as the paper's does.",
    ),
    _row(
        "the paper's",
        "sections 3 to 6; table 2, the paper's row",
        "own",
        "satisfies all the conditions; handles large rotation; lacks in associativity",
        "See kaji_ochiai.6.drawbacks.associativity. The numbers are the whole table.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        correction=Correction(
            statement=f"It has all of the properties: {_told(_ALL)}, where |b| times the angle is below π.",
            form=_ALL,
        ),
        copies=tuple(_flipped(_ALL)),
        numbers=_table,
    ),
)
