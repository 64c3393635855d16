"""The law matrix: each law can fail and be kept, domains and pairs are what they say, and fast's cells are as known."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.case import from_hex
from affinecert.certificate import MorphLawRecord
from affinecert.errors import UnknownNameError
from affinecert.fast import sam
from affinecert.judging import morph_laws, resolve
from affinecert.law_matrix import law_matrix, laws, morphs
from affinecert.properties.matrix import algebra, domains
from affinecert.properties.matrix.bank import bank
from affinecert.properties.matrix.domains import DOMAINS, REORDERINGS
from affinecert.properties.matrix.laws import AFFINE, LAWS, LEFT, RIGHT
from affinecert.properties.matrix.morphs import MORPHS, Morph
from affinecert.properties.matrix.motion import exactly, subject
from affinecert.properties.matrix.trial import trial
from affinecert.reports.markdown import law_matrix as law_matrix_in_markdown
from affinecert.reports.matrix import word
from affinecert.shrink import total
from affinecert.subject import Subject

Array = NDArray[np.float64]
Function = Callable[[Array, Array, Array], Array]

STEADY = Morph("sam", "sam.morph")
NAMES = [law.name for law in LAWS]


def linear(start: Array, end: Array, t: Array) -> Array:
    """Straight lines: a right morphs.linear."""
    return (1 - t[:, None, None]) * start + t[:, None, None] * end


def bump(t: Array) -> Array:
    """0 at the ends, positive between them and negative beyond."""
    return t * (1 - t)


def warped(change: Callable[[Array], Array]) -> Function:
    """The steady morph at another time than the one asked for."""
    return lambda start, end, t: sam.morph(start, end, change(t))


def with_factor(entry: tuple[int, int], amount: float, *, right: bool) -> Function:
    """The steady morph, times a map that is the identity at the ends."""

    def broken(start: Array, end: Array, t: Array) -> Array:
        factor = np.zeros_like(start) + np.eye(start.shape[-1])
        factor[:, entry[0], entry[1]] += amount * bump(t)
        pose = sam.morph(start, end, t)
        return pose @ factor if right else factor @ pose

    return broken


def jumping(start: Array, end: Array, t: Array) -> Array:
    """Carried one way or the other, as the first axis of the end points down or up against that of the start."""
    pose = sam.morph(start, end, t)
    pose[:, 0, -1] += bump(t) * np.sign(end[:, 1, 0] - start[:, 1, 0])
    return pose


def refusing(start: Array, end: Array, t: Array) -> Array:
    """Refuses ends that are turned by more than a right angle, and with them the batch."""
    if (end[:, 0, 0] < 0).any():
        raise ValueError("turned")
    return sam.morph(start, end, t)


BROKEN: Mapping[str, Function] = {
    "endpoints": warped(lambda t: 0.99 * t),
    "steady": warped(lambda t: t + 0.1 * bump(t)),
    "constant local velocity": warped(lambda t: t + 0.1 * bump(t)),
    "volume kept": with_factor((0, 0), 0.1, right=True),
    "volume monotone": with_factor((0, 0), 2.0, right=True),
    "isometry kept": with_factor((0, 1), 0.1, right=False),
    "similarity kept": with_factor((0, 1), 0.1, right=False),
    "reversible": warped(lambda t: t + 0.1 * bump(t)),
    "left invariant": with_factor((0, -1), 0.1, right=False),
    "right invariant": with_factor((0, -1), 0.1, right=True),
    "affine invariant": with_factor((0, -1), 0.1, right=False),
    "re-ordering invariant": with_factor((0, -1), 0.1, right=True),
    "never degenerate in [0, 1]": with_factor((0, 0), -5.0, right=True),
    "never degenerate in [-2, 3]": with_factor((0, 0), 1.0, right=True),
    "exists": refusing,
    "continuous": jumping,
    "ARA = 0": warped(lambda t: t + 0.1 * bump(t)),
}


@cache
def right() -> Mapping[str, MorphLawRecord]:
    tried = trial(sam.morph, STEADY)
    return {law.name: tried(law) for law in LAWS}


@pytest.mark.parametrize("law", LAWS, ids=NAMES)
def test_a_broken_morph_is_refuted_and_a_right_one_is_not(law: Any) -> None:
    broken = trial(BROKEN[law.name], STEADY)(law)
    assert broken.verdict in {"fails", "partly"}
    assert broken.residual > 1e-3
    known = right()[law.name]
    if known.verdict == "holds":
        # The reference keeps the law there: it is the code that breaks it.
        assert not broken.confirmed
        assert known.residual < 1e-12
    else:
        assert broken.holds_on != known.holds_on
    assert known.confirmed


def test_what_is_no_pose_counts_as_none() -> None:
    def careless(start: Array, end: Array, t: Array) -> Array:
        pose = linear(start, end, t)
        pose[end[:, 0, 0] > 1.5] = np.nan
        return pose

    (exists,) = (law for law in LAWS if law.name == "exists")
    cell = trial(careless, Morph("linear", "morphs.linear"))(exists)
    assert from_hex(cell.inputs[1])[0, 0] > 1.5
    assert not cell.confirmed
    nothing = trial(lambda start, end, t: np.zeros(3), STEADY)
    assert nothing(LAWS[0]).verdict == "void"
    assert nothing(exists).verdict == "fails"


def test_refused_pairs_are_singled_out() -> None:
    asked = []

    def counting(start: Array, end: Array, t: Array) -> tuple[Array]:
        asked.append(len(start))
        return (refusing(start, end, t),)

    start = np.array([np.eye(3)] * 64)
    end = start.copy()
    end[[5, 40], :2, :2] *= -1
    given = ~np.isnan(subject(counting)(start, end, 0.5)).any(axis=(-2, -1))
    assert np.flatnonzero(~given).tolist() == [5, 40]
    assert len(asked) <= 25


def test_a_counterexample_is_simple_and_fails() -> None:
    tried = trial(linear, Morph("linear", "morphs.linear"))
    for law in LAWS:
        cell = tried(law)
        if cell.inputs:
            poses = [from_hex(pose) for pose in cell.inputs]
            assert total(tuple(poses[:2])) <= 12, law.name
            assert all(np.linalg.det(pose) > 0 for pose in poses), law.name
            assert cell.confirmed


@pytest.mark.parametrize("n", [3, 4])
def test_algebra_is_that_of_numpy_in_every_arithmetic(n: int) -> None:
    generator = np.random.default_rng(n)
    poses = generator.normal(size=(5, n, n))
    poses[:, -1] = np.eye(n)[-1]
    assert np.allclose(algebra.inverse(poses), np.linalg.inv(poses))
    assert np.allclose(algebra.determinant(poses), np.linalg.det(poses[:, :-1, :-1]))
    assert np.allclose(algebra.size(poses), np.linalg.norm(poses, axis=(-2, -1)))
    ctx = mpmath.MPContext()
    ctx.prec = 200
    exact = exactly(ctx, poses)
    identity = algebra.inverse(exact) @ exact
    assert float(algebra.size(identity - np.eye(n)).max()) < 1e-55
    rotation = np.linalg.qr(poses)[0]
    assert algebra.unlike_rotation(rotation).max() < 1e-14
    assert algebra.unlike_rotation(3 * rotation, scaled=True).max() < 1e-14
    assert algebra.unlike_rotation(3 * rotation).min() > 1


@pytest.mark.parametrize("size", [2, 3])
def test_reorderings_are_even_and_move_vertices_to_vertices(size: int) -> None:
    vertices = np.concatenate([np.zeros((1, size)), np.eye(size)])
    homogeneous = np.concatenate([vertices, np.ones((size + 1, 1))], axis=1)
    for matrix in REORDERINGS[size]:
        moved = (homogeneous @ matrix.T)[:, :-1]
        assert sorted(moved.tolist()) == sorted(vertices.tolist())
        assert moved.tolist() != vertices.tolist()
        assert np.linalg.det(matrix) > 0


@pytest.mark.parametrize("size", [2, 3])
def test_the_maps_that_laws_are_tried_with_are_what_they_are_called(size: int) -> None:
    for matrix in (*LEFT[size], *RIGHT[size]):
        assert algebra.unlike_rotation(matrix[:-1, :-1]) < 1e-15
        assert np.linalg.norm(matrix[:-1, -1]) > 0.5
    for matrix in AFFINE[size]:
        assert algebra.unlike_rotation(matrix[:-1, :-1], scaled=True) > 0.5
        assert np.linalg.det(matrix) > 0


@pytest.mark.parametrize("size", [2, 3])
def test_the_bank_has_pairs_of_every_domain_from_simple_to_complex(size: int) -> None:
    pairs = bank(size)
    assert (algebra.determinant(pairs.start) > 0).all()
    assert (algebra.determinant(pairs.end) > 0).all()
    weights = [total((start, end)) for start, end in zip(pairs.start, pairs.end, strict=True)]
    ordinary = [weight for weight, astride in zip(weights, pairs.astride, strict=True) if not astride]
    assert ordinary == sorted(ordinary)
    for domain in DOMAINS:
        expected = 8 if domain is not domains.PLANE or size == 2 else 0
        assert pairs.within[domain.name].sum() >= expected, domain.name
    for law in LAWS:
        assert (law.premise(pairs.start, pairs.end) & ~pairs.within["shift"]).sum() >= 20
    for one, other in ((pairs.start, pairs.next_start), (pairs.end, pairs.next_end)):
        assert 0 < np.abs(one - other).max() < 1e-10


@pytest.mark.parametrize("size", [2, 3])
def test_pairs_astride_pi_lie_on_its_two_sides(size: int) -> None:
    pairs = bank(size)
    assert not pairs.within["not pi"][pairs.astride].any()
    for number in np.flatnonzero(pairs.astride):
        here, there = (
            [end @ np.linalg.inv(start), np.linalg.inv(start) @ end, start, end]
            for start, end in (
                (pairs.start[number], pairs.end[number]),
                (pairs.next_start[number], pairs.next_end[number]),
            )
        )
        opposite = [
            np.linalg.norm((a - a.T)[:-1, :-1] + (b - b.T)[:-1, :-1]) < np.linalg.norm((a - a.T)[:-1, :-1]) / 2
            for a, b in zip(here, there, strict=True)
        ]
        assert any(opposite), number


def test_domains_are_within_one_another_as_their_words_say() -> None:
    inclusions = [
        ("both rig", "both sim"),
        ("both rig", "rigid"),
        ("both sim", "similar"),
        ("rigid", "similar"),
        ("shift", "rigid"),
        ("shift", "stretch"),
        ("stretch", "mild"),
    ]
    for size in (2, 3):
        within = bank(size).within
        for narrow, wide in inclusions:
            assert (within[wide] | ~within[narrow]).all(), (narrow, wide)
    names = [domain.name for domain in DOMAINS]
    assert len(set(names)) == len(names)
    assert max(map(len, (*names, *(law.head for law in LAWS)))) <= 8


def test_domains_know_their_borders() -> None:
    quarter = np.array([[[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]])
    identity, half = np.eye(3)[None], np.diag([-1.0, -1.0, 1.0])[None]
    negative = np.array([[[0.0, -2.0, 0.0], [1.0, -3.0, 0.0], [0.0, 0.0, 1.0]]])
    assert not domains.MILD.holds(identity, quarter).any()
    assert domains.NO_HALF_TURN.holds(identity, quarter).all()
    assert not domains.NO_HALF_TURN.holds(identity, half).any()
    assert not domains.NO_HALF_TURN.holds(half, quarter).any()
    assert domains.NO_HALF_TURN.holds(identity, negative).all()
    assert domains.FROM_IDENTITY.holds(identity, quarter).all()
    assert not domains.FROM_IDENTITY.holds(quarter, identity).any()


# What theory says of morphs. "not pi", for what breaks at turns by exactly pi alone, is as good as yes.
THEOREMS: Mapping[str, Mapping[str, str]] = {
    "sam": {
        "endpoints": "yes",
        "steady": "yes",
        "constant local velocity": "yes",
        "volume kept": "yes",
        "volume monotone": "yes",
        "isometry kept": "yes",
        "similarity kept": "yes",
        "reversible": "not pi",
        "affine invariant": "not pi",
        "right invariant": "yes",
        "re-ordering invariant": "yes",
        "never degenerate in [-2, 3]": "yes",
        "exists": "mild",
        "ARA = 0": "0",
    },
    "lie": {
        "steady": "rigid",
        "volume kept": "yes",
        "volume monotone": "yes",
        "isometry kept": "yes",
        "reversible": "not pi",
        "left invariant": "not pi",
        "affine invariant": "no",
        "re-ordering invariant": "rigid",
        "exists": "yes",
    },
    "polar_exponential": {"volume kept": "yes", "isometry kept": "yes", "steady": "no", "left invariant": "no"},
    "sim": {"steady": "from I", "similarity kept": "yes", "exists": "yes", "affine invariant": "–"},
    "linear": {
        "steady": "no",
        "volume kept": "no",
        "isometry kept": "no",
        "similarity kept": "plane",
        "reversible": "yes",
        "affine invariant": "yes",
        "re-ordering invariant": "yes",
        "never degenerate in [0, 1]": "mild",
        "never degenerate in [-2, 3]": "no",
        "exists": "yes",
        "continuous": "yes",
    },
    "shoemake_duff": {"volume kept": "similar", "left invariant": "yes", "never degenerate in [0, 1]": "yes"},
    "arap": {"volume kept": "similar", "re-ordering invariant": "stretch", "never degenerate in [0, 1]": "yes"},
    "rarap": {"volume kept": "similar", "re-ordering invariant": "yes"},
    "asap": {"volume kept": "yes", "volume monotone": "yes", "steady": "no", "re-ordering invariant": "yes"},
    "alexa_2002": {"steady": "from I", "volume kept": "yes", "isometry kept": "both sim", "exists": "upright"},
    "sumner_2005": {"volume kept": "similar", "reversible": "yes", "left invariant": "no"},
    "log_spiral": {"steady": "similar", "re-ordering invariant": "similar", "exists": "yes"},
    "three_spiral": {"steady": "similar", "left invariant": "yes", "re-ordering invariant": "yes", "exists": "yes"},
    "sclerp": {
        "steady": "yes",
        "isometry kept": "yes",
        "left invariant": "yes",
        "affine invariant": "–",
        "ARA = 0": "0",
    },
    "dual_quaternion_linear": {"steady": "no", "isometry kept": "yes", "right invariant": "not pi", "exists": "yes"},
}


@cache
def matrix() -> Mapping[tuple[str, str], MorphLawRecord]:
    return {(cell.morph, cell.law): cell for cell in law_matrix("fast")}


def test_fast_has_every_cell_and_none_is_unclear_or_unconfirmed() -> None:
    assert list(matrix()) == [(morph.name, law) for morph in MORPHS for law in NAMES]
    assert {cell.verdict for cell in matrix().values()} == {"holds", "partly", "fails", "void"}
    assert [name for name, cell in matrix().items() if not cell.confirmed and cell.verdict != "void"] == []
    assert all(cell.inputs for cell in matrix().values() if cell.verdict in {"partly", "fails"})
    assert all(cell.holds_on for cell in matrix().values() if cell.verdict == "partly")


@pytest.mark.parametrize("morph", THEOREMS)
def test_fast_keeps_and_breaks_the_laws_that_theory_says(morph: str) -> None:
    assert {law: word(matrix()[morph, law]) for law in THEOREMS[morph]} == THEOREMS[morph]


def test_constant_velocities_and_no_acceleration_are_one_law() -> None:
    # Rossignac and Vinacua, section 6.1: steady morphs are the only ones of constant velocity, in either frame.
    for morph in MORPHS:
        first, second, third = (matrix()[morph.name, law] for law in ("steady", "constant local velocity", "ARA = 0"))
        assert first.verdict == second.verdict == third.verdict
        assert first.holds_on == second.holds_on == third.holds_on


def test_a_row_is_the_same_every_time() -> None:
    again = morph_laws("fast", "log_spiral", NAMES)
    assert again == tuple(matrix()["log_spiral", law] for law in NAMES)


def test_a_subject_is_tried_on_the_morphs_it_offers() -> None:
    asked = Subject("partial", "1", {"morphs.linear": linear})
    cells = law_matrix(asked, law="[sv]*")
    assert {cell.law for cell in cells} == {"steady", "volume kept", "volume monotone", "similarity kept"}
    assert {cell.morph for cell in cells if cell.verdict != "absent"} == {"linear"}
    found = {cell.law: replace(cell, residual=0.0) for cell in cells if cell.morph == "linear"}
    assert found == {law: replace(matrix()["linear", law], residual=0.0) for law in found}


def test_the_readme_shows_the_matrix_of_fast() -> None:
    table, _, legend = law_matrix_in_markdown(list(matrix().values())).strip().partition("\n\n")
    readme = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
    assert table in readme
    assert legend in readme


def test_unknown_names_are_told() -> None:
    with pytest.raises(UnknownNameError, match="no morph is named 'linaer'; did you mean linear"):
        morphs("linaer")
    with pytest.raises(UnknownNameError, match="no law of morphs is named 'stready'; did you mean steady"):
        laws("stready")


def test_morphs_of_the_table_are_in_the_catalogue() -> None:
    assert {morph.map for morph in MORPHS} <= set(resolve("fast").maps)
