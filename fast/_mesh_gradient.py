"""The gradient of the errors of a moved mesh of the plane, in double-double: what refines a solution.

The plane is that of complex numbers. A triangle of the source with edges e = p_2 - p_1 and g = p_3 - p_1, D = Im(e* g)
twice its signed area, goes to edges x = v_2 - v_1 and y = v_3 - v_1 by z -> alpha z + beta z* with

    2 i D alpha = -(x g* - y e*) = -alpha',    2 i D beta = x g - y e = beta'.

All is told by alpha' and beta', which are linear in v, and a', b', their like for the homotopy A(t), z -> a z + b z*:

    |A - B|_F^2 = (|alpha' - a'|^2 + |beta' - b'|^2) / (2 D^2).

Over complex factors s R_delta the vector (a', b') comes to within |a' beta' - b' alpha'| / |(a', b')| of
(alpha', beta'), for their determinant is the area that they span. So

    min |s R_delta A - B|_F^2 = |a' beta' - b' alpha'|^2 / (2 D^2 (|a'|^2 + |b'|^2)).

In the same way for the corners, seen from their centroid: with the Gram determinant of (p_k) and (p_k*), 16/3 of the
squared area, and sum |A p_k|^2, a third of the sum of the squared edges of the image,

    min sum_k |s R_delta A p_k + d - v_k|^2 = |a' beta' - b' alpha'|^2 / sum over edges |a' e - b' e*|^2.
"""

from __future__ import annotations

from affinecert.fast._complex import (
    Complex,
    accumulate,
    add,
    conjugate,
    difference,
    multiple,
    multiply,
    number,
    squared,
    subtract,
)
from affinecert.fast._double_double import add as real_add
from affinecert.fast._double_double import divide, scaled
from affinecert.fast._double_double import multiply as real_multiply
from affinecert.fast._kernel import Array, compiled, kernel

POINTS = (2, 2)
"""The shape of a point of the plane as pairs."""


@compiled
def _image(a: Complex, b: Complex, edge: Complex) -> complex:
    """The squared length of a' e - b' e*."""
    return squared(subtract(multiply(a, edge), multiply(b, conjugate(edge))))


@kernel(
    inputs={
        "source": ("vertices", 2),
        "triangles": ("faces", 3),
        "a": ("faces", *POINTS),
        "b": ("faces", *POINTS),
        "weights": ("faces", 2, 2),
        "by_points": (),
        "moved": ("vertices", *POINTS),
    },
    outputs=(("vertices", *POINTS),),
)
def gradient(
    source: Array,
    triangles: Array,
    a: Array,
    b: Array,
    weights: Array,
    by_points: float,
    moved: Array,
    slope: Array,
    _status: Array,
) -> None:
    """Half the gradient, downwards, of the sum over triangles of w E^F + w' E with respect to the vertices ``moved``.

    ``weights`` holds the pairs w and w' of each triangle; E is E^S if ``by_points`` is 1, else E^R.
    """
    slope[:] = 0.0
    for face in range(len(triangles)):
        i, j, k = int(triangles[face, 0]), int(triangles[face, 1]), int(triangles[face, 2])
        e, g = difference(source[j], source[i]), difference(source[k], source[i])
        twice_area = multiply(conjugate(e), g)[1]
        square = scaled(real_multiply(twice_area, twice_area), 2.0)
        origin = number(moved[i])
        x, y = subtract(number(moved[j]), origin), subtract(number(moved[k]), origin)
        alpha = subtract(multiply(x, conjugate(g)), multiply(y, conjugate(e)))
        beta = subtract(multiply(x, g), multiply(y, e))
        # a' = -2 i D a and b' = 2 i D b.
        doubled = scaled(twice_area, 2.0)
        real, imaginary = multiple(number(a[face]), doubled)
        goal = imaginary, -real
        real, imaginary = multiple(number(b[face]), doubled)
        conjugate_goal = -imaginary, real
        down, conjugate_down = (0j, 0j), (0j, 0j)
        if weights[face, 0, 0] != 0.0:
            factor = divide(complex(weights[face, 0, 0], weights[face, 0, 1]), square)
            down = multiple(subtract(goal, alpha), factor)
            conjugate_down = multiple(subtract(conjugate_goal, beta), factor)
        if weights[face, 1, 0] != 0.0:
            if by_points == 1.0:
                size = real_add(
                    real_add(_image(goal, conjugate_goal, e), _image(goal, conjugate_goal, g)),
                    _image(goal, conjugate_goal, subtract(g, e)),
                )
            else:
                size = real_multiply(square, real_add(squared(goal), squared(conjugate_goal)))
            factor = divide(complex(weights[face, 1, 0], weights[face, 1, 1]), size)
            spanned = multiple(subtract(multiply(goal, beta), multiply(conjugate_goal, alpha)), factor)
            down = add(down, multiply(conjugate(conjugate_goal), spanned))
            conjugate_down = subtract(conjugate_down, multiply(conjugate(goal), spanned))
        # alpha' and beta' have the derivatives g* and g in x, -e* and -e in y.
        at_second = add(multiply(g, down), multiply(conjugate(g), conjugate_down))
        at_third = add(multiply(e, down), multiply(conjugate(e), conjugate_down))
        accumulate(at_second, slope[j])
        accumulate((-at_third[0], -at_third[1]), slope[k])
        accumulate(subtract(at_third, at_second), slope[i])
