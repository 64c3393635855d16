"""Sections 6 and 7, with table 2: invariance and associativity of blends, and straight lines."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.kaji_ochiai.blending import blend, matrix_blend
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.reference import kaji_ochiai, quaternion, sam, so3
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, norm

LEFT, RIGHT = "left", "right"


def _alexa(m: Context, affines: Array, weights: Array) -> Array:
    """Exp of the weighted sum of logarithms."""
    total = sum(weight * sam.log(m, affine) for weight, affine in zip(weights, affines, strict=True))
    return definitions.exponential(m, np.asarray(total))


def _dual(m: Context, motion: Array) -> tuple[Array, Array]:
    q = quaternion.of_rotation(m, motion[:3, :3])
    return q, quaternion.product(array([m.zero, *motion[:3, 3]]), q) / 2


def _dual_linear_blend(m: Context, motions: Array, weights: Array) -> Array:
    """Dual quaternion linear blending: the weighted sum of dual quaternions, of signs like the first, normalised."""
    duals = [_dual(m, motion) for motion in motions]
    first = duals[0][0]
    signs = [1 if q @ first >= 0 else -1 for q, _ in duals]
    terms = list(zip(weights, signs, duals, strict=True))
    real = array([sum(w * sign * q[k] for w, sign, (q, _) in terms) for k in range(4)])
    dual = array([sum(w * sign * r[k] for w, sign, (_, r) in terms) for k in range(4)])
    length = norm(m, real)
    shift = 2 * quaternion.product(dual, quaternion.conjugate(real))[1:] / length**2
    return homogeneous(m, quaternion.matrix(real / length), shift)


def _gap(form: Any, case: tuple[Array, Array, Array, str]) -> Number:
    """How far a blend of translated maps is from the translated blend, on the left or right of the maps."""
    maps, weights, by, side = case
    moved = array([by @ each if side == LEFT else each @ by for each in maps])
    blended = form(mp, maps, weights)
    return difference(form(mp, moved, weights), by @ blended if side == LEFT else blended @ by)


def _invariant(form: Any, case: tuple[Array, Array, Array, str]) -> int:
    return int(_gap(form, case) < 1e-9)


def _affine_cases() -> list[tuple[Array, Array, Array, str]]:
    """Two maps that turn and stretch moderately, and a third one by which they are translated."""
    first = kaji_ochiai.realise(mp, exactly([1, 0, 0, 0, 0, 0.5, 0.25, 0, 0, 0, 0, 0]))
    second = kaji_ochiai.realise(mp, exactly([0, 1, 0, 0.5, 0, 0, 0, 0.25, 0, 0, 0, 0.5]))
    by = kaji_ochiai.realise(mp, exactly([0, 0, 1, 0, 0.5, 0, 0, 0, 0.25, 0.25, 0, 0]))
    return [(array([first, second]), exactly([0.5, 0.5]), by, side) for side in (LEFT, RIGHT)]


def _rigid_cases() -> list[tuple[Array, Array, Array, str]]:
    turns = rotations("rigid", 6, mp.mpf(1))
    shifts = arrays("rigid shifts", 6, (3,), -2, 2)
    motions = [homogeneous(mp, turn, shift) for turn, shift in zip(turns, shifts, strict=True)]
    weights = exactly([[0.5, 0.5], [0.25, 0.75]])
    return [
        (array(motions[2 * k : 2 * k + 2]), weights[k], motions[4 + k], side) for k in (0, 1) for side in (LEFT, RIGHT)
    ]


def _multiple(m: Context, factor: Number, affine: Array) -> Array:
    """The a-multiple of a map, phi(a psi(A))."""
    return blend(m, array([affine]), array([factor]))


def _other_order(m: Context, factor: Number, affine: Array) -> Array:
    """A multiple with the factors of phi exchanged, and those of psi not."""
    parameters = kaji_ochiai.parametrise(m, affine) * factor
    turn, zero = parameters.copy(), parameters.copy()
    turn[6:], zero[:6] = m.zero, m.zero
    found: Array = kaji_ochiai.realise(m, zero) @ kaji_ochiai.realise(m, turn)
    return found


FACTORS = exactly([[0.5, 0.5], [2, 0.5], [0.5, 1.5], [-1, 1.25], [3, -0.75]])
"""Factors a, b; |b| times the angle of the maps is below pi."""


def _maps() -> list[Array]:
    """A turn by 1 radian after a slanted stretch, and drawn maps."""
    slanted = kaji_ochiai.realise(mp, exactly([1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0]))
    return [slanted, *(kaji_ochiai.realise(mp, each) for each in arrays("multiples", 4, (12,), -1, 1))]


def _violation(multiple: Any, affine: Array) -> Number:
    """The largest difference between the a-multiple of the b-multiple and the ab-multiple."""
    return max(difference(multiple(mp, a, multiple(mp, b, affine)), multiple(mp, a * b, affine)) for a, b in FACTORS)


def _associative(multiple: Any, affine: Array) -> int:
    return int(_violation(multiple, affine) < 1e-40)


def _is_power(multiple: Any, affine: Array) -> int:
    """Whether the 2-multiple of a map is its square."""
    return int(difference(multiple(mp, mp.mpf(2), affine), affine @ affine) < 1e-12)


def _alexa_multiple(m: Context, factor: Number, affine: Array) -> Array:
    return _alexa(m, array([affine]), array([factor]))


def _leaves(form: Any, case: tuple[Array, Array]) -> int:
    """Whether a blend has no positive determinant."""
    return int(definitions.determinant(form(mp, *case)[:3, :3]) <= 0)


def _polar_and_linear(m: Context, affines: Array, weights: Array) -> Array:
    """Polar factors, rotation vectors blended as logarithms and stretches as matrices."""
    parameters = [kaji_ochiai.parametrise(m, affine) for affine in affines]
    unturned = []
    for own in parameters:
        stretch = own.copy()
        stretch[:6] = m.zero
        unturned.append(kaji_ochiai.realise(m, stretch)[:3, :3])
    turn = so3.exp(m, weights @ array([own[3:6] for own in parameters]))
    stretch = sum(weight * own for weight, own in zip(weights, unturned, strict=True))
    return homogeneous(m, turn @ stretch, weights @ affines[:, :3, 3])


def _extrapolations() -> list[tuple[Array, Array]]:
    pair = array([kaji_ochiai.realise(mp, each) for each in arrays("extrapolated", 2, (12,), -1, 1)])
    return [(pair, exactly(weights)) for weights in ([0.5, 0.5], [-1, 2], [3, -2], [-5, -4])]


def _steady(direction: Array, _: None) -> int:
    """Whether the line of parameters t times a direction has one velocity A^-1 A' all along."""

    def velocity(t: Number) -> Array:
        rate = definitions.derivative(mp, lambda s: kaji_ochiai.realise(mp, direction * s), t)
        found: Array = definitions.inverse(mp, kaji_ochiai.realise(mp, direction * t)) @ rate
        return found

    return int(size(velocity(mp.one) - velocity(mp.zero)) < 1e-12)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.6.drawbacks.not_bi_invariant",
        place="section 6, first drawback",
        statement="Blends of equation 9 are invariant neither under left nor under right translation.",
        verdict=Verdict.CONFIRMED,
        form=blend,
        cases=_affine_cases,
        deviation=_invariant,
        copies=(Copy("the weighted sum of matrices", matrix_blend),),
        remark="What they do commute with is a rotation of the frame, of the world and the shape at once.",
    ),
    Claim(
        id="kaji_ochiai.6.drawbacks.dual_quaternions",
        place="section 6, first drawback",
        statement="Dual quaternion linear blending of rigid motions is bi-invariant.",
        printed="whereas DLB has this property",
        verdict=Verdict.CONFIRMED,
        form=_dual_linear_blend,
        cases=_rigid_cases,
        deviation=_gap,
        copies=(Copy("equation 9", blend),),
        remark="With weights that choose the signs of the quaternions alike before and after.",
    ),
    Claim(
        id="kaji_ochiai.6.drawbacks.alexa",
        place="section 6, first drawback",
        statement="Alexa's blend exp(Σ w_i log A_i) is not bi-invariant either: neither from the left nor the right.",
        printed="they mistakenly claim that their method achieves bi-invariance",
        verdict=Verdict.CONFIRMED,
        form=_alexa,
        cases=_affine_cases,
        deviation=_invariant,
        copies=(Copy("the weighted sum of matrices", matrix_blend),),
        remark="It is invariant under a change of frame, A_i → B A_i B⁻¹.",
    ),
    Claim(
        id="kaji_ochiai.6.drawbacks.no_simple_blend",
        place="section 6, first drawback",
        statement="No parametrisation of Aff+(3) is known whose simple blend is bi-invariant; bi-invariant means are "
        "costly.",
        verdict=Verdict.UNCHECKABLE,
        reason="It tells what the authors know, and of costs.",
    ),
    Claim(
        id="kaji_ochiai.6.drawbacks.associativity",
        place="sections 2 and 6, second drawback; table 2, associativity",
        statement="The multiples φ(aψ(A)) lack associativity: the a-multiple of the b-multiple is not the ab-multiple.",
        printed="at the cost of losing the associativity; our Blend function lacks in associativity",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_multiple,
        cases=_maps,
        deviation=_associative,
        correction=Correction(
            statement="By the definition of section 2 they are associative, as Alexa's, where |b| times the angle is "
            "below π: ψ(φ(bψ(A))) = bψ(A).",
            form=_multiple,
            deviation=_violation,
        ),
        copies=(Copy("exp(Y) exp(X) for exp(X) exp(Y) in φ, and not in ψ", _other_order),),
        remark="Any one-to-one parametrisation by a linear space has it. What is lost is the next entry.",
    ),
    Claim(
        id="kaji_ochiai.6.drawbacks.no_powers",
        place="sections 2 and 6, second drawback",
        statement="What Alexa's multiples have and φ(aψ(A)) have not: the 2-multiple of a map is not its square.",
        verdict=Verdict.CONFIRMED,
        form=_multiple,
        cases=_maps,
        deviation=_is_power,
        copies=(Copy("exp(a log A)", _alexa_multiple),),
    ),
    Claim(
        id="kaji_ochiai.table_2.extrapolation",
        place="table 2, extrapolation, the row of the paper's method",
        statement="Blends with any weights, of extrapolation too, have positive determinant.",
        verdict=Verdict.CONFIRMED,
        form=blend,
        cases=_extrapolations,
        deviation=_leaves,
        copies=(
            Copy("polar factors with linear blends of the stretches", _polar_and_linear),
            Copy("the weighted sum of matrices", matrix_blend),
        ),
    ),
    Claim(
        id="kaji_ochiai.table_2.cells",
        place="table 2",
        statement="Times, surjectivity, extrapolation, associativity and large rotation of four methods, cell by cell.",
        verdict=Verdict.UNCHECKABLE,
        reason="Tables 1 and 2 and figure 1 are missing in the copy of the paper at hand; times are of its hardware.",
        remark="What the prose says of each row is checked cell by cell in kaji_ochiai.comparison; the numbers of "
        "kaji_ochiai.comparison.own are the whole table, our cells for the lost ones included.",
    ),
    Claim(
        id="kaji_ochiai.7.straight_lines",
        place="section 7",
        statement="A straight line in the parameter space is no geodesic, no steady motion, of the maps.",
        verdict=Verdict.CONFIRMED,
        form=exactly([0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0]),
        cases=lambda: [None],
        deviation=_steady,
        copies=(
            Copy(
                "a stretch along the axis, which commutes with the turn", exactly([0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1])
            ),
        ),
        remark="It is one if X and Y commute and there is no translation.",
    ),
)
