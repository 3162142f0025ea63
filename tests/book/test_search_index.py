"""The search of the book: how pages are read, what the index holds, and in which order it answers.

The order is asked of the built book, in Node, by the scripts that the search page loads.
"""

import json
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from content.chapters import list_required
from content.page_sections import read_sections
from content.toc import list_pages
from tests.helpers import browser
from tests.helpers.node import run_node
from tests.helpers.scripts import load_script
from tools.vendor import npm

ROOT = Path(__file__).resolve().parents[2]
search_index = load_script("book/_ext/search_index.py")
search_page = load_script("book/_ext/search_page.py")

PAGE = """
<nav>Sidebar</nav><article class="bd-article">
<section id="step-9"><span id="page-step9"></span>
<h1>Step 9: What is <em>blur</em>?<a class="headerlink" href="#">#</a></h1>
<table><tr><td>Reading</td><td>20 minutes</td></tr></table>
<p>Blur spreads <span class="math" data-tex="\\frac{f_x}{2}"><math><mi>f</mi></math></span>
pixels.</p><p>Next.</p>
<section id="new-words"><h2>New words</h2>
<ul><li><a><span class="std std-term">sharpness</span></a></li>
<li><span class="std-term">edge</span></li></ul></section>
<section id="kernel"><h2>Kernels</h2>
<div class="admonition"><p class="admonition-title">Predict</p>
<p>A <strong>kernel</strong> is small.</p></div>
<div class="cell_input"><pre>cv2.blur(a)<br>b</pre></div>
<div class="cell_output"><pre>0.25</pre>
<figure><img><figcaption>A soft edge.</figcaption></figure></div>
<div class="math" data-tex="x"><math><mi>x</mi></math></div>
<div class="quiz-answers">B is right</div>
<section id="inner"><h3>Inside</h3><p>Deeper.</p></section></section>
<script>var hidden = 1;</script></section></article><footer>Foot</footer>
"""
GLOSSARY = """
<article class="bd-article"><section id="glossary"><h1>Glossary</h1><p>Words.</p>
<dl><dt id="term-hue">hue<a class="headerlink">#</a></dt><dd><p>An angle on the circle of
<span class="std-term">color</span>.</p></dd><dt id="term-mask">mask</dt><dd>Zeros.</dd></dl>
</section></article>
"""

# Loads the scripts of the search page as a browser would; answers queries read as JSON.
ENGINE = """
import { readFileSync } from "node:fs";
import { runInThisContext } from "node:vm";
const [site, ...queries] = JSON.parse(readFileSync(0, "utf8"));
globalThis.window = globalThis;
for (const name of ["minisearch/index.js", "search_index.js", "search_engine.js"])
  runInThisContext(readFileSync(`${site}/_static/${name}`, "utf8"));
const { searchIndex, searchEngine } = window.cameraLab;
const engine = searchEngine.makeEngine(searchIndex, window.MiniSearch);
"""
ASK = """
console.log(JSON.stringify(queries.map((query) => engine.search(query).pages.map((page) => ({
  name: page.name,
  sections: page.sections.map((found) => ({
    heading: found.section.heading,
    anchor: found.section.anchor,
    excerpt: engine.cutExcerpt(found),
  })),
})))));
"""


@pytest.fixture(scope="module")
def site() -> str:
    """The folder of the built book."""
    return str(browser.require_pages())


def ask(site: str, *queries: str) -> list[list[dict[str, Any]]]:
    """Return the pages found for each query, best first."""
    answer: list[list[dict[str, Any]]] = json.loads(
        run_node(ENGINE + ASK, given=json.dumps([site, *queries]))
    )
    return answer


def test_a_page_is_read_section_by_section_without_what_is_no_text() -> None:
    top, words, kernel, inner = read_sections(PAGE)
    assert top["heading"] == "Step 9: What is blur?"
    assert top["anchor"] == "step-9"
    assert top["text"] == "Blur spreads f_x2 pixels. Next."
    assert top["terms"] == "page-step9"
    assert words["terms"] == "sharpness edge"
    assert kernel["text"] == "A kernel is small. A soft edge."
    assert kernel["terms"] == "kernel"
    assert kernel["code"] == "cv2.blur(a) b"
    assert inner["trail"] == ["Step 9: What is blur?", "Kernels"]
    assert inner["text"] == "Deeper."


def test_every_term_of_the_glossary_is_a_section_of_its_own() -> None:
    found = [(one["anchor"], one["heading"], one["text"]) for one in read_sections(GLOSSARY)]
    assert found == [
        ("glossary", "Glossary", "Words."),
        ("term-hue", "hue", "An angle on the circle of color."),
        ("term-mask", "mask", "Zeros."),
    ]


def test_new_words_and_objectives_are_about_the_whole_page() -> None:
    top, *rest = search_index.join_top(read_sections(PAGE))
    assert top["terms"] == "page-step9 sharpness edge"
    assert [one["anchor"] for one in rest] == ["kernel", "inner"]


def test_words_lose_their_endings_and_what_says_nothing() -> None:
    split = search_index.split_words
    assert split("How do I convert depths to METERS?") == ["convert", "depth", "meter"]
    assert split("depth_to_meters, grey centre") == ["depth", "meter", "grai", "center"]
    assert split("gray center") == split("grey centre")
    assert split("What is it?") == []


@pytest.mark.parametrize(
    ("page", "kind"),
    [
        ("book/step2_intrinsics", "chapter"),
        ("exercises/step2_intrinsics", "exercise"),
        ("book/glossary", "glossary"),
        ("book/troubleshooting", "help"),
        ("book/architecture", "reference"),
        ("book/background", "reading"),
        ("book/some_new_page", "reading"),
    ],
)
def test_every_page_has_a_kind(page: str, kind: str) -> None:
    assert search_index.get_kind(page) == kind
    assert kind in search_index.WEIGHTS


def test_pages_that_are_named_as_help_or_reference_or_left_out_exist() -> None:
    named = {search_index.GLOSSARY, *search_index.HELP, *search_index.REFERENCE}
    named |= {*search_index.LEFT_OUT}
    assert named <= set(list_pages())


def test_the_script_is_the_same_for_the_same_pages_and_needs_no_fetch() -> None:
    pages = [("book/step9", PAGE), ("book/glossary", GLOSSARY), ("book/empty", "<p></p>")]
    script = search_index.make_script(pages)
    assert script == search_index.make_script(pages)
    assert "fetch(" not in script
    assert '"name":"book/glossary","title":"Glossary","kind":"glossary"' in script
    assert "book/empty" not in script


def test_the_index_is_the_one_that_minisearch_makes_itself() -> None:
    browser.require_packages()
    records = [
        {"title": "A", "heading": "Depth in meters", "terms": "", "text": "a mask", "code": "x=1"},
        {"title": "A", "heading": "Masks", "terms": "mask", "text": "mask of masks", "code": ""},
    ]
    code = """
    import { readFileSync } from "node:fs";
    import { createRequire } from "node:module";
    const [place, fields, records] = JSON.parse(readFileSync(0, "utf8"));
    const MiniSearch = createRequire(place)("minisearch");
    const tokenize = (text) => text.split(" ").filter(Boolean);
    const made = new MiniSearch({ fields, tokenize, processTerm: (word) => word });
    made.addAll(records.map((record, id) => ({ id, ...record })));
    console.log(JSON.stringify(made));
    """
    split = [
        {field: " ".join(search_index.split_words(record[field])) for field in record}
        for record in records
    ]
    given = json.dumps([str(npm.get_package("minisearch") / "x.js"), search_index.FIELDS, split])
    theirs = json.loads(run_node(code, given=given))
    ours = json.loads(json.dumps(search_index.make_index(records)))
    for one in (theirs, ours):
        one["index"] = sorted(one["index"])
    assert ours["averageFieldLength"] == pytest.approx(theirs.pop("averageFieldLength"))
    del ours["averageFieldLength"]
    theirs["storedFields"] = {}  # nothing is stored, one entry a record there
    assert ours == theirs


def test_python_and_javascript_split_every_text_of_the_book_alike(site: str) -> None:
    texts = [
        one[part]
        for page in list_pages()
        if page not in search_index.LEFT_OUT
        for one in read_sections(Path(site, f"{page}.html").read_text(encoding="utf-8"))
        for part in ("heading", "text", "code")
    ]
    assert len(texts) > 500
    code = """
    const split = (text) => engine.splitWords(text).map(({ stem }) => stem);
    console.log(JSON.stringify(queries.map(split)));
    """
    found = json.loads(run_node(ENGINE + code, given=json.dumps([site, *texts])))
    for text, words in zip(texts, found, strict=True):
        assert words == search_index.split_words(text), text


#: What readers type, the page that they want, and the last place at which it may stand.
QUERIES = [
    ("intrinsic", "book/step2_intrinsics", 1),
    ("intrinsics", "book/step2_intrinsics", 1),
    ("hue", "book/step4_color", 1),
    ("how do I convert depth to meters", "book/step3_depth", 3),
    ("How do I convert depth to metres?", "book/step3_depth", 3),
    ("segment_by_color", "exercises/step4_color", 1),
    ("black picture", "book/troubleshooting", 1),
    ("step 5", "book/step5_cloud", 1),
    ("step5", "book/step5_cloud", 1),
    ("save the point cloud as PLY", "book/step6_view", 1),
    ("cv2.inRange", "book/step4_color", 1),
    ("rubric", "book/rubric", 1),
    ("IMU", "book/background", 1),
    ("Windows", "book/start", 3),  # the windows of stereo matching are more
    ("Windows make", "book/start", 1),
    ("principal point", "book/step2_intrinsics", 1),
    ("disparty", "book/glossary", 2),  # an exercise has it in its name
    ("inrtinsic matrix", "book/step2_intrinsics", 1),
    ("detph buffer", "book/step3_depth", 1),
    ("morphlogy", "book/step4_color", 2),
]


@pytest.fixture(scope="module")
def answers(site: str) -> dict[str, list[str]]:
    """The names of the pages found for each of QUERIES, best first."""
    queries = [query for query, *_ in QUERIES]
    found = ask(site, *queries)
    return {
        query: [page["name"] for page in pages] for query, pages in zip(queries, found, strict=True)
    }


@pytest.mark.parametrize(("query", "page", "place"), QUERIES)
def test_a_query_finds_its_page_near_the_top(
    query: str, page: str, place: int, answers: dict[str, list[str]]
) -> None:
    assert page in answers[query][:place]


@cache
def list_terms(site: str) -> list[str]:
    html = Path(site, "book", "glossary.html").read_text(encoding="utf-8")
    return [one["heading"] for one in read_sections(html) if one["anchor"].startswith("term-")]


def test_every_term_of_the_glossary_is_found_by_its_name(site: str) -> None:
    terms = list_terms(site)
    assert len(terms) > 40
    for term, pages in zip(terms, ask(site, *terms), strict=True):
        shown = [part["heading"] for page in pages[:4] for part in page["sections"]]
        assert term in shown, term


def test_every_term_is_found_with_two_letters_exchanged(site: str) -> None:
    terms = [term for term in list_terms(site) if min(map(len, term.split())) > 6]
    assert len(terms) > 10
    typed = [f"{term[:3]}{term[4]}{term[3]}{term[5:]}" for term in terms]
    for term, pages in zip(terms, ask(site, *typed), strict=True):
        shown = [part["heading"] for page in pages[:5] for part in page["sections"]]
        assert term in shown, term


def test_every_step_is_found_by_the_question_in_its_title(site: str) -> None:
    chapters = list_required()
    answers = ask(site, *(chapter.heading for chapter in chapters))
    for chapter, pages in zip(chapters, answers, strict=True):
        assert pages[0]["name"] == chapter.page


def test_nothing_is_found_for_what_the_book_does_not_say(site: str) -> None:
    for pages in ask(site, "", "what is the", "xylophonists", "?!"):
        assert pages == []


def test_an_excerpt_is_short_and_marks_the_words_found(site: str) -> None:
    (pages,) = ask(site, "convert depth")
    for page in pages[:5]:
        for part in page["sections"]:
            pieces = part["excerpt"]
            assert len("".join(piece["text"] for piece in pieces)) < 230
    first = pages[0]["sections"][0]["excerpt"]
    marked = {piece["text"].lower() for piece in first if piece["isMarked"]}
    assert {"convert", "depth"} <= marked


def test_sphinx_leaves_no_search_of_its_own(tmp_path: Path) -> None:
    page = tmp_path / "book" / "page.html"
    page.parent.mkdir()
    tags = [
        f'<script src="../{name}.js"></script>'
        for name in ("_static/searchtools", "_static/language_data", "searchindex", "_static/quiz")
    ]
    page.write_text("\n".join(tags), encoding="utf-8")
    (tmp_path / "_static").mkdir()
    (tmp_path / "_static" / "searchtools.js").write_text("")
    app = SimpleNamespace(outdir=tmp_path, builder=SimpleNamespace(name="html"))
    search_page.drop_files(app, None)
    assert page.read_text(encoding="utf-8").strip() == tags[-1]
    assert list((tmp_path / "_static").iterdir()) == []


def test_only_the_search_page_loads_the_index(site: str) -> None:
    with_index = {
        path.relative_to(site).as_posix()
        for path in Path(site).rglob("*.html")
        if "search_index.js" in path.read_text(encoding="utf-8")
    }
    assert with_index == {"search.html"}
    assert not Path(site, "searchindex.js").exists()
