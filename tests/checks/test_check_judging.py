"""Judging alone: it prints nothing, stores nothing and reads no progress."""

import builtins
import io
import os
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest

from labutils.checks import check, hint
from labutils.checks.calls import split_answer
from labutils.checks.judging import judge
from labutils.checks.progress_rules import FILE_NAME
from labutils.checks.table import Misfit, load_table
from labutils.checks.writing import encode
from solutions import QUALITY_POINTS
from solutions import load_exercises as load_cards

NAME = "intrinsics_matrix"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    "function",
    [None, lambda *_: None, lambda *_: np.eye(3), lambda *_: 1 / 0, load_cards()[NAME].reference],
)
def test_judging_neither_prints_nor_opens_a_file(
    function: object,
    folder: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (folder / FILE_NAME).write_bytes(b"{ damaged")
    table = load_table(NAME)
    judge(table, function)  # what is read once and kept: the source of the function, MuJoCo

    def refuse(*args: object, **_: object) -> NoReturn:
        raise AssertionError(f"opened {args[0]}")

    with monkeypatch.context() as patch:
        for module, name in ((builtins, "open"), (io, "open"), (os, "open"), (os, "replace")):
            patch.setattr(module, name, refuse)
        verdict = judge(table, function)
    assert verdict.result in ("passed", "failed")
    assert capsys.readouterr() == ("", "")
    assert (folder / FILE_NAME).read_bytes() == b"{ damaged"
    assert [path.name for path in folder.iterdir()] == [FILE_NAME]


def test_check_gives_the_verdict_of_judging_and_keeps_it(folder: Path) -> None:
    def wrong(*_: object) -> np.ndarray:
        return np.eye(3)

    assert check(NAME, wrong).paragraphs == judge(load_table(NAME), wrong).paragraphs
    hint(NAME)
    assert [path.name for path in folder.iterdir()] == [FILE_NAME]


def test_object_whose_name_ends_in_none_is_an_answer_and_no_empty_function() -> None:
    odd = type("Better than None", (), {})
    verdict = judge(load_table(NAME), lambda *_: odd())
    assert verdict.property == "type"
    assert verdict.paragraphs[0] == "Expected numbers, yours is a Better than None."
    assert judge(load_table(NAME), lambda *_: ...).paragraphs[0] == "Not started yet."


def test_emptiness_is_neither_stored_nor_compared() -> None:
    parts = load_table("depth_to_pointcloud").parts
    empty = split_answer(parts, None, ())
    other = split_answer(parts, 5, ())
    assert isinstance(empty, Misfit)
    assert isinstance(other, Misfit)
    assert empty.is_empty
    assert not other.is_empty
    assert encode(empty, {}) == {"misfit": empty.text}
    assert Misfit(empty.text) == empty


def test_points_for_quality_stand_on_the_report(folder: Path) -> None:
    from labutils.checks import report  # noqa: PLC0415 - beside the name of the module

    assert f"and {QUALITY_POINTS} more for code quality." in report(folder).summary[0]
