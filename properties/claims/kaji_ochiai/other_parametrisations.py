"""Section 2: Euler angles, quaternions, dual quaternions, polar factors and the logarithm, as others use them."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, equals, exactly, mp, size
from affinecert.reference import polar, quaternion, sam, so3
from affinecert.reference._existence import Logarithm, logarithm
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, scalar


def euler(m: Context, angles: Array) -> Array:
    """The rotation by Euler angles about z, then the new y, then the new x."""
    about = [
        so3.exp(m, array([angle * (row == k) for row in range(3)])) for k, angle in zip((2, 1, 0), angles, strict=True)
    ]
    rotation: Array = about[0] @ about[1] @ about[2]
    return rotation


def partial_derivative(chart: Any, at: Array, k: int) -> Array:
    """The derivative of a map of parameters by parameter k."""
    step = array([mp.one * (row == k) for row in range(len(at))])
    rate: Array = definitions.derivative(mp, lambda t: chart(at + t * step), mp.zero)
    return rate


def local_determinant(chart: Any, at: Array) -> Number:
    """The determinant of the differential of a chart of the rotations, as three angular velocities: 0 if singular."""
    inverse = chart(mp, at).T
    velocities = []
    for k in range(3):
        rate = inverse @ partial_derivative(lambda parameters: chart(mp, parameters), at, k)
        velocities.append([rate[2, 1], rate[0, 2], rate[1, 0]])
    return definitions.determinant(array(velocities))


def _gimbal() -> list[Array]:
    return [array([first, mp.pi / 2, last]) for first, last in ((mp.zero, mp.zero), (mp.one, mp.mpf(2)))]


def redundancy(chart: Any, at: Array) -> int:
    """How many parameters a chart has more than its images have degrees of freedom."""
    rates = [partial_derivative(chart, at, k).reshape(-1) for k in range(len(at))]
    gram = mp.matrix([[a @ b for b in rates] for a in rates])
    eigenvalues = mp.eigsy(gram, eigvals_only=True)
    return len(at) - sum(1 for each in eigenvalues if each > mp.mpf(10) ** -40)


def turned(q: Array) -> Array:
    """The rotation x -> q x q^-1 of a quaternion that is not 0."""
    return np.asarray(_scaled(q) / (q @ q))


def _scaled(q: Array) -> Array:
    """The map x -> q x q*, a rotation and a scaling."""
    images = [quaternion.product(quaternion.product(q, unit), quaternion.conjugate(q))[1:] for unit in np.eye(4)[1:]]
    return array(images).T


def _through_origin(segment: tuple[Array, Array]) -> Number:
    """How far a segment between quaternions is from the origin, and those from being one rotation."""
    p, q = segment
    step = q - p
    nearest = p + step * min(max(-(p @ step) / (step @ step), mp.zero), mp.one)
    return max(size(nearest), difference(turned(p), turned(q)))


def _law_of_motions(direct: bool = False) -> Any:
    """The product of (q, t) and (r, s), as that of a semi-direct product; or of a direct one."""

    def product(m: Context, q: Array, t: Array, r: Array, s: Array) -> tuple[Array, Array]:
        return quaternion.product(q, r), t + (s if direct else quaternion.matrix(q) @ s)

    return product


def _dual(q: Array, t: Array) -> tuple[Array, Array]:
    """The unit dual quaternion q + e t q / 2 of a turn and a shift after it."""
    return q, quaternion.product(array([mp.zero, *t]), q) / 2


def _of_dual(real: Array, dual: Array) -> tuple[Array, Array]:
    return real, 2 * quaternion.product(dual, quaternion.conjugate(real))[1:]


def _dual_product(m: Context, q: Array, t: Array, r: Array, s: Array) -> tuple[Array, Array]:
    """The product of dual quaternions, e e = 0."""
    (a, b), (c, d) = _dual(q, t), _dual(r, s)
    return _of_dual(quaternion.product(a, c), quaternion.product(a, d) + quaternion.product(b, c))


def _motions() -> list[tuple[Array, Array, Array, Array]]:
    turns = [each / mp.sqrt(each @ each) for each in arrays("turns", 6, (4,), -2, 2)]
    shifts = arrays("shifts", 6, (3,), -2, 2)
    unit = exactly([1, 0, 0, 0])
    return [
        (unit, shifts[0], unit, shifts[1]),
        (exactly([0, 0, 0, 1]), exactly([0, 0, 0]), unit, exactly([1, 0, 0])),
        *((turns[k], shifts[k], turns[k + 1], shifts[k + 1]) for k in (0, 2, 4)),
    ]


def _no_flip(m: Context, linear: Array) -> bool:
    return bool(definitions.determinant(linear) > 0)


def _turns_right(m: Context, linear: Array) -> bool:
    """Whether the orthogonal polar factor U V of L = U D V is a rotation and no flip."""
    u, _, v = m.svd_r(m.matrix(linear.tolist()))
    return bool(m.det(u * v) > 0)


def _linear_maps() -> list[tuple[Array]]:
    corners = [exactly(each) for each in ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [[-1, 0, 0], [0, -2, 0], [0, 0, 1]])]
    return [(each,) for each in corners + arrays("linear", 8, (3, 3), -2, 2)]


def _splits(pair: tuple[Array, Array], _: None) -> int:
    """Whether both polar factors of a product are the products of the polar factors."""
    (r, s), (q, t), (p, u) = (polar.decompose(mp, each) for each in (*pair, pair[0] @ pair[1]))
    return int(difference(p, r @ q) < 1e-9 and difference(u, s @ t) < 1e-9)


def _multiple(m: Context, factor: Number, affine: Array) -> Array:
    """Alexa's multiple exp(a log A), by the principal logarithm."""
    return sam.power(m, affine, scalar(factor))


def _translated_quadratically(m: Context, factor: Number, affine: Array) -> Array:
    """The multiple, but for its translation."""
    return homogeneous(m, _multiple(m, factor, affine)[:3, :3], affine[:3, 3] * (factor + factor**2) / 2)


def _not_associative(multiple: Any, case: tuple[Number, Number, Array]) -> Number:
    a, b, affine = case
    return difference(multiple(mp, a, multiple(mp, b, affine)), multiple(mp, a * b, affine))


def _screw(angle: Number) -> Array:
    linear = so3.exp(mp, exactly([0, 0, 1]) * angle) @ exactly([[2, 0, 0], [0, 2, 0], [0, 0, 1]])
    return homogeneous(mp, linear, exactly([1, 0, 2]))


def _multiples(*factors: tuple[float, float]) -> list[tuple[Number, Number, Array]]:
    """Multiples of a turn by 1 radian, with growth along the axis and a shift."""
    return [(mp.mpf(a), mp.mpf(b), _screw(mp.one)) for a, b in factors]


def _negative_eigenvalue(linear: list[list[int]]) -> bool:
    """Whether an integer matrix has a negative eigenvalue."""
    return any(abs(mp.im(each)) < 1e-20 and mp.re(each) < 0 for each in definitions.eigenvalues(mp, exactly(linear)))


def _negative_trace(linear: list[list[int]]) -> bool:
    return sum(linear[k][k] for k in range(3)) < 0


def _existence_missed(excluded: Any, linear: list[list[int]]) -> int:
    return int(excluded(linear) is not (logarithm(linear) is Logarithm.NONE))


def _simple_negative() -> list[list[list[int]]]:
    return [
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 4]],
        [[-1, 1, 0], [0, -1, 0], [0, 0, 1]],
        [[-2, 5, 1], [1, -3, 0], [2, 1, 4]],
        [[0, -1, 0], [1, -1, 0], [0, 0, 1]],
    ]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.2.euler_angles",
        place="section 2, Euler angles",
        statement="At the gimbal lock Euler angles have no differentiable local inverse: condition (III) fails.",
        verdict=Verdict.CONFIRMED,
        form=euler,
        cases=_gimbal,
        deviation=lambda chart, at: abs(local_determinant(chart, at)),
        copies=(Copy("the rotation vector for Euler angles", so3.exp),),
    ),
    Claim(
        id="kaji_ochiai.2.quaternions.redundancy",
        place="section 2, invertible quaternions",
        statement="Invertible quaternions have one parameter more than the rotations: condition (IV) fails.",
        printed="dim = 4, greater by one than that of SO(3)",
        verdict=Verdict.CONFIRMED,
        form=turned,
        cases=lambda: [exactly([1, 0, 0, 0]), exactly([1, 2, -1, 3])],
        deviation=lambda chart, at: abs(redundancy(chart, at) - 1),
        copies=(Copy("x → q x q*, which scales too, for x → q x q⁻¹", _scaled),),
    ),
    Claim(
        id="kaji_ochiai.2.quaternions.origin",
        place="section 2, invertible quaternions",
        statement="A segment between invertible quaternions may pass the origin, which is no rotation: from q to -q, "
        "which are one rotation.",
        verdict=Verdict.CONFIRMED,
        form=(exactly([1, 2, 0, -1]), exactly([-1, -2, 0, 1])),
        cases=lambda: [None],
        deviation=lambda segment, _: _through_origin(segment),
        copies=(Copy("one sign changed", (exactly([1, 2, 0, -1]), exactly([-1, -2, 0, -1]))),),
    ),
    Claim(
        id="kaji_ochiai.2.dual_quaternions",
        place="section 2, dual quaternions",
        statement="The unit dual quaternions are the semi-direct product of the unit quaternions and of space.",
        verdict=Verdict.CONFIRMED,
        form=_law_of_motions(),
        cases=_motions,
        deviation=equals(_dual_product),
        copies=(Copy("the direct product", _law_of_motions(direct=True)),),
    ),
    Claim(
        id="kaji_ochiai.2.flips",
        place="section 2, Aff+(3)",
        statement="An invertible map has a positive determinant if and only if it contains no flip.",
        verdict=Verdict.CONFIRMED,
        form=_no_flip,
        cases=_linear_maps,
        deviation=lambda form, case: int(form(mp, *case) != _turns_right(mp, *case)),
        copies=(Copy("the trace for the determinant", lambda m, linear: bool(linear.trace() > 0)),),
    ),
    Claim(
        id="kaji_ochiai.2.non_direct_product",
        place="section 2, polar decomposition",
        statement="Aff+(3) is no direct product: the polar factors of a product are not the products of theirs.",
        verdict=Verdict.CONFIRMED,
        form=(exactly([[2, 0, 0], [0, 1, 0], [0, 0, 1]]), exactly([[0, -1, 0], [1, 0, 0], [0, 0, 1]])),
        cases=lambda: [None],
        deviation=_splits,
        copies=(
            Copy(
                "a stretch along the axis of the quarter turn",
                (exactly([[1, 0, 0], [0, 1, 0], [0, 0, 2]]), exactly([[0, -1, 0], [1, 0, 0], [0, 0, 1]])),
            ),
        ),
    ),
    Claim(
        id="kaji_ochiai.2.alexa.associativity",
        place="section 2, Alexa's scalar multiple",
        statement="With multiples exp(a log A), the a-multiple of the b-multiple of a map is its ab-multiple.",
        verdict=Verdict.BOUND,
        domain="|b| θ < π, θ the largest argument of an eigenvalue; beyond, log exp(b X) is not b X",
        form=_multiple,
        cases=lambda: _multiples((0.5, 0.5), (2, 3.125), (-1, -3), (0.25, 2), (3, 0.25)),
        outside=lambda: _multiples((0.5, 3.1875), (-0.25, 4), (1.5, -3.5)),
        deviation=_not_associative,
        copies=(Copy("(a + a²) / 2 times the translation for what log A gives", _translated_quadratically),),
    ),
    Claim(
        id="kaji_ochiai.2.alexa.negative_eigenvalues",
        place="section 2, the defect of Alexa's construction",
        statement="A map has no logarithm if and only if it has negative real eigenvalues.",
        printed="it does not work with transformations with negative real eigenvalues",
        verdict=Verdict.BOUND,
        domain="no double negative eigenvalue with a plane of eigenvectors: half turns, "
        "with any stretch along the axis and a uniform one across, have logarithms",
        form=_negative_eigenvalue,
        cases=_simple_negative,
        outside=lambda: [
            [[-1, 0, 0], [0, -1, 0], [0, 0, 1]],
            [[-2, 0, 0], [0, -2, 0], [0, 0, 3]],
            [[-1, 0, 1], [0, -1, 2], [0, 0, 1]],
        ],
        deviation=_existence_missed,
        copies=(Copy("the trace is negative", _negative_trace),),
        remark="Section 6 has it right: the maps with a logarithm are the squares.",
    ),
)
