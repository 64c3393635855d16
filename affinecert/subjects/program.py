"""A program to talk to by the line; it ends when this process does, however that comes about."""

from __future__ import annotations

import atexit
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import suppress

from affinecert.errors import SubjectError
from affinecert.subjects import keeper

SHOWN = 80
"""Characters that are told of a line that is not understood, and of a program's last words."""

CHUNK = 1 << 16
LONGEST = 1 << 28
"""Bytes read at once, and of a line at most: ten thousand answers of a thousand numbers each are shorter."""


def shown(line: bytes | bytearray) -> str:
    """A line as it is told in an error."""
    text = line.decode(errors="backslashreplace").strip()
    return repr(text if len(text) <= SHOWN else text[:SHOWN] + "...")


class Program:
    """A program that runs. Once it broke down it has ended: whoever goes on starts another one."""

    def __init__(self, command: tuple[str, ...]) -> None:
        self.words = tempfile.TemporaryFile()  # noqa: SIM115, closed when the program is stopped
        self.unread = bytearray()
        self.keeper = subprocess.Popen(
            [sys.executable, "-I", "-S", keeper.__file__, *command],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.words,
            start_new_session=True,
        )
        assert self.keeper.stdin is not None
        assert self.keeper.stdout is not None
        self.stdin, self.stdout = self.keeper.stdin, self.keeper.stdout
        atexit.register(self.stop)

    def stop(self) -> None:
        """Ends the program, and waits for that."""
        for stream in (self.stdin, self.stdout, self.words):
            with suppress(BrokenPipeError):
                stream.close()
        self.keeper.wait()
        atexit.unregister(self.stop)

    def breakdown(self, what: str) -> SubjectError:
        """The error that tells what the program did, and the last line that it wrote to stderr; it is stopped."""
        size = os.fstat(self.words.fileno()).st_size
        lines = os.pread(self.words.fileno(), CHUNK, max(size - CHUNK, 0)).splitlines()
        last = next((f"; its last words: {shown(line)}" for line in reversed(lines) if line.strip()), "")
        self.stop()
        return SubjectError(f"the program {what}{last}")

    def exchange(self, line: bytes, seconds: float | None = None) -> bytes:
        """The line that the program answers to a line, within so many seconds; SubjectError if it does not."""
        deadline = None if seconds is None else time.monotonic() + seconds
        if self._readable(0.0):
            self._read()
            raise self.breakdown(f"wrote what nobody had asked for, {shown(self.unread)}")
        with suppress(BrokenPipeError):
            self.stdin.write(line + b"\n")
            self.stdin.flush()
        while b"\n" not in self.unread[-CHUNK:]:
            if deadline is not None and not self._readable(deadline - time.monotonic()):
                raise self.breakdown(f"wrote no line within {seconds:g} s")
            if len(self.unread) > LONGEST:
                raise self.breakdown(f"wrote more than {LONGEST} bytes without an end of line")
            self._read()
        answer, _, rest = bytes(self.unread).partition(b"\n")
        self.unread[:] = b""
        if rest:
            raise self.breakdown(f"wrote more than one line, {shown(rest)} after {shown(answer)}")
        return answer

    def _readable(self, seconds: float) -> bool:
        listener = select.poll()
        listener.register(self.stdout, select.POLLIN)
        return bool(listener.poll(max(seconds, 0.0) * 1000))

    def _read(self) -> None:
        chunk = os.read(self.stdout.fileno(), CHUNK)
        if not chunk:
            raise self.breakdown(self._end())
        self.unread += chunk

    def _end(self) -> str:
        try:
            status = self.keeper.wait(2 * keeper.GRACE)
        except subprocess.TimeoutExpired:
            return "closed its stdout"
        with suppress(ValueError):
            return f"was ended by {signal.Signals(status - 128).name}"
        return f"ended with status {status}"
