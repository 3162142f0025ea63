"""The modules that Node can import, alone: every `test` of `units/*.test.mjs`, by its name."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.helpers.node import check_units


def test_every_unit_keeps_its_promise(subtests: pytest.Subtests) -> None:
    assert check_units(Path(__file__).parent / "units", subtests) > 40
