"""Section 5.2, the experiment: how much rotations may be perturbed so that they keep a logarithm."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import mp
from affinecert.properties.claims.rossignac_vinacua.perturbed_rotations import (
    Floats,
    all_patterns,
    bad_patterns,
    is_bad,
    least_bad,
    orbits,
    perturbed,
    rotation_by,
    vertices,
)
from affinecert.reference._matrices import Number


def _beyond(printed: str, last: int) -> Number:
    """How far a printed bound is above the least bad p."""
    decided = least_bad(last)
    matrix = perturbed(rotation_by(np.array(decided.axis), decided.degrees), decided.pattern, decided.size)
    if not is_bad(matrix):
        raise ValueError(f"{matrix} has a real logarithm")
    return max(mp.mpf(printed) - mp.mpf(decided.size), mp.zero)


def _not_decreasing(degrees: tuple[int, ...], _: None) -> int:
    sizes = [least_bad(each).size for each in degrees]
    return int(any(later >= earlier for earlier, later in pairwise(sizes)))


def _measured(last: int, printed: str) -> Any:
    """The numbers of one range."""

    def measured() -> dict[str, Any]:
        decided = least_bad(last)
        rotation = rotation_by(np.array(decided.axis), decided.degrees)
        matrix = perturbed(rotation, decided.pattern, decided.size)
        return {
            "bound, printed": printed,
            "bound, found": decided.size,
            "angle in degrees": decided.degrees,
            "axis": decided.axis,
            "pattern": all_patterns()[0][decided.pattern].astype(int).tolist(),
            "det": float(np.linalg.det(matrix)),
            "eigenvalues": sorted(np.linalg.eigvals(matrix).real.tolist()),
        }

    return measured


def _reduction() -> dict[str, Any]:
    """That the symmetries may be used: bad patterns at p = 0.3, counted for all axes and turns, and by orbits."""
    size = np.array([0.3])
    each = {degrees: [_count(axis, degrees, size) for axis in range(len(vertices()))] for degrees in (120, -120)}
    by_orbits = 2 * sum(each[120][axis] * count for axis, count in orbits())
    return {
        "vertices of the icosahedron": len(vertices()),
        "vertices by symmetry": len(orbits()),
        "bad patterns at 120 degrees and p = 0.3, all vertices, both turns": sum(each[120] + each[-120]),
        "the same, by symmetry": by_orbits,
        "least p with a reversed orientation": 1 / 3,
    }


def _count(axis: int, degrees: float, size: Floats) -> int:
    return int(bad_patterns(rotation_by(vertices()[axis], degrees), size)[1].sum())


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.2.bound_120",
        place="section 5.2, the experiment",
        statement="For rotations by less than 2π/3 all perturbations by p < 0.29 leave a real logarithm.",
        printed="θ < 2π/3: p < 0.29",
        verdict=Verdict.CONFIRMED,
        form="0.29",
        cases=lambda: [120],
        deviation=_beyond,
        copies=(Copy("0.30", "0.30"),),
        numbers=lambda: {**_measured(120, "0.29")(), **_reduction()},
        remark="Of the axes that were sampled.",
    ),
    Claim(
        id="rossignac_vinacua.5.2.bound_90",
        place="section 5.2, the experiment",
        statement="For rotations by less than π/2 all perturbations up to 0.33 leave a real logarithm.",
        printed="θ < π/2: p up to .33",
        verdict=Verdict.CONFIRMED,
        form="0.33",
        cases=lambda: [90],
        deviation=_beyond,
        copies=(Copy("0.34", "0.34"),),
        numbers=_measured(90, "0.33"),
        remark="At p = 1/3 the first perturbed matrix is singular, at any angle with a rotation that carries a vector "
        "of signs to another.",
    ),
    Claim(
        id="rossignac_vinacua.5.2.bound_45",
        place="section 5.2, the experiment",
        statement="For rotations by less than π/4 all perturbations up to 0.50 leave a real logarithm.",
        printed="θ < π/4: p up to .50",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form="0.50",
        cases=lambda: [45],
        deviation=_beyond,
        correction=Correction(
            statement="... up to 0.44, of the perturbed matrices that preserve the orientation; they all do so up to "
            "1/3 only, which is a bound for π/4 and for π/2.",
            form="0.44",
        ),
        copies=(Copy("0.45", "0.45"),),
        numbers=_measured(45, "0.50"),
        remark="The bad p are slivers next to a determinant of 0, which coarse steps of p or of the angle miss; the "
        "identity itself allows for 0.50.",
    ),
    Claim(
        id="rossignac_vinacua.5.2.bound_decreases",
        place="section 5.2, the experiment",
        statement="The bound on p decreases as the bound on the angle increases.",
        verdict=Verdict.CONFIRMED,
        form=(45, 90, 120),
        cases=lambda: [None],
        deviation=_not_decreasing,
        copies=(Copy("the other way round", (120, 90, 45)),),
    ),
)
