"""Section 6.2: the velocity of a steady motion, in the moving frame and in space, and equation 7."""

from __future__ import annotations

from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.listings import power
from affinecert.properties.claims.rossignac_vinacua.motions_from_identity import (
    TIMES,
    all_maps,
    by,
    change_of_field,
    maps,
    parabolic_maps,
    singular_maps,
    steady_motion,
)
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, identity


def _place(end: Array) -> Array:
    """A point."""
    place: Array = exactly([1, -2, 3][: len(end) - 1])
    return place


def _local(constants: int = 1, transposed: bool = False) -> Any:
    """M x + (sigma, tau)."""

    def velocity(generator: Array, place: Array) -> Array:
        linear = generator[:-1, :-1].T if transposed else generator[:-1, :-1]
        found: Array = linear @ place + constants * generator[:-1, -1]
        return found

    return velocity


def _not_the_local_velocity(velocity: Any, end: Array) -> Number:
    """How far it is from L^-1 p', p the path of a point, at several times."""
    place = _place(end)
    stated = velocity(sam.log(mp, end), place)
    gaps = []
    for t in TIMES:
        pose, change = power(end, t), definitions.derivative(mp, steady_motion(end), t)
        moved = change[:-1, :-1] @ place + change[:-1, -1]
        gaps.append(difference(definitions.inverse(mp, pose[:-1, :-1]) @ moved, stated))
    return max(gaps)


def _commuting(transposed: bool = False) -> Any:
    def partner(velocity: Array, t: Number) -> Array:
        return definitions.exponential(mp, t * (velocity.T if transposed else velocity))

    return partner


def _commutator(partner: Any, end: Array) -> Number:
    velocity = sam.log(mp, end)[:-1, :-1]
    others = [partner(velocity, t) for t in TIMES]
    return max(difference(velocity @ other, other @ velocity) for other in others)


def _not_one_group(make: Any, end: Array) -> Number:
    """How far the motion from a point of a path is from the rest of that path: A^s A^t from A^(s + t)."""
    motion = make(end)
    return max(distance(motion(t) @ motion(s), motion(s + t)) for s in TIMES[1:] for t in TIMES[1:])


def _true_velocity(end: Array, place: Array, t: Number) -> Array:
    """The velocity of the motion at a place and time: that of the point that is there then."""
    back = definitions.inverse(mp, power(end, t))
    point = back[:-1, :-1] @ place + back[:-1, -1]
    change = definitions.derivative(mp, steady_motion(end), t)
    velocity: Array = change[:-1, :-1] @ point + change[:-1, -1]
    return velocity


def _equation_7(sign: int = 1) -> Any:
    """log(L) (p - q), q the fixed point: where 1 is no eigenvalue the last term of equation 7 is 0."""

    def velocity(end: Array, place: Array) -> Array:
        found: Array = sam.log(mp, end)[:-1, :-1] @ (place - sign * sam.fixed_point(mp, end))
        return found

    return velocity


def _without_logarithm(end: Array, place: Array) -> Array:
    """(L - 1) (p - q)."""
    found: Array = (end[:-1, :-1] - identity(mp, len(place))) @ (place - sam.fixed_point(mp, end))
    return found


def _not_the_velocity(velocity: Any, end: Array) -> Number:
    stated = velocity(end, _place(end))
    return max(difference(_true_velocity(end, _place(end), t), stated) for t in TIMES)


def _stretched_along() -> list[Array]:
    """Maps of the plane with the simple eigenvalue 1, first those with orthogonal eigenvectors."""
    return [
        affine([[1, 0], [0, 2]], [1, 3]),
        affine([[1, 1], [0, 2]], [0, 1]),
        affine([[0.5, 0], [1, 1]], [3, 1]),
        affine([[2, 1], [1, 2]], [1, 1]),
    ]


def _projection(orthogonal: bool, complement: int = 0) -> Any:
    """The projection of the translation onto the eigenspace of 1: orthogonal, or along the image of L - 1."""

    def projection(end: Array) -> Array:
        linear, translation = end[:-1, :-1], end[:-1, -1]
        other = linear.trace() - 1
        # L - other has the eigenspace of 1 as its image, and 0 on the other eigenvector.
        onto = (linear - other * identity(mp, 2)) / (1 - other)
        if complement:
            onto = identity(mp, 2) - onto
        if orthogonal:
            column = max((onto[:, k] for k in range(2)), key=size)
            along: Array = column * (column @ translation) / (column @ column)
            return along
        projected: Array = onto @ translation
        return projected

    return projection


def _not_the_velocity_with(projection: Any, end: Array) -> Number:
    """How far log(L) (p - q) + t_N is from the velocity, q being on the line that is mapped to itself."""
    generator = sam.log(mp, end)
    linear, vector = generator[:-1, :-1], generator[:-1, -1]
    on_the_line = -vector / linear.trace()
    return _not_the_velocity(lambda _, place: linear @ (place - on_the_line) + projection(end), end)


def _line(sign: int = -1) -> Any:
    """A point of a line that is mapped to itself: -v / trace(log L), or, of the eigenvalue 1 twice, any."""

    def point(end: Array) -> Array:
        generator = sam.log(mp, end)
        rate = generator[:-1, :-1].trace()
        found: Array = (
            sign * generator[:-1, -1] / rate if abs(rate) > mp.mpf(10) ** -50 else mp.zero * generator[:-1, -1]
        )
        return found

    return point


def _leaves_the_line(point: Any, end: Array) -> Number:
    """The part of the step from a point to its image that L changes: 0 for a fixed point, and on an invariant line."""
    place = point(end)
    step = end[:-1, :-1] @ place + end[:-1, -1] - place
    return size(end[:-1, :-1] @ step - step)


def _centre(factor: int = 1) -> Any:
    def centre(end: Array) -> Array:
        found: Array = factor * sam.fixed_point(mp, end)
        return found

    return centre


def _not_linear_in_distance(centre: Any, end: Array) -> Number:
    """How far the velocity at q + 3 x is from three times that at q + x."""
    middle, away = centre(end), _place(end)
    near, far = (sam.velocity(mp, end, middle + k * away) for k in (1, 3))
    return difference(far, 3 * near)


def _fixed_point_is_left(make: Any, end: Array) -> Number:
    """How far a motion takes the fixed point of A away."""
    try:
        middle = sam.fixed_point(mp, end)
    except InputError:
        return mp.inf
    motion = make(end)
    poses = [motion(t) for t in TIMES]
    return max(difference(pose[:-1, :-1] @ middle + pose[:-1, -1], middle) for pose in poses)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.6.2.local_velocity",
        place="section 6.2",
        statement="In the moving frame the velocity of the point that starts at x is M x + (σ, τ) at all times.",
        printed="M [x_0, y_0]ᵀ + [σ, τ]ᵀ",
        verdict=Verdict.CONFIRMED,
        form=_local(),
        cases=all_maps,
        deviation=_not_the_local_velocity,
        copies=(Copy("- (σ, τ)", _local(constants=-1)), Copy("M transposed", _local(transposed=True))),
    ),
    Claim(
        id="rossignac_vinacua.6.2.commute",
        place="section 6.2",
        statement="M and exp(t M) commute.",
        verdict=Verdict.CONFIRMED,
        form=_commuting(),
        cases=maps,
        deviation=_commutator,
        copies=(Copy("exp(t Mᵀ)", _commuting(transposed=True)),),
    ),
    Claim(
        id="rossignac_vinacua.6.2.stationary",
        place="section 6.2",
        statement="The velocity field of A^t is stationary: at each place of space the velocity is the same at all "
        "times, also where 1 is an eigenvalue of L.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=all_maps,
        deviation=change_of_field,
        copies=(Copy("rARAP", by("rarap")), Copy("ASAP", by("asap"))),
        remark="True of the parabolic shears too, for which the proof that is given fails "
        "(rossignac_vinacua.6.2.invariant_line).",
    ),
    Claim(
        id="rossignac_vinacua.6.2.trajectories",
        place="section 6.2 and figure 8",
        statement="The trajectories are integral curves of one field that does not depend on time: from each of its "
        "points a trajectory goes on as one that starts there.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=all_maps,
        deviation=_not_one_group,
        copies=(Copy("ASAP", by("asap")), Copy("the linear morph", by("linear"))),
    ),
    Claim(
        id="rossignac_vinacua.6.2.fixed_point",
        place="section 6.2 and section 4",
        statement="The fixed point of A stays where it is throughout the motion A^t.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=maps,
        deviation=_fixed_point_is_left,
        copies=(Copy("rARAP", by("rarap")),),
    ),
    Claim(
        id="rossignac_vinacua.6.2.invariant_line",
        place="section 6.2",
        statement="If 1 is an eigenvalue of L, there is a fixed point or a line that is mapped to itself along an "
        "eigenvector of 1.",
        verdict=Verdict.BOUND,
        domain="L is no shear with a translation across: [[1, 1], [0, 1]] with (0, 1) has neither",
        form=_line(),
        cases=lambda: [*singular_maps(), *_stretched_along()],
        outside=parabolic_maps,
        deviation=_leaves_the_line,
        copies=(Copy("a point opposite", _line(1)),),
    ),
    Claim(
        id="rossignac_vinacua.6.2.equation_7",
        place="section 6.2, equation 7",
        statement="If 1 is no eigenvalue of L, the velocity at p is log(L) (p - q), q the fixed point.",
        printed="p' = log(L)(qp) + t_N, t_N = 0",
        verdict=Verdict.CONFIRMED,
        form=_equation_7(),
        cases=maps,
        deviation=_not_the_velocity,
        copies=(Copy("p + q for p - q", _equation_7(-1)), Copy("L - 1 for log(L)", _without_logarithm)),
        remark="As A^t is reached at t = 1; no fixed point is needed in log A = [[log L, v], [0, 0]], with which the "
        "velocity is log(L) p + v in all cases.",
    ),
    Claim(
        id="rossignac_vinacua.6.2.projection",
        place="section 6.2, equation 7",
        statement="If 1 is an eigenvalue of L, t_N in equation 7 is the (orthogonal) projection of the translation "
        "onto its eigenspace.",
        printed="p' = log(L)(qp) + t_N",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_projection(orthogonal=True),
        cases=_stretched_along,
        deviation=_not_the_velocity_with,
        correction=Correction(
            statement="t_N is the projection along the image of L - 1, q a point of the invariant line; there is none "
            "for a shear with a translation across.",
            form=_projection(orthogonal=False),
        ),
        copies=(Copy("the complementary projection", _projection(orthogonal=False, complement=1)),),
        remark="The text does not say which projection; only that one does not depend on the origin.",
    ),
    Claim(
        id="rossignac_vinacua.figure_8.linear",
        place="figure 8",
        statement="Along each ray from the fixed point the velocity grows linearly with the distance.",
        verdict=Verdict.CONFIRMED,
        form=_centre(),
        cases=maps,
        deviation=_not_linear_in_distance,
        copies=(Copy("from the origin", _centre(0)),),
    ),
)
