"""Turn the Markdown of the book into what any notebook shows.

A notebook knows plain Markdown only. Roles such as {term} would stand there as written,
so they become text and links, boxes become quotes, questions get their choices, and a
figure its picture. Cells of code are left as they are.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path, PurePosixPath
from urllib.parse import quote

from content.path import read_path
from content.quiz_items import load_page
from labutils.checks.table import read_words
from tools.derive.path_tables import make_steps

#: Where a page has gone: given a path relative to the page, return what to link instead.
Resolve = Callable[[str], str]

LABEL = re.compile(r"^\(([\w-]+)\)=\n", re.MULTILINE)
LINK = re.compile(r"(?<=\]\()(?!\w+:)([^)#\s]+\.md)(#[\w-]*)?(?=\))")
FENCE = re.compile(
    r"^(?P<fence>`{3,}|:{3,})\{(?P<name>[\w-]+)\} ?(?P<title>[^\n]*)\n"
    r"(?P<body>.*?)^(?P=fence) *$\n?",
    re.MULTILINE | re.DOTALL,
)
INCLUDE = re.compile(
    r"^(?P<fence>`{3,}|:{3,})\{(?P<literal>literal)?include\} (?P<path>.*)\n[^`]*?^(?P=fence) *$",
    re.MULTILINE,
)
OPTION = re.compile(r"^:([\w-]+): ?(.*)\n", re.MULTILINE)
ROLE = re.compile(r"\{(\w+)\}`([^`]+)`")
TARGET = re.compile(r"^(.*?)\s*<([^<>]+)>$", re.DOTALL)
FORMULA = re.compile(r"^(\$\$.*?) *\$\$ *\(([\w-]+)\) *$", re.MULTILINE)
TERM = re.compile(r"^(\S.*)\n {2,}", re.MULTILINE)
TABLE_ROW = re.compile(r"^\* - ", re.MULTILINE)
TABLE_CELL = re.compile(r"^  - ", re.MULTILINE)


def find_labels(pages: dict[str, str]) -> dict[str, tuple[str, str]]:
    """Map each label above a heading to its page and to the heading."""
    found = {}
    for page, text in pages.items():
        for label, title in re.findall(r"^\(([\w-]+)\)=\n+#+ (.+)$", text, re.MULTILINE):
            found[label] = (page, title)
    return found


class Flattener:
    """Flatten the text of one page.

    Parameters
    ----------
    page : str
        Its path in the repository, with its ending.
    root : Path
        The repository.
    labels : dict of str to (str, str)
        What `find_labels` gives.
    resolve : callable
        From the path of a page to the path of what is shipped of it.
    """

    def __init__(
        self, page: str, root: Path, labels: dict[str, tuple[str, str]], resolve: Resolve
    ) -> None:
        self.page, self.root, self.labels, self.resolve = page, root, labels, resolve

    def flatten(self, text: str) -> str:
        """Return plain Markdown."""
        text = INCLUDE.sub(self._include, text)
        text = LABEL.sub("", text)
        text = FENCE.sub(self._flatten_fence, text)
        text = LINK.sub(self._flatten_link, text)
        text = ROLE.sub(self._flatten_role, text)
        return FORMULA.sub(lambda match: f"{match[1]} \\tag{{{_shorten(match[2])}}} $$", text)

    def _flatten_link(self, match: re.Match[str]) -> str:
        label = (match[2] or "").removeprefix("#")
        place = _make_place(self.labels[label][1]) if label in self.labels else ""
        return self.resolve(match[1]) + place

    def _flatten_fence(self, match: re.Match[str]) -> str:
        name, title, body = match["name"], match["title"], match["body"]
        options = dict(OPTION.findall(body))
        body = OPTION.sub("", body).strip()
        simple = {
            "math": lambda: _make_formula(body, options.get("label")),
            "figure": lambda: _make_picture(title, options.get("alt", ""), body),
            "image": lambda: _make_picture(title, options.get("alt", ""), body),
            "quiz": lambda: self._make_questions(title),
            "path": lambda: make_steps(read_path(read_words())),
            "table": lambda: f"**{title}**\n\n{body}\n",
            "list-table": lambda: _make_table(body),
            "glossary": lambda: TERM.sub(r"**\1**: ", body) + "\n",
        }
        if name in simple:
            return simple[name]()
        inner = FENCE.sub(self._flatten_fence, f"{body}\n").strip()
        heading = title if name in ("admonition", "dropdown") else title or name.capitalize()
        return _quote(f"**{heading}**\n\n{inner}" if heading else inner)

    def _include(self, match: re.Match[str]) -> str:
        path = self.root / PurePosixPath(self.page).parent / match["path"].strip()
        content = path.read_text(encoding="utf-8").strip()
        return content if match["literal"] is None else f"```python\n{content}\n```"

    def _make_questions(self, page: str) -> str:
        parts = []
        for number, item in enumerate(load_page(page), 1):
            choices = zip("ABCD", item.choices, strict=False)
            said = [(letter, choice) for letter, choice in choices]
            asked = "\n".join(f"- {letter}: {choice.text}" for letter, choice in said)
            answers = "\n".join(
                f"- **{letter}{' is right' if choice.right else ': no'}.** {choice.feedback}"
                for letter, choice in said
            )
            parts.append(
                f"**Question {number}.** {item.question}\n\n{asked}\n\n"
                f"<details><summary>Answers</summary>\n\n{answers}\n\n</details>\n"
            )
        return "\n".join(parts)

    def _flatten_role(self, match: re.Match[str]) -> str:
        role, content = match[1], match[2]
        if role == "eq":
            return f"({_shorten(content)})"
        split = TARGET.match(content)
        words, target = (split[1], split[2]) if split else (content, content)
        if role in ("ref", "numref") and target in self.labels:
            page, title = self.labels[target]
            words = words if split else title
            here = PurePosixPath(self.page).parent.as_posix()
            return f"[{words}]({self.resolve(_make_relative(page, here))}{_make_place(title)})"
        if role == "numref":
            return "the figure"
        return words


def _quote(text: str) -> str:
    return "\n".join(f"> {line}".rstrip() for line in text.splitlines()) + "\n"


def _make_place(title: str) -> str:
    """Return the address within a notebook that JupyterLab gives to a heading."""
    return "#" + quote(title.replace(" ", "-").replace("`", ""))


def _shorten(label: str) -> str:
    """Name a formula as its text does: eq-iou is (iou)."""
    return label.removeprefix("eq-")


def _make_formula(body: str, label: str | None) -> str:
    tag = f"\n\\tag{{{_shorten(label)}}}" if label else ""
    return f"$$\n{body}{tag}\n$$\n"


def _make_picture(path: str, words: str, caption: str) -> str:
    return f"![{words}]({path})\n" + (f"\n*{caption}*\n" if caption else "")


def _make_table(rows: str) -> str:
    """Turn the list of a list-table into lines with bars; its first row is the head."""
    cells = [TABLE_CELL.split(row) for row in TABLE_ROW.split(rows)[1:]]
    lines = ["| " + " | ".join(" ".join(cell.split()) for cell in row) for row in cells]
    columns = lines[0].count("|")
    lines.insert(1, "|" + "---|" * columns)
    return (
        "\n".join(f"{line} |" if number != 1 else line for number, line in enumerate(lines)) + "\n"
    )


def _make_relative(page: str, folder: str) -> str:
    """Return the path of a page as seen from a folder of the same tree."""
    parts, base = PurePosixPath(page).parts, PurePosixPath(folder).parts
    while parts and base and parts[0] == base[0]:
        parts, base = parts[1:], base[1:]
    return "/".join([*[".."] * len(base), *parts])
