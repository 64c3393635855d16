"""Affine maps and their twelve parameters tell one another: phi after psi, and psi near phi."""

from __future__ import annotations

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import CTX, affine, precisely
from affinecert.properties.law import Law, OutOfDomain

PARAMETRISE, NEAR, REALISE = (f"kaji_ochiai.{name}" for name in ("parametrise", "parametrise_near", "realise"))

# An error of the rotation vector, in radians, beyond which it may be nearer to another of the right ones.
KNOWN = CTX.mpf("0.1")


def _surjective(maps: Maps, matrix: Array) -> float:
    return ask(maps, REALISE, ask(maps, PARAMETRISE, matrix)).affine.misfit(affine(matrix))


def _unique(maps: Maps, parameters: Array) -> float:
    found = ask(maps, NEAR, ask(maps, REALISE, parameters), parameters)
    if found["rotation_vector"].error > KNOWN:
        raise OutOfDomain("a rotation vector that the affine map tells too roughly")
    return max(found[name].misfit(precisely(parameters[where])) for name, (where, _) in found.parts.items())


LAWS = (
    Law(
        name="parametrisation.realise",
        statement="phi(psi(A)) = A",
        source="kaji_ochiai, sections 1 (III) and 3",
        domain="every affine map of positive determinant",
        needs=(PARAMETRISE, REALISE),
        inputs=strategies.inputs(PARAMETRISE),
        residual=_surjective,
    ),
    Law(
        name="parametrisation.parametrise_near",
        statement="of the parameters of phi(x) those nearest to x are x",
        source="kaji_ochiai, section 4.3",
        domain="every x whose rotation vector is told by phi(x), once rounded, to a tenth of a radian",
        needs=(REALISE, NEAR),
        inputs=strategies.inputs(REALISE),
        residual=_unique,
    ),
)
