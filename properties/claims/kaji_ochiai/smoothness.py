"""Section 3, conditions (II) and (III): phi and its local inverses are differentiable."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.other_parametrisations import euler, local_determinant
from affinecert.properties.claims.kaji_ochiai.parametrisation import parameters_within_a_turn, phi
from affinecert.properties.claims.precision import exactly, mp, size
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, norm


def _absolute(m: Context, parameters: Array) -> Array:
    """Phi with the sizes of the entries of Y for Y."""
    return phi(m, np.concatenate([parameters[:6], np.abs(parameters[6:])]))


def _not_smooth(chart: Any, case: tuple[Array, Array]) -> Number:
    """The difference between the derivatives of a chart at parameters, in a direction, from the left and the right."""
    at, direction = case
    with mp.workdps(240):
        h = mp.mpf(10) ** -60
        here, ahead, behind = (chart(mp, at + direction * t) for t in (mp.zero, h, -h))
        # The difference of the one-sided quotients is h times the second derivative.
        return max(size((ahead - here) / h - (here - behind) / h) - size(direction) ** 2 * 1000 * h, mp.zero)


def _directions() -> list[tuple[Array, Array]]:
    return list(zip(parameters_within_a_turn()[:6], arrays("directions", 6, (12,), -1, 1), strict=True))


def _singular(chart: Any, omega: Array) -> int:
    return int(abs(local_determinant(chart, omega)) < 1e-30)


def _vectors(*lengths: Number) -> list[Array]:
    directions = [exactly(each) for each in ([0, 1, 0], [1, 0, 0], [1, 2, 2])]
    return [direction * (length / norm(mp, direction)) for length in lengths for direction in directions]


def _rotation_vector(m: Context, omega: Array) -> Array:
    return so3.exp(m, omega)


def _euler_of_vector(m: Context, omega: Array) -> Array:
    """Euler angles through the same numbers."""
    return euler(m, omega)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.3.condition_II",
        place="section 3, condition (II)",
        statement="φ is differentiable, also where eigenvalues of Y coincide.",
        verdict=Verdict.CONFIRMED,
        form=phi,
        cases=_directions,
        deviation=_not_smooth,
        copies=(Copy("the absolute values of the entries of Y", _absolute),),
    ),
    Claim(
        id="kaji_ochiai.3.condition_III",
        place="sections 1 and 3, condition (III)",
        statement="φ has a differentiable inverse round every value of its parameters: the differential is regular.",
        printed="there exists a differentiable local inverse; the correspondence is differentiable in both ways",
        verdict=Verdict.BOUND,
        domain="rotation vectors that are not as long as 2π, 4π, ...; there exp is singular across the axis",
        form=_rotation_vector,
        cases=lambda: _vectors(mp.mpf("1e-5"), mp.pi / 2, mp.pi, 2 * mp.pi - mp.mpf("1e-5"), mp.mpf(7)),
        outside=lambda: _vectors(2 * mp.pi, 4 * mp.pi),
        deviation=_singular,
        copies=(Copy("Euler angles, singular at a quarter turn about the second axis", _euler_of_vector),),
        remark="So ψ by principal logarithms is differentiable for angles below π, and continues through π, but not "
        "through 2π unless the axis stays.",
    ),
)
