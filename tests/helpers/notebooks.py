"""Run a page as a notebook the way a learner would: headless, offline, in an empty folder."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import jupytext
import nbformat
from jupyter_cache.cache.main import JupyterCacheBase

from tests.helpers.chapters import ROOT
from tools.build.edition import EDITIONS
from tools.build.memory import make_cell_stamp

CELL_SECONDS = 120
CHECKED = "nbval-check-output"
#: Cells that show a warning on purpose.
NOTICE = "notice"
HERE = Path(__file__).parent
ASK_FOR_BACKEND = "import os, labutils; print(os.environ.get('MUJOCO_GL', ''))"


def make_clean_environment() -> dict[str, str]:
    """Make an environment without a screen and without the network."""
    dropped = {"DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_GL"}
    environment = {k: v for k, v in os.environ.items() if k not in dropped}
    # A copy of the repository names its own library there, before the installed one.
    inherited = environment.get("PYTHONPATH")
    guard = str(HERE / "no_network")
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
    #: What the marked cells were compared with.
    reference: str = "the build"


def convert(page: Path, folder: Path) -> Path:
    """Turn a page into a notebook file in `folder`: as the book's build ran it, where it did."""
    notebook = jupytext.read((ROOT / page).with_suffix(".md"))
    path = folder / f"{page.name}.ipynb"
    nbformat.write(find_execution(notebook) or notebook, path)
    return path


def find_execution(
    notebook: nbformat.NotebookNode, build: Path = EDITIONS["student"].build
) -> nbformat.NotebookNode | None:
    """Find what the build kept of running these very cells; None where it has not run them.

    Of what another library or another scene put out nothing is taken: then the cells are new.
    """
    if not is_build_current(build):
        return None
    memory = JupyterCacheBase(build / ".jupyter_cache")
    _, key = memory.create_hashed_notebook(notebook)
    # not through the database: to read there is to write down when
    path = memory.path / "executed" / key / "base.ipynb"
    return nbformat.read(path, as_version=4) if path.is_file() else None


@cache
def is_build_current(build: Path) -> bool:
    """Whether the executions that a build has kept are of the library as it is now."""
    stamps = build / "stamps.json"
    if not stamps.is_file():
        return False
    kept = json.loads(stamps.read_text(encoding="utf-8"))["cells"]
    return bool(kept == make_clean_stamp())


@cache
def make_clean_stamp() -> str:
    """What a build would write down where there is no screen: the library chooses the backend."""
    done = run_python(ROOT, "-c", ASK_FOR_BACKEND)
    done.check_returncode()
    return make_cell_stamp({"MUJOCO_GL": done.stdout.strip()})


def run_python(
    folder: Path, *arguments: str, variables: dict[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    """Run Python in a folder, in the clean environment."""
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env=make_clean_environment() | (variables or {}),
        capture_output=True,
        text=True,
        check=False,
        timeout=900,
    )


def run_notebook(path: Path) -> NotebookRun:
    """Let nbval run a notebook, and compare the marked cells with what they put out before.

    What they put out before stands in the notebook. nbval leaves out cells without an execution
    count, as fresh conversions have them: such a notebook is executed first, or nothing would be
    compared.
    """
    reference = NotebookRun.reference
    if any(cell.execution_count is None for cell in read_code_cells(path)):
        reference = "a first run"
        options = ("--inplace", f"--timeout={CELL_SECONDS}")
        done = run_python(path.parent, "-m", "jupyter", "execute", *options, path.name)
        if done.returncode != 0:
            return NotebookRun(0, 0, 0, done.stdout + done.stderr)
    cells = read_code_cells(path)
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
    again, more_noise = run_nbval(path)
    passed = re.search(r"^(\d+) passed(?!.*(failed|error))", again.stdout, re.MULTILINE)
    return NotebookRun(
        len(cells),
        len(marked),
        int(passed[1]) if passed else 0,
        again.stdout + again.stderr,
        (*noise, *more_noise),
        reference,
    )


def read_code_cells(path: Path) -> list[nbformat.NotebookNode]:
    """Read the cells of a notebook that are run."""
    return [c for c in nbformat.read(path, as_version=4).cells if c.cell_type == "code"]


def run_nbval(path: Path) -> tuple[subprocess.CompletedProcess[str], list[str]]:
    """Run nbval on a notebook; also return what the cells said on stderr without being asked."""
    with tempfile.TemporaryDirectory() as elsewhere:  # the folder of the notebook stays as it is
        heard = Path(elsewhere) / "noise.json"
        folders = [make_clean_environment()["PYTHONPATH"], str(HERE / "nbval_noise")]
        variables = {
            "NBVAL_NOISE": str(heard),
            "PYTHONPATH": os.pathsep.join(folders),
            # of all installed plugins this one is needed, and the others take time to load
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        }
        plugins = ("-p", "nbval.plugin", "-p", "nbval_noise", "-p", "no:cacheprovider")
        timeout = f"--nbval-cell-timeout={CELL_SECONDS}"
        done = run_python(
            path.parent,
            *("-m", "pytest", *plugins, "--nbval-lax", timeout, "-q", path.name),
            variables=variables,
        )
        noise = json.loads(heard.read_text(encoding="utf-8")) if heard.exists() else []
    return done, [one["text"] for one in noise if NOTICE not in one["tags"]]
