"""Sections 2 and 7: closed forms, Alexa's logarithms, Lie Bodies, and meshes of tetrahedra."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import CANONICAL, at, between, maps, moved
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import HOLDS, difference, distance, exactly, mp, size
from affinecert.reference import affine_lie, morphs
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, identity, norm

HALF = mp.mpf(1) / 2

Between = Callable[[Context, Array, Array, Array], Array]
"""A morph."""


def _cubic(m: Context, matrix: Array) -> list[Number]:
    """The eigenvalues of a 3x3 matrix by Cardano's formula."""
    trace = matrix.trace()
    minors = (trace**2 - (matrix @ matrix).trace()) / 2
    p, q = minors - trace**2 / 3, -2 * trace**3 / 27 + trace * minors / 3 - definitions.determinant(matrix)
    root = m.sqrt(m.mpc(q**2 / 4 + p**3 / 27))
    u = m.root(-q / 2 + root, 3)
    turns = (m.expjpi(m.mpf(2 * k) / 3) for k in range(3))
    return [u * turn - p / (3 * u * turn) + trace / 3 for turn in turns]


def _closed(last: int = 0) -> Callable[[Context, Array], Array]:
    """The exponential of [[X, v], [0, 0]] in closed form, by Sylvester's formula at Cardano's eigenvalues and 0."""

    def exponential(m: Context, tangent: Array) -> Array:
        with m.extradps(15):
            nodes = [*_cubic(m, tangent[:3, :3]), m.mpc(last)]
            total = identity(m, 4) * m.mpc(0)
            for x in nodes:
                term = identity(m, 4) * m.exp(x)
                for y in nodes:
                    if y is not x:
                        term = term @ (tangent - identity(m, 4) * y) / (x - y)
                total = total + term
        return array([[entry.real for entry in row] for row in total])

    return exponential


def _tangents() -> list[Array]:
    drawn = arrays("affine tangents", 4, (3, 4), -1, 1)
    simple = exactly([[1, 0, 0, 1], [0, 2, 0, 1], [0, 0, 3, 1]])
    rows = exactly([[0, 0, 0, 0]])
    return [array([*each.tolist(), *rows.tolist()]) for each in (simple, *drawn)]


def _off_exponential(closed: Callable[[Context, Array], Array], tangent: Array) -> Number:
    return distance(closed(mp, tangent), definitions.exponential(mp, tangent))


def _straight(path: Between, pose: Array) -> Number:
    """How far the morph from I moves the origin off the straight line in which separate translations go."""
    return size(path(mp, identity(mp, 4), pose, at(HALF))[:3, 3] - pose[:3, 3] * HALF)


def _with_logarithms() -> list[Array]:
    found = []
    for pose in maps():
        try:
            morphs.alexa_2002(mp, identity(mp, 4), pose, at(HALF))
        except InputError:
            continue
        found.append(pose)
    return found


def _by_triangle(pose: Array) -> Array:
    """The linear map of the first face of the canonical tetrahedron's image and its unit normal."""
    face = moved(pose, CANONICAL)[:3]
    normal = cross(face[1] - face[0], face[2] - face[0])
    top = face[0] + normal / norm(mp, normal)
    return between(CANONICAL, array([*face.tolist(), top.tolist()]))[:3, :3]


def _by_tetrahedron(pose: Array) -> Array:
    return between(CANONICAL, moved(pose, CANONICAL))[:3, :3]


def _told_apart(represent: Callable[[Array], Array], pose: Array) -> int:
    """1 if two affine maps that agree on the first face are told apart."""
    other = homogeneous(mp, pose[:3, :3] @ exactly([[1, 0, 1], [0, 1, 0], [0, 0, 2]]), pose[:3, 3])
    return int(difference(represent(pose), represent(other)) > mp.mpf(1) / 1000)


def _translated(represent: Callable[[Array], Array], pose: Array) -> Number:
    return distance(represent(homogeneous(mp, pose[:3, :3], pose[:3, 3] + 3)), represent(pose))


def _glued(interpolate: Callable[..., Array], bend: Array) -> int:
    """1 if two tetrahedra with a face in common still have it in common half way."""
    top = exactly([[0, 0, -1]])
    lower = array([*CANONICAL[[0, 2, 1]].tolist(), *top.tolist()])
    goal = array([*moved(bend, CANONICAL)[:3].tolist(), [mp.zero, mp.zero, mp.mpf(2)]])
    lower_goal = array([*goal[[0, 2, 1]].tolist(), *(top - 1).tolist()])
    one, other = interpolate(CANONICAL, goal), interpolate(lower, lower_goal)
    return int(difference(one[:3], other[[0, 2, 1]]) < mp.mpf(1) / 1000)


def _by_lie(source: Array, target: Array) -> Array:
    return affine_lie.interpolate_tetrahedra(mp, source, target, at(HALF))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.2.closed_form",
        place="sections 2 and 4",
        statement="There is no closed form of the exponential of affine maps of space.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_closed(),
        cases=_tangents,
        deviation=lambda closed, tangent: int(_off_exponential(closed, tangent) < HOLDS),
        correction=Correction(
            statement="there is one by the roots of a cubic, with cases where eigenvalues coincide; section 2 ascribes "
            "one to Rossignac and Vinacua",
            form=_closed(),
            deviation=_off_exponential,
        ),
        copies=(Copy("the eigenvalue -1 for 0", _closed(-1)),),
    ),
    Claim(
        id="bansal_tatu.2.alexa_2002_translation",
        place="section 2",
        statement="Alexa (2002) handles the translation apart from the linear part.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=morphs.alexa_2002,
        cases=_with_logarithms,
        deviation=_straight,
        correction=Correction(
            statement="Shoemake (1992) and Sumner and others (2005) do; his logarithms are of homogeneous matrices",
            form=morphs.sumner_2005,
        ),
        copies=(Copy("the steady affine morph", morphs.MORPHS["sam"]),),
        remark="From I his morph is T^t, that is SAM. Of homogeneous matrices: so Rossignac and Vinacua, 3.3.2.",
    ),
    Claim(
        id="bansal_tatu.2.alexa_2002_series",
        place="section 2",
        statement="Alexa's exponential and logarithm are computed by Taylor series.",
        verdict=Verdict.UNCHECKABLE,
        reason="His paper is not at hand. Rossignac and Vinacua tell of square roots first, then a series.",
    ),
    Claim(
        id="bansal_tatu.2.lie_bodies",
        place="section 2, on Lie Bodies",
        statement="A representation of triangles serves for some affine maps of space only: maps that agree on the "
        "triangle are the same to it.",
        verdict=Verdict.CONFIRMED,
        form=_by_triangle,
        cases=maps,
        deviation=_told_apart,
        copies=(Copy("the tetrahedron", _by_tetrahedron),),
        remark="A triangle up to translations has 6 parameters, a linear map 9.",
    ),
    Claim(
        id="bansal_tatu.2.lie_bodies_translation",
        place="section 2, on Lie Bodies",
        statement="Lie Bodies ignore translations: they represent the edges of a triangle.",
        verdict=Verdict.CONFIRMED,
        form=_by_triangle,
        cases=maps,
        deviation=_translated,
        copies=(Copy("the affine map", lambda pose: pose),),
    ),
    Claim(
        id="bansal_tatu.7.meshes",
        place="section 7",
        statement="Applied to each tetrahedron by itself, the method does not in general yield a valid mesh: common "
        "faces come apart.",
        verdict=Verdict.CONFIRMED,
        form=_by_lie,
        cases=lambda: [affine([[1, 1, 0], [0, 1, 0], [0, 0, 1]]), affine([[2, 0, 0], [0, 1, 0], [1, 0, 1]])],
        deviation=_glued,
        copies=(Copy("vertices in straight lines", lambda source, target: (source + target) / 2),),
    ),
)
