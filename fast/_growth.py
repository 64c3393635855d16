"""Two stages that most maps share: the logarithm on three eigenvalues, and the power on them.

Eigenvalues and functions on them are as `affinecert.fast._three_nodes` has them, told by four double-doubles each.
"""

from __future__ import annotations

import math

from affinecert.fast._double_double import ONE, divide, multiply, scaled, subtract
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._spectrum import HALF_TURN
from affinecert.fast._three_nodes import Gaps, Values, bent, exponential, logarithm, multiple, product, separation

# Eigenvalues below this are away from 1.
SMALL = 0.5

VALUES = (4, 2)
"""The shape of what tells three eigenvalues, or a function on them."""


@compiled
def values(pairs: Array) -> Values:
    """Four double-doubles from an array of pairs."""
    return (
        complex(pairs[0, 0], pairs[0, 1]),
        complex(pairs[1, 0], pairs[1, 1]),
        complex(pairs[2, 0], pairs[2, 1]),
        complex(pairs[3, 0], pairs[3, 1]),
    )


@compiled
def write(four: Values, pairs: Array) -> None:
    """Writes four double-doubles as pairs."""
    pairs[0, 0], pairs[0, 1] = four[0].real, four[0].imag
    pairs[1, 0], pairs[1, 1] = four[1].real, four[1].imag
    pairs[2, 0], pairs[2, 1] = four[2].real, four[2].imag
    pairs[3, 0], pairs[3, 1] = four[3].real, four[3].imag


@kernel(inputs={"nodes": VALUES, "exponent": (), "existence": ()}, outputs=(VALUES, VALUES, VALUES))
def logarithms(
    nodes: Array, exponent: float, existence: float, log: Array, ratio: Array, setting: Array, _status: Array
) -> None:
    """The functions log(x) and log(x) / (x - 1) on the nodes (m, delta, m^2 - delta, mu) times 2^exponent.

    ``existence`` says whether the pair is a half turn; then slopes refer to its unit generator. ``setting`` is
    (m, delta, mu, separation).
    """
    m, delta, determinant, mu = values(nodes)
    half_turn = existence == HALF_TURN
    if half_turn:
        delta, determinant = complex(-1.0, 0.0), multiply(m, m)
    gaps = (delta, subtract(mu, m))
    distance = separation(m, delta, mu)
    logs, ratios = logarithm(m, determinant, mu, gaps, int(exponent), half_turn)
    write(bent(logs, gaps[1], distance), log)
    write(bent(ratios, gaps[1], distance), ratio)
    write((m, delta, mu, distance), setting)


@compiled
def _over_one_less(m: complex, mu: complex, gaps: Gaps, unit: float) -> Values:
    """The function 1 / (x - 1) on nodes away from 1; ``unit`` is the slope of x."""
    mean, single = subtract(scaled(m, unit), ONE), subtract(scaled(mu, unit), ONE)
    determinant = subtract(multiply(mean, mean), scaled(scaled(gaps[0], unit), unit))
    slope = divide(complex(-unit, 0.0), determinant)
    return divide(mean, determinant), slope, divide(ONE, single), divide(scaled(slope, -unit), single)


@kernel(
    inputs={"exponent": (), "existence": (), "log": VALUES, "ratio": VALUES, "setting": VALUES, "t": ()},
    outputs=(VALUES, VALUES),
)
def powers(
    exponent: float,
    existence: float,
    log: Array,
    ratio: Array,
    setting: Array,
    t: float,
    power: Array,
    quotient: Array,
    _status: Array,
) -> None:
    """The functions x^t and (x^t - 1) / (x - 1) on the nodes."""
    m, delta, mu, distance = values(setting)
    gaps = (delta, subtract(mu, m))
    x = multiple(values(log), t)
    grown, growth = exponential(x, gaps, distance)
    write(grown, power)
    result = multiple(product(growth, values(ratio), gaps), t)
    unit = math.ldexp(1.0, int(exponent))
    if unit * (abs(m.real) + math.sqrt(abs(delta.real))) < SMALL and existence != HALF_TURN:
        # The slopes of those factors are like the logarithm's at 0 and cancel; those of x^t - 1 and 1 / (x - 1) do not.
        less = product(x, growth, gaps)
        small = product((less[0], grown[1], less[2], grown[3]), _over_one_less(m, mu, gaps, unit), gaps)
        result = small[0], small[1], result[2], small[3] if unit * mu.real < SMALL else result[3]
    write(bent(result, gaps[1], distance), quotient)
