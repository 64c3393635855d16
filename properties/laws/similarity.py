"""Similarities: what the exponential of SIM(3) does to shapes and volumes, and SE(3) within it."""

from __future__ import annotations

import numpy as np

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import CTX, Inexact, log_determinant, precisely, ratio
from affinecert.properties.law import Law


def _shape(maps: Maps, tangent: Array) -> float:
    linear = ask(maps, "sim3.exp", tangent).affine.linear
    gram = linear.T @ linear
    mean = np.trace(gram.value) / 3
    volume, error = log_determinant(linear)
    return max(
        gram.misfit(Inexact(mean * precisely(np.eye(3)).value)),
        ratio(abs(volume - 3 * CTX.mpf(float(tangent[6]))), error),
    )


def _rigid_exponential(maps: Maps, twist: Array) -> float:
    similarity = ask(maps, "sim3.exp", np.append(twist, 0.0)).affine
    return similarity.misfit(ask(maps, "se3.exp", twist).affine)


def _rigid_logarithm(maps: Maps, pose: Array) -> float:
    tangent, twist = ask(maps, "sim3.log", pose), ask(maps, "se3.log", pose)
    still = tangent["growth"].misfit(precisely(np.zeros(1)))
    return max(still, *(tangent[name].misfit(twist[name]) for name in ("omega", "v")))


LAWS = (
    Law(
        name="similarity.sim3.exp",
        statement="the linear part L of exp(omega, v, lambda) has L^T L = e^(2 lambda) I and det L = e^(3 lambda)",
        source="gallier, section 2, Proposition 2.2",
        domain="every tangent",
        needs=("sim3.exp",),
        inputs=strategies.tangents().map(lambda tangent: (tangent,)),
        residual=_shape,
    ),
    Law(
        name="similarity.rigid.exp",
        statement="exp(omega, v, 0) in SIM(3) is exp(omega, v) in SE(3)",
        source="gallier, Theorem 2.3, case 3; bansal_tatu, A.2.1",
        domain="every twist",
        needs=("sim3.exp", "se3.exp"),
        inputs=strategies.twists().map(lambda twist: (twist,)),
        residual=_rigid_exponential,
    ),
    Law(
        name="similarity.rigid.log",
        statement="the logarithm of a rigid motion in SIM(3) is that in SE(3), and lambda = 0",
        source="gallier, section 4; bansal_tatu, A.2.2",
        domain="rigid motions, to within the rounding of their entries",
        needs=("sim3.log", "se3.log"),
        inputs=special.rigid_maps(3).map(lambda pose: (pose,)),
        residual=_rigid_logarithm,
    ),
)
