"""Recognize what must not leave the instructor's room, wherever it turns up.

A card gives away its answer by its code. So from every card a few fingerprints are taken:
lines of code that occur nowhere in the library, names of its helpers, sentences written for
instructors. Products are read as their readers would: pages without tags, notebooks cell by
cell, archives member by member, whatever the spacing.
"""

from __future__ import annotations

import ast
import html
import inspect
import io
import json
import re
import textwrap
import tokenize
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from solutions import Exercise
from solutions._completion import find_open_lines
from solutions._open_answers import Marked
from tools.editions.card_code import find_called, is_answered_by_library

ROOT = Path(__file__).resolve().parents[2]

#: A line of code shorter than this, without its spaces, is anybody's.
MIN_LINE = 24
#: Lines of one function that add up to this are no accident; one long line may be enough.
MIN_FOUND = 45
MIN_NAME = 9
MIN_SENTENCE = 50

#: Texts in which a reader may look; everything else in a build is a picture or a font.
TEXT = {".html", ".js", ".json", ".md", ".txt", ".py", ".yml", ".toml", ".xml", ".css", ".svg"}
#: What the build takes from others: no text of ours.
FOREIGN = (
    "_static/minisearch",
    "_static/widgets",
    "_static/vendor",
    "_static/scripts",
    "_static/python/vendor",
    "_static/python/editor.js",
)
NAMELESS = {"_answer_with", "_visible", "_hidden", "EXERCISE"}


@dataclass(frozen=True)
class Secret:
    """What must not be found together: the lines of one function, one name, or one sentence."""

    origin: str
    lines: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    sentences: tuple[str, ...] = field(default=(), repr=False)


def squeeze(text: str) -> str:
    """Drop spaces, and write all quotation marks alike."""
    return re.sub(r"\s+", "", text).replace("'", '"')


@cache
def read_library() -> str:
    """All code of the library, squeezed: a line in it gives nothing away."""
    files = sorted((ROOT / "labutils").rglob("*.py"))
    return squeeze("\n".join(path.read_text(encoding="utf-8") for path in files))


def get_lines(function: Callable[..., Any]) -> tuple[str, ...]:
    """Return the distinctive lines of a function: its body, without docstring and comments."""
    chosen = [
        line
        for line in read_lines(function)
        if len(line) >= MIN_LINE and line not in read_library()
    ]
    return tuple(dict.fromkeys(chosen))


def get_completed_lines(function: Callable[..., Any]) -> tuple[str, ...]:
    """Return the open lines of a twin that assign, each with the line that follows, and as marked.

    Together they are nobody else's, although a line alone may stand in a chapter.
    """
    lines = read_lines(function)
    found = [one for one in find_open_lines(function) if one.target]
    places = [lines.index(squeeze(one.code)) for one in found]
    marked = [squeeze(f"{one.code}  # open: {one.asks}") for one in found]
    return (*(lines[place] + lines[place + 1] for place in places), *marked)


def read_lines(function: Callable[..., Any]) -> list[str]:
    """Read the body of a function line by line, squeezed, without docstring and comments."""
    source = textwrap.dedent(inspect.getsource(function))
    tree = ast.parse(source).body[0]
    if not isinstance(tree, ast.FunctionDef):  # a lambda: what it calls has lines of its own
        return []
    docstring = tree.body[0] if ast.get_docstring(tree) is not None else None
    first = (docstring.end_lineno if docstring else tree.body[0].lineno - 1) or 0
    lines, current = [], ""
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.start[0] <= first or token.type in (tokenize.COMMENT, tokenize.NL):
            continue
        if token.type == tokenize.NEWLINE:
            lines.append(squeeze(current))
            current = ""
        elif token.type not in (tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER):
            current += token.string
    return lines


def collect_secrets(exercises: Iterable[Exercise], notes: Iterable[Path] = ()) -> list[Secret]:
    """Take the fingerprints of cards, and of the notes for instructors."""
    secrets = []
    for exercise in exercises:
        functions: list[Callable[..., Any]] = [exercise.hidden]
        if not is_answered_by_library(exercise):
            functions += [exercise.reference, exercise.answer_with, exercise.visible]
        for function in find_called(*functions):
            origin = f"{exercise.name}: {function.__name__}"
            secrets.append(Secret(origin, lines=get_lines(function)))
            secrets.append(Secret(origin, names=get_names(exercise, function)))
        if exercise.completion:
            lines = get_completed_lines(exercise.completion.twin)
            origin = f"{exercise.name}: completion"
            secrets += [Secret(origin, lines=(one,)) for one in lines]
        said = (exercise.tolerance_reason, *(one.reason for one in exercise.absorbed))
        secrets.append(Secret(f"{exercise.name}: reasons", sentences=get_sentences(said)))
    for path in notes:
        text = re.sub(r"[*`]", "", path.read_text(encoding="utf-8"))
        secrets.append(Secret(path.name, sentences=get_sentences([text])))
    return [one for one in secrets if one.lines or one.names or one.sentences]


def collect_answer_secrets(marked: Iterable[Marked]) -> list[Secret]:
    """Take the fingerprints of the example answers to open tasks: what they say, how they measure.

    A line that a page of the book has too gives nothing away.
    """
    pages = [*(ROOT / "book").glob("*.md"), *(ROOT / "exercises").glob("*.md")]
    public = squeeze("\n".join(path.read_text(encoding="utf-8") for path in sorted(pages)))
    secrets = []
    for one in marked:
        levels = (text for texts in one.levels.values() for text in texts)
        secrets.append(Secret(f"{one.task.page}: levels", sentences=get_sentences(levels)))
        for answer in one.answers:
            origin = f"{one.task.page}: {answer.kind}"
            said = [answer.text, *(mark.because for mark in answer.marks.values())]
            filled = [re.sub(r"[*`]", "", answer.fill(text)) for text in said]
            secrets.append(Secret(origin, sentences=get_sentences(filled)))
            lines = tuple(line for line in get_lines(answer.measure) if line not in public)
            secrets.append(Secret(origin, lines=lines))
    return [one for one in secrets if one.lines or one.sentences]


def get_names(exercise: Exercise, function: Callable[..., Any]) -> tuple[str, ...]:
    """Return the name of a helper where it is a name of its own."""
    name = function.__name__
    known = name == exercise.name or name in NAMELESS or len(name) < MIN_NAME
    return () if known or "_" not in name.strip("_") or name in read_library() else (name,)


def get_sentences(texts: Iterable[str]) -> tuple[str, ...]:
    """Split texts and keep, squeezed, what is long enough to be nobody else's."""
    parts = (squeeze(part) for text in texts for part in re.split(r"[.:;?]\s", text))
    return tuple(part for part in parts if len(part) >= MIN_SENTENCE)


def find_leaks(secrets: Iterable[Secret], documents: Iterable[tuple[str, str]]) -> list[str]:
    """Say what is found where, one line each."""
    secrets = list(secrets)
    return [
        f"{where}: {secret.origin} ({what})"
        for where, text in documents
        for secret in secrets
        if (what := _find_secret(secret, text, squeeze(text)))
    ]


def _find_secret(secret: Secret, text: str, squeezed: str) -> str:
    found = [line for line in secret.lines if line in squeezed]
    enough = min(MIN_FOUND, sum(map(len, secret.lines)))
    if found and sum(map(len, found)) >= enough:
        return f"{len(found)} of {len(secret.lines)} lines"
    for name in secret.names:
        # the search index writes words in small letters
        if re.search(rf"(?<![A-Za-z0-9]){re.escape(name)}(?![A-Za-z0-9])", text, re.IGNORECASE):
            return f"the name {name}"
    for sentence in secret.sentences:
        if sentence in squeezed:
            return "a sentence for instructors"
    return ""


def read_documents(folder: Path) -> Iterator[tuple[str, str]]:
    """Read every text below a folder, archives included."""
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_file() and not name.startswith(FOREIGN):
            yield from read_document(name, path.read_bytes())


def read_document(name: str, content: bytes) -> Iterator[tuple[str, str]]:
    """Read one file as its reader would; a binary one has only a name."""
    ending = Path(name).suffix
    if ending in (".zip", ".npz", ".whl"):
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            yield name, "\n".join(archive.namelist())
            # arrays hold outputs, not code: of them only the names are read
            for member in archive.namelist() if ending != ".npz" else ():
                yield from read_document(f"{name}/{member}", archive.read(member))
    elif ending == ".ipynb":
        yield name, read_notebook(content)
    elif ending == ".html":
        text = content.decode(errors="replace")
        yield name, f"{html.unescape(re.sub(r'<[^<>]*>', '', text))}\n{html.unescape(text)}"
    elif name.endswith("objects.inv"):
        head = content.split(b"\n", 4)
        yield name, zlib.decompress(head[4]).decode(errors="replace")
    elif ending in TEXT:
        yield name, content.decode(errors="replace")
    else:
        yield name, name


def read_notebook(content: bytes) -> str:
    """Join the cells of a notebook with everything that is written into them."""
    notebook = json.loads(content)
    return "\n".join(["\n".join(_find_texts(cell)) for cell in notebook.get("cells", [])])


def _find_texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from (str(key), *_find_texts(inner))
    elif isinstance(value, list):
        if all(isinstance(inner, str) for inner in value):
            yield "".join(value)
        else:
            for inner in value:
                yield from _find_texts(inner)
