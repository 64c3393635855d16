"""Runs a program, and ends it with all that it started once nobody is left who could speak to it.

Started as a script, with the program's command line for its arguments; stdin, stdout and stderr are the program's. The
other end of stdin closes when whoever holds it ends, however that comes about. A program that minds it ends by itself;
one that does not, because it computes or hangs, is killed. Exits like a shell: 128 and its number for a signal, 126 if
the program does not start. Nothing but Python itself is imported, so that it starts at once.
"""

import os
import select
import signal
import subprocess
import sys
from contextlib import suppress

GLANCE = 50
"""Milliseconds between two looks whether the program has ended."""

GRACE = 0.5
"""Seconds that a program has to end by itself after its stdin was closed."""


def keep(command: list[str]) -> int:
    """The exit status of the program, once it has ended and all that it started."""
    try:
        program = subprocess.Popen(command, start_new_session=True)
    except OSError as error:
        print(error, file=sys.stderr)
        return 126
    # The program alone may hold this, or the other side would not see it end.
    os.close(sys.stdout.fileno())
    listener = select.poll()
    listener.register(sys.stdin.fileno(), 0)
    while program.poll() is None and not listener.poll(GLANCE):
        pass
    with suppress(subprocess.TimeoutExpired):
        program.wait(GRACE)
    with suppress(ProcessLookupError):
        os.killpg(program.pid, signal.SIGKILL)
    status = program.wait()
    return status if status >= 0 else 128 - status


if __name__ == "__main__":
    os._exit(keep(sys.argv[1:]))
