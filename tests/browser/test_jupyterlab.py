"""In JupyterLab explorers work as on the page, and chapters open as notebooks."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import nbformat
import pytest

from tools import ROOT
from tools.build.jupyter_settings import install_settings

EXPLORE = """\
import json
from labutils import make_scene
from labutils.explorers import explore_fov
explorer = explore_fov(*make_scene())
explorer"""
READ = 'print(json.dumps({"fov_y": explorer.fov_y, "f": explorer.K[0, 0]}))'
SCENE = """\
from labutils.explorers import explore_scene
scene = explore_scene(*make_scene())
scene.move(pixel=[40, 90])
scene"""
READ_SCENE = "print(json.dumps(scene.values))"
WRONG = """\
def intrinsics_matrix(fovy_deg, width, height):
    f = width / 2 / np.tan(np.deg2rad(fovy_deg) / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
check("intrinsics_matrix", intrinsics_matrix)"""
CELLS = (EXPLORE, READ, SCENE, READ_SCENE)
LONGEST_START = 120  # seconds


@contextmanager
def serve_lab(folder: Path) -> Iterator[str]:
    """Start JupyterLab in a folder, without a browser and without a password, on this machine."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    options = {
        "ServerApp.ip": "127.0.0.1",
        "ServerApp.port": port,
        "ServerApp.open_browser": False,
        "ServerApp.root_dir": folder,
        "IdentityProvider.token": "",
        "LabApp.collaborative": False,
    }
    environment = os.environ | {
        name: str(folder / ".jupyter")
        for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")
    }
    environment["JUPYTER_CONFIG_PATH"] = str(folder / ".environment" / "etc" / "jupyter")
    command = [sys.executable, "-m", "jupyter", "lab", "--allow-root"]
    command += [f"--{name}={value}" for name, value in options.items()]
    with (
        (folder / "server.log").open("w") as log,
        subprocess.Popen(
            command, stdout=log, stderr=subprocess.STDOUT, cwd=folder, env=environment
        ) as server,
    ):
        try:
            address = f"http://127.0.0.1:{port}/"
            wait_for(server, address, folder / "server.log")
            yield address
        finally:
            server.terminate()


def wait_for(server: subprocess.Popen[bytes], address: str, log: Path) -> None:
    end = time.monotonic() + LONGEST_START
    while time.monotonic() < end and server.poll() is None:
        try:
            with urllib.request.urlopen(f"{address}api", timeout=5):  # noqa: S310 - our own server
                return
        except OSError:
            time.sleep(0.3)
    pytest.fail(f"JupyterLab did not start:\n{log.read_text()[-2000:]}")


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory, chromium: Callable[..., Any]) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("lab")
    notebook = nbformat.v4.new_notebook()
    notebook.metadata["kernelspec"] = {
        "name": "python3",
        "display_name": "Python 3",
        "language": "python",
    }
    notebook.cells = [nbformat.v4.new_code_cell(source) for source in CELLS]
    nbformat.write(notebook, folder / "explore.ipynb")
    for room in ("book", "exercises"):
        shutil.copytree(ROOT / room, folder / room)
    (folder / ".environment").mkdir()
    install_settings(folder / ".environment")
    with serve_lab(folder) as address:
        return chromium("jupyterlab.mjs", address, "explore.ipynb", "step2_intrinsics.md", WRONG)


def to_degrees(radians: float) -> float:
    return radians * 180 / 3.141592653589793


def agree(seen: dict[str, Any]) -> bool:
    return to_degrees(seen["python"]["fov_y"]) == pytest.approx(seen["page"]["fov_y_deg"])


def test_python_reads_where_the_slider_was_dragged(seen: dict[str, Any]) -> None:
    assert seen["dragged"]["page"]["fov_y_deg"] > seen["before"]["page"]["fov_y_deg"] + 5
    assert agree(seen["before"])
    assert agree(seen["dragged"])
    assert seen["dragged"]["python"]["f"] < seen["before"]["python"]["f"]


def test_arrow_keys_move_the_slider_and_not_the_notebook(seen: dict[str, Any]) -> None:
    moved = seen["pressed"]["page"]["fov_y_deg"] - seen["dragged"]["page"]["fov_y_deg"]
    assert moved == pytest.approx(1.0)  # two steps of half a degree
    assert agree(seen["pressed"])


def test_reset_reaches_python_too(seen: dict[str, Any]) -> None:
    assert seen["reset"]["python"]["fov_y"] == pytest.approx(seen["before"]["python"]["fov_y"])
    assert agree(seen["reset"])


def test_the_slider_has_a_name_there_too(seen: dict[str, Any]) -> None:
    assert seen["name"] == "fov_y (°)"


def test_the_scene_that_python_draws_is_the_one_that_was_dragged(seen: dict[str, Any]) -> None:
    scene = seen["scene"]
    assert scene["page"]["pan_deg"] > 1
    assert scene["page"]["pixel_depth"] is not None
    # both read the same bytes
    assert scene["python"] == pytest.approx(scene["page"], abs=1e-9)


def test_only_what_a_learner_works_with_is_listed(seen: dict[str, Any]) -> None:
    pages = {path.name for path in (ROOT / "exercises").glob("*.md")}
    assert set(seen["chapter"]["names"]) == pages


def test_a_double_click_opens_a_chapter_as_a_notebook(seen: dict[str, Any]) -> None:
    assert seen["chapter"]["cells"] > 4


def test_no_news_are_offered(seen: dict[str, Any]) -> None:
    assert seen["chapter"]["notices"] == []


def test_the_link_of_a_verdict_opens_the_chapter_as_a_notebook(seen: dict[str, Any]) -> None:
    chapter = seen["chapter"]
    assert "K[0, 0]" in chapter["verdict"]
    assert chapter["link"] == "step 2: How does an angle become a focal length?"
    assert chapter["followed"].startswith("Step 2: Which direction does a pixel look?")
