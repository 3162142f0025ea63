"""The page's Python under Node: the same assets that a page loads, and one start for all tests."""

from __future__ import annotations

import ast
import importlib.metadata
import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

from tools import ROOT
from tools.stable_zip import make_zip
from tools.vendor import (
    npm,
    pack_python,
    page_python,
    page_recordings,
    page_simulator,
    page_wheels,
)

HARNESS = ROOT / "tests" / "page" / "_python.mjs"
#: Beside what every page loads: all check tables, which a page loads one by one.
LIBRARY = (*pack_python.LIBRARY, "labutils/checks/tables/*.npz", "labutils/explorers/*.py")


def find_wheels() -> page_wheels.Wheels:
    """Find NumPy and OpenCV for the page, on this machine: nothing is downloaded."""
    version = json.loads((ROOT / "package.json").read_text("utf-8"))["dependencies"]["pyodide"]

    def refuse(address: str) -> bytes:
        raise OSError(f"{address} is not asked for by a test")

    return page_wheels.find_wheels(page_python.VENDOR / page_python.LOCK, version, refuse)


def list_functions(path: Path) -> list[str]:
    """List the functions of a file that run in the page."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    return [one.name for one in functions if one.name[0] != "_" and not one.args.args]


def collect_extras() -> dict[str, bytes]:
    """Collect what the files in the page import or read beside the library."""
    patterns = (
        "content/*.py",
        "content/*.yml",
        "solutions/**/*.py",
        "exercises/_generated/*.py",
    )
    paths = [
        path
        for pattern in (*patterns, "book/*.md", "exercises/*.md")
        for path in ROOT.glob(pattern)
    ]
    extras = {path.relative_to(ROOT).as_posix(): path.read_bytes() for path in paths}
    for file in importlib.metadata.files("pyyaml") or []:
        if file.parts[0] == "yaml" and file.suffix == ".py":
            extras[file.as_posix()] = file.read_binary()
    return extras


def write_assets(folder: Path, wheels: page_wheels.Wheels, extra: dict[str, bytes]) -> None:
    """Write what the harness loads.

    Parameters
    ----------
    folder : Path
        A new one.
    wheels : Wheels
        With files.
    extra : dict
        More files for Python to import or read, by their places beside ``labutils``.
    """
    vendor = folder / "vendor"
    vendor.mkdir(parents=True)
    for name in (*page_python.CORE, page_python.LOCK):
        shutil.copyfile(page_python.VENDOR / name, vendor / name)
    for name, path in wheels.files.items():
        (folder / f"{name}.zip").write_bytes(pack_python.trim_wheel(path))
    paths = {path for pattern in LIBRARY for path in ROOT.glob(pattern)}
    library = {path.relative_to(ROOT).as_posix(): path.read_bytes() for path in paths}
    (folder / "labutils.zip").write_bytes(make_zip(sorted((library | extra).items())))
    for name, content in page_recordings.make_recording_assets().items():
        (folder / name).write_bytes(content)
    for name, content in page_simulator.make_simulator_assets().items():
        # Node takes a file for a module by its ending
        place = folder / (name[:-3] + ".mjs" if name.endswith(".js") else name)
        place.write_bytes(content)


def run_files(assets: Path, out: Path, *files: Path) -> dict[str, Any]:
    """Run files in one start of the page's Python; return what each of their functions said."""
    command = [*npm.find_node(), "--no-warnings", str(HARNESS), str(assets), str(out)]
    done = subprocess.run(
        [*command, *map(str, files)], capture_output=True, text=True, check=False, timeout=600
    )
    if done.returncode:
        raise AssertionError(f"the page's Python did not run: {done.stderr[-3000:]}")
    said: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return said
