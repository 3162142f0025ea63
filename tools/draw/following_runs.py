"""Run the controllers of the chapter on following, and keep what came of it.

Two files in ``book/_generated``: ``following.json`` holds the curves that
`tools/draw/following_figures.py` draws, ``following.md`` the table of the page. The controllers
are those of the page itself, and the worked answer on the card of the challenge.

Run it as ``python -m tools.draw.following_runs``; it takes minutes.
"""

from __future__ import annotations

import ast
import json
import re
from concurrent.futures import ProcessPoolExecutor
from hashlib import sha256
from multiprocessing import get_context
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from labutils.following import FollowingLoop
from solutions.control import control as worked
from tools import ROOT

if TYPE_CHECKING:
    from collections.abc import Callable

    from labutils.following import FollowingRecord

PAGE = ROOT / "book" / "following.md"
DATA = ROOT / "book" / "_generated" / "following.json"
TABLE = ROOT / "book" / "_generated" / "following.md"

CELL = re.compile(
    r"^```\{code-cell\}[^\n]*\n(?:---\n.*?^---\n|:[^\n]*\n)?(.*?)^```$", re.MULTILINE | re.DOTALL
)
#: What makes no picture and runs no loop when it is executed.
DEFINING = (ast.Import, ast.ImportFrom, ast.FunctionDef, ast.Assign)
#: Of the table, and of the curves and points of the figures, which are scaled to the first.
SIZE, SMALL = (640, 480), (160, 120)
SEEDS = range(5)
#: Name in the table, and the function of the page; the last one is the card's.
TABLED = {
    "one look, then nothing": "open_loop",
    "proportional": "proportional",
    "predicting": "predicting",
    "a worked answer": "worked",
}
RUN_S, SHORT_S = 8.0, 4.0
GAINS = (0.25, 0.5, 1.0, 1.5, 2.0, 3.0)
DELAYS = (0, 1, 2, 3)
#: Digits that are kept: more than a figure shows.
DIGITS = 2


class Run(NamedTuple):
    """What is run: a controller by name, for how long, and how the loop is made."""

    controller: str
    size: tuple[int, int]
    seconds: float
    settings: tuple[tuple[str, Any], ...]


def make_runs() -> dict[str, list[Run]]:
    """List all runs, by what they are for."""
    calm = {"seed": 0, "hidden": ()}
    return {
        "table": [
            make_run(name, SIZE, RUN_S, seed=seed) for name in TABLED.values() for seed in SEEDS
        ],
        "gains": [make_run("proportional", SMALL, SHORT_S, **calm, gain=gain) for gain in GAINS],
        "delays": [
            make_run(name, SMALL, SHORT_S, **calm, delay=delay)
            for name in ("pose_of_now", "proportional", "predicting")
            for delay in DELAYS
        ],
        "still": [
            make_run(name, SMALL, SHORT_S, **calm, speed=0.0, delay=2)
            for name in ("pose_of_now", "proportional")
        ],
    }


def make_run(controller: str, size: tuple[int, int], seconds: float, **settings: Any) -> Run:
    """Write a run down, so that it can be sent to another process and compared."""
    return Run(controller, size, seconds, tuple(sorted(settings.items())))


def load_controllers() -> dict[str, Callable[..., Any]]:
    """Return the controllers of the page, what is made of them, and the worked answer."""
    scope: dict[str, Any] = {}
    exec(compile(read_definitions(), str(PAGE), "exec"), scope)  # noqa: S102 - our own page
    return {
        "open_loop": make_open_loop(scope["proportional"]),
        "proportional": scope["proportional"],
        "pose_of_now": make_stale(scope["proportional"]),
        "predicting": scope["predicting"],
        "worked": worked,
    }


def read_definitions() -> str:
    """Return the cells of the page that only define, as one text."""
    cells = CELL.findall(PAGE.read_text(encoding="utf-8"))
    return "\n".join(cell for cell in cells if is_defining(cell))


def is_defining(cell: str) -> bool:
    """Tell whether a cell holds imports, functions and constants only."""
    return all(
        isinstance(part, DEFINING)
        and (not isinstance(part, ast.Assign) or isinstance(part.value, (ast.Tuple, ast.Constant)))
        and "explorers" not in (getattr(part, "module", None) or "")
        for part in ast.parse(cell).body
    )


def make_open_loop(control: Callable[..., Any]) -> Callable[..., Any]:
    """Let a controller look once, and then repeat its first answer."""

    def look_once(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        memory = state.memory
        if "command" not in memory:
            memory["command"] = control(rgb, depth, K, state)
        return memory["command"]

    return look_once


def make_stale(control: Callable[..., Any]) -> Callable[..., Any]:
    """Let a controller believe that the picture was taken in the pose of now."""

    def believe(rgb: Any, depth: Any, K: Any, state: Any) -> Any:
        now = {"seen_pan": state.pan, "seen_tilt": state.tilt}
        return control(rgb, depth, K, type(state)(**{**vars(state), **now}))

    return believe


def do(run: Run) -> dict[str, Any]:
    """Run it, and keep the curve and the score."""
    with FollowingLoop(*run.size, **dict(run.settings)) as loop:
        record = loop.run(load_controllers()[run.controller], run.seconds)
    kept = summarize(record, SIZE[0] / run.size[0])
    return {"controller": run.controller, "settings": dict(run.settings), **kept}


def summarize(record: FollowingRecord, scale: float) -> dict[str, Any]:
    """Round what is kept, so that it can be compared; what was not measured is null."""
    score = record.get_score()
    score = score._replace(mean_px=scale * score.mean_px)
    return {
        "error_px": np.round(scale * record.error_px, DIGITS).tolist(),
        "hidden": record.time[record.is_hidden].round(DIGITS).tolist(),
        "score": {
            name: round(value, DIGITS) if np.isfinite(value) else None
            for name, value in score._asdict().items()
        },
    }


def measure() -> dict[str, Any]:
    """Do all runs, on all cores."""
    runs = make_runs()
    # A copy of a process that has drawn, or whose OpenCV has threads, may wait for ever.
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        done = {name: list(pool.map(do, some)) for name, some in runs.items()}
    return {"made_from": get_stamp(), **done}


def get_stamp() -> str:
    """Return a checksum of the page's code and of what is run; a slow test repeats the runs."""
    return sha256(f"{read_definitions()}{make_runs()}".encode()).hexdigest()[:16]


def make_table(done: dict[str, Any]) -> str:
    """Write the table of the page."""
    rows = []
    for title, name in TABLED.items():
        scores = [one["score"] for one in done["table"] if one["controller"] == name]
        cells = (
            say_range(scores, "mean_px", 1, "lost"),
            say_range(scores, "recovery_s", 2, "not in each run"),
            say_range(scores, "center_mm", 1, "not told"),
        )
        rows.append(f"| {title} | {' | '.join(cells)} |")
    return "\n".join(
        [
            "<!-- Made by tools/draw/following_runs.py. -->",
            "",
            ":::{table} Five seeds, smallest to largest",
            "| controller | mean distance, px | found again after, s | center off by, mm |",
            "|---|---:|---:|---:|",
            *rows,
            ":::",
            "",
        ]
    )


def say_range(scores: list[dict[str, Any]], name: str, digits: int, otherwise: str) -> str:
    """Write the smallest and the largest of some numbers, or words where one is missing."""
    values = [score[name] for score in scores]
    if any(value is None for value in values):
        return otherwise
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def main() -> None:
    """Write both files."""
    done = measure()
    lines = [f"{json.dumps(name)}: {json.dumps(value)}" for name, value in done.items()]
    DATA.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    TABLE.write_text(make_table(done), encoding="utf-8")
    print(make_table(done))


if __name__ == "__main__":
    main()
