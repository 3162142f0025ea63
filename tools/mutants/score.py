"""Score the cases of all cards against mutants of their references: what `make mutants` runs.

Writes ``solutions/_generated/mutants.json``, which tests read, and the same as a table for people,
``mutants.md``. With names of exercises only these are scored anew. With fewer draws or seeds
nothing is written: the scores are printed.
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import cv2

from solutions import load_exercises
from tools import ROOT
from tools.mutants.inputs import SEEDS, count_draws, count_seeds
from tools.mutants.judge import Judge
from tools.mutants.reasons import get_reason

if TYPE_CHECKING:
    from solutions import Exercise

SCORES = Path("solutions/_generated/mutants.json")
TABLE = Path("solutions/_generated/mutants.md")

#: Which share of the mutants that differ has to be refused, by the visible cases, and by the hidden
#: ones of the worst seed.
VISIBLE_LIMIT, HIDDEN_LIMIT = 0.95, 0.97


@dataclass(frozen=True)
class Score:
    """How the mutants of one exercise ended."""

    #: All mutants; on how many draws they were compared; how many differed on one of them.
    mutants: int
    draws: int
    differing: int
    #: Those that the visible cases let pass, and those that hidden cases do, with how many seeds.
    visible: list[str]
    hidden: dict[str, int]
    #: How many the hidden cases of the worst seed let pass.
    worst: int

    @property
    def visible_share(self) -> float:
        """Share of the differing mutants that the visible cases refuse."""
        return 1 - len(self.visible) / self.differing

    @property
    def hidden_share(self) -> float:
        """Share of the differing mutants that the hidden cases of the worst seed refuse."""
        return 1 - self.worst / self.differing


def main(arguments: list[str] | None = None) -> int:
    """Score, print and write; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="exercises; all without")
    parser.add_argument("--draws", type=int, help="compare on this many inputs, write nothing")
    parser.add_argument("--seeds", type=int, default=SEEDS, help="fewer than 50: write nothing")
    options = parser.parse_args(arguments)
    cv2.setNumThreads(1)  # pictures this small are slower with more
    exercises = load_exercises()
    scores = read_scores()
    for name in options.names or exercises:
        draws = min(options.draws or count_draws(name), count_draws(name))
        seeds = min(options.seeds, count_seeds(name))
        score = scores[name] = score_exercise(exercises[name], draws, seeds)
        print(
            f"{name}: {score.mutants} mutants, {score.differing} differ, visible cases refuse "
            f"{score.visible_share:.1%}, hidden ones {score.hidden_share:.1%}",
            flush=True,
        )
        if options.draws or options.seeds != SEEDS:
            _print_survivors(exercises[name], score)
        else:
            write_scores(scores)
    return 0


def score_exercise(exercise: Exercise, draws: int, seeds: int) -> Score:
    """Run all mutants of one exercise."""
    judge = Judge(exercise, draws, seeds)
    differing = 0
    visible: list[str] = []
    hidden: dict[str, int] = {}
    passed = [0] * seeds
    for mutant in judge.mutants:
        function = judge.make(mutant)
        if not judge.differs(mutant, function):
            continue
        differing += 1
        if not judge.is_refused(function, judge.visible):
            visible.append(mutant.id)
        for seed, tables in enumerate(judge.hidden):
            if not judge.is_refused(function, tables):
                passed[seed] += 1
                hidden[mutant.id] = hidden.get(mutant.id, 0) + 1
    return Score(len(judge.mutants), draws, differing, visible, hidden, max(passed))


def read_scores() -> dict[str, Score]:
    """Read the scores of the last full run, in the order of the book."""
    path = ROOT / SCORES
    stored = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    return {name: Score(**words) for name, words in stored.items()}


def write_scores(scores: dict[str, Score]) -> None:
    """Write the scores and the table."""
    ordered = {name: scores[name] for name in load_exercises() if name in scores}
    words = {name: asdict(score) for name, score in ordered.items()}
    (ROOT / SCORES).write_text(json.dumps(words, indent=1) + "\n", encoding="utf-8")
    (ROOT / TABLE).write_text(make_table(ordered), encoding="utf-8")


def make_table(scores: dict[str, Score]) -> str:
    """Write the scores for people: a row per exercise, then what survives and why."""
    lines = [
        "# How many wrong functions the cases refuse",
        "",
        "<!-- Written by tools/mutants/score.py: run `make mutants`. -->",
        "",
        (
            "A mutant is the reference with one small fault. Counted are those that differ from "
            "the reference on one of the inputs drawn: valid ones, the same every time, fewer "
            "where a call takes long (scenes of MuJoCo, RANSAC). What acts in loops differs where "
            "a property of its loop is lost, and has 3 seeds. Guards of arguments are mutated "
            "too: the fault that counts there is to refuse what is valid. The hidden cases are "
            "those of the worst of "
            f"{SEEDS} seeds; refused have to be {VISIBLE_LIMIT:.0%} by the visible cases and "
            f"{HIDDEN_LIMIT:.0%} by the hidden ones."
        ),
        "",
        "| Exercise | Mutants | Inputs | Differ | Visible cases refuse | Hidden cases refuse |",
        "|---|---:|---:|---:|---:|---:|",
    ]
    for name, score in scores.items():
        lines.append(
            f"| `{name}` | {score.mutants} | {score.draws} | {score.differing} "
            f"| {score.visible_share:.1%} | {score.hidden_share:.1%} |"
        )
    for name, score in scores.items():
        if survivors := list(dict.fromkeys([*score.visible, *score.hidden])):
            lines += ["", f"## What passes in `{name}`", ""]
            lines += ["| Mutant | Visible | Hidden, seeds | Why |", "|---|---|---:|---|"]
            changes = {one.id: one.change for one in Judge(load_exercises()[name], 0, 0).mutants}
            for one in survivors:
                function = one.split(":")[1]
                change = changes.get(one, "no longer a mutant").replace("|", "\\|")
                lines.append(
                    f"| `{function}`: {change} | {'passes' if one in score.visible else ''} "
                    f"| {score.hidden.get(one, 0) or ''} | {get_reason(one)} |"
                )
    return "\n".join(lines) + "\n"


def _print_survivors(exercise: Exercise, score: Score) -> None:
    changes = {one.id: one.change for one in Judge(exercise, 0, 0).mutants}
    for one in dict.fromkeys([*score.visible, *score.hidden]):
        seen = "visible " if one in score.visible else ""
        print(f"  {one}  {changes[one]}  passes {seen}{score.hidden.get(one, 0)} seeds")


if __name__ == "__main__":
    sys.exit(main())
