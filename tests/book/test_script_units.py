"""The scripts of the pages that need no page: every `test` of `units/*.test.mjs`, by its name."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.helpers.node import run_tests

UNITS = sorted((Path(__file__).parent / "units").glob("*.test.mjs"))
NAMED = re.compile(r'^test\(\s*"(.+?)",', re.MULTILINE)


def test_every_unit_keeps_its_promise(subtests: pytest.Subtests) -> None:
    promised = [name for path in UNITS for name in NAMED.findall(path.read_text("utf-8"))]
    found = run_tests(*UNITS)
    for name in promised:
        with subtests.test(name):
            assert found.pop(name, "it did not run") == ""
    assert found == {}, 'expected names in the form test("...", and each once'
    assert len(promised) > 8
