"""Write what the search page looks in: every section of the book, and an index of its words.

Both are one classic script, because a page that was opened from a file may fetch nothing. The
index has the form in which MiniSearch keeps its own, so that a browser only loads it. Words are
kept by their stems; the script lists the stem of every word, so no browser has to find it.
"""

import hashlib
import json
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.search.en import SearchEnglish

from content.chapters import READING, find_chapter
from content.page_sections import PARTS, read_sections

SCRIPT = "search_index.js"
#: Fields of a section: the first line of a page, its own heading, words it explains, the rest.
FIELDS = ("title", *PARTS)
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
HELP = ("book/troubleshooting", "book/errata", "book/rubric")
#: It names every word and explains none.
LEFT_OUT = ("book/index_of_terms",)
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
WORD = re.compile(r"[^\W_]+")
#: Words that say nothing about what is looked for; `near` and `up` do say something here.
STOP_WORDS = frozenset(
    WORD.findall("""
    a about am an and any are as at be been but by can could did do does for from get had has have
    how i if in into is it its may me my of on or our s shall should so than that the their then
    there these they this those to us was we were what when where which who why will with would you
    your
    """)
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
SHORTEST_STEMMED = 3  # of the letter s alone, nothing would be left

stemmer = SearchEnglish({})


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


def split_letters(text: str) -> list[str]:
    """Return the words of a text as they stand there, in small letters."""
    return WORD.findall(text.lower())


def find_stem(word: str) -> str:
    """Return the stem of a word in small letters, whatever its spelling."""
    word = SPELLINGS.get(word, word)
    return stemmer.stem(word) if len(word) >= SHORTEST_STEMMED else word


def split_words(text: str) -> list[str]:
    """Return the stems of the words of a text that count, as the index knows them."""
    return [find_stem(word) for word in split_letters(text) if word not in STOP_WORDS]


def list_stems(records: list[dict[str, str]]) -> dict[str, str]:
    """Return the stems of all words, and of other spellings, where they are not the words."""
    words = {
        word for record in records for field in FIELDS for word in split_letters(record[field])
    }
    stems = {word: find_stem(word) for word in sorted(words.union(SPELLINGS) - STOP_WORDS)}
    return {word: stem for word, stem in stems.items() if word != stem}


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
            records.append({"title": above, **{field: one[field] for field in PARTS}})
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
        "stems": list_stems(records),
        "stopWords": sorted(STOP_WORDS),
        "words": make_index(records),
    }
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return f"window.cameraLab = {{ ...window.cameraLab, searchIndex: {text} }};\n"


def write_index(app: Sphinx, exception: Exception | None) -> None:
    """Write the script beside the pages, and its checksum into the page that loads it."""
    if exception or app.builder.name != "html":
        return
    folder = Path(app.outdir)
    names = [
        name
        for name in app.env.collect_relations()
        if name not in LEFT_OUT and (folder / f"{name}.html").is_file()
    ]
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
