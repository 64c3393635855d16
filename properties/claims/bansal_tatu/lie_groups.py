"""Section 3.2: what is said of Lie groups and their exponentials."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.product_group import BASIS, group_logarithm, off_group, unit_matrix
from affinecert.properties.claims.bansal_tatu.samples import QUARTER_TURN, TIMES, embedded, inverse, rigid_maps
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.reference import se3, shear, so3
from affinecert.reference._matrices import Array, Number, array, cross_matrix, identity, tangent


def _elements() -> list[tuple[str, Array]]:
    """Elements of the groups."""
    twists = [exactly([1, 0, 1, 0, -1]), *arrays("shear twists", 3, (5,), -2, 2)]
    scales = [exactly([[each]]) for each in (2, mp.mpf(3) / 4)]
    rigid = [("SE(3)", pose) for pose in rigid_maps()[:4]]
    return rigid + [("G_A", shear.exp(mp, twist)) for twist in twists] + [("G_S", each) for each in scales]


def _tangents() -> list[tuple[str, Array]]:
    """Elements of their Lie algebras."""
    return [(group, group_logarithm(group, element)) for group, element in _elements()]


def _naive_logarithm(group: str, element: Array) -> Array:
    """That of the rotation alone, with the translation as it is."""
    if group != "SE(3)":
        return group_logarithm(group, element)
    return tangent(mp, cross_matrix(mp, so3.log(mp, element[:3, :3])), element[:3, 3])


def _exponential(matrix: Array) -> Array:
    return definitions.exponential(mp, matrix)


# 2 pi J, J with J^2 = -1 on a plane, in a skew basis: no skew matrix, and its exponential is I.
FULL_TURN = array([[0, -mp.pi / 2, 0], [8 * mp.pi, 0, 0], [0, 0, 0]]) * mp.one


def _misjudged(times: Sequence[Number], matrix: Array) -> int:
    """Whether "exp(t X) is a rotation for those t" is another thing than "X is tangent to SO(3)", that is skew."""
    member = all(off_group("SO(3)", _exponential(matrix * t)) < mp.mpf(10) ** -40 for t in times)
    return int(member != (size(matrix + matrix.T) == 0))


def _off_translates(velocity: Callable[[Array, Array], Array], case: tuple[str, Array]) -> Number:
    """How far the velocity of t -> p exp(t X) at 0, for X of the basis, is from both p g and g p."""
    group, p = case

    def off(x: Array) -> Number:
        found = velocity(p, x)
        curve = definitions.derivative(mp, lambda t: p @ _exponential(x * t), mp.zero)
        return max(difference(found, curve), _coordinates(group, found @ inverse(p)))

    return max(map(off, BASIS[group]))


def _coordinates(group: str, matrix: Array) -> Number:
    """How far a matrix is from the Lie algebra of a group."""
    rest = matrix.copy()
    for x in BASIS[group]:
        # The basis is orthogonal.
        rest = rest - x * ((x * matrix).sum() / (x * x).sum())
    return size(rest)


def _not_integral(curve: Callable[[Array, Number], Array], case: tuple[str, Array]) -> Number:
    """How far γ' is from γ X, the left-invariant field."""
    _, x = case
    return max(distance(definitions.derivative(mp, lambda s: curve(x, s), t), curve(x, t) @ x) for t in TIMES)


def _first_variation(metric: Callable[[Array, Array], Number], case: tuple[Array, Sequence[Array]]) -> Number:
    """The largest first variation of the energy of exp(t X) in a left-invariant metric, relative to |X|^2.

    Of c = exp(t X), varied by c^-1 delta c = eta(t) with eta = 0 at both ends, it is the integral of <X, eta' + [X,
    eta]>, and that of <X, eta'> is 0. So exp(t X) is a geodesic if and only if <X, [X, Y]> = 0 for all Y.
    """
    x, basis = case
    largest = max(abs(metric(x, x @ y - y @ x)) for y in basis)
    return largest / metric(x, x)


def _frobenius(x: Array, y: Array) -> Number:
    return (x * y).sum()


def _oblong(x: Array, y: Array) -> Number:
    """The energy of a rotating oblong body."""
    weights = exactly([[1, 1, 2], [1, 1, 3], [2, 3, 1]])[: len(x), : len(x)]
    return (weights * x * y).sum()


def _geodesics() -> list[tuple[Array, Sequence[Array]]]:
    skew = [cross_matrix(mp, axis) for axis in identity(mp, 3)]
    vectors = [exactly([1, 0, 0]), exactly([1, 1, 0]), *arrays("turns", 3, (3,), -2, 2)]
    return [(exactly([[2]]), BASIS["G_S"]), *((cross_matrix(mp, each), skew) for each in vectors)]


def _no_geodesics() -> list[tuple[Array, Sequence[Array]]]:
    turning = tangent(mp, cross_matrix(mp, exactly([0, 0, 1])), exactly([1, 0, 0]))
    return [(turning, BASIS["SE(3)"]), (unit_matrix(3, 0, 1), BASIS["G_A"])]


def _lengths() -> dict[str, Number]:
    """Frobenius lengths, in the frame that moves, of two motions by a quarter turn about z and 1 along x."""
    pose = embedded(QUARTER_TURN)
    pose[0, 3] = mp.one
    twist = se3.log(mp, pose)
    turn = mp.sqrt(2) * mp.pi / 2
    return {
        "exp(t log E), E a quarter turn about z and a unit step along x": mp.hypot(turn, mp.norm(list(twist[3:]))),
        "the same turn with the step in a straight line": mp.hypot(turn, 1),
    }


def _between(p: Array, q: Array, t: Number, group: str) -> Array:
    result: Array = p @ _exponential(group_logarithm(group, inverse(p) @ q) * t)
    return result


def _backwards(p: Array, q: Array, t: Number, group: str) -> Array:
    result: Array = p @ _exponential(group_logarithm(group, inverse(q) @ p) * t)
    return result


def _by_logarithms(p: Array, q: Array, t: Number, group: str) -> Array:
    return _exponential(group_logarithm(group, p) * (1 - t) + group_logarithm(group, q) * t)


def _straight(p: Array, q: Array, t: Number, _: str) -> Array:
    result: Array = p * (1 - t) + q * t
    return result


def _no_translate(curve: Callable[..., Array], case: tuple[str, Array, Array, Array]) -> Number:
    """Whether it is a curve in the group from p to q that is carried along by g."""
    group, g, p, q = case
    t = TIMES[0]
    ends = max(difference(curve(p, q, mp.zero, group), p), difference(curve(p, q, mp.one, group), q))
    inside = curve(p, q, t, group)
    carried = difference(curve(g @ p, g @ q, t, group), g @ inside)
    return max(ends, carried, off_group(group, inside))


def _triples() -> list[tuple[str, Array, Array, Array]]:
    elements = _elements()
    triples = zip(elements, elements[1:], elements[2:], strict=False)
    return [(one[0], one[1], two[1], three[1]) for one, two, three in triples if one[0] == three[0]]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.3.2.lie_algebra",
        place="section 3.2, definition of 𝔤",
        statement="The Lie algebra of a matrix group G, a vector space and its tangent space at the identity, is the "
        "set of the X with exp(X) ∈ G.",
        printed="𝔤 = {X ∈ M_n(ℝ) | exp(X) ∈ G}",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=(mp.one,),
        cases=lambda: [
            cross_matrix(mp, exactly([0, 0, 1])),
            exactly([[1, 0, 0], [0, 0, 0], [0, 0, 0]]),
            FULL_TURN,
            cross_matrix(mp, exactly([1, -2, 2])),
        ],
        deviation=_misjudged,
        correction=Correction(
            statement="it is the set of the X with exp(t X) ∈ G for all real t",
            form=(mp.one, mp.mpf(1) / 2, mp.sqrt(2)),
        ),
        copies=(Copy("exp(2 X) for exp(X)", (mp.mpf(2),)),),
        remark="In SO(3), X = 2π P J P⁻¹ has exp(X) = I without being skew; such X make no vector space.",
    ),
    Claim(
        id="bansal_tatu.3.2.tangent_space",
        place="section 3.2",
        statement="The tangent space at p is p 𝔤, and also 𝔤 p.",
        printed="T_p G = {p X | X ∈ 𝔤}",
        verdict=Verdict.CONFIRMED,
        form=lambda p, x: p @ x,
        cases=_elements,
        deviation=_off_translates,
        copies=(Copy("p Xᵀ", lambda p, x: p @ x.T), Copy("pᵀ X", lambda p, x: p.T @ x)),
    ),
    Claim(
        id="bansal_tatu.3.2.integral_curve",
        place="section 3.2",
        statement="The integral curve of the left-invariant field of X through the identity is exp(t X).",
        verdict=Verdict.CONFIRMED,
        form=lambda x, t: _exponential(x * t),
        cases=_tangents,
        deviation=_not_integral,
        copies=(Copy("exp(t² X)", lambda x, t: _exponential(x * t**2)),),
    ),
    Claim(
        id="bansal_tatu.3.2.logarithm",
        place="section 3.2",
        statement="The logarithm inverts the exponential: exp(log g) = g in SE(3), G_A and G_S.",
        verdict=Verdict.CONFIRMED,
        form=group_logarithm,
        cases=_elements,
        deviation=lambda logarithm, case: distance(_exponential(logarithm(*case)), case[1]),
        copies=(Copy("the translation of E taken over as it is", _naive_logarithm),),
    ),
    Claim(
        id="bansal_tatu.3.2.geodesic",
        place="section 3.2",
        statement="In a matrix Lie group the curve exp(t log p) is a geodesic, of locally least length.",
        verdict=Verdict.BOUND,
        domain="groups with a metric invariant from both sides, such as SO(3) and G_S; in SE(3) and G_A there is none",
        form=_frobenius,
        cases=_geodesics,
        outside=_no_geodesics,
        deviation=_first_variation,
        copies=(Copy("the metric of an oblong body on SO(3)", _oblong),),
        remark="Checked with the left-invariant metric that is Frobenius' at the identity, by the first variation of "
        "the energy. The interpolation needs one-parameter groups only, no geodesics.",
        numbers=_lengths,
    ),
    Claim(
        id="bansal_tatu.3.2.translated",
        place="section 3.2, figure 2",
        statement="The curve p exp(t log(p⁻¹q)) runs in the group from p to q; left translation carries it along.",
        printed="c(t) = p exp(t log(p⁻¹q))",
        verdict=Verdict.CONFIRMED,
        form=_between,
        cases=_triples,
        deviation=_no_translate,
        copies=(
            Copy("q⁻¹p for p⁻¹q", _backwards),
            Copy("exp((1 - t) log p + t log q)", _by_logarithms),
            Copy("(1 - t) p + t q", _straight),
        ),
    ),
    Claim(
        id="bansal_tatu.3.2.closed_subgroups",
        place="section 3.2",
        statement="A closed subgroup of GL(n, ℝ) is an embedded submanifold.",
        verdict=Verdict.UNCHECKABLE,
        reason="Cartan's theorem: a proof of it, not a computation on examples, would be its check.",
    ),
)
