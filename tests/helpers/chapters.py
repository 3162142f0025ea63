"""Find the pages of the book, and run one as a notebook the way a learner would."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import jupytext
import nbformat

from content import toc

ROOT = Path(__file__).resolve().parents[2]
CELL_SECONDS = 120
CHECKED = "nbval-check-output"
#: Cells that show a warning on purpose.
NOTICE = "notice"


def get_toc_pages(root: Path = ROOT) -> list[Path]:
    """List the pages of the table of contents, in order, without endings."""
    return [Path(page) for page in toc.list_pages(root)]


def find_pages(root: Path = ROOT) -> list[Path]:
    """List the page files of the book and the exercises, without endings."""
    return [
        path.relative_to(root).with_suffix("")
        for folder in ("book", "exercises")
        for path in sorted((root / folder).rglob("*.md"))
        if not any(part.startswith(("_", ".")) for part in path.relative_to(root).parts)
    ]


def find_widgets(root: Path = ROOT) -> list[str]:
    """List the names of the explorers: one public module each."""
    folder = root / "labutils" / "explorers"
    return sorted(p.stem for p in folder.glob("*.py") if not p.stem.startswith("_"))


def find_orphans(root: Path = ROOT) -> list[str]:
    """Say which pages and widgets nobody can reach, and which listed pages do not exist."""
    listed, existing = get_toc_pages(root), find_pages(root)
    problems = [f"page {p} is not in _toc.yml" for p in existing if p not in listed]
    problems += [f"page {p} in _toc.yml does not exist" for p in listed if p not in existing]
    problems += [f"page {p} is in _toc.yml twice" for p in set(listed) if listed.count(p) > 1]
    text = "".join((root / p).with_suffix(".md").read_text(encoding="utf-8") for p in existing)
    for name in find_widgets(root):
        if f"explore_{name}(" not in text:
            problems.append(f"widget {name} is on no page")
        if not (root / "tests" / "explorers" / f"test_{name}.py").is_file():
            problems.append(f"widget {name} has no test")
    return problems


def get_executable_pages() -> list[Path]:
    """List the pages with code cells, by the table of contents: all of them are run."""
    files = {page: (ROOT / page).with_suffix(".md") for page in get_toc_pages()}
    # A listed page without a file is another test's finding; it must not hide all the others.
    return [
        page
        for page, file in files.items()
        if file.is_file() and "```{code-cell}" in file.read_text(encoding="utf-8")
    ]


def make_clean_environment() -> dict[str, str]:
    """Make an environment without a screen and without the network."""
    dropped = {"DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_GL"}
    environment = {k: v for k, v in os.environ.items() if k not in dropped}
    guard = str(Path(__file__).parent / "no_network")
    # A copy of the repository names its own library there, before the installed one.
    inherited = environment.get("PYTHONPATH")
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, (guard, inherited)))
    # The warning a debugger would print into every notebook under Python 3.12 and later.
    environment["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"
    return environment


@dataclass(frozen=True)
class NotebookRun:
    """What running one chapter showed."""

    cells: int
    compared: int
    passed: int
    output: str
    noise: tuple[str, ...] = ()


def convert(page: Path, folder: Path) -> Path:
    """Turn a page into a notebook file in `folder`."""
    notebook = jupytext.read((ROOT / page).with_suffix(".md"))
    path = folder / f"{page.name}.ipynb"
    nbformat.write(notebook, path)
    return path


def run_tool(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run one of our Python tools in a folder, in the clean environment."""
    return subprocess.run(
        [sys.executable, "-m", *arguments],
        cwd=folder,
        env=make_clean_environment(),
        capture_output=True,
        text=True,
        check=False,
        timeout=900,
    )


def run_notebook(path: Path) -> NotebookRun:
    """Execute a notebook once, then let nbval run it again and compare the marked cells.

    nbval leaves out cells without an execution count, as fresh conversions have them: so without
    the first run it would compare nothing.
    """
    done = run_tool(
        path.parent, "jupyter", "execute", "--inplace", f"--timeout={CELL_SECONDS}", path.name
    )
    if done.returncode != 0:
        return NotebookRun(0, 0, 0, done.stdout + done.stderr)
    cells = [c for c in nbformat.read(path, as_version=4).cells if c.cell_type == "code"]
    noise = [
        output.text
        for cell in cells
        for output in cell.outputs
        if output.get("name") == "stderr" and NOTICE not in cell.metadata.get("tags", [])
    ]
    marked = [c for c in cells if CHECKED in c.metadata.get("tags", [])]
    silent = [c.source for c in marked if not c.outputs]
    if silent:
        return NotebookRun(len(cells), 0, 0, f"marked to be compared, but prints nothing: {silent}")
    again = run_tool(
        path.parent,
        "pytest",
        "--nbval-lax",
        f"--nbval-cell-timeout={CELL_SECONDS}",
        "-p",
        "no:dash",
        "-p",
        "no:cacheprovider",
        "-q",
        path.name,
    )
    passed = re.search(r"^(\d+) passed(?!.*(failed|error))", again.stdout, re.MULTILINE)
    return NotebookRun(
        len(cells),
        len(marked),
        int(passed[1]) if passed else 0,
        again.stdout + again.stderr,
        tuple(noise),
    )
