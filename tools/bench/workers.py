"""Routes in processes of their own, which agree first and then take turns.

In a shared process the routes would inherit each other's heap, and on Linux that decides what they
cost: see the page book/speed.md. For the same reason `SETTINGS` has two kinds of process, one with
everything as installed and one where the C library keeps freed memory and waiting threads sleep.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from typing import IO, TYPE_CHECKING, cast

import numpy as np

from tools import ROOT
from tools.environments import NoEnvironmentError, make_environment

if TYPE_CHECKING:
    from pathlib import Path
# What the GNU C library needs to hear to keep memory; other systems ignore the variable.
_KEEP = 1 << 28
KEEP_MEMORY = {
    "GLIBC_TUNABLES": ":".join(
        f"glibc.malloc.{name}={_KEEP}" for name in ("trim_threshold", "mmap_threshold", "top_pad")
    )
}
# Threads that wait by spinning take the processor from each other on a machine with few cores.
PATIENT_THREADS = {"OMP_WAIT_POLICY": "passive"}

#: Column of a table to the variables its processes get.
SETTINGS = {"as installed": {}, "tuned": KEEP_MEMORY | PATIENT_THREADS}

# Between two turns: threads of the last route that still spin have gone to sleep by then.
PAUSE_S = 0.02

TOLERANCE = 1e-5  # meters and shares of color: float32 against float64

#: Seconds of all runs of every route.
Seconds = dict[str, list[float]]


@dataclass(frozen=True)
class Entry:
    """A route as the table lists it."""

    label: str
    #: The module whose `make_route` builds it.
    module: str = "tools.bench.routes"
    #: False where it does less than the others, so that its result cannot agree.
    comparable: bool = True
    #: False where its threads hand over the points in any order.
    ordered: bool = True
    #: One of `tools.environments`, where it needs what the book does not install.
    environment: str = ""
    variables: dict[str, str] = field(default_factory=dict)


class Worker:
    """A process that runs one route when it is its turn."""

    def __init__(
        self, route: str, entry: Entry, python: str, frame: Path, variables: dict[str, str]
    ) -> None:
        self.route, self.entry = route, entry
        self.process = subprocess.Popen(
            [python, "-m", entry.module, route, str(frame)],
            cwd=ROOT,
            env=os.environ | variables | entry.variables,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.asked = cast("IO[str]", self.process.stdin)
        self.answers = cast("IO[str]", self.process.stdout)

    def ask(self, command: str) -> str:
        """Send one line, return the answer."""
        with suppress(BrokenPipeError):  # where it has stopped, no answer comes either
            self.asked.write(command + "\n")
            self.asked.flush()
        answer = self.answers.readline().strip()
        if not answer:
            raise SystemExit(f"bench: the route {self.route!r} stopped; its error is above")
        return answer

    def stop(self) -> None:
        """End the process and wait for it."""
        with suppress(BrokenPipeError):
            self.asked.close()
        self.process.wait()
        self.answers.close()


@lru_cache
def find_python(environment: str) -> str | None:
    """Return the Python of an environment, "" for this one; None where it cannot be made."""
    if not environment:
        return sys.executable
    try:
        return str(make_environment(environment))
    except NoEnvironmentError as error:
        print(f"bench: {environment} is not measured: {error}", file=sys.stderr, flush=True)
        return None


def measure_group(
    entries: dict[str, Entry], frame: Path, variables: dict[str, str], rounds: int, burst: int
) -> Seconds:
    """Verify that the routes agree, then let them take turns; return seconds per route."""
    workers = [
        Worker(route, entry, python, frame, variables)
        for route, entry in entries.items()
        if (python := find_python(entry.environment))
    ]
    try:
        verify(workers, frame)
        for worker in workers:  # lazy imports, the heap's own habits
            worker.ask("run 5")
        seconds: Seconds = {worker.route: [] for worker in workers}
        for turn in range(rounds):
            # Another one starts every time, so none always follows the same neighbor.
            start = turn % len(workers)
            for worker in workers[start:] + workers[:start]:
                time.sleep(PAUSE_S)
                answer = [float(word) for word in worker.ask(f"run {burst}").split()]
                seconds[worker.route].extend(answer[1:] or answer)
    finally:
        for worker in workers:
            worker.stop()
    return seconds


def verify(workers: list[Worker], frame: Path) -> None:
    """Stop unless every route that claims the same result gives it."""
    with np.load(frame) as file:
        K = file["K"]
    reference = None
    for worker in workers:
        path = frame.with_name("result.npz")
        worker.ask(f"save {path}")
        if not worker.entry.comparable:
            continue
        with np.load(path) as file:
            result = [file[name] for name in file.files]
        if not worker.entry.ordered:
            result = sort_by_pixel(result, K)
        if reference is None:
            reference = result
        if not all(map(is_same, reference, result)) or len(reference) != len(result):
            raise SystemExit(f"bench: {worker.route!r} does not give the result of the others")


def is_same(ours: np.ndarray, theirs: np.ndarray) -> bool:
    """Tell whether two results agree, where either may give colors as bytes."""
    ours, theirs = (part / 255 if part.dtype == np.uint8 else part for part in (ours, theirs))
    return ours.shape == theirs.shape and np.allclose(ours, theirs, rtol=0, atol=TOLERANCE)


def sort_by_pixel(result: list[np.ndarray], K: np.ndarray) -> list[np.ndarray]:
    """Sort points in the camera frame, and their colors, row by row of the picture."""
    x, y, z = result[0].T
    u, v = np.round(K[0, 0] * x / z + K[0, 2]), np.round(K[1, 1] * y / z + K[1, 2])
    order = np.lexsort((u, v))
    return [part[order] for part in result]
