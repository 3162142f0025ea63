"""Run the pages that have to be run side by side, before Sphinx reads them one after the other.

The results go to the cache of executed pages, under the keys by which MyST-NB looks them up: it
finds every page there, as if an earlier build had run it. What runs a page is what MyST-NB itself
would call, with the same notebook, folder and time limit. Only that what a cell prints is joined
here, as it came: a kernel that is short of time hands it over in pieces, and MyST-NB would end a
line after each of them.

One process runs all kernels, each from a thread: so no two of them are given the same port. The
variable ``PAGES_AT_ONCE`` says how many; with 1, they run one after the other.
"""

import os
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from jupyter_cache import get_cache
from jupyter_cache.base import CacheBundleIn, JupyterCacheAbstract
from jupyter_cache.executors.utils import ExecutionResult, single_nb_execution
from jupyter_core.utils import ensure_event_loop
from myst_nb.core.config import NbParserConfig
from myst_nb.core.execute import ExecutionError
from myst_nb.core.read import create_nb_reader
from nbformat import NotebookNode
from sphinx.application import Sphinx
from sphinx.errors import ConfigError
from sphinx.util import logging

logger = logging.getLogger(__name__)

VARIABLE = "PAGES_AT_ONCE"
# Numerics and OpenGL take all cores for one kernel; several kernels would only wait for each other.
THREAD_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "LP_NUM_THREADS")


@dataclass(frozen=True)
class Page:
    """A page to run."""

    name: str
    path: Path
    notebook: NotebookNode
    read_fmt: dict[str, Any] | None

    @property
    def weight(self) -> int:
        """How many cells there are: nearly how long the page takes, compared with others."""
        return sum(cell.cell_type == "code" for cell in self.notebook.cells)

    def run(self, config: NbParserConfig) -> ExecutionResult:
        """Run all cells in a folder of their own; write their outputs into the notebook."""
        logger.info("%s: Executing notebook using temporary CWD [mystnb]", self.path)
        try:
            with TemporaryDirectory() as folder:
                return single_nb_execution(
                    self.notebook,
                    cwd=folder,
                    allow_errors=config.execution_allow_errors,
                    timeout=config.execution_timeout,
                    meta_override=True,
                    coalesce_streams=True,
                )
        finally:
            ensure_event_loop().close()  # the one that nbclient has made for this thread


def run_pages(_app: Sphinx, env: Any, names: list[str]) -> None:
    """Run those of the pages that Sphinx is about to read which are not in the cache.

    MyST-NB hangs its settings on the environment, whose type does not know them.
    """
    config = env.mystnb_config
    if config.execution_mode != "cache" or not config.execution_in_temp:
        return
    cache = get_cache(config.execution_cache_path)
    pages = sorted(find_pages(env, names, cache), key=lambda page: -page.weight)
    at_once = min(count_at_once(), len(pages)) or 1
    running: dict[Future[ExecutionResult], Page] = {}
    with share_cores(at_once), ThreadPoolExecutor(at_once) as pool:
        while pages or running:
            while pages and len(running) < at_once:  # after an error, no other page begins
                page = pages.pop(0)
                running[pool.submit(page.run, config)] = page
            for done in wait(running, return_when=FIRST_COMPLETED).done:
                keep(running.pop(done), done.result(), cache)


def find_pages(env: Any, names: Iterable[str], cache: JupyterCacheAbstract) -> Iterator[Page]:
    """Read the pages with cells as MyST-NB does; give those the cache does not have."""
    for name in names:
        path = Path(env.doc2path(name))
        text = path.read_text(encoding="utf-8-sig")
        reader = create_nb_reader(str(path), env.myst_config, env.mystnb_config, text)
        if reader is None:
            continue
        notebook = reader.read(text)
        if env.mystnb_config.metadata_key in notebook.metadata:
            continue  # a page with settings of its own is left to MyST-NB
        try:
            cache.match_cache_notebook(notebook)
        except KeyError:
            yield Page(name, path, notebook, reader.read_fmt)


def keep(page: Page, result: ExecutionResult, cache: JupyterCacheAbstract) -> None:
    """Put a page that has run into the cache.

    Raises
    ------
    ExecutionError
        If a cell has failed; what failed is its cause, as it is in MyST-NB.
    """
    if result.err is not None:
        kind = type(result.err).__name__
        logger.warning(
            "Executing notebook failed: %s [mystnb.exec]", kind, location=page.name, type="mystnb"
        )
        logger.info("%s", result.exc_string)  # Sphinx tells no more of an error in a hook
        raise ExecutionError(str(page.path)) from result.err
    read = {"read_data": page.read_fmt} if page.read_fmt else {}
    record = cache.add_nb_to_project(str(page.path), **read)
    bundle = CacheBundleIn(page.notebook, record.uri, data={"execution_seconds": result.time})
    cache.cache_notebook_bundle(bundle, check_validity=False, overwrite=True)
    logger.info("%s: Executed notebook in %.2f seconds [mystnb]", page.path, result.time)


def count_at_once() -> int:
    """Return how many pages run at a time: one per core, unless the variable says otherwise.

    Raises
    ------
    ConfigError
        If the variable is no whole number above zero.
    """
    wanted = os.environ.get(VARIABLE, "")
    if not wanted:
        return count_cores()
    if not wanted.isdecimal() or int(wanted) < 1:
        raise ConfigError(f"{VARIABLE}: expected a whole number from 1, got {wanted!r}")
    return int(wanted)


def count_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@contextmanager
def share_cores(at_once: int) -> Iterator[None]:
    """Let kernels that start in the block use their share of the cores; keep what is set."""
    threads = str(max(1, count_cores() // at_once))
    added = [name for name in THREAD_VARIABLES if name not in os.environ]
    os.environ.update(dict.fromkeys(added, threads))
    try:
        yield
    finally:
        for name in added:
            del os.environ[name]


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("env-before-read-docs", run_pages)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
