"""The checks give the same verdicts with the browser's OpenCV (4.11) and the locked one."""

import subprocess
import sys
from pathlib import Path

import pytest

from tools.environments import NoEnvironmentError, make_environment

ROOT = Path(__file__).resolve().parents[2]
BROWSER_OPENCV = "4.11"


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
def test_verdicts_agree_with_the_opencv_of_the_browser() -> None:
    try:
        python = make_environment(f"matrix-opencv{BROWSER_OPENCV}")
    except NoEnvironmentError as error:
        pytest.skip(f"OpenCV {BROWSER_OPENCV} cannot be installed here: {error}")
    ours, theirs = run_script(sys.executable), run_script(python)
    assert f"OpenCV {BROWSER_OPENCV}." in theirs.stderr
    assert ours.stderr != theirs.stderr
    assert ours.stdout.splitlines() == theirs.stdout.splitlines()
    assert "not checked" not in ours.stdout
