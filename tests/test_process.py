"""Subjects in other processes: small programs that answer well, badly or not at all; and the example in C++."""

from __future__ import annotations

import os
import pickle
import re
import select
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from affinecert.campaign import run_name
from affinecert.case import Case, generate
from affinecert.catalogue import CATALOGUE
from affinecert.errors import SubjectError
from affinecert.judging import judge, truths_of
from affinecert.subject import load
from affinecert.subjects import keeper, process
from affinecert.subjects.program import Program

PROGRAM = """
import json, math, os, sys, time

def exp(omega):
    x, y, z = map(float.fromhex, omega)
    a = math.hypot(x, y, z)
    s, c = (math.sin(a) / a, 2 * (math.sin(a / 2) / a) ** 2) if a else (1.0, 0.5)
    rows = [[1 - c * (y * y + z * z), c * x * y - s * z, c * x * z + s * y],
            [c * x * y + s * z, 1 - c * (x * x + z * z), c * y * z - s * x],
            [c * x * z - s * y, c * y * z + s * x, 1 - c * (x * x + y * y)]]
    return [[number.hex() for number in row] for row in rows]

def right():
    return [[exp(omega)] for omega, in request["inputs"]]

def tell(answer):
    print(answer if isinstance(answer, str) else json.dumps(answer), flush=True)

hello = {"name": "theirs", "version": "1", "maps": ["so3.exp"]}

for line in sys.stdin:
    request = json.loads(line)
    if "hello" in request:
        {hello}
        continue
    {answer}
"""

Write = Callable[..., str]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Writes a program with these statements; its spec."""

    def program(answer: str = 'tell({"outputs": right()})', hello: str = "tell(hello)") -> str:
        path = tmp_path / "subject.py"
        path.write_text(PROGRAM.replace("{answer}", answer).replace("{hello}", hello), encoding="utf-8")
        return f"exec:{sys.executable} -S -E {path}"

    return program


def cases(name: str = "so3.exp", regime: str = "generic", count: int = 3) -> list[Case]:
    (chosen,) = (each for each in CATALOGUE[name].regimes if each.name == regime)
    return list(generate(CATALOGUE[name], chosen, count))


def verdicts(spec: str, asked: list[Case]) -> list[tuple[str, str]]:
    return [(result.verdict, result.note) for result in judge(load(spec), asked, truths_of(asked))]


def test_a_sound_program_is_a_subject_as_any_other(write: Write) -> None:
    subject = load(write(hello='tell(hello | {"conventions": {"angles": "radians"}, "dtype": "float64"})'))
    assert (subject.name, subject.version, subject.dtype) == ("theirs", "1", "float64")
    assert subject.conventions["angles"] == "radians"
    rotation = subject.maps["so3.exp"](np.array([[0.0, 0.0, np.pi / 2]]))
    np.testing.assert_allclose(rotation, [[[0, -1, 0], [1, 0, 0], [0, 0, 1]]], atol=1e-15)
    assert pickle.loads(pickle.dumps(subject)) == subject
    found = judge(subject, cases(), truths_of(cases()))
    assert [result.verdict for result in found] == ["ok"] * 3


def test_every_bit_comes_through(write: Write) -> None:
    subject = load(write('tell({"outputs": request["inputs"]})'))
    numbers = np.array([[5e-324, -0.0, 1.7976931348623157e308], [np.inf, -np.inf, 0.1]])
    np.testing.assert_array_equal(subject.maps["so3.exp"](numbers), numbers)


def test_a_changed_program_is_another_run(write: Write) -> None:
    before = run_name(load(write()))
    assert run_name(load(write())) == before
    assert run_name(load(write("tell({'outputs': right()}); pass"))) != before


HERE = "the program "


@pytest.mark.parametrize(
    ("answer", "note"),
    [
        ("sys.exit(3)", HERE + "ended with status 3"),
        ("os.kill(os.getpid(), 11)", HERE + "was ended by SIGSEGV"),
        (
            "raise ArithmeticError('no turns')",
            HERE + "ended with status 1; its last words: 'ArithmeticError: no turns'",
        ),
        ("tell('rubbish')", HERE + "wrote 'rubbish' where a JSON object is due"),
        ("tell('[' * 100000)", HERE + "wrote '" + "[" * 80 + "...' where a JSON object is due"),
        ("tell([])", HERE + "wrote '[]' where a JSON object is due"),
        ("tell({})", HERE + "answered so3.exp with [] where outputs or an error are due"),
        ("tell({'outputs': right()[1:]})", HERE + "gave 0 outputs of so3.exp where 1 are due"),
        ("tell(json.dumps({'outputs': right()}) + '\\ndone')", HERE + "wrote more than one line, 'done' after '{"),
        ("tell({'outputs': [[1.5] for _ in right()]})", HERE + "gave an output of so3.exp that is not understood: 1.5"),
        (
            "tell({'outputs': [['0.5'] for _ in right()]})",
            HERE + "gave an output of so3.exp that is not understood: '0.5'",
        ),
        ("tell({'outputs': [[[['0x1p+0'], []]] for _ in right()]})", HERE + "gave an output of so3.exp that is not "),
        ("tell({'outputs': [7 for _ in right()]})", HERE + "gave an output of so3.exp that is no list of results"),
    ],
)
def test_a_program_that_breaks_down_is_told_and_asked_again(write: Write, answer: str, note: str) -> None:
    found = verdicts(write(answer), cases(count=2))
    assert {verdict for verdict, _ in found} == {"raised"}
    assert all(told.startswith("SubjectError: " + note) for _, told in found), found


def test_a_program_that_falls_silent_is_told(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keeper, "GRACE", 0.1)
    ((verdict, note),) = verdicts(write("os.close(1); time.sleep(60)"), cases(count=1))
    assert (verdict, note) == ("raised", "SubjectError: the program closed its stdout")


@pytest.mark.parametrize(
    ("answer", "verdict", "note"),
    [
        ("tell({'error': 'no rotations today'})", "raised", "ValueError: no rotations today"),
        ("tell({'outputs': [None for _ in right()]})", "raised", "ValueError: refused"),
        ("tell({'outputs': [['nan'] for _ in right()]})", "wrong", "output 0 has shape () where (3, 3) is due"),
        ("tell({'outputs': [item * 2 for item in right()]})", "wrong", "2 outputs where 1 are due"),
        ("tell({'outputs': [[[['nan'] * 3] * 3] for _ in right()]})", "non-finite", "not finite where a number is due"),
    ],
)
def test_answers_that_are_wrong_are_judged_as_of_any_subject(
    write: Write, answer: str, verdict: str, note: str
) -> None:
    assert verdicts(write(answer), cases(count=2)) == [(verdict, note)] * 2


def test_one_bad_item_does_not_spoil_the_batch(write: Write) -> None:
    moody = "tell({'outputs': [None if k == 1 and len(right()) > 1 else item for k, item in enumerate(right())]})"
    assert [verdict for verdict, _ in verdicts(write(moody), cases())] == ["ok"] * 3
    deadly = f"if {cases()[1].inputs[0][0].hex()!r} in str(request): os.abort()\n    tell({{'outputs': right()}})"
    assert [verdict for verdict, _ in verdicts(write(deadly), cases())] == ["ok", "raised", "ok"]


def test_outside_the_domain_a_refusal_is_right_and_a_breakdown_is_not(write: Write) -> None:
    hello = 'tell(hello | {"maps": ["so3.log"]})'
    for answer, verdict in (("tell({'error': 'no rotation'})", "ok"), ("os.abort()", "raised")):
        assert [found for found, _ in verdicts(write(answer, hello), cases("so3.log", "outside", 1))] == [verdict]


@pytest.mark.parametrize(
    ("hello", "message"),
    [
        ("tell('hi')", "wrote 'hi' where a JSON object is due"),
        ("sys.exit('no licence')", "ended with status 1; its last words: 'no licence'"),
        ("time.sleep(60)", "wrote no line within 0.5 s"),
        ("print('{', end='', flush=True); time.sleep(60)", "wrote no line within 0.5 s"),
        ("tell({'name': 'theirs', 'maps': ['so3.exp']})", "does not tell its version"),
        ("tell(hello | {'maps': ['so3.lgo']})", "no map is named 'so3.lgo'; did you mean so3.log"),
        ("tell(hello | {'maps': 'so3.exp'})", "tells of itself what is not understood, maps: 'so3.exp'"),
        ("tell(hello | {'dtype': 'float16'})", "tells of itself what is not understood, dtype: 'float16'"),
        ("tell(hello | {'convention': {}})", "tells of itself what is not understood, convention: {}"),
    ],
)
def test_who_does_not_introduce_himself_is_no_subject(
    write: Write, monkeypatch: pytest.MonkeyPatch, hello: str, message: str
) -> None:
    monkeypatch.setattr(process, "HELLO_SECONDS", 0.5)
    spec = write(hello=hello)
    with pytest.raises(SubjectError) as caught:
        load(spec)
    assert str(caught.value).startswith(f"{spec}: ")
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        ("exec:", "exec:: there is no program '' that can be run"),
        ("exec:./nowhere --flag", "there is no program './nowhere' that can be run"),
        ("exec:'./nowhere", "not a command line: No closing quotation"),
    ],
)
def test_what_does_not_start_is_told(spec: str, message: str) -> None:
    with pytest.raises(SubjectError) as caught:
        load(spec)
    assert message in str(caught.value)


def test_a_file_that_no_system_runs_is_told(tmp_path: Path) -> None:
    script = tmp_path / "subject"
    script.write_bytes(b"\x7fELF and nothing else")
    script.chmod(0o755)
    with pytest.raises(SubjectError, match=r"ended with status 126; its last words: .*Exec format error"):
        load(f"exec:{script}")


def test_a_program_that_hangs_ends_with_who_asked_it(tmp_path: Path) -> None:
    told = tmp_path / "pid"
    hanging = f"import os, time; open({str(told)!r}, 'w').write(str(os.getpid())); time.sleep(60)"
    asking = (
        f"from affinecert.subjects.program import Program; Program({(sys.executable, '-c', hanging)}).exchange(b'')"
    )
    parent = subprocess.Popen([sys.executable, "-c", asking])
    until(lambda: told.exists() and told.read_text() != "")
    parent.send_signal(signal.SIGKILL)
    parent.wait()
    until(lambda: not alive(int(told.read_text())))


def test_a_line_that_nobody_asked_for_is_told(tmp_path: Path) -> None:
    sign = tmp_path / "sign"
    later = f"import os\nwhile not os.path.exists({str(sign)!r}): pass\nprint('done', flush=True)\ninput()"
    program = Program((sys.executable, "-c", f"input()\nprint('here I am', flush=True)\n{later}"))
    assert program.exchange(b"") == b"here I am"
    sign.touch()
    until(lambda: bool(select.select([program.stdout], [], [], 0.0)[0]))
    with pytest.raises(SubjectError, match="wrote what nobody had asked for, 'done'"):
        program.exchange(b"")


def until(happened: Callable[[], bool]) -> None:
    for _ in range(500):
        if happened():
            return
        time.sleep(0.02)
    pytest.fail("it did not happen within 10 s")


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


EXAMPLE = Path(__file__).parents[1] / "examples" / "eigen" / "subject.cpp"
EIGEN = next(
    (place for place in map(Path, ("/usr/include/eigen3", "/usr/local/include/eigen3")) if place.is_dir()), None
)


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++ to compile the example with")
@pytest.mark.skipif(EIGEN is None, reason="Eigen is not installed (Debian's libeigen3-dev)")
def test_the_example_in_c_plus_plus_compiles_and_eigen_passes(tmp_path: Path) -> None:
    program = tmp_path / "subject"
    subprocess.run(["g++", "-O0", f"-I{EIGEN}", str(EXAMPLE), "-o", str(program)], check=True)
    subject = load(f"exec:{program}")
    assert set(subject.maps) == {"so3.exp", "so3.log", "quaternion.slerp"}
    (talk,) = re.findall(
        r"^```\n(\{.*?)^```$", EXAMPLE.with_name("README.md").read_text("utf-8"), re.MULTILINE | re.DOTALL
    )
    requests, answers = talk.split("\n")[0::3], talk.replace("3.4.0", subject.version).split("\n")[1::3]
    told = subprocess.run(program, input="\n".join(requests), capture_output=True, text=True, check=True)
    assert told.stdout.splitlines() == answers
    off_the_manifold = {"off-manifold", "from-float32"}
    for name in subject.maps:
        for regime in CATALOGUE[name].regimes:
            asked = cases(name, regime.name, 1)
            found = {result.verdict for result in judge(subject, asked, truths_of(asked))}
            assert found <= ({"ok", "degraded"} if regime.name in off_the_manifold else {"ok", "other-branch"}), (
                regime.name
            )
