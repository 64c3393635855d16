"""Where work is done: in this process, or in several, where a call that hangs can be stopped."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from typing import Any, Protocol

from pebble import ProcessPool

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
"""What the linear algebra libraries under NumPy and SciPy read, when they are loaded."""


class Executor(Protocol):
    """Runs a picklable function; its future fails with TimeoutError when ``timeout`` seconds have passed."""

    def __call__(self, function: Callable[..., Any], *args: Any, timeout: float | None = None) -> Future[Any]:
        """Starts one call."""


def here(function: Callable[..., Any], *args: Any, timeout: float | None = None) -> Future[Any]:
    """Runs the call at once, in this process, where nothing can stop it: the time limit does not hold."""
    future: Future[Any] = Future()
    try:
        future.set_result(function(*args))
    except Exception as error:
        future.set_exception(error)
    return future


@contextmanager
def _interrupts_blocked() -> Iterator[None]:
    """Blocks Ctrl-C for the threads and processes started meanwhile: it is the parent's to answer."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _one_thread_a_process() -> Iterator[None]:
    """Has the processes spawned meanwhile use one thread each: idle threads of a linear algebra library spin."""
    before = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


@contextmanager
def executor(jobs: int) -> Iterator[Executor]:
    """An executor of that many processes; with one job, this process.

    The processes are spawned, not forked: a fork would copy the threads' locks of whatever the subject imported.
    """
    if jobs == 1:
        yield here
        return
    context = multiprocessing.get_context("spawn")
    with (
        _one_thread_a_process(),
        ProcessPool(max_workers=jobs, context=context) as pool,
    ):

        def submit(function: Callable[..., Any], *args: Any, timeout: float | None = None) -> Future[Any]:
            future: Future[Any] = pool.schedule(function, args=args, timeout=timeout)
            return future

        with _interrupts_blocked():
            # Asked whether it is active, the pool starts its threads; they and the processes inherit what is blocked.
            pool.active  # noqa: B018
        try:
            yield submit
        except BaseException:
            pool.stop()  # type: ignore[no-untyped-call]
            raise
