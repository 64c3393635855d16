"""Section 3: the inverse psi by polar factors, and remark 3.1."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.kaji_ochiai.parametrisation import affine_maps, symmetric
from affinecert.properties.claims.precision import difference, distance, equals, mp
from affinecert.reference import kaji_ochiai, so3, sym3
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, homogeneous, identity, scalar


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


def _factors(stretch_first: bool = True) -> Any:
    """The factors exp(X) and exp(Y) of the linear part that psi finds; or of L L^T."""

    def factors(m: Context, affine: Array) -> tuple[Array, Array]:
        of = affine if stretch_first else homogeneous(m, affine[:3, :3].T, affine[:3, 3])
        parameters = kaji_ochiai.parametrise(m, of)
        return so3.exp(m, parameters[3:6]), sym3.exp(m, symmetric(parameters[6:]))

    return factors


def polar(m: Context, linear: Array) -> tuple[Array, Array]:
    """The factors U V and V^T D V of L = U D V."""
    u, d, v = m.svd_r(m.matrix(linear.tolist()))
    rotation, stretch = u * v, v.T * m.diag(list(d)) * v
    return array(rotation.tolist()), array(stretch.tolist())


CLAIMS: tuple[Claim[Any, Any], ...] = (
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
        id="kaji_ochiai.3.remark_3.1.polar",
        place="remark 3.1",
        statement="exp(X) and exp(Y) are the factors of the polar decomposition: rotation and scale-shear.",
        verdict=Verdict.CONFIRMED,
        form=_factors(),
        cases=lambda: [(each,) for each in affine_maps()],
        deviation=equals(lambda m, affine: polar(m, affine[:3, :3])),
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
