"""What a law is: a statement about maps, true for all inputs of a domain, and how far a subject is from keeping it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from hypothesis.strategies import SearchStrategy

from affinecert.map import Array


class OutOfDomain(Exception):
    """The input lies outside the domain of the law that is being tried."""


class BadAnswer(Exception):
    """A subject's answer cannot be measured: a wrong shape, a number that is not finite, a matrix of another form."""


@dataclass(frozen=True)
class Law:
    """A statement that is true for all inputs of a domain (a lemma of a paper, an axiom of a group).

    ``inputs`` is a strategy of tuples of float64 arrays. ``residual(maps, *inputs)`` is how far the maps that the law
    ``needs`` are from keeping it there, over what output errors of u (|truth| + K) in each block, K the map's
    sensitivity at that input, account for to first order; it raises OutOfDomain for an input outside the domain.
    Answers as accurate as their data allow give residuals about 1; the law is kept up to ``bound``, as a map's answer
    is ok up to a scaled error of 16.
    """

    name: str
    statement: str
    source: str
    domain: str
    needs: tuple[str, ...]
    inputs: SearchStrategy[tuple[Array, ...]]
    residual: Callable[..., float]
    bound: float = 16.0
