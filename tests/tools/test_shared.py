"""What Python and JavaScript both need to know is written once, and the copy is no older."""

from __future__ import annotations

import pytest

from tools import ROOT
from tools.derive import shared


@pytest.mark.parametrize("name", shared.make_files())
def test_the_copy_for_javascript_is_up_to_date(name: str) -> None:
    said = "run `make exercises`: what JavaScript knows of the library is older than the library"
    assert (ROOT / name).read_text(encoding="utf-8") == shared.make_files()[name], said
