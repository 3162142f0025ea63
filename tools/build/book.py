"""Build the book: what `make book` runs once the environment stands.

Does nothing where nothing has changed. Otherwise it gathers the front-end files, drops executed
pages that no longer hold, runs Jupyter Book with warnings as errors, and prints one line per stage.
The whole log goes to ``book.log`` beside the pages; of a failure the part that matters is printed.

Usage: ``python -m tools.build.book``. The variable ``EDITION`` chooses what is built:
``student`` (the default) goes to ``_build/html`` and holds no solution; ``instructor``
goes to ``_build/instructor/html`` and adds the pages of ``tools/editions/instructor_pages.py``.
The two share nothing but the front-end files. ``MUJOCO_GL`` is passed on to the cells;
``PAGES_AT_ONCE`` says how many pages run at a time (default: one per core).
"""

import os
import re
import subprocess
import sys
import time

from tools import ROOT
from tools.build.edition import Edition, get_edition
from tools.build.memory import Memory

COLOR_CODES = re.compile(r"\x1b\[[0-9;]*m")
CELL_ERROR = re.compile(
    r"^nbclient\.exceptions\.\w+: .*?(?=^The above exception was|^Extension error|\Z)",
    re.MULTILINE | re.DOTALL,
)
COMPLAINT = re.compile(r"\b(WARNING|ERROR|CRITICAL)\b")
HARMLESS = "Kernel is running over TCP without encryption"  # ipykernel, on the loopback
LAST_LINES = 40

# What `jupyter-book build -W -n --keep-going` runs; the command itself puts pages nowhere
# but into a folder named _build.
JUPYTER_BOOK = """
import sys
from pathlib import Path
# jsonschema compiles the whole grammar of addresses when it is imported, two seconds in which
# nothing happens, for a check that no notebook asks for; without the package it goes on
sys.modules["rfc3987_syntax"] = None
from jupyter_book.sphinx import build_sphinx
source, html, config, toc = map(Path, sys.argv[1:])
code = build_sphinx(
    source, html, noconfig=True, path_config=config, warningiserror=True, keep_going=True,
    confoverrides={
        "external_toc_path": toc.as_posix(), "nitpicky": True, "latex_individualpages": False
    },
)
sys.exit(code if isinstance(code, int) else 1)
"""


def main() -> int:
    """Build the edition that ``EDITION`` names; return the exit code."""
    started = time.monotonic()
    try:
        edition = get_edition(os.environ.get("EDITION", ""))
    except ValueError as error:
        print(f"book: {error}", file=sys.stderr)
        return 2
    edition.build.mkdir(parents=True, exist_ok=True)
    memory = Memory(edition)
    if memory.is_up_to_date():
        print("book: nothing has changed since the last build")
        print(f"open {(edition.html / 'index.html').as_uri()}")
        return 0
    if code := gather(edition):
        return code
    print(f"executed pages: {memory.forget_what_changed()}", flush=True)
    code, log = _run_jupyter_book(edition)
    executed = log.count("Executed notebook in")
    read = len(set(re.findall(r"^reading sources\.\.\. \[ *\d+%\] (\S+)", log, re.MULTILINE)))
    seconds = time.monotonic() - started
    if code:
        memory.forget_pages()
        print(_what_went_wrong(log), file=sys.stderr)
        print(
            f"book: failed after {seconds:.0f} s; the whole log is {edition.log}", file=sys.stderr
        )
        return code
    memory.note_built()
    print(f"book: {read} pages read, {executed} executed, no warnings, {seconds:.0f} s")
    print(f"open {(edition.html / 'index.html').as_uri()}")
    return 0


def gather(edition: Edition) -> int:
    """Bring together what Jupyter Book does not make; return the exit code."""
    # only here: a build without changes shall not wait for these imports
    from tools.vendor import frontend, pack_python, page_hero  # noqa: PLC0415

    if code := frontend.main() or page_hero.main() or pack_python.main():
        return code
    if edition.name == "instructor":
        # measures every mistake, which only this edition needs
        from tools.editions import instructor_pages  # noqa: PLC0415

        print(f"instructor pages: {instructor_pages.write_pages()}", flush=True)
    return 0


def _run_jupyter_book(edition: Edition) -> tuple[int, str]:
    """Run the build; return its exit code and its log without colors."""
    command = [sys.executable, "-c", JUPYTER_BOOK]
    command += [str(ROOT), str(edition.html), str(ROOT / edition.config), str(ROOT / edition.toc)]
    environment = os.environ | {
        "IPYTHONDIR": str(
            edition.build / "ipython"
        ),  # not the reader's own profile and start-up files
        "JUPYTER_PREFER_ENV_PATH": "1",  # the kernel of this environment, not one of the user
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        "PYTHONHASHSEED": "0",  # the same order of sets in every build
        "PYTHONUNBUFFERED": "1",
    }
    lines = []
    with (
        edition.log.open("w", encoding="utf-8") as file,
        subprocess.Popen(
            command,
            cwd=ROOT,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
        ) as process,
    ):
        for raw in process.stdout or ():
            line = COLOR_CODES.sub("", raw)
            file.write(line)
            lines.append(line)
            if "Executing notebook using" in line:
                print(f"  running {_relative(line).split(': ')[0]}", flush=True)
    return process.returncode, "".join(lines)


def _what_went_wrong(log: str) -> str:
    """Return the part of the log that explains the failure."""
    complaints = [
        _relative(line)
        for line in log.splitlines()
        if COMPLAINT.search(line) and HARMLESS not in line
    ]
    parts = ["", *dict.fromkeys(complaints)]
    if error := CELL_ERROR.search(log):
        parts += ["", _relative(error[0]).strip()]
    elif not complaints:
        parts += log.splitlines()[-LAST_LINES:]
    return "\n".join([*parts, ""])


def _relative(text: str) -> str:
    return text.replace(f"{ROOT}{os.sep}", "")


if __name__ == "__main__":
    sys.exit(main())
