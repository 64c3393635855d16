"""Section 5.3: blends of shapes."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.blending import blend
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference import kaji_ochiai, mesh3
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, norm

FACES = exactly([[0, 1, 2], [1, 3, 2]])


REST = exactly([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1]])


TARGETS = exactly([[[0, 0, 0], [2, 0, 0], [0, 1, 1], [1, 1, 3]], [[1, 0, 0], [1, 1, 0], [0, 0, 1], [-1, 2, 1]]])


def _frame(m: Context, triangle: Array, side: int = 1) -> Array:
    normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
    return array([triangle[1] - triangle[0], triangle[2] - triangle[0], side * normal / norm(m, normal)]).T


def _face_map(side: int = 1) -> Any:
    """The affine map of a triangle and its unit normal to another one and its own, or its opposite."""

    def of_faces(m: Context, source: Array, target: Array) -> Array:
        linear = _frame(m, target, side) @ definitions.inverse(m, _frame(m, source))
        return homogeneous(m, linear, target[0] - linear @ source[0])

    return of_faces


def _no_face_map(form: Any, case: tuple[Array, Array]) -> Number:
    """How far a map is from taking vertices and normal to vertices and normal, and from a positive determinant."""
    source, target = case
    affine = form(mp, source, target)
    images = array([(affine @ array([*u, mp.one]))[:3] for u in source])
    gap = difference(affine[:3, :3] @ _frame(mp, source)[:, 2], _frame(mp, target)[:, 2])
    return max(difference(images, target), gap, mp.one * (definitions.determinant(affine[:3, :3]) <= 0))


def _faces() -> list[tuple[Array, Array]]:
    triangles = arrays("triangles", 10, (3, 3), -2, 2)
    return [(REST[:3], TARGETS[0][:3]), *zip(triangles[::2], triangles[1::2], strict=True)]


def _unique(points: int, case: tuple[Array, Array]) -> int:
    """Whether so many conditions, three vertices and the tip of the normal, leave an affine map open."""
    source, _ = case
    tip = source[0] + _frame(mp, source)[:, 2]
    rows = [[*u, mp.one] for u in (*source, tip)][:points]
    gram = array(rows) @ array(rows).T
    return 4 - points + int(abs(definitions.determinant(gram)) < 1e-40)


def _edge_kept(targets: Array, weights: Array) -> int:
    """Whether the blended maps of two faces agree on their common edge, 1 to 2: then nothing has to be patched."""
    images = []
    for face in FACES.astype(int):
        maps = [_face_map()(mp, REST[face], target[face]) for target in targets]
        images.append(blend(mp, array(maps), weights)[:3, :3] @ (REST[2] - REST[1]))
    return int(difference(images[0], images[1]) < 1e-9)


def _rigid_targets() -> Array:
    return array(
        [REST @ kaji_ochiai.realise(mp, own)[:3, :3].T for own in exactly([[0] * 3 + [1, 0, 2] + [0] * 6, [0] * 12])]
    )


def _shape(form: str) -> Any:
    def shape(m: Context, weights: Array) -> Array:
        if form == "blend":
            return mesh3.blend(m, REST, TARGETS, FACES, weights)
        return mesh3.blend(m, REST, TARGETS[::-1], FACES, weights)

    return shape


def _given_shape(m: Context, weights: Array) -> Array:
    chosen = [target for weight, target in zip(weights, TARGETS, strict=True) if weight]
    return np.asarray(chosen[0] if chosen else REST)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.5.3.face_map",
        place="section 5.3",
        statement="The affine map of a face to a face, and of unit normal to unit normal, has positive determinant.",
        verdict=Verdict.CONFIRMED,
        form=_face_map(),
        cases=_faces,
        deviation=_no_face_map,
        copies=(Copy("the opposite normal", _face_map(-1)),),
        remark="The determinant is the ratio of the areas.",
    ),
    Claim(
        id="kaji_ochiai.5.3.face_map_unique",
        place="section 5.3",
        statement="It is unique: three vertices and the tip of the normal are four points in general position.",
        printed="the unique affine transformation",
        verdict=Verdict.CONFIRMED,
        form=4,
        cases=_faces,
        deviation=_unique,
        copies=(Copy("the vertices only", 3),),
    ),
    Claim(
        id="kaji_ochiai.5.3.incoherent",
        place="section 5.3",
        statement="Blended maps of faces do not agree on common edges.",
        verdict=Verdict.CONFIRMED,
        form=TARGETS,
        cases=lambda: [exactly([0.5, 0.5]), exactly([0.25, 0.5])],
        deviation=_edge_kept,
        copies=(Copy("targets that are the rest shape, turned as a whole", _rigid_targets()),),
    ),
    Claim(
        id="kaji_ochiai.5.3.interpolates",
        place="section 5.3",
        statement="The blended shape is target i for w_i = 1 and 0 else, and the rest shape for w = 0.",
        verdict=Verdict.CONFIRMED,
        form=_shape("blend"),
        cases=lambda: [(exactly(each),) for each in ([0, 0], [1, 0], [0, 1])],
        deviation=equals(_given_shape),
        copies=(Copy("the targets exchanged", _shape("exchanged")),),
        remark="With the error function of `affinecert.reference.mesh3`; that of the paper is lost. Any that vanishes "
        "for maps that agree on the edges does, once the free translation is fixed.",
    ),
    Claim(
        id="kaji_ochiai.5.3.error_function",
        place="section 5.3",
        statement="Blended maps are patched by the minimiser of an error function.",
        verdict=Verdict.UNCHECKABLE,
        reason="The error function is missing in the copy of the paper at hand.",
    ),
    Claim(
        id="kaji_ochiai.5.figures",
        place="section 5, figures 2 to 4",
        statement="Deformations and blends look better than those of other methods.",
        verdict=Verdict.UNCHECKABLE,
        reason="The figures and their meshes are missing, and the judgement is the eye's.",
    ),
)
