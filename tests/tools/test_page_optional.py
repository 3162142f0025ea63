"""Packages that a reader may import and the page has to fetch: all that they need, checksummed."""

from __future__ import annotations

import json
from pathlib import Path

from tools.vendor.page_optional import find_optional


def write_lock(folder: Path, **depends: list[str]) -> Path:
    packages = {
        name: {"depends": needs, "file_name": f"{name}-1.whl", "sha256": name * 2}
        for name, needs in depends.items()
    }
    path = folder / "lock.json"
    path.write_text(json.dumps({"packages": packages}))
    return path


def test_a_package_comes_with_all_that_it_needs_and_nothing_twice(tmp_path: Path) -> None:
    lock = write_lock(
        tmp_path, matplotlib=["cycler", "numpy", "pillow"], cycler=["six"], six=[], pillow=["six"]
    )
    (wheels,) = find_optional(lock, "314.0").values()
    assert [wheel["name"] for wheel in wheels] == ["cycler", "matplotlib", "pillow", "six"]
    assert wheels[0]["sha256"] == "cyclercycler"
    assert all("v314.0" in wheel["url"] and wheel["url"].startswith("https:") for wheel in wheels)


def test_a_package_that_pyodide_does_not_know_is_left_out(tmp_path: Path) -> None:
    assert find_optional(write_lock(tmp_path, six=[]), "314.0") == {}
