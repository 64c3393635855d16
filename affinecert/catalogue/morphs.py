"""The catalogue of morphs: the ways in which people move an affine pose to another, all on the same kinds of poses."""

from __future__ import annotations

from collections.abc import Iterable

from affinecert.catalogue import conformal_pairs, pose_pairs
from affinecert.catalogue.parts import LINEAR, LINEAR_BLOCKS, TIME, TRANSLATION
from affinecert.catalogue.pose_pairs import Pair, about_times, regimes
from affinecert.map import Argument, Group, Manifold, Map, Regime
from affinecert.reference import morphs as reference

# The truth of poses in space takes some five times as long as that of poses in the plane, for it has many more
# derivatives; morphs of space alone are tried on a little more of it.
IN_PLANE, IN_SPACE, IN_SPACE_ALONE = 0.4, 0.1, 0.2

EVERYWHERE = (
    pose_pairs.GENERIC,
    pose_pairs.NEAR_IDENTITY,
    pose_pairs.EQUAL,
    pose_pairs.PURE_TRANSLATION,
    pose_pairs.RIGID,
    pose_pairs.SIMILAR,
    pose_pairs.SHEARED,
    pose_pairs.STRETCHED,
    pose_pairs.FAR,
    pose_pairs.OUTSIDE,
)
"""What every morph between all poses is tried on."""

SOMEWHERE = (pose_pairs.GENERIC, pose_pairs.NEAR_IDENTITY, pose_pairs.RIGID, pose_pairs.STRETCHED, pose_pairs.OUTSIDE)
"""The part of it on which the morphs are tried in space too."""

BETWEEN_TURNS = (pose_pairs.NEAR_PI, pose_pairs.AT_PI)
"""What the morphs are tried on that turn from one pose to the other."""

FROM_THE_IDENTITY = (pose_pairs.ONE_POSE_NEAR_PI, pose_pairs.ONE_POSE_AT_PI)
"""What the morphs are tried on that turn both poses from the identity."""

CONDITION = "The condition is against perturbations of each linear part as a whole, and of each translation."
CONTINUED = "At half a turn, where the morph jumps, and beside it, the condition is that of one branch."

POSES = "det B > 0, det C > 0, last rows 0 ... 0 1; every t"


def _pose(name: str, size: int | str, manifold: Manifold | None) -> Argument:
    """A pose; a perturbation moves its linear part as a whole, and its translation."""
    return Argument(name, (size, size), (Group(LINEAR), Group(TRANSLATION)), "1, length", manifold)


def _tried_on(turned: Iterable[Pair]) -> tuple[Regime, ...]:
    return (
        *regimes((*EVERYWHERE, *turned), (2,), IN_PLANE),
        *regimes((*SOMEWHERE, *turned), (3,), IN_SPACE),
        *about_times(pose_pairs.GENERIC, (2,), IN_PLANE),
        *about_times(pose_pairs.GENERIC, (3,), IN_SPACE),
    )


def _in_space(pairs: tuple[Pair, ...]) -> tuple[Regime, ...]:
    return (*regimes(pairs, (3,), IN_SPACE_ALONE), *about_times(pairs[0], (3,), IN_SPACE_ALONE))


def _morph(
    name: str,
    definition: str,
    source: str,
    tried_on: tuple[Regime, ...],
    *,
    domain: str = POSES,
    size: int | str = "n",
    manifold: Manifold | None = None,
    cost: float = 8.0,
) -> Map:
    continuation = reference.CONTINUATIONS.get(name)
    return Map(
        name=f"morphs.{name}",
        definition=definition,
        source=source,
        domain=domain,
        arguments=(_pose("start", size, manifold), _pose("end", size, manifold), TIME),
        outputs=((size, size),),
        blocks=LINEAR_BLOCKS,
        regimes=tried_on,
        reference=reference.MORPHS[name],
        continuation=continuation,
        accuracy=8.0,
        cost=cost,
        remark=CONDITION if continuation is None else f"{CONDITION} {CONTINUED}",
    )


RIGID = "B and C rigid to within 1e-6, the nearest rotations count; last rows 0 0 0 1; every t"

MAPS = (
    _morph("linear", "(1 - t) B + t C", "rossignac_vinacua, section 2.4 (a)", _tried_on(()), cost=2.0),
    _morph(
        "shoemake_duff",
        "R_B (R_B^T R_C)^t ((1 - t) S_B + t S_C), L_X = R_X S_X polar; translation (1 - t) b + t c",
        "Shoemake and Duff 1992, as in rossignac_vinacua, section 3.3.2",
        _tried_on(BETWEEN_TURNS),
    ),
    _morph(
        "arap",
        "R^t ((1 - t) I + t S) L_B, R S = L_C L_B^-1 polar; translation (1 - t) b + t c",
        "Alexa, Cohen-Or, Levin 2000, as in rossignac_vinacua, section 3.3.2, and kaji_2d, equation 2",
        _tried_on(BETWEEN_TURNS),
    ),
    _morph(
        "rarap",
        "the linear part of morphs.arap; the barycentre of 0, e_1, ..., e_n moves in a straight line",
        "rossignac_vinacua, section 2.4 (b)",
        _tried_on(BETWEEN_TURNS),
    ),
    _morph(
        "asap",
        "R^t S^t L_B, R S = L_C L_B^-1 polar; the barycentre of 0, e_1, ..., e_n moves in a straight line",
        "rossignac_vinacua, section 3.3.2; kaji_2d, equation 3",
        _tried_on(BETWEEN_TURNS),
    ),
    _morph(
        "alexa_2002",
        "exp((1 - t) log B + t log C), the logarithms those of sam.log",
        "Alexa 2002, as in rossignac_vinacua, section 3.3.2",
        (
            *regimes(pose_pairs.WITH_LOGARITHMS, (2,), IN_PLANE),
            *regimes((*pose_pairs.WITH_LOGARITHMS, pose_pairs.OUTSIDE), (3,), IN_SPACE),
            *about_times(pose_pairs.LOGARITHMIC, (2,), IN_PLANE),
        ),
        domain="B and C as for sam.log, every t",
    ),
    _morph(
        "sumner_2005",
        "exp((1 - t) log R_B + t log R_C) ((1 - t) S_B + t S_C), L_X = R_X S_X polar; translation (1 - t) b + t c",
        "Sumner, Zwicker, Gotsman, Popovic 2005",
        _tried_on(FROM_THE_IDENTITY),
    ),
    _morph(
        "log_spiral",
        "(Z_C Z_B^-1)^t Z_B ((1 - t) D_B + t D_C), Z_X the similarity (det(L_X)^(1/dim) R_X, x), D_X = Z_X^-1 X",
        "rossignac_vinacua, section 2.4 (c)",
        _tried_on(BETWEEN_TURNS),
    ),
    _morph(
        "three_spiral",
        "corners of 0, e_1, e_2 the means of their two sides' p + (z^t - 1) / (z - 1) (p' - p), z the ratio of a side",
        "rossignac_vinacua, section 2.4 (d), after Whited and others 2010",
        (
            *regimes((*EVERYWHERE, *BETWEEN_TURNS), (2,), IN_PLANE),
            *about_times(pose_pairs.GENERIC, (2,), IN_PLANE),
        ),
        size=3,
    ),
    _morph(
        "lie",
        "from B Delta to C Delta as affine_lie.interpolate_tetrahedra; Delta the simplex 0, e_1, e_2, e_3",
        "bansal_tatu, equation 4",
        _tried_on(BETWEEN_TURNS),
        cost=14.0,
    ),
    _morph(
        "polar_exponential",
        "exp(mix of log R_B, log R_C) exp(mix of log S_B, log S_C), mix (1 - t, t); translation (1 - t) b + t c",
        "kaji_ochiai, equation 9",
        _tried_on(FROM_THE_IDENTITY),
    ),
    _morph(
        "sim",
        "exp((1 - t) X + t Y), X = sim3.log(B), Y = sim3.log_next(C, X)",
        "gallier, section 5",
        (
            *_in_space(conformal_pairs.SIMILAR),
            *regimes(FROM_THE_IDENTITY, (3,), IN_SPACE_ALONE),
        ),
        domain="B and C similar to within 1e-6, the nearest rotations count; last rows 0 0 0 1; every t",
        size=4,
        manifold="similarities",
    ),
    _morph(
        "sclerp",
        "B exp(t log(B^-1 C))",
        "Kavan and others 2008, as in rossignac_vinacua, section 3.3.1",
        _in_space(conformal_pairs.RIGID),
        domain=RIGID,
        size=4,
        manifold="rotations",
    ),
    _morph(
        "dual_quaternion_linear",
        "normalised (1 - t) p + t s q, p, q the unit dual quaternions of B, C, s the sign of their real parts' product",
        "Kavan and others 2008 (DLB), as in rossignac_vinacua, section 3.3.1",
        _in_space(conformal_pairs.RIGID),
        domain=RIGID,
        size=4,
        manifold="rotations",
    ),
)
