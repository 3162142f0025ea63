"""Formulas are typeset when the book is built."""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType
from typing import Any

import pytest
from sphinx.errors import ExtensionError

from tests.helpers import browser
from tests.helpers.scripts import ROOT, load_script


@pytest.fixture(scope="module")
def hook() -> ModuleType:
    return load_script("book/_ext/formulas.py")


@pytest.fixture(scope="module")
def typesetter(hook: ModuleType) -> Iterator[Any]:
    browser.require_packages()
    made = hook.Typesetter(str(ROOT))
    yield made
    made.close(None, None)


def test_a_formula_is_a_drawing_with_mathml_for_screen_readers(typesetter: Any) -> None:
    html = typesetter.typeset("f_y", display=False)
    assert html.startswith("<mjx-container")
    assert "<svg" in html
    assert "<msub><mi>f</mi><mi>y</mi></msub>" in html
    assert " id=" not in html  # quizzes show copies of formulas
    assert 'display="true"' in typesetter.typeset("f_y", display=True)


def test_what_is_no_tex_is_an_error_that_says_why(typesetter: Any) -> None:
    with pytest.raises(ExtensionError, match=r"frac.a': expected TeX .* Missing close"):
        typesetter.typeset(r"\frac{a", display=False)
    assert typesetter.typeset("a", display=False)  # and the next one works


def test_without_mathjax_the_error_says_where_to_look(
    hook: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(hook, "COMMAND", ("-c", "pass"))
    typesetter = hook.Typesetter(str(ROOT))
    with pytest.raises(ExtensionError, match=r"no answer; see tools/vendor/typeset\.py"):
        typesetter.typeset("a", display=False)
    typesetter.close(None, None)
