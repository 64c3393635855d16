"""Sections 3.2 and 3.3.2: logarithms and roots by series and iterations, as others compute them."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.linalg

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity, norm


def _log(linear: Array) -> Array:
    """The principal logarithm of a linear part."""
    found: Array = sam.log(mp, homogeneous(mp, linear, linear[0] * 0))[:-1, :-1]
    return found


def _back_from_basis(basis: Array, log: Array) -> Array:
    found: Array = basis @ log @ definitions.inverse(mp, basis)
    return found


def _not_commuting(form: Any, case: tuple[Array, Array]) -> Number:
    """How far the logarithm in a basis, taken back, is from that of the matrix; and how far exp is from undoing it."""
    basis, triangular = case
    matrix = basis @ triangular @ definitions.inverse(mp, basis)
    found = form(basis, _log(triangular))
    return max(distance(found, _log(matrix)), distance(definitions.exponential(mp, found), matrix))


def _triangular() -> list[tuple[Array, Array]]:
    uppers = [exactly(each) for each in ([[1, 1], [0, 1]], [[2, 1], [0, 3]])]
    bases = [exactly(each) for each in ([[0, -1], [1, 0]], [[1, 2], [1, 1]])]
    return list(zip(bases, uppers, strict=True))


def _schur_basis(matrix: Array) -> Array:
    """The unitary basis in which [[a, b], [c, d]] is upper triangular: an eigenvector, and the one across."""
    vector = _eigenvectors(matrix)[:, 0]
    x, y = vector / norm(mp, vector)
    return array([[x, -y], [y, x]])


def _eigenvectors(matrix: Array) -> Array:
    """The basis of Jordan's form of a matrix of the plane with two real eigenvalues and b != 0."""
    (a, b), (_, d) = matrix
    root = mp.sqrt((a + d) ** 2 / 4 - definitions.determinant(matrix))
    return array([[b, b], [(a + d) / 2 + root - a, (a + d) / 2 - root - a]])


def _magnification(form: Any, matrix: Array) -> Number:
    """By how much more than 1 errors can grow in a change of basis and back, of a basis that triangulates."""
    basis = form(matrix)
    back = definitions.inverse(mp, basis)
    below = (back @ matrix @ basis)[1, 0]
    lengths = [mp.sqrt(max(definitions.eigenvalues(mp, each.T @ each), key=mp.re).real) for each in (basis, back)]
    return max(abs(below), abs(lengths[0] * lengths[1] - 1))


def _nearly_defective() -> list[Array]:
    return [exactly([[3, 1], [1, 2]]), *(exactly([[1, 1], [gap, 1]]) for gap in (0.25, 2.0**-20, 2.0**-60))]


def _real_logarithm(off: Number) -> Array:
    return array([[mp.log(2), -off], [off, mp.log(2)]])


def _unlike_exponent(form: Array, matrix: Array) -> Number:
    return distance(definitions.exponential(mp, form), matrix)


def _real_in_vain(form: Any, matrix: Any) -> Number:
    """Whether a logarithm comes out real, or is none."""
    found = np.asarray(form(np.array(matrix)))
    wrong = np.abs(scipy.linalg.expm(found) - np.array(matrix)).max() > 1e-12
    return mp.mpf(bool(wrong or np.abs(found.imag).max() < 1e-12))


def _real_branch(matrix: Any) -> Any:
    return sam.log(mp, homogeneous(mp, exactly(matrix.tolist()), exactly([0, 0])))[:2, :2].astype(float)


def _series(matrix: Array, terms: int = 1100) -> Array:
    """The sum of -(I - L)^k / k. At 7/8 of the radius of convergence so many terms leave 1e-64."""
    unlike = identity(mp, len(matrix)) - matrix
    total, power = 0 * unlike, identity(mp, len(matrix))
    for k in range(1, terms):
        power = power @ unlike
        total = total - power / k
    found: Array = total
    return found


def _alternating(matrix: Array) -> Array:
    """The sum of (L - I)^k / k."""
    return -_series(2 * identity(mp, len(matrix)) - matrix)


def _unlike_logarithm(form: Any, matrix: Array) -> Number:
    return distance(form(matrix), _log(matrix))


def _within() -> list[Array]:
    """Matrices with |x - 1| <= 7/8 for all eigenvalues x; the second is far from the identity."""
    matrices = [[1.5, 0], [0, 0.5]], [[1, 100], [0, 1]], [[1.5, -0.5], [0.5, 1.5]], [[0.125, 3], [0, 1.875]]
    return [exactly(each) for each in matrices]


def _beyond() -> list[Array]:
    """Matrices with an eigenvalue that is further than 1 from 1."""
    return [exactly(each) for each in ([[2.0625, 0], [0, 1]], [[1, -1.0625], [1.0625, 1]], [[0, -1], [1, 0]])]


def _by_roots(_: Context, affinity: Array, halvings: int = 6, factor: int = 2) -> Array:
    """Log A = 2^k log A^(1/2^k), the root by the iteration of Denman and Beavers, the logarithm by its series."""
    for _ in range(halvings):
        affinity = _denman_beavers(affinity, steps=12)
    found: Array = _series(affinity, 140) * factor**halvings
    return found


def _root_cases() -> list[tuple[Array]]:
    found = [
        homogeneous(mp, each[:, :2] + 2 * identity(mp, 2), each[:, 2]) for each in arrays("roots", 3, (2, 3), -1, 1)
    ]
    return [(homogeneous(mp, exactly([[0, -1], [1, 0]]), exactly([6, 0])),), *((each,) for each in found)]


def _denman_beavers(matrix: Any, steps: int) -> Any:
    """X <- (X + Y^-1) / 2, Y <- (Y + X^-1) / 2 from X = A, Y = I."""
    inverse = _inverse_of(matrix)
    x, y = matrix, 0 * matrix + np.eye(len(matrix))
    for _ in range(steps):
        x, y = (x + inverse(y)) / 2, (y + inverse(x)) / 2
    return x


def _newton(matrix: Any, steps: int) -> Any:
    """X <- (X + X^-1 A) / 2 from X = A."""
    inverse = _inverse_of(matrix)
    x = matrix
    for _ in range(steps):
        x = (x + inverse(x) @ matrix) / 2
    return x


def _inverse_of(matrix: Any) -> Any:
    return np.linalg.inv if matrix.dtype == np.float64 else lambda x: definitions.inverse(mp, x)


def _stable(form: Any, case: tuple[Any, Any]) -> Number:
    """Whether, in float64, the error of a square root once found stays where it is."""
    basis, eigenvalues = (np.array(each, dtype=np.float64) for each in case)
    back = np.linalg.inv(basis)
    matrix, root = basis @ np.diag(eigenvalues) @ back, basis @ np.diag(np.sqrt(eigenvalues)) @ back
    return mp.mpf(bool(np.abs(form(matrix, 20) - root).max() < 1e-9 * np.abs(root).max()))


def _spread() -> list[tuple[Any, Any]]:
    """Matrices of condition 1e3 and more, in bases of whole numbers."""
    plane = [[1, 1], [0, 1]], [[2, 1], [1, 1]]
    return [(plane[0], [1, 1000]), (plane[1], [1, 4000]), ([[2, 1, 0], [1, 1, 0], [0, 1, 1]], [1, 30, 2000])]


def _arrives(form: Any, matrix: Array) -> Number:
    """Whether an iteration in real numbers comes to a square root."""
    with mp.workdps(30):
        try:
            found = form(matrix, 40)
        except ZeroDivisionError:
            return mp.zero
        return mp.mpf(size(found @ found - matrix) < 1e-12)


def _turned_root(matrix: Array, _: int) -> Array:
    """The real root of -s I that turns by a right angle."""
    found: Array = mp.sqrt(-matrix[0, 0]) * exactly([[0, -1], [1, 0]])
    return found


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.2.change_of_basis",
        place="section 3.2",
        statement="A change of basis commutes with the logarithm and with the exponential.",
        verdict=Verdict.CONFIRMED,
        form=_back_from_basis,
        cases=_triangular,
        deviation=_not_commuting,
        copies=(Copy("the transposed for the inverse, of any basis", lambda basis, log: basis @ log @ basis.T),),
        remark="Schur's basis is orthogonal, so that its transposed does; for complex eigenvalues it is complex, and "
        "a real one leaves blocks of two.",
    ),
    Claim(
        id="rossignac_vinacua.3.2.schur_stable",
        place="section 3.2",
        statement="Schur's decomposition is more stable than Jordan's normal form: its basis magnifies no errors.",
        verdict=Verdict.CONFIRMED,
        form=_schur_basis,
        cases=_nearly_defective,
        deviation=_magnification,
        copies=(Copy("the eigenvectors, as for Jordan's form", _eigenvectors),),
    ),
    Claim(
        id="rossignac_vinacua.3.2.minus_two",
        place="section 3.2",
        statement="diag(-2, -2), which has a double negative eigenvalue, has a real logarithm.",
        printed="[ log(2) 0; 0 log(2) ] (the entries off the diagonal are lost)",
        verdict=Verdict.REFUTED,
        fault=Fault.SCAN,
        form=_real_logarithm(mp.zero),
        cases=lambda: [exactly([[-2, 0], [0, -2]])],
        deviation=_unlike_exponent,
        correction=Correction(
            statement="[ log(2) -π; π log(2) ] is one, its transposed another.",
            form=_real_logarithm(+mp.pi),
        ),
        copies=(Copy("π/2 for π", _real_logarithm(mp.pi / 2)),),
    ),
    Claim(
        id="rossignac_vinacua.3.2.logm",
        place="section 3.2",
        statement="logm returns a complex solution for diag(-2, -2).",
        verdict=Verdict.CONFIRMED,
        form=scipy.linalg.logm,
        cases=lambda: [[[-2.0, 0.0], [0.0, -2.0]]],
        deviation=_real_in_vain,
        copies=(Copy("the logarithm with half a turn", _real_branch),),
        remark="Tried with SciPy's, for Matlab's and Octave's: it is the principal logarithm, (log 2 + π i) I.",
    ),
    Claim(
        id="rossignac_vinacua.3.2.branching",
        place="section 3.2",
        statement="Iterations have convergence and branching problems: for diag(-2, -2), which has real square roots, "
        "they find none.",
        verdict=Verdict.CONFIRMED,
        form=_denman_beavers,
        cases=lambda: [exactly([[-2, 0], [0, -2]])],
        deviation=_arrives,
        copies=(Copy("sqrt(2) times a quarter turn", _turned_root),),
        remark="From A and I all iterates are multiples of I, and no real multiple of I is a root.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.series",
        place="section 3.3.2",
        statement="The series of log A converges for matrices close to the identity only.",
        printed="approximates log(L) by a series expansion ... only converges for matrices close to the identity",
        verdict=Verdict.BOUND,
        domain="|x - 1| < 1 for all eigenvalues x: that is what close means. [[1, 100], [0, 1]] is close, and the "
        "quarter turn is not",
        form=_series,
        cases=_within,
        outside=_beyond,
        deviation=_unlike_logarithm,
        copies=(Copy("A - I for I - A", _alternating),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.roots_first",
        place="section 3.3.2",
        statement="After a series of square roots the series serves any A that has one: log A = 2^k log A^(1/2^k).",
        verdict=Verdict.CONFIRMED,
        form=_by_roots,
        cases=_root_cases,
        deviation=lambda form, case: difference(form(mp, *case), sam.log(mp, *case)),
        copies=(
            Copy("k roots and 3^k", lambda m, a: _by_roots(m, a, factor=3)),
            Copy("k roots and 2^(k - 1)", lambda m, a: _by_roots(m, a) / 2),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.denman_beavers",
        place="section 3.3.2",
        statement="The iteration of Denman and Beavers for square roots is unstable.",
        printed="Alexa relies on the Denman-Beavers iteration, which was found to be unstable [Higham 1986]",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_denman_beavers,
        cases=_spread,
        deviation=_stable,
        correction=Correction(
            statement="Newton's iteration X <- (X + X^-1 A) / 2 is unstable. That of Denman and Beavers is a variant "
            "of it that is stable, for practical purposes.",
            form=_newton,
        ),
        remark="That is also what the paper says that is cited (Higham, Newton's method for the matrix square root, "
        "1986): two simplified Newton iterations are unstable, a further variant is stable.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.slower",
        place="sections 3.2 and 3.3.2",
        statement="Iterative logarithms are slower than the closed forms, and less robust.",
        verdict=Verdict.UNCHECKABLE,
        reason="a comparison of running times and robustness without a measurement",
    ),
)
