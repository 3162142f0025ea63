"""Keep what the cells of a notebook say on stderr while nbval runs them: it compares, but forgets.

A plugin for the pytest that runs nbval (``-p nbval_noise``, its folder on PYTHONPATH); the
variable NBVAL_NOISE names the file it writes.
"""

import json
import os
from pathlib import Path
from typing import Any

noise: list[dict[str, Any]] = []


def pytest_runtest_teardown(item: Any) -> None:
    """Look through what one cell put out."""
    tags = item.cell.metadata.get("tags", [])
    noise.extend(
        {"tags": tags, "text": output["text"]}
        for output in getattr(item, "test_outputs", [])
        if output.get("name") == "stderr"
    )


def pytest_sessionfinish() -> None:
    """Write it down, also when there was nothing."""
    Path(os.environ["NBVAL_NOISE"]).write_text(json.dumps(noise), encoding="utf-8")
