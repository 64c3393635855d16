"""Appendix A.6: fixed points of affine maps of space, and what is left of the translation where 1 is an eigenvalue."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.definitions import determinant, inverse
from affinecert.properties.claims.draws import affine, arrays, numbers
from affinecert.properties.claims.precision import equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.poses import affines, power
from affinecert.properties.claims.rossignac_vinacua.space import null, turned
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, identity


def _fixed(sign: int = -1) -> Any:
    """The solution of (L - 1)(oq) = sign ot."""

    def point(m: Context, matrix: Array) -> Array:
        found: Array = inverse(m, matrix[:3, :3] - identity(m, 3)) @ (sign * matrix[:3, 3])
        return found

    return point


def _without_one() -> list[tuple[Array]]:
    return [(affine([[2, 0, 0], [0, 2, 0], [0, 0, 2]], [1, 0, 0]),), *((each,) for each in affines("21", 5, 3))]


def _translation_there(form: Any, case: tuple[Array]) -> Number:
    """The translation of A in coordinates with the origin at the point, relative to the point."""
    (matrix,) = case
    point = form(mp, matrix)
    return size(matrix[:3, :3] @ point + matrix[:3, 3] - point) / size(point)


_Kernel = tuple[Array, Array]
"""L and a basis of Ker(L - 1), in columns."""


def _kernels() -> list[_Kernel]:
    blocks = [[1, 0, 0], [0, 2, 0], [0, 0, 3]], [[1, 0, 0], [0, 0, -1], [0, 1, 0]], [[1, 0, 0], [0, 2, 1], [0, 0, 2]]
    pairs = []
    for k, block in enumerate(blocks):
        linear = turned(block, "basis"[: k + 1])
        pairs.append((linear, null(linear - identity(mp, 3))[:, None]))
    double = exactly([[1, 0, 2], [0, 1, 1], [0, 0, 3]])
    return [*pairs, (double, exactly([[1, 0], [0, 1], [0, 0]]))]


def _sheared() -> list[_Kernel]:
    one, both = exactly([[1], [0], [0]]), exactly([[1, 0], [0, 0], [0, 1]])
    pairs = [([[1, 1, 0], [0, 1, 0], [0, 0, 2]], one), ([[1, 1, 0], [0, 1, 0], [0, 0, 1]], both)]
    return [(exactly(rows), kernel) for rows, kernel in (*pairs, ([[1, 1, 0], [0, 1, 1], [0, 0, 1]], one))]


def _image(linear: Array, kernel: Array) -> Array:
    """Columns of L - 1 that complete the kernel, or if none do, the first ones."""
    moving = linear - identity(mp, 3)
    choices = [moving[:, list(some)] for some in itertools.combinations(range(3), 3 - kernel.shape[1])]
    best: Array = max(choices, key=lambda some: abs(determinant(np.concatenate([kernel, some], axis=1))))
    return best


def _orthogonal_complement(_: Array, kernel: Array) -> Array:
    if kernel.shape[1] == 2:
        return cross(kernel[:, 0], kernel[:, 1])[:, None]
    first = null(array([kernel[:, 0].tolist()] * 3))
    return np.stack([first, cross(kernel[:, 0], first)], axis=1)


def _not_decomposed(form: Any, case: _Kernel) -> Number:
    """The part in N of (L - 1)(N^C), relative; a division by zero where N and N^C do not make up space."""
    linear, kernel = case
    rest = form(linear, kernel)
    moved = (linear - identity(mp, 3)) @ rest
    inside = inverse(mp, np.concatenate([kernel, rest], axis=1)) @ moved
    return size(inside[: kernel.shape[1]]) / size(inside)


def _beside(linear: Array, kernel: Array) -> Array:
    """The image of L - 1, or where it meets the kernel the span of the other, generalised, eigenvectors."""
    image = _image(linear, kernel)
    whole = determinant(np.concatenate([kernel, image], axis=1))
    return image if whole else _orthogonal_complement(linear, kernel)


def _unsolvable(form: Any, case: _Kernel) -> Number:
    """For a translation in N^C, v_N = 0: the part of it that no (L - 1) q reaches, relative."""
    linear, kernel = case
    rest = form(linear, kernel)
    moved, transposed = rest.sum(axis=1), (linear - identity(mp, 3)).T
    normals = [null(transposed)]
    if kernel.shape[1] == 2:
        normals.append(cross(max(transposed, key=size), normals[0]))
    return max(abs(normal @ moved) / (size(normal) * size(moved)) for normal in normals)


def _with_constant(part: int = 1) -> Any:
    """A'^t and the translation t v_N, A' = A - v_N; the whole translation of A for v_N if ``part`` is 0."""

    def printed(m: Context, matrix: Array, in_kernel: Array, t: Number) -> Array:
        constant = in_kernel if part else matrix[:3, 3]
        rest = homogeneous(m, matrix[:3, :3], matrix[:3, 3] - constant)
        moved = power(m, rest, t)
        return homogeneous(m, moved[:3, :3], moved[:3, 3] + t * constant)

    return printed


def _true_power(m: Context, matrix: Array, _: Array, t: Number) -> Array:
    return power(m, matrix, t)


def _with_kernel_parts() -> list[tuple[Array, Array, Number]]:
    cases = []
    pairs = [*_kernels(), *_sheared()]
    moves = arrays("constant", len(pairs), (3,), -2, 2)
    for (linear, kernel), moved, factor in zip(pairs, moves, numbers("in", len(pairs), 1, 3), strict=True):
        cases.append((homogeneous(mp, linear, moved), factor * kernel[:, 0], factor / 4))
    return cases


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.6.equation_21",
        place="equation 21",
        statement="If 1 is no eigenvalue, (L - 1)(oq) = -ot gives the fixed point q; with the origin there A has no "
        "translation.",
        printed="(L - 1)(oq) = -ot",
        verdict=Verdict.CONFIRMED,
        form=_fixed(),
        cases=lambda: [
            (each,) for each in (affine([[2, 0, 0], [0, 2, 0], [0, 0, 2]], [1, 0, 0]), *affines("21", 5, 3))
        ],
        deviation=_translation_there,
        copies=(Copy("ot for -ot, as in appendix A.4", _fixed(1)),),
    ),
    Claim(
        id="rossignac_vinacua.A.6.kernel_and_co_kernel",
        place="appendix A.6",
        statement="Space decomposes into the kernel N of L - 1 and a co-kernel N^C with (L - 1)(N^C) in N^C.",
        printed="(L - 1)(N^C) ⊆ N^C, v = v_N + v_(N^C)",
        verdict=Verdict.BOUND,
        domain="1 has as many independent eigenvectors as its multiplicity: L is no shear",
        form=_image,
        cases=_kernels,
        outside=_sheared,
        deviation=_not_decomposed,
        copies=(Copy("the orthogonal complement of N", _orthogonal_complement),),
        remark="N^C is the image of L - 1; of a shear it meets N.",
    ),
    Claim(
        id="rossignac_vinacua.A.6.solvable",
        place="appendix A.6",
        statement="If the part v_N of the translation is 0, equation 21 has a solution, though 1 is an eigenvalue.",
        printed="If v_N = (0, 0, 0), then the linear system (21) can still be solved",
        verdict=Verdict.BOUND,
        domain="1 has as many independent eigenvectors as its multiplicity; a shear has no fixed point for v = v_(N^C) "
        "along a generalised eigenvector",
        form=_beside,
        cases=_kernels,
        outside=_sheared,
        deviation=_unsolvable,
        copies=(Copy("the orthogonal complement of N for N^C", _orthogonal_complement),),
    ),
    Claim(
        id="rossignac_vinacua.A.6.constant_part",
        place="appendix A.6",
        statement="For v_N in the kernel of L - 1, A^t is A'^t, A'(p) = A(p) - v_N, and a translation of constant "
        "velocity v_N.",
        printed="A'(p) = A(p) - v_N",
        verdict=Verdict.CONFIRMED,
        form=_with_constant(),
        cases=_with_kernel_parts,
        deviation=equals(_true_power),
        copies=(Copy("the whole translation for v_N", _with_constant(0)),),
        remark="True of shears as well; but then A' may have no fixed point, and is not solved as the general case.",
    ),
)
