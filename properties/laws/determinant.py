"""What homotopies of linear maps do to areas."""

from __future__ import annotations

from affinecert.map import Array
from affinecert.properties import special
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import CTX, cofactors, determinant, exact, log_determinant, norm, ratio, real
from affinecert.properties.law import Law


def _polar(maps: Maps, linear: Array, time: Array) -> float:
    (a, b), (c, d) = exact(linear)
    t, rest = exact(time).item(), 1 - exact(time).item()
    sum_of_stretches = norm([a + d, c - b])  # the trace of S, which is the largest trace(R^T A) of all rotations R
    expected = real(rest**2 + t**2 * (a * d - b * c)) + real(t * rest) * sum_of_stretches
    moved = ask(maps, "homotopy2.polar", linear, time).whole
    missed = abs(real(determinant(moved.value)) - expected)
    return ratio(missed, norm(cofactors(moved.value)) * moved.error)


def _exponential(maps: Maps, linear: Array, time: Array) -> float:
    found, error = log_determinant(ask(maps, "homotopy2.exponential", linear, time).whole)
    expected = CTX.log(real(determinant(exact(linear)))) * real(exact(time).item())
    return ratio(abs(found - expected), error)


LAWS = (
    Law(
        name="determinant.homotopy2.polar",
        statement="det A^P(t) = (1 + t (x - 1)) (1 + t (y - 1)), x and y the singular values of A",
        source="kaji_2d, section 3, after equation 2",
        domain="det A > 0; all real t",
        needs=("homotopy2.polar",),
        inputs=special.plane_maps_in_time(),
        residual=_polar,
    ),
    Law(
        name="determinant.homotopy2.exponential",
        statement="det A^E(t) = (det A)^t, so that it is never 0",
        source="kaji_2d, section 3, after equation 3",
        domain="det A > 0; all real t",
        needs=("homotopy2.exponential",),
        inputs=special.plane_maps_in_time(),
        residual=_exponential,
    ),
)
