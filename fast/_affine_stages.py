"""The stages of the affine maps as elements of SE(3) x G_A x G_S: compiled kernels that hand double-doubles over.

Everything is in terms of the upper triangular U = s A and the rigid E = [R d]; the scale never stands alone, for it
commutes with A.
"""

from __future__ import annotations

import numpy as np

from affinecert.fast._alignment import differences, edges_aligned, rows_aligned
from affinecert.fast._double_double import add, divide, exact_product, multiply_add, subtract, times
from affinecert.fast._growth import VALUES, values, write
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._numbers import (
    Numbers,
    dot,
    image,
    inverse_image,
    numbers,
    store,
    store_vector,
    vector,
)
from affinecert.fast._rotation import NOT_ORTHOGONAL, ORTHOGONALITY, REFLECTION, defect, determinant, entries
from affinecert.fast._triangular import closest, growth, pair_of, quotient
from affinecert.fast._triangular import power as triangular_power
from affinecert.fast._turn import carried, quaternion, turned

MATRIX, VECTOR = (3, 3, 2), (3, 2)
LAST_ROW = "the last row is not 0 0 0 1"


@compiled
def has_last_row(affine: Array) -> bool:
    """Whether the last row is 0 0 0 1."""
    return bool(affine[3, 0] == 0.0 and affine[3, 1] == 0.0 and affine[3, 2] == 0.0 and affine[3, 3] == 1.0)


@compiled
def _linear(affine: Array) -> Numbers:
    matrix = np.empty((3, 3), dtype=np.complex128)
    for i in range(len(matrix)):
        for j in range(len(matrix)):
            matrix[i, j] = complex(affine[i, j], 0.0)
    return matrix


@kernel(
    inputs={"affine": (4, 4)},
    outputs=(MATRIX, MATRIX, VECTOR, ()),
    refusals=(("affine", LAST_ROW),),
)
def factors(affine: Array, rotation: Array, upper: Array, displacement: Array, sign: Array, status: Array) -> None:
    """The R, s A and d of T = A S [R d], and the sign of the determinant, 0 if not sure."""
    if not has_last_row(affine):
        status[0] = 1
    r, u = np.empty((3, 3), dtype=np.complex128), np.empty((3, 3), dtype=np.complex128)
    sign[0] = rows_aligned(_linear(affine), r, u)
    x = np.zeros(3, dtype=np.complex128)
    for i in range(2, -1, -1):
        x[i] = divide(subtract(complex(affine[i, 3], 0.0), dot(u[i], x)), u[i, i])
    store(r, rotation)
    store(u, upper)
    store_vector(x, displacement)


@kernel(inputs={"vertices": ("m", 3)}, outputs=(MATRIX, MATRIX, VECTOR, ()))
def frame(vertices: Array, rotation: Array, upper: Array, displacement: Array, sign: Array, _status: Array) -> None:
    """The alignment of a tetrahedron (m = 4) or triangle (m = 3): R, the aligned edges U, and -R u_0.

    The sign is that of the volume, 0 if not sure; of a triangle 1, or 0 if it may have no area.
    """
    r, u = np.empty((3, 3), dtype=np.complex128), np.empty((3, 3), dtype=np.complex128)
    sign[0] = edges_aligned(differences(vertices), r, u)
    origin = np.empty(3, dtype=np.complex128)
    for j in range(len(origin)):
        origin[j] = complex(-vertices[0, j], 0.0)
    store(r, rotation)
    store(u, upper)
    store_vector(image(r, origin), displacement)


@kernel(inputs={"upper": MATRIX, "by": MATRIX}, outputs=(MATRIX,))
def divided(upper: Array, by: Array, ratio: Array, _status: Array) -> None:
    """The quotient U P^-1."""
    store(quotient(numbers(upper), numbers(by)), ratio)


@kernel(inputs={"upper": MATRIX}, outputs=((3, 3), ()))
def split(upper: Array, shear: Array, scale: Array, _status: Array) -> None:
    """The shear A and the scale s of U = s A."""
    u = numbers(upper)
    scale[0] = u[0, 0].real
    for i in range(len(u)):
        for j in range(len(u)):
            shear[i, j] = divide(u[i, j], u[0, 0]).real if i <= j else 0.0
    shear[0, 0] = 1.0


@kernel(
    inputs={"rotation": MATRIX, "origin": (3,), "goal": MATRIX, "goal_origin": (3,)},
    outputs=(MATRIX, VECTOR),
)
def relative(
    rotation: Array, origin: Array, goal: Array, goal_origin: Array, turn: Array, shift: Array, _status: Array
) -> None:
    """The rigid motion E_p^-1 E_q = [W, u - W w] of two alignments E_p = [R, -R u] and E_q = [Q, -Q w]: W = R^T Q."""
    r, q = numbers(rotation), numbers(goal)
    w = np.zeros((3, 3), dtype=np.complex128)
    for i in range(len(w)):
        total = complex(origin[i], 0.0)
        for j in range(len(w)):
            for k in range(len(w)):
                w[i, j] = multiply_add(r[k, i], q[k, j], w[i, j])
            total = subtract(total, times(w[i, j], goal_origin[j]))
        shift[i, 0], shift[i, 1] = total.real, total.imag
    store(w, turn)


@kernel(inputs={"upper": MATRIX, "rotation": MATRIX}, outputs=((2, *VALUES), (2,), VALUES))
def nodes(upper: Array, rotation: Array, both: Array, exponents: Array, turn: Array, _status: Array) -> None:
    """Two sets of nodes for the powers of U and of R, with their exponents, and the quaternion of R.

    The first set is that of `affinecert.fast._triangular.pair_of`. The second is the quaternion, as a pair, and with it
    the entry that the first may leave out.
    """
    u = numbers(upper)
    pair, exponent = pair_of(u)
    scalar, axis = quaternion(numbers(rotation))
    square = dot(axis, axis)
    j = closest(u)[1]
    write(pair, both[0])
    write((scalar, -square, multiply_add(scalar, scalar, square), u[j, j]), both[1])
    exponents[0], exponents[1] = exponent, 0.0
    write((scalar, axis[0], axis[1], axis[2]), turn)


@kernel(
    inputs={
        "upper": MATRIX,
        "turn": VALUES,
        "displacement": VECTOR,
        "t": (),
        "log": (2, *VALUES),
        "power": (2, *VALUES),
        "ratio": (2, *VALUES),
    },
    outputs=(MATRIX, MATRIX, VECTOR),
)
def grown(
    upper: Array,
    turn: Array,
    displacement: Array,
    t: float,
    log: Array,
    power: Array,
    ratio: Array,
    upper_power: Array,
    rotation_power: Array,
    displacement_power: Array,
    _status: Array,
) -> None:
    """The powers U^t, and R^t and d_t of [R d]^t, from the functions log x, x^t, (x^t - 1) / (x - 1) on `nodes`."""
    u = numbers(upper)
    j = closest(u)[1]
    x, p, r = values(log[1]), values(power[1]), values(ratio[1])
    single = growth(u[j, j], x[2], p[2], r[2], t)
    store(triangular_power(u, t, (values(log[0]), values(power[0]), values(ratio[0])), single), upper_power)
    scalar, first, second, third = values(turn)
    axis = np.empty(3, dtype=np.complex128)
    axis[0], axis[1], axis[2] = first, second, third
    matrix = np.empty((3, 3), dtype=np.complex128)
    turned(p[0], p[1], axis, matrix)
    store(matrix, rotation_power)
    store_vector(carried(t, scalar, axis, p[0], p[1], vector(displacement)), displacement_power)


@kernel(
    inputs={"affine": (4, 4), "t": (), "upper": MATRIX, "rotation": MATRIX, "displacement": VECTOR},
    outputs=((4, 4),),
)
def assembled(
    affine: Array, t: float, upper: Array, rotation: Array, displacement: Array, pose: Array, _status: Array
) -> None:
    """The affine map U [R d], for powers U and [R d]: exactly I at t = 0, and the affine map given at t = 1."""
    u, r, d = numbers(upper), numbers(rotation), vector(displacement)
    for i in range(4):
        for j in range(4):
            pose[i, j] = 1.0 if i == j else 0.0
            if t == 1.0:
                pose[i, j] = affine[i, j]
            elif t != 0.0 and i < 3:
                total = 0j
                for k in range(i, 3):
                    total = multiply_add(u[i, k], r[k, j] if j < 3 else d[k], total)
                pose[i, j] = total.real


@kernel(
    inputs={
        "source": ("m", 3),
        "target": ("m", 3),
        "t": (),
        "edges": MATRIX,
        "rotation": MATRIX,
        "upper": MATRIX,
        "turn": MATRIX,
        "shift": VECTOR,
    },
    outputs=(("m", 3),),
)
def carried_vertices(
    source: Array,
    target: Array,
    t: float,
    edges: Array,
    rotation: Array,
    upper: Array,
    turn: Array,
    shift: Array,
    vertices: Array,
    _status: Array,
) -> None:
    """The vertices W^-1 (R^-1 U e_i + u - v), e_i the aligned edges of the source, for powers U and [W v].

    Exactly the source at t = 0, and the target at t = 1.
    """
    e, r, u, w, v = numbers(edges), numbers(rotation), numbers(upper), numbers(turn), vector(shift)
    for n in range(len(source)):
        edge = np.zeros(3, dtype=np.complex128)
        if n > 0:
            for j in range(3):
                edge[j] = e[j, n - 1]
            edge = inverse_image(r, image(u, edge))
        for j in range(3):
            edge[j] = subtract(add(complex(source[0, j], 0.0), edge[j]), v[j])
        edge = inverse_image(w, edge)
        for j in range(3):
            vertices[n, j] = edge[j].real
            if t in (0.0, 1.0):
                vertices[n, j] = source[n, j] if t == 0.0 else target[n, j]


@kernel(
    inputs={"rigid": (4, 4), "shear": (3, 3), "scale": ()},
    outputs=((4, 4),),
    refusals=(
        ("rigid", LAST_ROW),
        ("rigid", NOT_ORTHOGONAL),
        ("rigid", REFLECTION),
        ("shear", "not a shear: the first column is not 1 0 0, or an entry below the diagonal is not 0"),
        ("shear", "the diagonal is not positive"),
        ("scale", "not positive"),
    ),
)
def composed(rigid: Array, shear: Array, scale: float, affine: Array, status: Array) -> None:
    """The affine map A S E."""
    rotation = entries(rigid)
    if not has_last_row(rigid):
        status[0] = 1
    elif defect(rotation)[1] > ORTHOGONALITY**2:
        status[0] = 2
    elif determinant(rotation) < 0.0:
        status[0] = 3
    elif shear[0, 0] != 1.0 or shear[1, 0] != 0.0 or shear[2, 0] != 0.0 or shear[2, 1] != 0.0:
        status[0] = 4
    elif not (shear[1, 1] > 0.0 and shear[2, 2] > 0.0):
        status[0] = 5
    elif not scale > 0.0:
        status[0] = 6
    for i in range(4):
        for j in range(4):
            total = complex(rigid[i, j], 0.0)
            if i < 3:
                total = 0j
                for k in range(i, 3):
                    total = add(total, times(exact_product(shear[i, k], rigid[k, j]), scale))
            affine[i, j] = total.real
