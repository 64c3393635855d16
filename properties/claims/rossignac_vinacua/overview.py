"""Section 4: what the extraction of affinity roots rests on."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import general_pairs
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity, scalar


def _power(m: Context, affinity: Array, t: Number) -> Array:
    return sam.power(m, affinity, scalar(t))


def _linear_power(m: Context, linear: Array, t: Number) -> Array:
    found: Array = _power(m, homogeneous(m, linear, linear[0] * 0), t)[:-1, :-1]
    return found


def _about_fixed_point(m: Context, affinity: Array, t: Number, sign: int = 1) -> Array:
    """The matrix of p -> L^t (p - q) + q."""
    turned = _linear_power(m, affinity[:-1, :-1], t)
    centre = sign * definitions.inverse(m, identity(m, len(turned)) - affinity[:-1, :-1]) @ affinity[:-1, -1]
    return homogeneous(m, turned, centre - turned @ centre)


def _steps() -> list[tuple[Array, Number]]:
    return [(pair[1] @ inverse(pair[0]), mp.mpf(t)) for d in (2, 3) for pair in general_pairs(d) for t in (0.5, 2)]


def _stretched(m: Context, stretch: Number, t: Number) -> Array:
    """The translation of A^t along the first axis for L = diag(stretch, 2) and t = (1, 1), by its definition."""
    linear = array([[stretch, m.zero], [m.zero, m.mpf(2)]])
    return _power(m, homogeneous(m, linear, array([m.one, m.one])), t)[:1, 2]


def _stretched_about_fixed_point(m: Context, stretch: Number, t: Number) -> Array:
    """The same as q - L^t q."""
    fixed = m.one / (m.one - stretch)
    return array([fixed - m.mpf(stretch) ** t * fixed])


def _straight(m: Context, affinity: Array, t: Number) -> Array:
    """L^t p + t t."""
    return homogeneous(m, _linear_power(m, affinity[:-1, :-1], t), affinity[:-1, -1] * t)


def _real(linear: Array) -> list[Number]:
    """The real eigenvalues, in ascending order."""
    found = definitions.eigenvalues(mp, linear)
    return sorted(mp.re(each) for each in found if abs(mp.im(each)) < mp.mpf(10) ** -30)


def _spaces() -> list[Array]:
    """Linear maps of space of positive determinant: with real eigenvalues of both signs, and others."""
    signs = exactly([[-1, 1, 0], [0, -2, 1], [0, 0, 3]])
    drawn = [each for each in arrays("space", 12, (3, 3), -2, 2) if definitions.determinant(each) > 0.5]
    return [signs, exactly([[0, 0, 1], [1, 0, 0], [0, 1, 0]]), *drawn[:5]]


def _without_positive(form: Any, linear: Array) -> Number:
    return mp.mpf(not any(each > 0 for each in _real(form(linear))))


def _of_opposite_signs(form: Any, linear: Array) -> Number:
    """Whether the other two eigenvalues, besides the one taken, have a product that is not positive."""
    taken = form(_real(linear))
    return mp.mpf(not definitions.determinant(linear) / taken > 0)


def _split(m: Context, linear: Array, across: bool = True) -> tuple[Array, Array]:
    """The scaling along e_1, and the linear map of the invariant plane of the others: L is their product.

    x1 is the greatest, and P = (L - x2)(L - x3) / ((x1 - x2)(x1 - x3)) projects to e_1. Not ``across``, it does
    so orthogonally.
    """
    first = _real(linear)[-1]
    total, product = linear.trace() - first, definitions.determinant(linear) / first
    unit = identity(m, 3)
    projector = (linear @ linear - linear * total + unit * product) / (first * first - first * total + product)
    if not across:
        axis = projector.sum(axis=1)
        projector = axis[:, None] * axis[None, :] / (axis @ axis)
    rest = unit - projector
    return projector * first + rest, projector + linear @ rest


def _unlike_product(form: Any, linear: Array) -> Number:
    """How far the parts are from commuting, and their powers from being those of L."""
    scaling, plane = form(mp, linear)
    half = _linear_power(mp, scaling, mp.mpf(0.5)) @ _linear_power(mp, plane, mp.mpf(0.5))
    return max(size(scaling @ plane - plane @ scaling), distance(half, _linear_power(mp, linear, mp.mpf(0.5))))


def _upright() -> list[Array]:
    drawn = arrays("products", 3, (3, 3), -1, 1)
    return [exactly([[0, -1, 0], [1, 0, 0], [0, 0, 2]]), *(each + 3 * identity(mp, 3) for each in drawn)]


def _triple() -> list[Array]:
    """Matrices with one eigenvector, of a triple eigenvalue."""
    return [exactly([[1, 1, 0], [0, 1, 1], [0, 0, 1]]), exactly([[2, 1, 0], [0, 2, 1], [0, 0, 2]])]


def _diagonalised(m: Context, linear: Any, t: Number, shift: int = 0) -> Array:
    """P diag(x^t, y^t) P^-1 of a matrix [[a, b], [c, d]] with b != 0 and two positive eigenvalues x, y."""
    (a, b), (c, d) = linear
    half = (a + d) / 2
    root = m.sqrt(half * half - (a * d - b * c))
    basis = array([[b, b], [half + root - a, half - root - a]])
    values = array([[(half + root) ** (t + shift), m.zero], [m.zero, (half - root) ** t]])
    found: Array = basis @ values @ definitions.inverse(m, basis)
    return found


def _of_positive_pairs() -> list[tuple[Array, Number]]:
    return [(exactly(each), mp.mpf(0.5)) for each in ([[2, 1], [1, 1]], [[1, 2], [0, 3]], [[0.5, 0.25], [0.25, 2]])]


def _kind(linear: Array) -> int:
    """1, 2 or 3: two positive eigenvalues, a complex pair, two negative ones."""
    trace = linear.trace()
    return 2 if trace**2 < 4 * definitions.determinant(linear) else 1 if trace > 0 else 3


def _misjudged(form: Any, linear: Array) -> Number:
    """Whether the kind says other than that A^t exists."""
    return mp.mpf((form(linear) != 3) != sam.exists(mp, homogeneous(mp, linear, exactly([0, 0]))))


def _planes() -> list[Array]:
    return [exactly(each) for each in ([[2, 1], [1, 1]], [[-1, -1], [1, -1]], [[-1, 0], [0, -2]], [[-1, 1], [0, -1]])]


def _half_turns() -> list[Array]:
    return [exactly([[-2, 0], [0, -2]]), exactly([[-1, 0], [0, -1]])]


def _changes_nearby(form: Any, linear: Array) -> Number:
    """Whether the kind is another somewhere next to a matrix."""
    small = mp.mpf(2) ** -10
    signs = [array(each).reshape(2, 2) - 1 for each in np.ndindex(3, 3, 3, 3)]
    return mp.mpf(any(form(linear + each * small) != form(linear) for each in signs))


def _is_singular(linear: Any, tolerance: float = 0.0) -> bool:
    """The case S1 of algorithm 1, in float64: whether 1 is an eigenvalue of L."""
    (a, b), (c, d) = linear
    r = (a + d) / 2
    discriminant = r * r - (a * d - b * c)
    if discriminant < 0:
        return False
    s = float(np.sqrt(discriminant))
    return bool(abs(r + s - 1) <= tolerance or abs(r - s - 1) <= tolerance)


def _exactly_singular(linear: Any) -> bool:
    """det(L - I) == 0 in rational numbers."""
    (a, b), (c, d) = exactly(linear) - identity(mp, 2)
    return bool(a * d == b * c)


def _missed(form: Any, linear: Any) -> Number:
    return mp.mpf(form(linear) != _exactly_singular(linear))


def _short() -> list[Any]:
    """Matrices of up to 24 bits, with the eigenvalue 1 or not; of the last it is 1 + 2^-20."""
    rows = [
        [[1.0, 1.0], [0.0, 2.0]],
        [[2.0, 1.0], [0.0, 3.0]],
        [[3.0, 2.0], [4.0, 5.0]],
        _doubled(11184811, 5592405, 24),
    ]
    return [*rows, [[1 + 2.0**-20, 0.5], [0.0, 2.0]]]


def _doubled(u: int, v: int, bits: int) -> Any:
    """I + [[u, v], [2 u, 2 v]] / 2^bits, which has the eigenvalue 1 exactly."""
    x, y = u / 2**bits, v / 2**bits
    return [[1 + x, y], [2 * x, 1 + 2 * y]]


def _long() -> list[Any]:
    """Matrices of 26 bits and more with the eigenvalue 1."""
    pairs = [(61646893, 51017097, 26), (51766006, 3623530, 26), (157562823, 245617680, 28)]
    return [_doubled(*each) for each in pairs]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.4.fixed_point",
        place="section 4",
        statement="A^t(p) = L^t (p - q) + q, where q is the fixed point of A, unique in general configurations.",
        printed="A^t(p) = L^t(qp) + q = e^(t log(L))(qp) + q",
        verdict=Verdict.CONFIRMED,
        form=_about_fixed_point,
        cases=_steps,
        deviation=equals(_power),
        copies=(
            Copy("-q for q", lambda m, affinity, t: _about_fixed_point(m, affinity, t, sign=-1)),
            Copy("L^t p + t t", _straight),
        ),
        losses=(
            Loss(
                where="the translation of A^0.3 for an eigenvalue 1 + 1e-10: q is 1e10 away",
                formula=_stretched_about_fixed_point,
                truth=_stretched,
                at=(1 + 1e-10, 0.3),
                digits=10,
            ),
        ),
        remark="The configurations without a fixed point are few, those where it is far away and digits are lost are "
        "not. With log A = [[log L, log[1, L] t], [0, 0]], a divided difference, there is no need for q.",
    ),
    Claim(
        id="rossignac_vinacua.4.real_positive",
        place="section 4",
        statement="In space L has at least one real positive eigenvalue, as it preserves orientation.",
        verdict=Verdict.CONFIRMED,
        form=lambda linear: linear,
        cases=_spaces,
        deviation=_without_positive,
        copies=(Copy("-L, which does not preserve it", lambda linear: -linear),),
    ),
    Claim(
        id="rossignac_vinacua.4.no_opposite_signs",
        place="section 4",
        statement="When a positive eigenvalue is taken first, the other two, if real, do not have opposite signs.",
        verdict=Verdict.CONFIRMED,
        form=max,
        cases=_spaces,
        deviation=_of_opposite_signs,
        copies=(Copy("any real eigenvalue is taken, such as the least", min),),
        remark="That of appendix A.6 must so be a positive one as well.",
    ),
    Claim(
        id="rossignac_vinacua.4.product",
        place="section 4",
        statement="Therefore L is the commutative product of a scaling along e_1 and of a linear map of the plane of "
        "the other two, probably generalised, eigenvectors; and L^t is that of their powers.",
        verdict=Verdict.BOUND,
        domain="some real positive eigenvalue has an invariant plane beside its axis. A triple eigenvalue with one "
        "eigenvector has none, and L is no such product",
        form=_split,
        cases=_upright,
        outside=_triple,
        deviation=_unlike_product,
        copies=(Copy("the plane orthogonal to e_1", lambda m, linear: _split(m, linear, across=False)),),
        remark="Of a double eigenvalue with one eigenvector and a simple one, the simple one must be taken.",
    ),
    Claim(
        id="rossignac_vinacua.4.diagonal",
        place="section 4, (1)",
        statement="Where L has two unequal real positive eigenvalues it can be diagonalised, and L^t is "
        "P diag(x^t, y^t) P^-1.",
        verdict=Verdict.CONFIRMED,
        form=_diagonalised,
        cases=_of_positive_pairs,
        deviation=equals(_linear_power),
        copies=(Copy("x^(t + 1) for x^t", lambda m, linear, t: _diagonalised(m, linear, t, shift=1)),),
        losses=(
            Loss(
                where="eigenvalues 1 and 1 + 1e-12: from trace and determinant they come out equal",
                formula=_diagonalised,
                truth=_linear_power,
                at=([[1.0, 1.0], [0.0, 1.0 + 1e-12]], 0.5),
                digits=16,
            ),
        ),
        remark="A double eigenvalue with one eigenvector, a shear, can not; by divided differences it needs no case.",
    ),
    Claim(
        id="rossignac_vinacua.4.two_negative",
        place="section 4, (1) to (3)",
        statement="A^t exists where L has two real positive eigenvalues or a complex pair, and not where it has two "
        "real negative ones.",
        verdict=Verdict.BOUND,
        domain="all but half turns with a uniform scaling, -s I, which has two negative eigenvalues and real powers",
        form=_kind,
        cases=_planes,
        outside=_half_turns,
        deviation=_misjudged,
        copies=(Copy("no A^t where the trace is negative", lambda linear: 3 if linear.trace() < 0 else 1),),
        remark="Section 3.2 has the example, diag(-2, -2).",
    ),
    Claim(
        id="rossignac_vinacua.4.full_dimensional",
        place="section 4",
        statement="The three types of general configurations are of full dimension: next to one all are of its type.",
        verdict=Verdict.CONFIRMED,
        form=_kind,
        cases=lambda: _planes()[:3],
        deviation=_changes_nearby,
        copies=(Copy("triangular matrices as a type", lambda linear: 4 if linear[1, 0] == 0 else _kind(linear)),),
    ),
    Claim(
        id="rossignac_vinacua.4.booleans",
        place="section 4, with algorithm 1",
        statement="The singular configurations can be identified reliably using simple closed-form Boolean "
        "expressions: 1 is an eigenvalue if r + s == 1 or r - s == 1.",
        printed="if (r + s != 1 && r - s != 1) G2(); else S1();",
        verdict=Verdict.BOUND,
        domain="entries of up to 24 bits, of which nothing is rounded in float64. From 26 bits on many matrices that "
        "have the eigenvalue 1 are taken for general",
        form=_is_singular,
        cases=_short,
        outside=_long,
        deviation=_missed,
        copies=(Copy("up to 1e-6", lambda linear: _is_singular(linear, tolerance=1e-6)),),
        remark="Reliable is det(L - I) == 0 in whole numbers. What is missed goes to formulas that lose all digits.",
    ),
)
