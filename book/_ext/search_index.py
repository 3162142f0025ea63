"""Write what the search page looks in: every section of the book, and an index of its words.

Both are one classic script, because a page that was opened from a file may fetch nothing. The
index has the form in which MiniSearch keeps its own, so that a browser only loads it. What makes a
word stands here (`split_words`) and in ``search_engine.js``; a test compares the two.
"""

import hashlib
import json
import re
from collections import Counter
from collections.abc import Iterable
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.search.en import SearchEnglish

from content.chapters import READING, find_chapter

SCRIPT = "search_index.js"
#: Fields of a section: the first line of a page, its own heading, words it explains, the rest.
FIELDS = ("title", "heading", "terms", "text", "code")
#: Kinds of pages, and how much they count: first where a thing is taught, then the rest.
WEIGHTS = {
    "chapter": 2.0,
    "exercise": 1.0,
    "reading": 1.0,
    "glossary": 0.8,
    "help": 0.7,
    "reference": 0.4,
}
GLOSSARY = "book/glossary"
TERM = "term-"  # with this begins the anchor of its terms
HELP = ("book/troubleshooting", "book/errata", "book/rubric")
REFERENCE = ("book/references", "book/architecture", "book/speed", "book/evidence")
#: Sections of a chapter that say what the whole page is about: they are found as its top.
ABOUT_PAGE = ("question-and-objectives", "new-words")
#: Sections of a chapter that repeat or prepare; what they mention is explained elsewhere.
MINOR = {
    "check-your-understanding",
    "exercises",
    "expected-result",
    "further-reading",
    "recap",
    "set-up",
    "where-we-are",
}
MINOR_WEIGHT = 0.4
#: Words that say nothing about what is looked for; `near` and `up` do say something here.
STOP_WORDS = frozenset(
    "a about am an and any are as at be been but by can could did do does for from get had has have "
    "how i if in into is it its may me my of on or our shall should so than that the their then "
    "there these they this those to us was we were what when where which who why will with would "
    "you your".split()
)
#: Other spellings of the words of this book, as a reader may type them.
SPELLINGS = {
    "colour": "color",
    "colours": "color",
    "metre": "meter",
    "metres": "meter",
    "millimetre": "millimeter",
    "millimetres": "millimeter",
    "grey": "gray",
    "centre": "center",
    "centres": "center",
    "neighbour": "neighbor",
    "neighbours": "neighbor",
}
WORD = re.compile(r"[^\W_]+")
TEX_LAYOUT = re.compile(
    r"\\(?:frac|mathrm|mathbf|mathsf|operatorname|text|left|right|[dt]frac|q?quad|begin|end)\b"
)
TEX_SIGNS = re.compile(r"\\[()\[\],;:! ]|[{}\\]")
VOID = {"area", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}
INLINE = {"a", "abbr", "b", "code", "em", "i", "kbd", "mark", "small", "span", "strong", "sub", "sup"}
HEADINGS = {"h1", "h2", "h3", "h4", "h5", "h6"}
SKIPPED_TAGS = {"script", "style", "nav", "button", "svg", "noscript", "textarea"}
# answers of the quiz: a result must not give away what its page asks
SKIPPED_CLASSES = {
    "admonition-title",  # "Predict" is no part of a sentence
    "caption-number",
    "cell_output",
    "headerlink",
    "page-stamp",
    "quiz-answers",
}

stemmer = SearchEnglish({})


class SectionReader(HTMLParser):
    """Read the article of a page section by section; every glossary term is a section.

    `sections` holds one record each: `anchor`, `trail` (the headings above it), and the
    FIELDS but `title`, as lists of pieces until `close` joins them.
    """

    def __init__(self) -> None:
        super().__init__()
        self.sections: list[dict[str, Any]] = []
        self._open: list[dict[str, Any]] = []
        self._is_formula = False
        # of every element that is open: its tag, and where its text goes
        self._elements: list[tuple[str, tuple[str, ...]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Open a section, or decide where the text of an element goes."""
        given = {key: value or "" for key, value in attrs}
        if tag == "article" and "bd-article" in given.get("class", ""):
            self._elements = [(tag, ("text",))]
        if not self._elements:
            return
        if tag not in INLINE:
            self._write(" ")
        if tag in VOID:
            return
        self._is_formula = tag == "span" and "math" in given.get("class", "").split()
        name = given.get("id", "")
        is_term = tag == "dt" and name.startswith(TERM)
        if (tag == "section" and name) or is_term:
            self._begin(name)
        elif tag == "span" and name and self._open:
            self._open[-1]["terms"].append(f" {name} ")  # a label, like exercise-depth-to-meters
        goes = self._elements[-1][1]
        if tag != "article":
            goes = _choose_fields(tag, set(given.get("class", "").split()), goes, is_term=is_term)
        self._elements.append((tag, goes))

    def handle_endtag(self, tag: str) -> None:
        """Close what the tag closes, and the section with it."""
        self._is_formula = False
        if not self._elements or tag in VOID:
            return
        while self._elements:
            closed, goes = self._elements.pop()
            if "terms" in goes and self._open:
                self._open[-1]["terms"].append(" ")  # two terms are two words
            if closed == tag:
                break
        if tag not in INLINE:
            self._write(" ")
        if self._open and (tag == "section" or (tag == "dd" and self._is_in_term())):
            self._open.pop()
        if tag == "article":
            self._elements = []

    def handle_data(self, data: str) -> None:
        """Keep a piece of text."""
        self._write(_drop_tex(data) if self._is_formula else data)

    def close(self) -> None:
        """Join the pieces."""
        super().close()
        for section in self.sections:
            for field in FIELDS[1:]:
                section[field] = " ".join("".join(section[field]).split())
        for section in self.sections:
            section["trail"] = [above["heading"] for above in section["trail"]]

    def _is_in_term(self) -> bool:
        return bool(self._open) and self._open[-1]["anchor"].startswith(TERM)

    def _begin(self, anchor: str) -> None:
        fields: dict[str, Any] = {field: [] for field in FIELDS[1:]}
        section = {"anchor": anchor, "trail": list(self._open), **fields}
        self.sections.append(section)
        self._open.append(section)

    def _write(self, text: str) -> None:
        if self._open and self._elements:
            for field in self._elements[-1][1]:
                self._open[-1][field].append(text)


def _choose_fields(
    tag: str, classes: set[str], goes: tuple[str, ...], *, is_term: bool
) -> tuple[str, ...]:
    """Say which fields the text of an element belongs to; `goes` is where it went so far."""
    if tag == "figcaption":
        return ("text",)  # also below an output
    if not goes or tag in SKIPPED_TAGS or classes & SKIPPED_CLASSES:
        return ()
    if tag == "div" and "math" in classes:
        return ()
    if tag in HEADINGS or is_term:
        return ("heading",)
    if tag == "pre":
        return ("code",)
    if "text" in goes and (tag == "strong" or "std-term" in classes):
        return ("text", "terms")  # what is bold is defined there
    return goes


def _drop_tex(text: str) -> str:
    r"""Write inline formulas as plain text: `\(f_y\)` becomes f_y."""
    return TEX_SIGNS.sub("", TEX_LAYOUT.sub(" ", text))


def read_sections(html: str) -> list[dict[str, Any]]:
    """Return the sections of a page; see `SectionReader`."""
    reader = SectionReader()
    reader.feed(html)
    reader.close()
    return [one for one in reader.sections if one["heading"]]


def get_kind(page: str) -> str:
    """Return the kind of a page: a key of WEIGHTS."""
    if page == GLOSSARY:
        return "glossary"
    if chapter := find_chapter(page):
        if page == chapter.exercises:
            return "exercise"
        return "reading" if chapter.kind == READING else "chapter"
    if page in REFERENCE:
        return "reference"
    return "help" if page in HELP else "reading"


def join_top(sections: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Add to the top of a page what is about the whole of it: objectives and new words.

    The words count as terms: a reader who looks for one wants the page that teaches it.
    """
    top = dict(sections[0])
    about = [one for one in sections[1:] if one["anchor"] in ABOUT_PAGE]
    for one in about:
        explained = "terms" if one["anchor"] == "new-words" else "text"
        top[explained] = f"{top[explained]} {one[explained]}".strip()
    return [top, *(one for one in sections[1:] if one not in about)]


def split_words(text: str) -> list[str]:
    """Return the words of a text that count, as the index knows them."""
    words = (SPELLINGS.get(word, word) for word in WORD.findall(text.lower()))
    return [stemmer.stem(word) for word in words if word not in STOP_WORDS]


def make_index(records: list[dict[str, str]]) -> dict[str, Any]:
    """Return an index in the form of MiniSearch; the id of a record is its place."""
    index: dict[str, dict[str, dict[str, int]]] = {}
    lengths: dict[str, list[int]] = {}
    for place, record in enumerate(records):
        counts = [Counter(split_words(record[field])) for field in FIELDS]
        lengths[str(place)] = [len(count) for count in counts]
        for field, count in enumerate(counts):
            for word, times in count.items():
                index.setdefault(word, {}).setdefault(str(field), {})[str(place)] = times
    number = len(records)
    return {
        "documentCount": number,
        "nextId": number,
        "documentIds": {str(place): place for place in range(number)},
        "fieldIds": {field: place for place, field in enumerate(FIELDS)},
        "fieldLength": lengths,
        "averageFieldLength": [
            sum(length[field] for length in lengths.values()) / max(number, 1)
            for field in range(len(FIELDS))
        ],
        "storedFields": {},
        "dirtCount": 0,
        "index": sorted(index.items()),
        "serializationVersion": 2,
    }


def make_script(pages: Iterable[tuple[str, str]]) -> str:
    """Return the script; `pages` are names and HTML, in reading order."""
    listed, sections, records = [], [], []
    for name, html in pages:
        found = read_sections(html)
        if not found:
            continue
        kind, title = get_kind(name), found[0]["heading"]
        listed.append({"name": name, "title": title, "kind": kind})
        # the name of a page is a word about it: step4_color
        for one in join_top(found):
            above = " ".join([title, name.rpartition("/")[2].replace("_", " "), *one["trail"][1:]])
            records.append({"title": above, **{field: one[field] for field in FIELDS[1:]}})
            shown = {key: one[key] for key in ("anchor", "heading", "text", "code")}
            weight = WEIGHTS[kind] * (MINOR_WEIGHT if one["anchor"] in MINOR else 1)
            # the top of a page has no headings above it, not even none
            trail = one["trail"][1:] if one["trail"] else None
            place = {"page": len(listed) - 1, "trail": trail, "weight": weight}
            sections.append({**place, **shown})
    data = {
        "fields": FIELDS,
        "pages": listed,
        "sections": sections,
        "spellings": SPELLINGS,
        "stopWords": sorted(STOP_WORDS),
        "words": make_index(records),
    }
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return (
        f"(() => {{\n{stemmer.js_stemmer_code.strip()}\n"
        f"const stemmer = new Stemmer();\nconst index = {text};\n"
        "index.stem = (word) => stemmer.stemWord(word);\n"
        "window.cameraLab = { ...window.cameraLab, searchIndex: index };\n})();\n"
    )


def write_index(app: Sphinx, exception: Exception | None) -> None:
    """Write the script beside the pages, and its checksum into the page that loads it."""
    if exception or app.builder.name != "html":
        return
    folder = Path(app.outdir)
    names = [name for name in app.env.collect_relations() if (folder / f"{name}.html").is_file()]
    script = make_script((name, (folder / f"{name}.html").read_text("utf-8")) for name in names)
    (folder / "_static" / SCRIPT).write_text(script, encoding="utf-8")
    version = hashlib.sha256(script.encode()).hexdigest()[:8]
    page = folder / "search.html"
    html = page.read_text(encoding="utf-8")
    tag = re.sub(rf"({re.escape(SCRIPT)})(?:\?v=\w+)?", rf"\1?v={version}", html)
    page.write_text(tag, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx, after those that finish the pages."""
    app.connect("build-finished", write_index, priority=950)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
