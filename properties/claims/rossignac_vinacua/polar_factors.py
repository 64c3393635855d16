"""Section 3.3.2: the linear part by its entries, its polar factors and its singular values."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, numbers, plane_rotation, rotations
from affinecert.properties.claims.precision import HOLDS, difference, distance, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import Morph, Pair, at, general_pairs, unit
from affinecert.reference import morphs, polar
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, identity, norm

Angles = tuple[Number, Number, Array]
"""alpha, beta and the diagonal matrix Y of L = R(alpha) Y R(beta)."""


def turned(alpha: Number, beta: Number, stretch: Array) -> Array:
    """L = U^T Y V, with R(alpha) = U^T and R(beta) = V."""
    found: Array = plane_rotation(alpha) @ stretch @ plane_rotation(beta)
    return found


def conjugate(angle: Number, stretch: Array) -> Array:
    """R(-angle) Y R(angle)."""
    return turned(-angle, angle, stretch)


def angles_and_stretches() -> list[Angles]:
    """Angles whose sum is less than pi, and stretches of two unequal factors."""
    angles = zip(numbers("alpha", 4, -1.5, 1.5), numbers("beta", 4, -1.5, 1.5), strict=True)
    stretch = exactly([[2, 0], [0, 0.5]]), exactly([[1, 0], [0, 3]])
    return [(a, b, stretch[k % 2]) for k, (a, b) in enumerate([(mp.zero, mp.one), *angles]) if a + b]


def _never_inverted(form: Morph, pair: Pair) -> Number:
    return mp.mpf(all(definitions.determinant(at(form, pair, mp.mpf(k) / 16)[:-1, :-1]) >= 0 for k in range(17)))


def _rotation(m: Context, linear: Array) -> Array:
    return polar.decompose(m, linear)[0]


def _gram_schmidt(m: Context, linear: Array) -> Array:
    """The rotation whose first column is along that of L."""
    columns: list[Array] = []
    for column in linear.T:
        rest = column - sum(((axis @ column) * axis for axis in columns), start=0 * column)
        columns.append(rest / norm(m, rest))
    return array(columns).T


def _not_nearest(form: Any, case: tuple[Array, Array]) -> Number:
    """How far the rotation is from a stationary point of |L - R|, or from being at least as near as others."""
    linear, small = case
    nearest = form(mp, linear)
    stretch = nearest.T @ linear
    others = [nearest @ turn for turn in (*rotations("others", 4), identity(mp, 3) * 1)]
    others += [nearest @ definitions.exponential(mp, cross_matrix(mp, small))]
    nearer = [norm(mp, (linear - nearest).flat) - norm(mp, (linear - other).flat) for other in others]
    minors = [definitions.determinant(stretch[:k, :k]) for k in (1, 2, 3)]
    return max(size(stretch - stretch.T), *nearer, *(-minor for minor in minors))


def _linear_parts() -> list[tuple[Array, Array]]:
    small = exactly([1, -2, 2]) / 64
    return [(pair[1][:-1, :-1], small) for pair in general_pairs(3)]


def _exchanged(left: Array, middle: Array, right: Array) -> tuple[Array, Array, Array]:
    """U, Y and V of L = U^T Y V with the first two singular values exchanged."""
    swap = np.eye(len(middle), dtype=int)[[1, 0, *range(2, len(middle))]]
    return swap @ left, swap @ middle @ swap, swap @ right


def _not_rotations(form: Any, case: tuple[Array, Array, Array]) -> Number:
    """How far U^T Y V is from what it was, and whether U and V have negative determinants."""
    left, middle, right = case
    u, y, v = form(left, middle, right)
    mirrored = max(-definitions.determinant(each) for each in (u, v))
    return max(difference(u.T @ y @ v, left.T @ middle @ right), mirrored)


def _mirrored() -> list[tuple[Array, Array, Array]]:
    mirror = exactly([[1, 0], [0, -1]])
    cases = angles_and_stretches()
    plane = [(mirror @ plane_rotation(a), stretch, mirror @ plane_rotation(b)) for a, b, stretch in cases]
    first, second = rotations("singular vectors", 2)
    return [*plane, (-first, exactly([[3, 0, 0], [0, 2, 0], [0, 0, 1]]), -second)]


def _equal_stretches(form: Any, case: Angles) -> Number:
    """Whether a stretch is that of the polar decomposition."""
    return mp.mpf(_unlike_polar(form, case) < HOLDS)


def _unlike_polar(form: Any, case: Angles) -> Number:
    _, beta, stretch = case
    return distance(form(beta, stretch), polar.decompose(mp, turned(*case))[1])


def _reduced(bound: Number) -> Any:
    """The angle, less a whole turn if it exceeds a bound."""
    return lambda angle: angle - 2 * mp.pi * mp.sign(angle) if abs(angle) > bound else angle


def _not_shortest(form: Any, case: tuple[Number, Number]) -> Number:
    """How far the reduced sum of two angles is from the shortest turn."""
    total = sum(case)
    return abs(form(total) - mp.atan2(mp.sin(total), mp.cos(total)))


def _sums() -> list[tuple[Number, Number]]:
    return [(mp.mpf(a), mp.mpf(b)) for a, b in ((1, 2), (2, 2), (-3, -1), (3.125, 3.125), (-2, 3))]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.3.2.linear_inverts",
        place="section 3.3.2",
        statement="The linear interpolation of the coefficients of L may temporarily invert the shape.",
        verdict=Verdict.CONFIRMED,
        form=morphs.linear,
        cases=lambda: [
            (unit(2), affine([[-1, 0], [0, -2]], [0, 0])),
            (affine([[1, 1], [0, 1]], [0, 0]), affine([[-3, -3], [0, -1]], [0, 0])),
        ],
        deviation=_never_inverted,
        copies=(
            Copy("rotations and stretches apart", morphs.shoemake_duff),
            Copy("R^t S^t", morphs.asap),
        ),
        remark="det((1 - t) I + t A) is the product of 1 - t + t x over the eigenvalues x: it falls below 0 only if "
        "there are unequal negative ones, where there is no steady morph either.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.nearest_rotation",
        place="section 3.3.2",
        statement="The rotation of the polar decomposition A = R S, S symmetric and positive-definite, minimises the "
        "Frobenius norm |A - R|.",
        verdict=Verdict.CONFIRMED,
        form=_rotation,
        cases=_linear_parts,
        deviation=_not_nearest,
        copies=(Copy("the rotation by Gram and Schmidt", _gram_schmidt),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.exchange",
        place="section 3.3.2",
        statement="If U and V of L = Uᵀ Y V have negative determinants, exchanging the variables makes them positive.",
        printed="L = U^T Y V",
        verdict=Verdict.CONFIRMED,
        form=_exchanged,
        cases=_mirrored,
        deviation=_not_rotations,
        copies=(Copy("Y is left as it is", lambda u, y, v: (_exchanged(u, y, v)[0], y, _exchanged(u, y, v)[2])),),
        remark="In space a change of the signs of both serves as well.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.rotation_and_stretch",
        place="section 3.3.2",
        statement="L = R(α) Y R(β) is R(α + β) B with B = R(-β) Y R(β).",
        printed="L = R(α) ∘ R(β) ∘ (R(-β) ∘ Y ∘ R(β)) = R(α + β) ∘ B",
        verdict=Verdict.CONFIRMED,
        form=lambda a, b, y: plane_rotation(a + b) @ conjugate(b, y),
        cases=angles_and_stretches,
        deviation=lambda form, case: distance(form(*case), turned(*case)),
        copies=(Copy("R(β) Y R(-β) for B", lambda a, b, y: plane_rotation(a + b) @ conjugate(-b, y)),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.another_stretch",
        place="section 3.3.2",
        statement="B is a stretch other than the S of the polar decomposition L = R S.",
        printed="a positive definite stretch matrix, analogous to (but different from) S in [Shoemake and Duff 1992]",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=conjugate,
        cases=angles_and_stretches,
        deviation=_equal_stretches,
        correction=Correction(
            statement="B is S, and R(α + β) is R, as the polar decomposition is unique.",
            form=conjugate,
            deviation=_unlike_polar,
        ),
        copies=(Copy("R(β) Y R(-β) for B", lambda beta, y: conjugate(-beta, y)),),
        remark="From one pose to the next the morphs of Alexa and others (2000) and of Shoemake and Duff differ in "
        "what they decompose, C B^-1 or B and C, and agree for B = I.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.sum_of_angles",
        place="section 3.3.2",
        statement="2π is to be added or subtracted where the absolute value of α + β exceeds 2π.",
        printed="their sum's absolute value may exceed 2π, in which case the authors of ARAP recommend "
        "adding/subtracting 2π",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_reduced(2 * mp.pi),
        cases=_sums,
        deviation=_not_shortest,
        correction=Correction(
            statement="Where it exceeds π: of angles within (-π, π] the sum never exceeds 2π, and beyond π it is the "
            "longer way round.",
            form=_reduced(+mp.pi),
        ),
        copies=(Copy("π/2 for π", _reduced(mp.pi / 2)),),
    ),
)
