"""The machinery of the book: front-end pins, page hooks, what a failed build says."""

import json
import re
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import nbformat
import pytest
import yaml

from tests.helpers.scripts import load_script
from tools.build import book

ROOT = Path(__file__).resolve().parents[2]
# Where a package came from; packages also name who to thank, under "funding".
ADDRESS_OF_A_PACKAGE = re.compile(r'"resolved"|\.tgz"|\.whl|--index-url|--registry|registry=')

CELL_ERROR_LOG = """reading
nbclient.exceptions.CellExecutionError: An error occurred while executing the following cell:
1 / 0
ZeroDivisionError: division by zero

The above exception was the direct cause of the following exception:
Traceback of Sphinx
"""
CELL_ERROR_IN_HOOK = (
    CELL_ERROR_LOG.partition("The above")[0]
    + """Extension error (side_by_side):
Handler of Sphinx
"""
)


def load(path: str, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Import a script that belongs to no package."""
    monkeypatch.syspath_prepend(str((ROOT / path).parent))
    return load_script(path)


@pytest.fixture
def manifest() -> dict[str, Any]:
    return json.loads((ROOT / "package.json").read_text())


@pytest.fixture
def lock() -> dict[str, Any]:
    return json.loads((ROOT / "package-lock.json").read_text())


@pytest.fixture
def config() -> dict[str, Any]:
    return yaml.safe_load((ROOT / "_config.yml").read_text())


def test_front_end_packages_are_pinned_exactly_and_locked(
    manifest: dict[str, Any], lock: dict[str, Any]
) -> None:
    for name, wanted in (manifest["dependencies"] | manifest["devDependencies"]).items():
        assert re.fullmatch(r"\d+\.\d+\.\d+", wanted), name
        assert lock["packages"][f"node_modules/{name}"]["version"] == wanted


def test_every_locked_package_has_a_checksum_and_no_address(lock: dict[str, Any]) -> None:
    packages = {name: entry for name, entry in lock["packages"].items() if name}
    assert packages
    for name, entry in packages.items():
        assert entry["integrity"].startswith("sha512-"), name
        assert "resolved" not in entry, name


def test_no_lock_file_says_where_packages_came_from() -> None:
    # A mirror must serve as well as the public registry; the hashes say what is right.
    for name in ("package.json", "package-lock.json", "requirements.in", "requirements.txt"):
        assert not ADDRESS_OF_A_PACKAGE.search((ROOT / name).read_text()), name


def find_place(name: str, parent: str, packages: dict[str, Any]) -> str | None:
    """Look where Node looks: inside the package that asks, then outward, folder by folder."""
    while parent and f"{parent}/node_modules/{name}" not in packages:
        parent = parent.rpartition("/node_modules/")[0]
    place = f"{parent}/node_modules/{name}" if parent else f"node_modules/{name}"
    return place if place in packages else None


def test_a_package_inside_another_is_found_before_one_at_the_top() -> None:
    packages: dict[str, Any] = {
        "node_modules/wrap": {},
        "node_modules/wrap/node_modules/width": {},
        "node_modules/width": {},
        "node_modules/ansi": {},
    }
    inner = "node_modules/wrap/node_modules/width"
    assert find_place("width", "node_modules/wrap", packages) == inner
    assert find_place("width", "node_modules/ansi", packages) == "node_modules/width"
    assert find_place("ansi", inner, packages) == "node_modules/ansi"
    assert find_place("gone", inner, packages) is None


def test_every_package_is_locked_with_all_it_needs(lock: dict[str, Any]) -> None:
    packages = lock["packages"]
    for place, entry in packages.items():
        for name in entry.get("dependencies", {}) | entry.get("devDependencies", {}):
            found = find_place(name, place, packages)
            assert found, (place, name)
            assert packages[found]["integrity"]


def test_repository_address_is_stated_once(config: dict[str, Any]) -> None:
    address = config["repository"]["url"]
    assert (ROOT / "_config.yml").read_text().count(address) == 1


def test_an_error_in_a_cell_fails_the_build(config: dict[str, Any]) -> None:
    assert config["execute"]["allow_errors"] is False
    assert config["sphinx"]["config"]["nb_execution_raise_on_error"] is True


def test_every_hook_is_switched_on(config: dict[str, Any]) -> None:
    hooks = {path.stem for path in (ROOT / "book" / "_ext").glob("*.py")}
    assert hooks == set(config["sphinx"]["local_extensions"])


def test_every_style_sheet_is_loaded(
    config: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    sheets = {path.name for path in (ROOT / "book" / "_static").glob("*.css")}
    # these two only on the pages that have what they are for
    some = {load(f"book/_ext/{name}.py", monkeypatch).SHEET for name in ("hero", "videos")}
    assert sheets == {*config["sphinx"]["config"]["html_css_files"], *some}


def test_every_script_is_loaded(config: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    search = load("book/_ext/search_page.py", monkeypatch)
    scripts = {path.name for path in (ROOT / "book" / "_static").glob("*.js")}
    options = config["sphinx"]["config"]
    named = {name for name, _ in options["html_js_files"]} | set(options["nb_ipywidgets_js"])
    named |= set(load("book/_ext/predictions.py", monkeypatch).SCRIPTS)  # where there are some
    named.add(load("book/_ext/hero.py", monkeypatch).DATA)
    named.add(load("book/_ext/path.py", monkeypatch).SCRIPT)
    assert scripts <= named | {*search.SCRIPTS, search.MARKS}


def test_strip_marks_the_page_and_links_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    strip = load("book/_ext/progress_strip.py", monkeypatch)
    pages = {page for _, page in strip.STAGES} - {"book/step6_view"}
    html = strip.strip_html("book/step3_depth", pages, lambda page: f"../{page}.html")
    assert html.count('aria-current="step"') == 1
    assert '<a href="../book/step3_depth.html" aria-current="step">meters</a>' in html
    assert "<span>view</span>" in html  # a stage whose page does not exist yet
    assert html.count("<li>") == len(strip.STAGES)


def test_widget_ids_are_the_same_whatever_the_random_ids_were(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hook = load("book/_ext/stable_ids.py", monkeypatch)

    def build(slider: str, layout: str, view: str, link: str) -> tuple[str, str]:
        models = {
            link: {"state": {"source": [f"IPY_MODEL_{slider}", "value"]}},
            slider: {"state": {"layout": f"IPY_MODEL_{layout}", "value": 45}},
            layout: {"state": {}},
            view: {"state": {"children": [f"IPY_MODEL_{slider}"]}},
        }
        state = json.dumps({"state": dict(sorted(models.items()))})
        script = SimpleNamespace(attributes={"type": hook.WIDGET_STATE, "body": state})
        body = f'<script type="{hook.WIDGET_STATE.replace("state", "view")}">'
        body += json.dumps({"model_id": view}) + "</script>"
        context: dict[str, Any] = {"body": body, "script_files": [script]}
        hook.rename_models(None, "book/page", "", context, None)
        return context["body"], script.attributes["body"]

    first = build(*(digit * 32 for digit in "1234"))
    second = build(*(digit * 32 for digit in "c8a0"))
    assert first == second
    (view,) = hook.MODEL_ID.findall(first[0])
    assert view in json.loads(first[1])["state"]


def test_tracebacks_name_files_from_the_repository_on(monkeypatch: pytest.MonkeyPatch) -> None:
    hook = load("book/_ext/local_paths.py", monkeypatch)
    app = SimpleNamespace(srcdir="/somewhere/else")
    context = {"body": "File /somewhere/else/labutils/x.py:3"}
    hook.shorten_paths(app, "", "", context, None)
    assert context["body"] == "File labutils/x.py:3"


def test_downloaded_notebooks_carry_no_outputs_and_no_random_ids(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hook = load("book/_ext/clean_notebooks.py", monkeypatch)
    output = nbformat.v4.new_output("stream", text="6 points\n")
    cell = nbformat.v4.new_code_cell("print()", outputs=[output], execution_count=3)
    notebook = nbformat.v4.new_notebook(
        cells=[cell], metadata={"language_info": {"name": "python"}}
    )
    hook.clean(notebook)
    assert notebook.cells[0].id == "cell-0"
    assert notebook.cells[0].outputs == []
    assert notebook.cells[0].execution_count is None
    assert "language_info" not in notebook.metadata


@pytest.mark.parametrize(
    ("log", "expected", "unwanted"),
    [
        (
            CELL_ERROR_LOG,
            "ZeroDivisionError: division by zero",
            "Traceback of Sphinx",
        ),
        (CELL_ERROR_IN_HOOK, "ZeroDivisionError: division by zero", "Handler of Sphinx"),
        (
            "book/start.md:3: WARNING: unknown document: 'nowhere'\nbuild finished\n",
            "unknown document: 'nowhere'",
            "build finished",
        ),
        ("something\nwithout a marker\n", "without a marker", "WARNING"),
    ],
)
def test_a_failed_build_shows_its_reason(log: str, expected: str, unwanted: str) -> None:
    said = book._what_went_wrong(log)
    assert expected in said
    assert unwanted not in said
