"""The checks give the same verdicts with the browser's OpenCV (4.11) and the locked one."""

import subprocess
import sys
import venv
from importlib.metadata import version
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BROWSER_OPENCV = "4.11.0.86"


def run_script(python: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [python, "-m", "tools.derive.opencv_parity"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
    )


@pytest.mark.slow  # its quick relative: the exercise pages in a browser, which has that OpenCV
def test_verdicts_agree_with_the_opencv_of_the_browser(tmp_path: Path) -> None:
    venv.create(tmp_path / "env", with_pip=True)
    folder = "Scripts" if sys.platform == "win32" else "bin"
    python = tmp_path / "env" / folder / "python"
    wanted = [
        f"numpy=={version('numpy')}",
        f"mujoco=={version('mujoco')}",
        f"PyYAML=={version('PyYAML')}",
        f"opencv-python-headless=={BROWSER_OPENCV}",
    ]
    done = subprocess.run(
        [python, "-m", "pip", "install", "--quiet", *wanted],
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        pytest.skip(f"OpenCV {BROWSER_OPENCV} cannot be installed here: {done.stderr[-200:]}")
    ours, theirs = run_script(sys.executable), run_script(python)
    assert "OpenCV 4.11" in theirs.stderr
    assert ours.stderr != theirs.stderr
    assert ours.stdout.splitlines() == theirs.stdout.splitlines()
    assert "not checked" not in ours.stdout
