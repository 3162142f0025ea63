"""Pages that have to be run, run side by side, and leave what MyST-NB would have left."""

import os
import threading
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import nbformat
import pytest
from docutils.utils import new_document
from jupyter_cache import get_cache
from jupyter_cache.executors.utils import ExecutionResult
from jupyter_core.utils import ensure_event_loop
from myst_nb.core.config import NbParserConfig
from myst_nb.core.execute import ExecutionError, create_client
from myst_nb.core.loggers import DocutilsDocLogger
from myst_parser.config.main import MdParserConfig
from nbformat.notebooknode import NotebookNode
from sphinx.errors import ConfigError

from tests.helpers.scripts import load_script

TOP = """---
jupytext:
  text_representation: {extension: .md, format_name: myst}
kernelspec: {display_name: Python 3, language: python, name: python3}
---
"""


@pytest.fixture
def hook(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.delenv("PAGES_AT_ONCE", raising=False)
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "LP_NUM_THREADS"):
        monkeypatch.delenv(name, raising=False)
    module = load_script("book/_ext/side_by_side.py")
    monkeypatch.setattr(module, "count_cores", lambda: 2)
    return module


def make_env(folder: Path, pages: dict[str, list[str]]) -> SimpleNamespace:
    """Make what the hook asks of Sphinx: pages, and where the cache is."""
    for name, cells in pages.items():
        text = "".join(f"\n```{{code-cell}}\n{cell}\n```\n" for cell in cells)
        (folder / f"{name}.md").write_text(f"{TOP if cells else ''}# {name}\n{text}")
    config = NbParserConfig(
        execution_mode="cache",
        execution_cache_path=str(folder / "cache"),
        execution_in_temp=True,
        execution_timeout=77,
    )
    return SimpleNamespace(
        doc2path=lambda name: str(folder / f"{name}.md"),
        myst_config=MdParserConfig(enable_extensions={"colon_fence"}),
        mystnb_config=config,
        names=list(pages),
    )


class Runs:
    """Stands for what runs a page; remembers what ran, in which order and how many at once."""

    def __init__(self, failing: str | None = None, together: int = 1) -> None:
        self.ran: list[str] = []
        self.options: list[dict[str, Any]] = []
        self.now = self.most = 0
        self.failing = failing
        self.lock = threading.Lock()
        self.together = threading.Barrier(together)  # waits until so many run at once
        self.variables: dict[str, str] = {}

    def __call__(self, notebook: NotebookNode, **options: Any) -> ExecutionResult:
        title = notebook.cells[0].source.removeprefix("# ")
        with self.lock:
            self.ran.append(title)
            self.options.append(options)
            self.now += 1
            self.most = max(self.most, self.now)
            self.variables = dict(os.environ)
        self.together.wait(timeout=30)
        for cell in notebook.cells:
            if cell.cell_type == "code":
                cell.outputs = [nbformat.v4.new_output("stream", text=cell.source)]
        with self.lock:
            self.now -= 1
        error = ValueError("a cell failed") if title == self.failing else None
        return ExecutionResult(notebook, options["cwd"], 1.0, error)


def run(
    hook: ModuleType, env: SimpleNamespace, monkeypatch: pytest.MonkeyPatch, **options: Any
) -> Runs:
    runs = Runs(**options)
    monkeypatch.setattr(hook, "single_nb_execution", runs)
    hook.run_pages(None, env, env.names)
    return runs


def test_two_pages_run_at_once_on_two_cores(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    env = make_env(tmp_path, {"a": ["1"], "b": ["2"]})
    assert run(hook, env, monkeypatch, together=2).most == 2


def test_one_after_the_other_where_the_variable_says_so(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PAGES_AT_ONCE", "1")
    env = make_env(tmp_path, {name: [name] for name in "abc"})
    runs = run(hook, env, monkeypatch)
    assert (sorted(runs.ran), runs.most) == (["a", "b", "c"], 1)


@pytest.mark.parametrize("value", ["0", "-1", "two", "1.5"])
def test_a_number_of_pages_that_is_none_is_refused(
    value: str, hook: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PAGES_AT_ONCE", value)
    with pytest.raises(ConfigError, match=f"PAGES_AT_ONCE: expected a whole number.*'{value}'"):
        hook.count_at_once()


def test_only_pages_with_cells_that_are_not_in_the_cache_run(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    env = make_env(tmp_path, {"text": [], "a": ["1"], "b": ["2"]})
    assert sorted(run(hook, env, monkeypatch).ran) == ["a", "b"]
    assert run(hook, env, monkeypatch).ran == []
    env = make_env(tmp_path, {"text": [], "a": ["1"], "b": ["3"]})
    assert run(hook, env, monkeypatch).ran == ["b"]


def test_a_change_of_the_text_runs_nothing(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    env = make_env(tmp_path, {"a": ["1"]})
    run(hook, env, monkeypatch)
    page = tmp_path / "a.md"
    page.write_text(page.read_text() + "\nOne more sentence.\n")
    assert run(hook, env, monkeypatch).ran == []


def test_long_pages_begin_first(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PAGES_AT_ONCE", "1")
    env = make_env(tmp_path, {"a": ["1"], "b": list("123"), "c": list("12")})
    assert run(hook, env, monkeypatch).ran == ["b", "c", "a"]


def test_a_page_runs_in_a_folder_of_its_own_with_the_limits_of_the_book(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    env = make_env(tmp_path, {"a": ["1"], "b": ["2"]})
    options = run(hook, env, monkeypatch).options
    assert len({one["cwd"] for one in options}) == 2
    for one in options:
        assert not os.path.exists(one["cwd"])  # noqa: PTH110 - a string, as it was given
        assert (one["timeout"], one["allow_errors"]) == (77, False)


def test_kernels_share_the_cores_unless_the_environment_says_otherwise(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LP_NUM_THREADS", "5")
    env = make_env(tmp_path, {"a": ["1"], "b": ["2"]})
    variables = run(hook, env, monkeypatch).variables
    assert variables["OMP_NUM_THREADS"] == "1"
    assert variables["LP_NUM_THREADS"] == "5"
    assert "OMP_NUM_THREADS" not in os.environ
    env = make_env(tmp_path, {"c": ["3"]})  # alone, it may have all
    assert run(hook, env, monkeypatch).variables["OMP_NUM_THREADS"] == "2"


def test_a_page_that_fails_stops_the_build_and_what_has_run_is_kept(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PAGES_AT_ONCE", "1")
    env = make_env(tmp_path, {"a": list("1234"), "b": list("123"), "c": list("12"), "d": ["1"]})
    runs = Runs(failing="b")
    monkeypatch.setattr(hook, "single_nb_execution", runs)
    with pytest.raises(ExecutionError, match=r"b\.md") as caught:
        hook.run_pages(None, env, env.names)
    assert str(caught.value.__cause__) == "a cell failed"
    assert "d" not in runs.ran
    assert "a" not in run(hook, env, monkeypatch).ran


def test_a_page_with_settings_of_its_own_is_left_to_myst_nb(
    hook: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    env = make_env(tmp_path, {"a": ["1"]})
    page = tmp_path / "a.md"
    page.write_text(page.read_text().replace("---\n#", "mystnb: {execution_timeout: 9}\n---\n#"))
    assert run(hook, env, monkeypatch).ran == []


@pytest.mark.slow
def test_what_is_kept_is_what_myst_nb_looks_for_and_would_have_made(
    hook: ModuleType, tmp_path: Path
) -> None:
    cells = ["import os\nprint(len(os.listdir()))", "6 * 7", ":tags: [x]\nprint('done')"]
    env = make_env(tmp_path, {"a": cells, "b": ["print(1)"]})
    hook.run_pages(None, env, env.names)

    def read(folder: Path) -> tuple[NotebookNode, str]:
        """Let MyST-NB have the page from a cache; return the page and what it said."""
        (found,) = hook.find_pages(env, ["a"], get_cache(tmp_path / "empty"))
        said: list[str] = []
        logger = DocutilsDocLogger(new_document("a.md"))
        logger.info = lambda message, *_args, **_options: said.append(message)
        config = env.mystnb_config.copy(execution_cache_path=str(folder))
        with create_client(found.notebook, str(found.path), config, logger, found.read_fmt) as made:
            for cell in made.notebook.cells:
                cell.pop("id", None)
            ensure_event_loop().close()  # MyST-NB leaves it open
            return made.notebook, " ".join(said)

    ours, said = read(tmp_path / "cache")
    assert "Using cached notebook" in said
    theirs, said = read(tmp_path / "own")
    assert "Executed notebook" in said
    assert ours.cells == theirs.cells
    assert ours.metadata == theirs.metadata
    assert ours.cells[1].outputs[0].text == "0\n"


@pytest.mark.slow
def test_what_a_slow_cell_prints_in_pieces_stays_one_line(hook: ModuleType, tmp_path: Path) -> None:
    cell = "import time\nprint('same:', end='', flush=True)\ntime.sleep(0.5)\nprint(' yes')"
    env = make_env(tmp_path, {"a": [cell]})
    hook.run_pages(None, env, env.names)
    (found,) = hook.find_pages(env, ["a"], get_cache(tmp_path / "empty"))
    _, notebook = get_cache(tmp_path / "cache").merge_match_into_notebook(found.notebook)
    (output,) = notebook.cells[1].outputs
    assert output.text == "same: yes\n"
