"""Write the cell a learner starts from: what the reference promises, nothing of its body."""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from solutions import Exercise

#: Columns of a code cell that a page shows without scrolling.
WIDTH = 70

#: Sections of a docstring in which an exercise may ask for less than the library does.
SECTIONS = ("Convention", "Returns", "Raises", "Examples", "References")

#: A duty of every exercise.
INPUTS_STAY = "The arguments stay as they are."

#: What may change all the same: MuJoCo computes it from the state, and whoever looks asks for it.
STATE_MAY_FOLLOW = "What follows from the state in `data` may be brought up to date."


def make_starter(exercise: Exercise) -> str:
    """Keep imports, signature and docstring of the reference, and nothing of its body.

    What the library's function takes by keyword only goes beyond the exercise: signature and
    docstring of the starter leave it out. Where an exercise asks for less in another way, its card
    has the words (`Exercise.asks`).
    """
    tree = ast.parse(textwrap.dedent(inspect.getsource(exercise.reference)))
    function = tree.body[0]
    assert isinstance(function, ast.FunctionDef)  # noqa: S101 - cards refer to plain functions
    extras = [argument.arg for argument in function.args.kwonlyargs]
    function.args.kwonlyargs, function.args.kw_defaults = [], []
    for argument in function.args.args:
        argument.annotation = None  # the names in them are not imported where a learner writes
    docstring = inspect.cleandoc(ast.get_docstring(function, clean=False) or "")
    follows = any(argument.arg == "data" for argument in function.args.args)
    docstring = promise_inputs(narrow(docstring, extras, exercise.asks), follows=follows)
    docstring = textwrap.indent(rewrap(docstring), "    ", lambda line: bool(line.strip()))
    head = f"def {exercise.name}({ast.unparse(function.args)}):"
    if len(head) > WIDTH:
        head = f"def {exercise.name}(\n    {ast.unparse(function.args)},\n):"
    return (
        "\n".join(exercise.imports) + f'\n\n\n{head}\n    """{docstring.strip()}\n'
        f'    """\n    raise NotImplementedError\n'
    )


def rewrap(docstring: str) -> str:
    """Break lines that are too long for a cell on a page, but no examples."""
    lines: list[str] = []
    block: list[str] = []
    for line in [*docstring.splitlines(), ""]:
        ends = not line or line.startswith("---") or _get_indent(line) != _get_indent(*block[:1])
        if ends and block:
            lines += _wrap(block)
            block = []
        if not line or line.startswith("---"):
            lines.append(line)
        else:
            block.append(line)
    return "\n".join(lines).strip()


def _get_indent(line: str = "") -> int:
    return len(line) - len(line.lstrip())


def _wrap(block: list[str]) -> list[str]:
    limit = WIDTH - 4  # inside a function
    if max(map(len, block)) <= limit or block[0].lstrip().startswith(">>>"):
        return block
    indent = " " * _get_indent(block[0])
    return textwrap.wrap(
        " ".join(line.strip() for line in block),
        limit,
        initial_indent=indent,
        subsequent_indent=indent if " : " not in block[0] else f"{indent}    ",
        break_long_words=False,
        break_on_hyphens=False,
    )


def promise_inputs(docstring: str, *, follows: bool = False) -> str:
    """Say after the section Parameters what holds in every exercise: the check looks at it."""
    head, found, rest = docstring.partition("\nParameters\n----------\n")
    if not found:
        raise ValueError("expected a section Parameters, got none")
    section, blank, tail = rest.partition("\n\n")
    promise = f"{INPUTS_STAY} {STATE_MAY_FOLLOW}" if follows else INPUTS_STAY
    return f"{head}{found}{section}\n\n{promise}{blank}{tail}"


def narrow(docstring: str, extras: list[str], asks: Mapping[str, str]) -> str:
    """Rewrite a docstring for an exercise that asks for less than the library does.

    Parameters
    ----------
    docstring : str
        Cleaned: sections start at the first column.
    extras : list of str
        Parameters whose entries are left out.
    asks : mapping
        Parameter to the entry that replaces its own: the type, a line break, the description. Or
        the title of a section to the text below it; a section without text is left out.

    Raises
    ------
    ValueError
        If there is no such section, or an entry has no parameter of its own: it would be lost, or
        kept, unseen.
    """
    titles = [title for title in asks if title in SECTIONS]
    for title in titles:
        docstring = _replace_section(docstring, title, asks[title])
    asks = {name: words for name, words in asks.items() if name not in titles}
    head, found, rest = docstring.partition("\nParameters\n----------\n")
    section, blank, tail = rest.partition("\n\n")
    entries = re.split(r"\n(?=\S)", section)
    names = [entry.partition(" :")[0].split(", ") for entry in entries]
    for wanted in (*extras, *asks):
        if wanted not in [name for one in names for name in one]:
            raise ValueError(f"{wanted}: expected an entry in the section Parameters, got none")
    kept = []
    for entry, its_names in zip(entries, names, strict=True):
        left = [name for name in its_names if name not in extras]
        if not left:
            continue
        replaced = [name for name in left if name in asks]
        if replaced and len(left) > 1:
            raise ValueError(f"{replaced[0]}: expected an entry of its own, got {', '.join(left)}")
        if replaced:
            kind, _, description = asks[replaced[0]].partition("\n")
            kept.append(f"{replaced[0]} : {kind}\n{textwrap.indent(description, '    ')}")
        else:
            kept.append(", ".join(left) + entry[len(", ".join(its_names)) :])
    return head + found + "\n".join(kept) + blank + tail


def _replace_section(docstring: str, title: str, text: str) -> str:
    head, found, rest = docstring.partition(f"\n\n{title}\n{'-' * len(title)}\n")
    if not found:
        raise ValueError(f"{title}: expected a section of this title, got none")
    following = re.search(r"\n\n(?=\S[^\n]*\n-+\n)", rest)
    tail = rest[following.start() :] if following else ""
    return head + (found + text if text else "") + tail
