"""Section 3: the parameters, and the map phi of them."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.other_parametrisations import partial_derivative
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference import kaji_ochiai
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, homogeneous, identity, norm


def skew(x: Array) -> Array:
    """The matrix X of three parameters, as printed."""
    x4, x5, x6 = x
    return array([[mp.zero, x4, x5], [-x4, mp.zero, x6], [-x5, -x6, mp.zero]])


def symmetric(y: Array) -> Array:
    """The matrix Y of six parameters, as printed."""
    y7, y8, y9, y10, y11, y12 = y
    return array([[y7, y8, y9], [y8, y10, y11], [y9, y11, y12]])


def phi(m: Context, parameters: Array) -> Array:
    """Equation 2, by the series of exponentials; the parameters are numbered as printed, but x is a rotation vector."""
    x, y = cross_matrix(m, parameters[3:6]), symmetric(parameters[6:])
    linear = definitions.exponential(m, x) @ definitions.exponential(m, y)
    return homogeneous(m, linear, parameters[:3])


def _first_order(m: Context, parameters: Array) -> Array:
    """Phi with I + Y for exp Y."""
    x, y = cross_matrix(m, parameters[3:6]), symmetric(parameters[6:])
    return homogeneous(m, definitions.exponential(m, x) @ (identity(m, 3) + y), parameters[:3])


def parameters_within_a_turn() -> list[Array]:
    """Parameters with rotation vectors shorter than pi; zero, and with a triple and a double eigenvalue, first."""
    zero = exactly([0] * 12)
    triple, double = zero.copy(), zero.copy()
    triple[[0, 3, 6, 9, 11]] = exactly([1, 2, 1, 1, 1])
    double[[1, 4, 6, 9, 11]] = exactly([-2, 1, 1, 1, -1])
    return [zero, triple, double, *arrays("parameters", 5, (12,), -1.5, 1.5)]


def affine_maps() -> list[Array]:
    """Affine maps of positive determinant: one without a logarithm, a shear, a half turn, and drawn ones."""
    corners = (
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[1, 3, 0], [0, 1, 0], [0, 0, 1]],
        [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
    )
    drawn = [each for each in arrays("affine", 9, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    shifts = arrays("translations", 20, (3,), -2, 2)
    linears = [exactly(each) for each in corners] + drawn
    return [homogeneous(mp, linear, shift) for linear, shift in zip(linears, shifts[: len(linears)], strict=True)]


def _dimensions_off(stated: tuple[int, int, int, int], _: None) -> int:
    """How far stated dimensions are from those of R^3, so(3), sym(3) and of the image of the differential of phi."""
    transposed = np.zeros((9, 9))
    for i in range(3):
        for j in range(3):
            transposed[3 * i + j, 3 * j + i] = 1
    unit = np.eye(9)
    skew_count = 9 - int(np.linalg.matrix_rank(unit + transposed))
    symmetric_count = 9 - int(np.linalg.matrix_rank(unit - transposed))
    rates = [partial_derivative(lambda p: kaji_ochiai.realise(mp, p), exactly([0] * 12), k) for k in range(12)]
    whole = int(np.linalg.matrix_rank(np.array([rate.reshape(-1) for rate in rates], dtype=np.float64)))
    found = (3, skew_count, symmetric_count, whole)
    return max(abs(a - b) for a, b in zip(stated, found, strict=True))


def _asymmetry(form: tuple[Any, Any], numbers: Array) -> Number:
    x, y = form[0](numbers[:3]), form[1](numbers[3:])
    return max(difference(x.T, -x), difference(y.T, y))


def _symmetric_slipped(y: Array) -> Array:
    return np.asarray(symmetric(y) + array([[0, 0, 0], [0, 0, 0], [y[1] - y[2], 0, 0]]))


def _split(order: int) -> Any:
    def product(m: Context, affine: Array) -> Array:
        shift = homogeneous(m, identity(m, 3), affine[:3, 3])
        linear = homogeneous(m, affine[:3, :3], exactly([0, 0, 0]))
        found: Array = (shift @ linear) if order > 0 else (linear @ shift)
        return found

    return product


def _determinant_off(chart: Any, parameters: Array) -> Number:
    """How far det phi is from exp(tr Y), which is positive for all parameters."""
    trace = parameters[6] + parameters[9] + parameters[11]
    return abs(definitions.determinant(chart(mp, parameters)) / mp.exp(trace) - 1)


def _free_parameters() -> list[Array]:
    return [*parameters_within_a_turn(), *arrays("free parameters", 3, (12,), -6, 6)]


def _path(order: int) -> Any:
    """The path phi(t psi(A)) from the identity; or with -Y for Y on half of it."""

    def path(affine: Array, t: Number) -> Array:
        parameters = kaji_ochiai.parametrise(mp, affine)
        if order < 0:
            return homogeneous(mp, identity(mp, 3) * (1 - t) + affine[:3, :3] * t, parameters[:3] * t)
        return kaji_ochiai.realise(mp, parameters * t)

    return path


def _disconnected(path: Any, affine: Array) -> int:
    """Whether a path from the identity to a map misses either, or leaves the maps of positive determinant."""
    times = [mp.mpf(k) / 12 for k in range(13)]
    ends = max(difference(path(affine, times[0]), identity(mp, 4)), difference(path(affine, times[-1]), affine))
    return int(ends > 1e-50 or any(definitions.determinant(path(affine, t)[:3, :3]) <= 1e-30 for t in times))


def _lengthened(turn: Number) -> Any:
    """The rotation vector lengthened k times by a turn."""

    def longer(x: Array, k: int) -> Array:
        return np.asarray(x * (1 + k * turn / norm(mp, x)))

    return longer


def _not_one_preimage(longer: Any, case: tuple[Array, int]) -> Number:
    """How far phi of other parameters is from that of given ones, and psi of it from the given, principal, ones."""
    parameters, k = case
    other = np.concatenate([parameters[:3], longer(parameters[3:6], k), parameters[6:]])
    affine = phi(mp, other)
    return max(distance(affine, phi(mp, parameters)), difference(kaji_ochiai.parametrise(mp, affine), parameters))


def _one_to_one(pair: tuple[Array, Array], _: None) -> int:
    """Whether two different elements of the algebra fail to have one exponential."""
    a, b = (definitions.exponential(mp, cross_matrix(mp, each)) for each in pair)
    return int(difference(a, b) > 1e-50 or difference(*pair) < 1)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.3.not_one_to_one",
        place="section 3, first point",
        statement="Different elements of the Lie algebra may have one exponential: 0, and a whole turn.",
        verdict=Verdict.CONFIRMED,
        form=(exactly([0, 0, 0]), exactly([1, 2, 2]) * (2 * mp.pi / 3)),
        cases=lambda: [None],
        deviation=_one_to_one,
        copies=(Copy("half a turn", (exactly([0, 0, 0]), exactly([1, 2, 2]) * (mp.pi / 3))),),
    ),
    Claim(
        id="kaji_ochiai.3.dimensions",
        place="section 3, the parameter space; condition (IV)",
        statement="The parameters are 3 + 3 + 6 = 12, as many as the affine maps have degrees of freedom.",
        printed="two 3-dimensional and one 6-dimensional vector spaces; Aff+(3) is a 12-dimensional Lie group",
        verdict=Verdict.CONFIRMED,
        form=(3, 3, 6, 12),
        cases=lambda: [None],
        deviation=_dimensions_off,
        copies=(Copy("5 for 6, as of the symmetric matrices without trace", (3, 3, 5, 11)),),
    ),
    Claim(
        id="kaji_ochiai.3.parameter_matrices",
        place="section 3, the display of the parameter space",
        statement="The matrices of x4, x5, x6 and of y7 to y12 are skew and symmetric.",
        printed="(0, x4, x5; -x4, 0, x6; -x5, -x6, 0), (y7, y8, y9; y8, y10, y11; y9, y11, y12)",
        verdict=Verdict.CONFIRMED,
        form=(skew, symmetric),
        cases=lambda: arrays("entries", 3, (9,), -2, 2),
        deviation=_asymmetry,
        copies=(Copy("y8 for y9 at the lower left", (skew, _symmetric_slipped)),),
        remark="x4, x5, x6 are -z, y, -x of the rotation vector, not the vector itself.",
    ),
    Claim(
        id="kaji_ochiai.3.linear_and_translation",
        place="section 3, after equation 1",
        statement="A map is the translation by l after its linear part.",
        printed="A = ψ_L(A) ι(Â)",
        verdict=Verdict.CONFIRMED,
        form=_split(1),
        cases=lambda: [(each,) for each in affine_maps()],
        deviation=equals(lambda m, affine: affine),
        copies=(Copy("the factors exchanged", _split(-1)),),
    ),
    Claim(
        id="kaji_ochiai.3.eq2.positive_determinant",
        place="section 3, equation 2; condition (I)",
        statement="All parameters without restriction give maps of positive determinant: it is exp(tr Y).",
        printed="φ(L, X, Y) = L ι(exp(X) exp(Y)) ∈ Aff+(3)",
        verdict=Verdict.CONFIRMED,
        form=phi,
        cases=_free_parameters,
        deviation=_determinant_off,
        copies=(Copy("I + Y for exp Y", _first_order),),
    ),
    Claim(
        id="kaji_ochiai.3.connected",
        place="section 3, Aff+(3)",
        statement="The maps of positive determinant are connected: φ(tψ(A)) is a path from the identity to A.",
        verdict=Verdict.CONFIRMED,
        form=_path(1),
        cases=affine_maps,
        deviation=_disconnected,
        copies=(Copy("the segment from the identity to A", _path(-1)),),
    ),
    Claim(
        id="kaji_ochiai.3.eq3.uniqueness",
        place="section 3, after equation 3",
        statement="Parameters of a map are unique up to whole turns about the axis of its rotation.",
        printed="unique up to modulo 2π",
        verdict=Verdict.CONFIRMED,
        form=_lengthened(2 * mp.pi),
        cases=lambda: [(each, k) for each in parameters_within_a_turn()[1:] for k in (1, -2)],
        deviation=_not_one_preimage,
        copies=(Copy("half turns", _lengthened(mp.pi)),),
        remark="Where the rotation is the identity every axis will do: a sphere of rotation vectors for each turn.",
    ),
)
