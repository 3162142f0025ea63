"""The package `mujoco` of the page, tested inside the page's Python: see the folder ``inside``."""

from __future__ import annotations

from typing import Any

import pytest

from tests.helpers.page import list_functions
from tests.page.conftest import FILES, INSIDE

CASES = [(name, one) for name in FILES for one in list_functions(INSIDE / f"{name}.py")]


@pytest.mark.parametrize(("file", "function"), CASES)
def test_inside_the_page(page_said: dict[str, Any], file: str, function: str) -> None:
    said = page_said[file]
    assert not said["import"]["error"], said["import"]["error"]
    assert not said[function]["error"], said[function]["error"]


def test_every_file_for_the_page_is_run() -> None:
    assert sorted(path.stem for path in INSIDE.glob("*.py")) == sorted(FILES)
