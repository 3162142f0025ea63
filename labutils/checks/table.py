"""What a check knows of an exercise: its frozen cases, right answers and known wrong answers.

A table holds outputs, never code: nothing a learner installs can be read to find how an answer is
computed. Tables are written by ``make exercises`` from the instructor's cards, stored as one JSON
file of words and one array file per exercise.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from labutils.checks.loops.scenario import Loop

#: Where the frozen tables lie.
TABLES = Path(__file__).with_name("tables")
WORDS = "exercises.json"
COMPLETIONS = "completions.json"


@dataclass(frozen=True)
class Scene:
    """A MuJoCo scene an argument is made of, kept as text so that no table needs MuJoCo.

    ``gives`` names the arguments made from it: "model", then "data", then "renderer".
    The positions `qpos` are set after the scene was forwarded, as a simulation leaves them.
    """

    xml: str
    gives: tuple[str, ...] = ("model",)
    qpos: tuple[float, ...] = ()
    width: int = 0
    height: int = 0


@dataclass(frozen=True)
class Raised:
    """An answer that is an exception.

    For the message only: `line`, the learner's own, and `advice`, what the exception means there.
    """

    kind: str
    text: str = ""
    line: str = field(default="", compare=False)
    base_kinds: tuple[str, ...] = field(default=(), compare=False)
    advice: str = field(default="", compare=False)


@dataclass(frozen=True)
class Misfit:
    """An answer that cannot be taken apart into the expected parts.

    `is_empty` says that nothing came: None, or the ``...`` of a body that nobody has begun.
    """

    text: str
    is_empty: bool = field(default=False, compare=False)


Parts: TypeAlias = "tuple[np.ndarray | None, ...]"
Outcome: TypeAlias = "Parts | Raised | Misfit"


@dataclass(frozen=True)
class Case:
    """One call: what it shows in words, its arguments, and the exception due, if one is."""

    label: str
    args: tuple[Any, ...]
    raises: str = ""


@dataclass(frozen=True)
class Part:
    """One thing a function returns, and what counts as right.

    Parameters
    ----------
    name, kind : str
        What it is called, and which of `labutils.checks.kinds` it is: how it has to look, how it
        is compared, told and drawn.
    dtype : str
        "float", "uint8", "int", "bool" or "str".
    atol : float
        How far a value may be off.
    share : float
        Which share of the values may be off by more.
    unit : str
        For messages.
    low, high : float or str or None
        Limits of the range gate; a str names the parameter that holds the limit.
    values : tuple of int
        The only values allowed.
    nullable : bool
        Whether None can be right.
    note : str
        For a flag: what is wrong when it is not set. For others: a reminder in type messages.
    """

    name: str
    kind: str
    dtype: str
    atol: float = 0.0
    share: float = 0.0
    unit: str = ""
    low: float | str | None = None
    high: float | str | None = None
    values: tuple[int, ...] = ()
    nullable: bool = False
    note: str = ""


@dataclass(frozen=True)
class Simpler:
    """Cases without one complication: its name, "words" that follow "as soon as", the cases.

    ``of`` are the numbers of the cases that they were made from.
    """

    name: str
    words: str
    of: tuple[int, ...]
    cases: tuple[Case, ...]
    expected: tuple[Outcome, ...]


@dataclass(frozen=True)
class CheckTable:
    """Everything `check` needs for one exercise."""

    name: str
    title: str
    #: What the report calls its chapter, and whether that is "required" or an "extension".
    chapter: str
    kind: str
    points: int
    parameters: tuple[str, ...]
    section: str
    parts: tuple[Part, ...]
    hints: tuple[str, ...]
    misconceptions: dict[str, str]
    cases: tuple[Case, ...]
    expected: tuple[Outcome, ...]
    #: Names of the mistakes made at once (one or two) to the answers that come out.
    wrong: dict[tuple[str, ...], tuple[Outcome, ...]]
    #: Mistakes that are explained in another section than the exercise.
    links: dict[str, str] = field(default_factory=dict)
    #: The arguments, and entries of them, that make a difference: probes ask for no others.
    matters: tuple[str, ...] = ()
    #: Simpler cases, for whoever is wrong: tried in this order.
    simpler: tuple[Simpler, ...] = ()
    #: Of a completion: how many values its starter leaves open, and the exercise it leads to.
    open_lines: int = 0
    leads_to: str = ""

    def with_cases(self, cases: tuple[Case, ...], expected: tuple[Outcome, ...]) -> CheckTable:
        """Return a table of other cases: of these, no wrong answers are known."""
        return replace(self, cases=cases, expected=expected, wrong={}, simpler=())

    @property
    def signature(self) -> str:
        """How the function is called."""
        return f"{self.name}({', '.join(self.parameters)})"

    @property
    def needs_mujoco(self) -> bool:
        """Whether a case is made from a scene, or acts in one."""
        return any(isinstance(value, Scene | Loop) for case in self.cases for value in case.args)


class TableError(Exception):
    """A table is missing or cannot be read: a fault of the installation, never of the learner."""


@cache
def read_words(folder: Path = TABLES) -> dict[str, Any]:
    """Read the words of all exercises, in the order of the book."""
    return _read_json(folder / WORDS)


@cache
def read_completions(folder: Path = TABLES) -> dict[str, Any]:
    """Read the words of all completions, in the order of the book."""
    return _read_json(folder / COMPLETIONS)


def _read_json(path: Path) -> dict[str, Any]:
    try:
        words = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise TableError(f"the check tables cannot be read ({error})") from error
    return dict(words)


def find_words(name: str, folder: Path = TABLES) -> dict[str, Any]:
    """Return the words of an exercise or completion; raise KeyError where there is none."""
    known = read_words(folder)
    return dict(known[name] if name in known else read_completions(folder)[name])


@cache
def load_table(name: str, folder: Path = TABLES) -> CheckTable:
    """Read the table of one exercise or completion; raise KeyError where there is none."""
    words = find_words(name, folder)
    try:
        with np.load(folder / f"{name}.npz", allow_pickle=False) as stored:
            arrays = {key: stored[key] for key in stored.files}
    except (OSError, ValueError) as error:
        raise TableError(f"the check table of {name} cannot be read ({error})") from error
    for array in arrays.values():
        array.setflags(write=False)

    def outcomes(items: list[Any]) -> tuple[Outcome, ...]:
        return tuple(_decode(item, arrays) for item in items)

    return CheckTable(
        name=name,
        title=words["title"],
        chapter=words["chapter"],
        kind=words["kind"],
        points=words["points"],
        parameters=tuple(words["parameters"]),
        section=words["section"],
        parts=tuple(_make_part(item) for item in words["parts"]),
        hints=tuple(words["hints"]),
        misconceptions=dict(words["misconceptions"]),
        cases=tuple(
            Case(item["label"], _decode(item["args"], arrays), item["raises"])
            for item in words["cases"]
        ),
        expected=outcomes(words["expected"]),
        wrong={tuple(item["made"]): outcomes(item["answers"]) for item in words["wrong"]},
        links=dict(words["links"]),
        matters=tuple(words["matters"]),
        simpler=tuple(
            Simpler(
                item["name"],
                item["words"],
                tuple(item["of"]),
                tuple(Case("", _decode(args, arrays)) for args in item["cases"]),
                outcomes(item["expected"]),
            )
            for item in words["simpler"]
        ),
        open_lines=words.get("open_lines", 0),
        leads_to=words.get("leads_to", ""),
    )


def _make_part(item: dict[str, Any]) -> Part:
    return Part(**{**item, "values": tuple(item.get("values", ()))})


def _decode(item: Any, arrays: dict[str, np.ndarray]) -> Any:  # noqa: PLR0911 - one per form
    """Undo `labutils.checks.writing.encode`."""
    if not isinstance(item, dict):
        return item
    ((form, content),) = item.items()
    if form == "array":
        return arrays[content]
    if form == "mask":
        key, shape = content
        bits = np.unpackbits(arrays[key], count=int(np.prod(shape))).reshape(shape)
        mask = (bits * np.uint8(255)).astype(np.uint8)
        mask.setflags(write=False)
        return mask
    if form == "raised":
        return Raised(*content)
    if form == "misfit":
        return Misfit(content)
    if form == "scene":
        xml, gives, qpos, width, height = content
        return Scene(xml, tuple(gives), tuple(qpos), width, height)
    if form == "loop":
        return Loop.from_words(content)
    return tuple(_decode(one, arrays) for one in content)
