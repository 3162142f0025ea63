"""Make the environments and run the tests in them: what ``make foreign`` does.

Usage: ``python -m tests.foreign [--record-foreign=FILE] [any option of pytest]``.
"""

from __future__ import annotations

import subprocess
import sys

from tools import ROOT
from tools.environments import NoEnvironmentError, make_environment


def main(arguments: list[str]) -> int:
    """Run the tests of this room; return a shell's exit code."""
    try:
        python, drake = make_environment("foreign"), make_environment("drake")
    except NoEnvironmentError as error:
        print(f"foreign: {error}", file=sys.stderr)
        return 1
    command = [str(python), "-m", "pytest", "tests/foreign", f"--drake={drake}", *arguments]
    return subprocess.run(command, cwd=ROOT, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
