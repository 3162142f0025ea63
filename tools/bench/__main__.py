"""Run every bench, one after the other: what ``make bench`` does.

None stops the others. What a bench finds is no error, however slow; that it could not run is.

Usage: ``python -m tools.bench``.
"""

import subprocess
import sys
from collections.abc import Iterable

from tools import ROOT

BENCHES = (
    "clouds",
    "stereo",
    "checks",
    "explorers",
    "page_python",
    "page_cells",
    "page_following",
)


def main(benches: Iterable[str] = BENCHES) -> int:
    """Run the benches; return 1 and name them where some could not run."""
    failed = []
    for name in benches:
        print(f"--- {name} ---", flush=True)
        command = [sys.executable, "-m", f"tools.bench.{name}"]
        if subprocess.run(command, cwd=ROOT, check=False).returncode:
            failed.append(name)
    if failed:
        print(f"bench: could not run: {', '.join(failed)}; the reasons are above", file=sys.stderr)
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(main())
