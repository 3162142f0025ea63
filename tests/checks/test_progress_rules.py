"""One schema of progress files: Python and the page take and refuse the same ones."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from labutils.checks.progress import Prediction, Progress, load_progress, save_progress
from labutils.checks.progress_rules import FILE_NAME, MAX_CHARACTERS
from tests.helpers.node import run_node

ROOT = Path(__file__).resolve().parents[2]
FILES = ROOT / "tests" / "fixtures" / "progress"
GOOD = sorted((FILES / "good").glob("*.json"))
BAD = sorted((FILES / "bad").glob("*.json"))
FAULTS: dict[str, str] = json.loads((FILES / "faults.json").read_text(encoding="utf-8"))

#: Gives texts to the scripts of the page, which read them as progress files; tells what they say.
READ_PROGRESS = """
import { readFileSync } from "node:fs";
import vm from "node:vm";
const [, ...scripts] = process.argv;
globalThis.window = globalThis;
globalThis.addEventListener = () => {}; // there is no other tab
globalThis.document = new EventTarget(); // who hears of a change is another test's matter
const told = JSON.parse(readFileSync(0)).map((files) => {
  try {
    localStorage.clear(); // and scripts anew, as in a new tab
    for (const script of scripts) vm.runInThisContext(readFileSync(script, "utf8"));
    const { merge, parse, text } = window.cameraLab.progress;
    for (const given of files) merge(parse(given)); // one after the other
    return text();
  } catch (error) {
    return `refused: ${error.message}`;
  }
});
console.log(JSON.stringify(told));
"""
#: Node has no storage of its own.
STORAGE = """
const kept = new Map();
Object.defineProperty(globalThis, "localStorage", { value: {
  clear: () => kept.clear(),
  getItem: (key) => kept.get(key) ?? null,
  setItem: (key, value) => kept.set(key, value),
  removeItem: (key) => kept.delete(key),
}});
"""


def ask_page(*texts: str | list[str]) -> list[str]:
    """What the page makes of files, or of several in turn: what it would write, or why not."""
    scripts = (
        str(ROOT / "book/_page_python" / name) for name in ("progress_rules.js", "progress.js")
    )
    told = run_node(
        STORAGE + READ_PROGRESS,
        *scripts,
        given=json.dumps([[text] if isinstance(text, str) else text for text in texts]),
    )
    return list(json.loads(told))


def test_every_bad_file_has_its_sentence() -> None:
    assert [path.stem for path in BAD] == sorted(FAULTS)
    assert len(GOOD) > 5


def test_the_page_reads_good_files_as_the_library_does(tmp_path: Path) -> None:
    for path, told in zip(GOOD, ask_page(*(one.read_text("utf-8") for one in GOOD)), strict=True):
        (tmp_path / FILE_NAME).write_bytes(path.read_bytes())
        progress = load_progress(tmp_path)
        assert progress.notice == "", path.stem
        save_progress(progress, tmp_path)
        assert (tmp_path / FILE_NAME).read_text("utf-8") == told, path.stem


def test_the_page_refuses_bad_files_in_the_same_sentence() -> None:
    told = ask_page(*(path.read_text("utf-8") for path in BAD))
    assert dict(zip((path.stem for path in BAD), told, strict=True)) == {
        name: f"refused: {said}" for name, said in FAULTS.items()
    }


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_the_library_sets_bad_files_aside_and_says_why(path: Path, tmp_path: Path) -> None:
    (tmp_path / FILE_NAME).write_bytes(path.read_bytes())
    progress = load_progress(tmp_path)
    assert progress.records == {}
    aside = "labutils-progress-damaged-1.json"
    said = f"{FILE_NAME} is no progress file: {FAULTS[path.stem]}. It is kept as {aside}; progress"
    assert progress.notice.startswith(said)
    assert (tmp_path / aside).read_bytes() == path.read_bytes()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (" " * (MAX_CHARACTERS + 1), "it is far too long"),
        ("[" * 200_000, "it is no JSON"),
        ("", "it is no JSON"),
    ],
)
def test_what_is_too_long_or_too_deep_is_refused(text: str, said: str, tmp_path: Path) -> None:
    (tmp_path / FILE_NAME).write_text(text)
    assert f"is no progress file: {said}. It is kept" in load_progress(tmp_path).notice
    assert ask_page(text) == [f"refused: {said}"]


def write_predictions(**said: str | None) -> str:
    """A file with predictions; the answer "2" is right."""
    items = {name: {"said": one, "right": one == "2"} for name, one in said.items()}
    return json.dumps({"version": 1, "exercises": {}, "predictions": items})


@pytest.mark.parametrize(
    ("first", "second", "kept"),
    [
        ("1", "2", "1"),  # what one said before one knew
        ("2", "1", "2"),
        (None, "1", "1"),  # an answer wins over none
        ("1", None, "1"),
        (None, None, None),
    ],
)
def test_of_two_predictions_the_first_answer_is_kept(
    first: str | None, second: str | None, kept: str | None
) -> None:
    (told,) = ask_page([write_predictions(a=first, b="1"), write_predictions(a=second, c="2")])
    expected = json.loads(write_predictions(a=kept, b="1", c="2"))
    assert json.loads(told) == expected


def test_a_file_of_an_older_release_takes_no_prediction_away() -> None:
    old = (FILES / "good" / "first_release.json").read_text("utf-8")
    (told,) = ask_page([write_predictions(a="2"), old])
    merged = json.loads(told)
    assert merged["predictions"] == {"a": {"said": "2", "right": True}}
    assert set(merged["exercises"]) == set(json.loads(old)["exercises"])


def test_what_the_library_writes_it_reads(tmp_path: Path) -> None:
    progress = Progress()
    progress.get("find_edges").attempts = 3
    progress.predictions["stale"] = Prediction("2", right=True)
    save_progress(progress, tmp_path)
    assert load_progress(tmp_path) == progress
