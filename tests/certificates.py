"""Certificates made by hand, for the tests of what shows them."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np

from affinecert.arithmetic import FLOAT64
from affinecert.case import Case, to_record
from affinecert.certificate import (
    CaseResult,
    Certificate,
    LawRecord,
    Machine,
    MorphLawRecord,
    RegimeResult,
    Timing,
)
from affinecert.scoring import FINDINGS, Verdict
from affinecert.summary import GRAVITY

BOUND = 16.0
HOSTILE = "<img src=x onerror=alert(1)> | `rm -rf` \n**bold** & \udc80"


def case_result(
    *,
    map_: str = "so3.log",
    regime: str = "near-pi",
    inputs: tuple[object, ...] = (np.eye(3),),
    distance: float = 1e-9,
    scaled: float = 1.5,
    verdict: Verdict = Verdict.OK,
    note: str = "",
    backward: float | None = 0.75,
) -> CaseResult:
    arrays = tuple(np.asarray(array, dtype=np.float64) for array in inputs)
    case = Case(map_, regime, arrays, distance, "regime, seed 0, number 0")
    return CaseResult(str(verdict), note, "rotation_vector", scaled * 2, scaled, 1.0, backward, to_record(case))


def verdict_of(scaled: float) -> Verdict:
    if scaled <= BOUND:
        return Verdict.OK
    return Verdict.DEGRADED if scaled <= FLOAT64.lost_half else Verdict.WRONG


def regime_result(map_: str, regime: str, results: list[CaseResult], distance: str = "angle") -> RegimeResult:
    ranked = sorted(results, key=lambda r: (GRAVITY[Verdict(r.verdict)], r.scaled), reverse=True)
    return RegimeResult(
        map=map_,
        regime=regime,
        distance=distance,
        cases=len(results),
        verdicts=dict(Counter(result.verdict for result in results)),
        worst=ranked[0] if ranked else None,
        findings=tuple(result for result in ranked if Verdict(result.verdict) in FINDINGS)[:5],
        points=tuple((float.fromhex(r.case["distance"]), r.scaled, r.verdict) for r in results),
    )


def law(name: str, verdict: str = "passed", worst: float = 0.4, note: str = "") -> LawRecord:
    inputs = (["0x1.0p+0", "0x0.0p+0"],) if verdict == "failed" else ()
    return LawRecord(name, f"the statement of {name}", "Lemma 1", "everywhere", verdict, worst, 16.0, 25, inputs, note)


POSE = [["0x1.0p+0", "0x0.0p+0", "-0x1.8p+0"], ["0x0.0p+0", "0x1.0p+0", "0x0.0p+0"], ["0x0.0p+0"] * 2 + ["0x1.0p+0"]]


def morph_laws() -> tuple[MorphLawRecord, ...]:
    """Every kind of cell, of two morphs and of one that nobody knows, with an infinite residual and hostile texts."""
    takes, similar, where = "all pairs", "C B^-1 is a similarity", "where it exists"
    poses, two_pairs = (POSE, POSE), (POSE, POSE, POSE, POSE)
    return (
        MorphLawRecord("sam", "steady", "holds", takes, residual=1e-16, examples=40, confirmed=True, note=where),
        MorphLawRecord("sam", "ARA = 0", "holds", takes, examples=40, confirmed=True, value=1e-13),
        MorphLawRecord("linear", "steady", "fails", takes, (similar,), math.inf, 40, poses, True),
        MorphLawRecord("linear", "ARA = 0", "partly", takes, (similar,), 0.5, 40, poses, True, 3.75),
        MorphLawRecord("sclerp", "steady", "partly", takes, (HOSTILE,), 0.5, 40, two_pairs, False, None, HOSTILE),
        MorphLawRecord("sclerp", "ARA = 0", "unclear", HOSTILE, note=HOSTILE),
        MorphLawRecord("nobody's", "steady", "void", takes),
        MorphLawRecord("nobody's", "ARA = 0", "absent", takes),
    )


MACHINE = Machine("Linux x86_64", "A processor", 2, "3.11.4", {"numpy": "2.3.0", "numba": "0.62.0", "mpmath": "1.3.0"})


def certificate(
    results: tuple[RegimeResult, ...],
    laws: tuple[LawRecord, ...] = (),
    subject: str = "fast",
    absent: tuple[str, ...] = (),
    cells: tuple[MorphLawRecord, ...] = (),
) -> Certificate:
    return Certificate(
        subject=subject,
        subject_version="1.2.3",
        spec=subject,
        conventions={"twists": "rotation first"},
        affinecert="0.1.0",
        profile="quick",
        maps="*",
        created="2025-01-01T12:00:00+00:00",
        seconds=12.5,
        machine=MACHINE,
        results=results,
        laws=laws,
        timings=tuple(Timing(name, 10_000, 51.25) for name in sorted({result.map for result in results})),
        absent=absent,
        morph_laws=cells,
    )


def passing() -> Certificate:
    """One map, one regime, everything well."""
    results = [case_result(distance=10.0**-n, scaled=n / 8) for n in range(8)]
    return certificate((regime_result("so3.log", "near-pi", results, "pi - angle"),), (law("steadiness"),))


def failing() -> Certificate:
    """Every verdict, infinite errors, distance 0, an empty regime, a broken law, absent maps, hostile texts."""
    near_pi = [
        case_result(distance=0.0, scaled=0.0, inputs=(np.diag([1.0, -1.0, -1.0]),)),
        case_result(distance=1e-300, scaled=40.0, verdict=Verdict.DEGRADED, note="1.3 bits beyond the bound"),
        case_result(distance=1e-9, scaled=1e15, verdict=Verdict.OTHER_BRANCH, note="its exponential gives it back"),
        case_result(distance=1e-8, scaled=9e15, verdict=Verdict.WRONG, note="more than half", backward=math.inf),
    ]
    generic = [
        case_result(regime="generic", distance=1.0, scaled=math.inf, verdict=Verdict.NON_FINITE, note="not finite"),
        case_result(regime="generic", distance=1.0, scaled=math.inf, verdict=Verdict.RAISED, note=HOSTILE),
    ]
    power = [
        case_result(
            map_="sam.power", regime=HOSTILE, inputs=(np.eye(4), 0.5), distance=math.inf, scaled=2.0, backward=None
        )
    ]
    return certificate(
        (
            regime_result("so3.log", "near-pi", near_pi, "pi - angle"),
            regime_result("so3.log", "generic", generic),
            regime_result("so3.log", "empty", []),
            regime_result("sam.power", HOSTILE, power, HOSTILE),
        ),
        (law("steadiness"), law("volume kept", "failed", math.inf, HOSTILE), law("isometry", "absent", 0.0)),
        subject="scipy",
        absent=("shear.exp", "shear.log"),
        cells=morph_laws(),
    )


def large(maps: int = 20, regimes: int = 8, cases: int = 32, spoilt: float = 0.1) -> Certificate:
    """As large as a real one; the share ``spoilt`` of the regimes loses digits towards the singular set."""
    generator = np.random.default_rng(0)
    families = ("so3.exp", "so3.log", "se3.exp", "se3.log", "shear.exp", "affine_lie.interpolate_tetrahedra")
    labels = ("angle", "pi - angle", "gap of eigenvalues", "size")
    names = ("generic", "near-identity", "near-pi", "at-pi", "coalescing", "off-manifold", "huge", "tiny")
    results = []
    for number in range(maps):
        name = families[number] if number < len(families) else f"sam.map_{number}"
        for index in range(regimes):
            bad = generator.random() < spoilt
            judged = []
            for _ in range(cases):
                distance = 0.0 if names[index] == "at-pi" else 10.0 ** generator.uniform(-16, 0)
                scaled = float(generator.exponential(0.8))
                if bad:
                    scaled += 1e-15 / max(distance, 1e-30) * 10.0 ** generator.uniform(0, 3)
                verdict = verdict_of(scaled)
                inputs = (generator.standard_normal((4, 4)), np.float64(generator.random()))
                judged.append(
                    case_result(
                        map_=name,
                        regime=names[index],
                        inputs=inputs,
                        distance=distance,
                        scaled=scaled,
                        verdict=verdict,
                        note="loses bits",
                    )
                )
            results.append(regime_result(name, names[index], judged, labels[index % 4]))
    laws = tuple(law(f"law {number}", "failed" if spoilt and number == 3 else "passed") for number in range(12))
    return certificate(tuple(results), laws, "fast" if not spoilt else "scipy", ("shear.log",) if spoilt else ())
