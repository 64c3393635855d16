"""Exponential and logarithm undo each other, on the domains where they do."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import Answer, near_rigid, near_rotation, near_symmetric
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import CTX, UNDECIDED, exact, norm, precisely
from affinecert.properties.law import Law, OutOfDomain


def _blocks(answer: Answer, due: Answer) -> float:
    return max(answer[name].misfit(due[name]) for name in answer.parts)


def _exactly(array: Array, like: Answer) -> Answer:
    return Answer(array, {name: (where, CTX.zero) for name, (where, _) in like.parts.items()})


def _log_of_exp(family: str, maps: Maps, element: Array) -> float:
    whole = ask(maps, f"{family}.exp", element)
    if family in {"so3", "se3"}:
        _inside_the_cut(element[:3], whole)
    back = ask(maps, f"{family}.log", whole)
    if family == "sym3":
        return _blocks(back, near_symmetric(element, "logarithm"))
    return _blocks(back, _exactly(element, back))


KNOWN: Mapping[str, Callable[[Array], Answer]] = {
    "so3": near_rotation,
    "se3": near_rigid,
    "sym3": partial(near_symmetric, name="exponential"),
}
"""What a matrix that is in a group but for its rounding stands for."""


def _inside_the_cut(omega: Array, rotation: Answer) -> None:
    """OutOfDomain if the angle is not below pi, by more than the error of the rotation."""
    if norm(exact(omega)) + UNDECIDED * rotation["rotation"].error >= CTX.pi:
        raise OutOfDomain("an angle of pi or more")


def _exp_of_log(family: str, maps: Maps, element: Array) -> float:
    back = ask(maps, f"{family}.exp", ask(maps, f"{family}.log", element))
    known = KNOWN.get(family, partial(_exactly, like=back))
    return _blocks(back, known(element))


def _log_near(maps: Maps, omega: Array) -> float:
    rotation = ask(maps, "so3.exp", omega)
    turns = norm(exact(omega)) / (2 * CTX.pi)
    to_full_turn = 2 * CTX.pi * abs(turns - max(1, CTX.nint(turns)))
    if to_full_turn <= UNDECIDED * rotation["rotation"].error:
        raise OutOfDomain("a full turn, whose axis cannot be told")
    found = ask(maps, "so3.log_near", rotation, omega)
    return _blocks(found, _exactly(omega, found))


def _log_of_power(maps: Maps, matrix: Array, time: Array) -> float:
    whole = ask(maps, "sam.log", matrix)
    short = ask(maps, "sam.log", ask(maps, "sam.power", matrix, time))
    factor = precisely(time.reshape(1, 1))
    return max((factor * whole[name]).misfit(short[name]) for name in whole.parts)


BELOW_PI = "angles below pi, by more than the rounding of the rotation"


def _pair(family: str, source: str, log_domain: str, exp_domain: str) -> tuple[Law, Law]:
    exp, log = f"{family}.exp", f"{family}.log"
    return (
        Law(
            name=f"exp_log.{log}",
            statement="log(exp x) = x",
            source=source,
            domain=log_domain,
            needs=(exp, log),
            inputs=strategies.inputs(exp),
            residual=partial(_log_of_exp, family),
        ),
        Law(
            name=f"exp_log.{exp}",
            statement="exp(log X) = X",
            source=source,
            domain=exp_domain,
            needs=(exp, log),
            inputs=strategies.inputs(log),
            residual=partial(_exp_of_log, family),
        ),
    )


LAWS = (
    *_pair("so3", "bansal_tatu, A.2.1 and A.2.2", BELOW_PI, "every rotation, angle pi too"),
    Law(
        name="exp_log.so3.log_near",
        statement="the logarithm of exp x nearest to x is x",
        source="kaji_ochiai (the logarithm closest to a given one)",
        domain="every x but those whose angle is within rounding of 2 pi, 4 pi, ...",
        needs=("so3.exp", "so3.log_near"),
        inputs=strategies.inputs("so3.exp"),
        residual=_log_near,
    ),
    *_pair("se3", "bansal_tatu, A.2.1 and A.2.2", BELOW_PI, "every rigid motion, angle pi too"),
    *_pair("shear", "bansal_tatu, A.2.3 and A.2.4", "every element of the algebra", "every element of G_A"),
    *_pair("scale", "bansal_tatu, A.2.5", "every number", "every positive number"),
    *_pair(
        "sym3",
        "kaji_ochiai, equations 6 and 7",
        "every symmetric matrix whose exponential is positive definite once rounded",
        "every symmetric positive definite matrix",
    ),
    Law(
        name="exp_log.sam.log",
        statement="log(A^t) = t log A",
        source="rossignac_vinacua, section 2.2, equation 2",
        domain="A with a real logarithm, of the plane and of space; 0 <= t <= 1/2, which keeps every angle of A^t at "
        "pi/2 or below (up to t = 1 it is true, but rounding may carry A^t over the cut)",
        needs=("sam.log", "sam.power"),
        inputs=st.tuples(
            strategies.affine_maps(),
            strategies.inner_times().map(lambda time: np.asarray(time / 2)),
        ),
        residual=_log_of_power,
    ),
)
