"""The gradient of the errors of a moved mesh of space, in double-double: what refines a solution."""

from __future__ import annotations

from affinecert.fast._double_double import add, multiply, subtract
from affinecert.fast._kernel import Array, compiled, kernel


@compiled
def _number(pair: Array) -> complex:
    return complex(pair[0], pair[1])


@compiled
def _accumulate(x: complex, pair: Array) -> None:
    total = add(_number(pair), x)
    pair[0], pair[1] = total.real, total.imag


@kernel(
    inputs={
        "triangles": ("faces", 3),
        "metric": ("faces", 3, 2),
        "goals": ("faces", 2, 3, 2),
        "moved": ("vertices", 3, 2),
    },
    outputs=(("vertices", 3, 2),),
)
def surface_gradient(triangles: Array, metric: Array, goals: Array, moved: Array, slope: Array, _status: Array) -> None:
    """Half the gradient, downwards, of the sum over triangles of g x.x + 2 g' x.y + g'' y.y at the vertices ``moved``.

    x and y are what the edges from the first vertex to the second and the third lack of their goals, and ``metric``
    holds the pairs g, g' and g'' of each triangle.
    """
    slope[:] = 0.0
    for face in range(len(triangles)):
        i, j, k = int(triangles[face, 0]), int(triangles[face, 1]), int(triangles[face, 2])
        first, mixed, last = _number(metric[face, 0]), _number(metric[face, 1]), _number(metric[face, 2])
        for axis in range(3):
            origin = _number(moved[i, axis])
            x = subtract(_number(goals[face, 0, axis]), subtract(_number(moved[j, axis]), origin))
            y = subtract(_number(goals[face, 1, axis]), subtract(_number(moved[k, axis]), origin))
            at_second = add(multiply(first, x), multiply(mixed, y))
            at_third = add(multiply(mixed, x), multiply(last, y))
            _accumulate(at_second, slope[j, axis])
            _accumulate(at_third, slope[k, axis])
            _accumulate(-add(at_second, at_third), slope[i, axis])
