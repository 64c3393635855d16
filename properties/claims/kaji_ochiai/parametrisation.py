"""Section 3: the parametrisation phi, its inverse psi, the conditions that they satisfy, and remark 3.1."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.other_parametrisations import (
    euler,
    local_determinant,
    partial_derivative,
)
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp, size
from affinecert.reference import kaji_ochiai, so3, sym3
from affinecert.reference._matrices import (
    Array,
    Context,
    Number,
    array,
    cross_matrix,
    homogeneous,
    identity,
    norm,
    scalar,
)


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


def _absolute(m: Context, parameters: Array) -> Array:
    """Phi with the sizes of the entries of Y for Y."""
    return phi(m, np.concatenate([parameters[:6], np.abs(parameters[6:])]))


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


def _psi(gram: str, side: str = "right") -> Any:
    """The factors R and S of equation 3: S the square root of L^T L or L L^T, and R = L S^-1 or S^-1 L."""

    def factors(m: Context, affine: Array) -> tuple[Array, Array]:
        linear = affine[:3, :3]
        square = linear.T @ linear if gram == "LtL" else linear @ linear.T
        stretch = sym3.power(m, square, scalar(m.mpf(1) / 2))
        inverse = definitions.inverse(m, stretch)
        return linear @ inverse if side == "right" else inverse @ linear, stretch

    return factors


def _not_inverse(order: int) -> Any:
    """How far phi of the logarithms of R and S, or phi with exp(Y) first, is from the map; or R from a rotation."""

    def deviation(psi: Any, affine: Array) -> Number:
        rotation, stretch = psi(mp, affine)
        skewness = difference(rotation.T @ rotation, identity(mp, 3))
        if skewness > 1e-9:
            return skewness
        turned = definitions.exponential(mp, cross_matrix(mp, so3.log(mp, rotation)))
        stretched = definitions.exponential(mp, sym3.log(mp, stretch))
        return distance(turned @ stretched if order > 0 else stretched @ turned, affine[:3, :3])

    return deviation


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


def _one_to_one(pair: tuple[Array, Array], _: None) -> int:
    """Whether two different elements of the algebra fail to have one exponential."""
    a, b = (definitions.exponential(mp, cross_matrix(mp, each)) for each in pair)
    return int(difference(a, b) > 1e-50 or difference(*pair) < 1)


def _factors(stretch_first: bool = True) -> Any:
    """The factors exp(X) and exp(Y) of the linear part that psi finds; or of L L^T."""

    def factors(m: Context, affine: Array) -> tuple[Array, Array]:
        of = affine if stretch_first else homogeneous(m, affine[:3, :3].T, affine[:3, 3])
        parameters = kaji_ochiai.parametrise(m, of)
        return so3.exp(m, parameters[3:6]), sym3.exp(m, symmetric(parameters[6:]))

    return factors


def _polar(m: Context, affine: Array) -> tuple[Array, Array]:
    """The factors U V and V^T D V of L = U D V."""
    u, d, v = m.svd_r(m.matrix(affine[:3, :3].tolist()))
    rotation, stretch = u * v, v.T * m.diag(list(d)) * v
    return array(rotation.tolist()), array(stretch.tolist())


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
        id="kaji_ochiai.3.eq3.inverse",
        place="section 3, equation 3",
        statement="φ(ψ(A)) = A for every map of positive determinant.",
        printed="ψ(A) = (ψ_L(A), log(ÂS⁻¹), log(S)), S = sqrt(ᵗÂÂ)",
        verdict=Verdict.CONFIRMED,
        form=_psi("LtL"),
        cases=affine_maps,
        deviation=_not_inverse(1),
        copies=(
            Copy("ÂᵗÂ for ᵗÂÂ, and S⁻¹Â for ÂS⁻¹: the factors of the other order", _psi("LLt", "left")),
            Copy("ÂᵗÂ for ᵗÂÂ", _psi("LLt")),
        ),
        remark="It exists too where A itself has no logarithm, as for diag(-1, -2, 1).",
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
    Claim(
        id="kaji_ochiai.3.remark_3.1.polar",
        place="remark 3.1",
        statement="exp(X) and exp(Y) are the factors of the polar decomposition: rotation and scale-shear.",
        verdict=Verdict.CONFIRMED,
        form=_factors(),
        cases=lambda: [(each,) for each in affine_maps()],
        deviation=equals(_polar),
        copies=(Copy("those of the transposed linear part", _factors(stretch_first=False)),),
    ),
    Claim(
        id="kaji_ochiai.3.remark_3.1.order",
        place="remark 3.1",
        statement="With the rotation first, A = L ι(exp(Y) exp(X)), equation 3 changes: S = sqrt(ÂᵗÂ), R = S⁻¹Â.",
        printed="(3) would change accordingly",
        verdict=Verdict.CONFIRMED,
        form=_psi("LLt", "left"),
        cases=affine_maps,
        deviation=_not_inverse(-1),
        copies=(
            Copy("S = sqrt(ᵗÂÂ), as for the order of equation 2", _psi("LtL", "left")),
            Copy("both factors as for the order of equation 2", _psi("LtL")),
        ),
    ),
)
