"""Exercise cells as a reader uses them: buttons, keys, what is kept, what is said when it fails."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from labutils import hint
from labutils.checks.progress import Progress, Record, load_progress, save_progress
from labutils.checks.table import read_completions, read_words
from tests.checks.test_progress_rules import FAULTS, FILES

ROOT = Path(__file__).resolve().parents[2]
PAGE = "exercises/step3_depth"
PACKED = ROOT / "_build" / "page_python" / "python"
SOLVED = Record(
    passed=True,
    attempts=3,
    hints=1,
    mistakes={"linear": 2},
    relations={"scaled:1000": 1},
    probes={"no-effect:far": 2},
)
CDN = "https://cdn.jsdelivr.net/pyodide/v314.0.7/full/"

#: Files that break a rule each; all of them are tried without a browser.
REFUSED = ("cut_short", "list", "newer_version", "attempts_below_zero", "count_in_words")


def write_progress(folder: Path, **records: Record) -> Path:
    folder.mkdir()
    save_progress(Progress(dict(records)), folder)
    return folder / "labutils-progress.json"


@pytest.fixture(scope="module")
def imports(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Progress files, good ones and some of the bad ones."""
    folder = tmp_path_factory.mktemp("imports")
    good = [
        write_progress(folder / "a", process_depth=SOLVED, render_camera=Record(passed=True)),
        write_progress(folder / "b", process_depth=Record(attempts=9, last_property="value")),
    ]
    bad = [FILES / "bad" / f"{name}.json" for name in REFUSED]
    plan = folder / "imports.json"
    plan.write_text(json.dumps({"good": list(map(str, good)), "bad": list(map(str, bad))}))
    return plan


@pytest.fixture(scope="module")
def used(use_python: Callable[..., Any], imports: Path) -> dict[str, Any]:
    return use_python("exercise_ui", PAGE, imports)


@pytest.fixture(scope="module")
def limited(
    chromium: Callable[..., Any],
    http_site: str,
    page_python: dict[str, Any],
    tmp_path_factory: pytest.TempPathFactory,
    once: Callable[..., Any],
) -> dict[str, Any]:
    """The page where something is missing; wheels are made of what is packed."""
    folder = tmp_path_factory.mktemp("wheels")
    remote, files = [], {}
    for asset in page_python["parts"]["python"]:
        name = asset["name"].removeprefix("vendor/").removesuffix(".zip")
        if name not in ("numpy", "cv2"):
            continue
        pieces = [(PACKED / file).read_text().split('"')[3] for file in asset["files"]]
        content = gzip.decompress(b"".join(map(base64.b64decode, pieces)))
        (folder / f"{name}.whl").write_bytes(content)
        url = f"{CDN}{name}.whl"
        remote.append({"name": name, "url": url, "sha256": hashlib.sha256(content).hexdigest()})
        files[url] = str(folder / f"{name}.whl")
    plan = folder / "wheels.json"
    plan.write_text(json.dumps({"remote": remote, "files": files}))
    make = lambda: chromium("exercise_limits.mjs", http_site, PAGE, plan)  # noqa: E731
    return once("exercise-limits", make)


def read_exported(exported: dict[str, str], folder: Path) -> dict[str, Record]:
    """Read an exported file with the library, which sets aside what it does not accept."""
    assert exported["name"] == "labutils-progress.json"
    (folder / exported["name"]).write_text(exported["text"])
    progress = load_progress(folder)
    assert progress.notice == ""
    return progress.records


def test_nothing_goes_wrong_on_the_page(used: dict[str, Any]) -> None:
    assert used["complaints"] == []


def test_python_is_loaded_on_the_first_click_only_and_says_how_far_it_is(
    used: dict[str, Any],
) -> None:
    assert used["askedBefore"] == []
    said = used["progressOfLoading"]
    assert any(text.startswith("Loading Python: ") and "12." in text for text in said)
    assert said.index("Starting Python") < said.index("Running")


def test_stop_before_python_stands_says_so(used: dict[str, Any]) -> None:
    assert used["stoppedEarly"]["result"] == "stopped"
    assert "Stopped before it began." in used["stoppedEarly"]["text"]


def test_checks_that_are_asked_while_python_loads_wait_for_it(used: dict[str, Any]) -> None:
    assert len(used["queued"]) == 2
    for said in used["queued"]:
        assert "Not started yet." in said["text"]


def test_an_endless_loop_is_stopped_after_20_seconds(used: dict[str, Any]) -> None:
    assert used["limit"] == 20_000
    assert used["endlessByDefault"]["result"] == "stopped"
    assert "Stopped after 20 seconds: is there a loop" in used["endlessByDefault"]["text"]
    assert "Stopped after 0.5 seconds" in used["endless"]["text"]


def test_stop_ends_what_runs_and_the_next_check_works(used: dict[str, Any]) -> None:
    assert "Stopped. The next run starts it anew." in used["stopped"]["text"]
    assert used["focusAfterStop"] == "Check"
    assert used["afterStop"]["result"] == "error"


def test_an_error_shows_the_line_and_what_was_printed(used: dict[str, Any]) -> None:
    text = used["afterStop"]["text"]
    assert "line 2: x = [][1]" in text
    assert "IndexError: list index out of range" in text
    assert "alive" in text
    assert "page_runner" not in text


def test_hints_are_those_of_the_notebook_and_are_counted(
    used: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    name = used["names"][1]
    assert used["hints"] == [str(hint(name)) for _ in range(3)]
    assert read_exported(used["exported"], tmp_path)[name].hints == 3


def test_reset_can_be_undone_until_the_next_edit(used: dict[str, Any]) -> None:
    assert used["reset"] == {
        "isStarter": True,
        "isBack": True,
        "buttons": ["Run", "Check", "Hint", "Reset"],
    }


def test_the_keyboard_is_enough(used: dict[str, Any]) -> None:
    keyboard = used["keyboard"]
    assert keyboard["label"] == f"Code of {used['names'][1]}"
    assert keyboard["indented"] == "    pass"
    assert keyboard["next"] == "Run"
    assert keyboard["back"]
    assert "by keyboard" in keyboard["said"]["text"]


def test_bad_files_are_refused_with_their_reason_and_change_nothing(used: dict[str, Any]) -> None:
    refused, taken = used["imports"][: len(REFUSED)], used["imports"][len(REFUSED) :]
    assert len(taken) == 2
    for seen, name in zip(refused, REFUSED, strict=True):
        said = f"{name}.json is no progress file: {FAULTS[name]}. Nothing was changed."
        assert seen["said"] == said
        assert seen["exported"]["text"] == used["exported"]["text"]


def test_an_import_adds_and_loses_nothing(used: dict[str, Any], tmp_path: Path) -> None:
    first, second = used["imports"][-2:]
    assert first["said"].startswith("Imported: 2 exercises.")
    assert first["count"] == "1 of 3 solved on this page"
    before = read_exported(used["exported"], tmp_path)
    records = read_exported(first["exported"], tmp_path)
    assert records["process_depth"].passed
    assert records["process_depth"].mistakes["linear"] == 2
    assert records["process_depth"].relations["scaled:1000"] == 1
    assert records["process_depth"].probes["no-effect:far"] == 2
    assert records["render_camera"].passed
    kept = used["names"][1]
    assert records[kept] == before[kept]
    # a longer history without the pass does not take it back
    records = read_exported(second["exported"], tmp_path)
    assert records["process_depth"].passed
    assert (records["process_depth"].attempts, records["process_depth"].last_property) == (
        9,
        "value",
    )


def test_what_is_exported_is_written_as_the_library_writes_it(
    used: dict[str, Any], tmp_path: Path
) -> None:
    exported = used["imports"][-1]["exported"]
    save_progress(Progress(read_exported(exported, tmp_path)), tmp_path)
    assert (tmp_path / "labutils-progress.json").read_text() == exported["text"]


def test_code_and_progress_survive_a_reload(used: dict[str, Any]) -> None:
    assert used["reloaded"]["code"].startswith("kept = 'as it was'")
    assert used["reloaded"]["status"] == "Restored: your code from last time."
    assert "IndexError" in used["reloaded"]["text"]
    assert "Your code has changed since this check." in used["reloaded"]["text"]
    assert used["reloadedCount"] == "1 of 3 solved on this page"


def test_on_paper_there_is_the_code_and_no_button(used: dict[str, Any]) -> None:
    assert used["print"]["editors"] is False
    assert used["print"]["hints"] is False
    assert used["print"]["code"].startswith("kept = 'as it was'")


def test_everybody_can_use_it(used: dict[str, Any]) -> None:
    assert used["axe"] == []
    assert used["sideways"] <= 0
    assert used["smallButtons"] == []


def test_without_scripts_the_page_is_plain(limited: dict[str, Any]) -> None:
    exercises = [one for one in read_words().values() if one["chapter"] == "3"]
    completions = [one for one in read_completions().values() if one["chapter"] == "3"]
    hints = len(exercises)
    count = hints + len(completions)
    assert limited["scriptless"] == {"sources": count, "checks": count, "hints": hints, "ours": 0}


def test_without_storage_it_works_and_says_that_nothing_is_kept(limited: dict[str, Any]) -> None:
    forgetful = limited["forgetful"]
    assert forgetful["errors"] == []
    assert "This browser keeps nothing" in forgetful["before"]["status"]
    assert forgetful["hints"] == 2
    assert forgetful["after"]["result"] == "error"


def test_without_wheels_the_page_loads_them_and_says_so_before(limited: dict[str, Any]) -> None:
    cdn = limited["cdn"]
    assert "NumPy and OpenCV from cdn.jsdelivr.net: it needs a network" in cdn["before"]["status"]
    assert "NumPy and OpenCV come from cdn.jsdelivr.net, by the network." in cdn["bar"]
    assert cdn["askedBefore"] == 0
    assert sorted(cdn["asked"]) == [f"{CDN}cv2.whl", f"{CDN}numpy.whl"]
    assert "Not started yet." in cdn["after"]["text"]


def test_a_wheel_that_is_not_the_right_one_is_not_run(limited: dict[str, Any]) -> None:
    assert limited["spoiled"]["after"]["result"] == "stopped"
    assert "is not the file it should be" in limited["spoiled"]["after"]["text"]


def test_without_a_network_the_page_says_what_it_could_not_load(limited: dict[str, Any]) -> None:
    text = limited["unreachable"]["after"]["text"]
    assert "numpy could not be loaded from cdn.jsdelivr.net" in text
