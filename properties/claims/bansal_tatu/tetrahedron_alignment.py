"""Appendix A.1.2, part (3) of Theorem 1: a tetrahedron is aligned, scaled and sheared to the canonical one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import shear, tetrahedra
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, identity, norm

Corners = tuple[Array, Array]


def _solids() -> list[tuple[Array]]:
    return [(solid,) for solid in tetrahedra("aligned", 8)]


def alignment(normal: int = 1, *, turned: bool = True) -> Any:
    """The rigid motion of step (1), by the first edge and the normal of the first face."""

    def rigid_motion(m: Context, solid: Array) -> Array:
        first, corner = solid[:3, 1] - solid[:3, 0], solid[:3, 0]
        across = cross(first, solid[:3, 2] - solid[:3, 0]) * normal
        x, z = first / norm(m, first), across / norm(m, across)
        rotation = array([x, cross(z, x), z])
        return homogeneous(m, rotation, -(rotation @ corner if turned else corner))

    return rigid_motion


def _unaligned(form: Any, case: tuple[Array]) -> Number:
    """How far the motion is from rigid, and the vertices from where Figure 1 has them."""
    motion = form(mp, *case)
    v = (motion @ case[0])[:3]
    zeros = [*v[:, 0], v[1, 1], v[2, 1], v[2, 2]]
    rotation = motion[:3, :3]
    negative = v[0, 1] <= 0 or v[1, 2] <= 0 or v[2, 3] <= 0 or definitions.determinant(rotation) < 0
    return max(size(zeros), distance(rotation @ rotation.T, identity(mp, 3)), mp.mpf(negative))


def _choices(conditions: tuple[tuple[int, int], ...], case: tuple[Array]) -> int:
    """How many rotations, besides one, put the edge and the face where they are due and meet the conditions.

    Those that put the edge on the x axis and the face into the xy plane differ by half turns about the axes.
    """
    v = (alignment()(mp, *case) @ case[0])[:3]
    turns = [array([a, b, a * b])[:, None] * v for a in (1, -1) for b in (1, -1)]
    return abs(sum(all(turned[place] > 0 for place in conditions) for turned in turns) - 1)


def _scaled(m: Context, solid: Array, scale: Any = None) -> tuple[Number, Array]:
    """The scale s of step (2) and the scaled aligned vertices."""
    v = (alignment()(m, solid) @ solid)[:3]
    s = (scale or _scale)(v)
    return s, v * s


def _scale(v: Array) -> Number:
    return 1 / v[0, 1]


def _not_unit(scale: Any, case: tuple[Array]) -> Number:
    return distance(_scaled(mp, case[0], scale)[1][:, 1], exactly([1, 0, 0]))


def _corners() -> list[Corners]:
    """The third and fourth vertices after alignment and scaling, simple ones first."""
    simple = [(exactly([0, 1, 0]), exactly([0, 1, 1])), (exactly([2, 2, 0]), exactly([3, 4, 2]))]
    aligned = [_scaled(mp, solid)[1] for (solid,) in _solids()[2:]]
    return [*simple, *((w[:, 2] * exactly([1, 1, 0]), w[:, 3]) for w in aligned)]


def _solution(m: Context, w2: Array, w3: Array) -> Array:
    """The matrix that keeps the x axis and maps w2 to (1, 1, 0) and w3 to (0, 0, 1), by elimination."""
    images = np.stack([exactly(image, m) for image in ([1, 0, 0], [1, 1, 0], [0, 0, 1])], axis=1)
    shear_matrix: Array = images @ definitions.inverse(m, np.stack([exactly([1, 0, 0], m), w2, w3], axis=1))
    return shear_matrix


def _entries(*places: tuple[int, int]) -> Callable[..., Any]:
    return lambda m, w2, w3: tuple(_solution(m, w2, w3)[place] for place in places)


def _alpha_1(sign: int = -1) -> Any:
    return lambda m, w2, w3: ((1 + sign * w2[0]) / w2[1],)


def _alpha_3(sign: int = 1, outer: int = -1) -> Any:
    return lambda m, w2, w3: (outer * ((1 - w2[0]) * w3[1] + sign * w3[0] * w2[1]) / (w2[1] * w3[2]),)


def _alpha_4(sign: int = -1) -> Any:
    return lambda m, w2, w3: (sign * w3[1] / (w2[1] * w3[2]),)


def represented(m: Context, solid: Array) -> tuple[Array, Array, Number]:
    """The E, A and s of a tetrahedron, with A from equations 8 and 9 as printed."""
    s, w = _scaled(m, solid)
    w2, w3 = w[:, 2], w[:, 3]
    (a1,), (a3,), (a4,) = _alpha_1()(m, w2, w3), _alpha_3()(m, w2, w3), _alpha_4()(m, w2, w3)
    return alignment()(m, solid), shear(m, a1, 1 / w2[1], a3, a4, 1 / w3[2]), s


def _not_positive(form: Any, case: tuple[Array]) -> bool:
    """Whether w_2y or w_3z, by that alignment, is not positive."""
    w = (form(mp, *case) @ case[0])[:3]
    return bool(w[1, 2] <= 0 or w[2, 3] <= 0)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.2.3.rigid",
        place="appendix A.1.2 (3); figure 1",
        statement="A rotation by the first edge and the normal of the first face, and the translation by -R u_0, align "
        "a tetrahedron: first edge on the positive x axis, third vertex in the xy plane at y > 0, fourth at z > 0.",
        verdict=Verdict.CONFIRMED,
        form=alignment(),
        cases=_solids,
        deviation=_unaligned,
        copies=(
            Copy("the translation by -u_0", alignment(turned=False)),
            Copy("the normal reversed", alignment(normal=-1)),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.rotation_unique",
        place="appendix A.1.2 (3)",
        statement="The aligning rotation is unique.",
        printed="there exists a unique rotation matrix that aligns two orthogonal vectors",
        verdict=Verdict.CONFIRMED,
        form=((0, 1), (1, 2)),
        cases=_solids,
        deviation=_choices,
        copies=(
            Copy("the edge is to be on the x axis, of either direction", ((1, 2),)),
            Copy("the third vertex may be at y < 0", ((0, 1),)),
        ),
        remark="z > 0 of the fourth vertex follows, and could stand for either condition.",
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.scale",
        place="appendix A.1.2 (3)",
        statement="The scaling by 1 / v_1x maps the second vertex of the aligned tetrahedron to (1, 0, 0).",
        printed="s = 1 / v_1x",
        verdict=Verdict.CONFIRMED,
        form=_scale,
        cases=_solids,
        deviation=_not_unit,
        copies=(
            Copy("v_1x for its inverse", lambda v: v[0, 1]),
            Copy("v_2 for v_1", lambda v: 1 / norm(mp, v[:, 2])),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.alpha_1",
        place="appendix A.1.2, equation 8",
        statement="The parameter α1 of the shear that maps w_2 to (1, 1, 0).",
        printed="α1 = (1 - w_2x) / w_2y",
        verdict=Verdict.CONFIRMED,
        form=_alpha_1(),
        cases=_corners,
        deviation=equals(_entries((0, 1))),
        copies=(Copy("1 + w_2x", _alpha_1(sign=1)),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.alpha_2_5",
        place="appendix A.1.2, equations 8 and 9",
        statement="The parameters α2 and α5 of that shear.",
        printed="α2 = 1 / w_2y, α5 = 1 / w_3z",
        verdict=Verdict.CONFIRMED,
        form=lambda m, w2, w3: (1 / w2[1], 1 / w3[2]),
        cases=_corners,
        deviation=equals(_entries((1, 1), (2, 2))),
        copies=(Copy("w_3y for w_3z", lambda m, w2, w3: (1 / w2[1], 1 / w3[1])),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.alpha_3",
        place="appendix A.1.2, equation 8",
        statement="The parameter α3 of the shear that maps w_3 to (0, 0, 1) too.",
        printed="α3 = -((1 - w_2x) w_3y + w_3x w_2y) / (w_2y w_3z)",
        verdict=Verdict.CONFIRMED,
        form=_alpha_3(),
        cases=_corners,
        deviation=equals(_entries((0, 2))),
        copies=(
            Copy("- w_3x w_2y", _alpha_3(sign=-1)),
            Copy("without the sign in front", _alpha_3(outer=1)),
        ),
        losses=(
            Loss(
                where="w_2 = (0.1, 0.9, 0), w_3 = (-0.3, 0.3, 1), where the two products cancel",
                formula=_alpha_3(),
                truth=_entries((0, 2)),
                at=([0.1, 0.9, 0.0], [-0.3, 0.3, 1.0]),
                digits=16,
            ),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.alpha_4",
        place="appendix A.1.2, equation 9",
        statement="The parameter α4 of that shear.",
        printed="α4 = -w_3y / (w_2y w_3z)",
        verdict=Verdict.CONFIRMED,
        form=_alpha_4(),
        cases=_corners,
        deviation=equals(_entries((1, 2))),
        copies=(Copy("without the sign", _alpha_4(sign=1)),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.positive",
        place="appendix A.1.2 (3), the note below equation 9",
        statement="For a tetrahedron oriented as the canonical one w_2y > 0 and w_3z > 0.",
        printed="w_2y > 0 and w_3z > 0",
        verdict=Verdict.CONFIRMED,
        form=alignment(),
        cases=_solids,
        deviation=_not_positive,
        copies=(Copy("the normal reversed in the alignment", alignment(normal=-1)),),
    ),
)
