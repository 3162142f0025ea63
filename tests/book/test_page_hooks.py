"""The hooks that make pages light: icons, pictures, what is left out."""

import importlib.util
import io
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any, NoReturn

import pytest
from docutils import nodes
from fontTools.ttLib import TTFont
from PIL import Image

from tests.helpers.scripts import load_script

SHEET = (
    '.fa-bars:before,.fa-navicon:before{content:"\\f0c9"}.fa-github:before{content:"\\f09b"}'
    ".fa-lg{font-size:1.25em}"
)


def load(name: str) -> ModuleType:
    """Import a hook, which belongs to no package."""
    return load_script(f"book/_ext/{name}.py")


@pytest.fixture
def icons() -> ModuleType:
    return load("icons")


@pytest.fixture
def fonts(icons: ModuleType) -> Path:
    """The theme's own folder of fonts."""
    spec = importlib.util.find_spec("pydata_sphinx_theme")
    assert spec is not None
    assert spec.submodule_search_locations is not None
    theme = spec.submodule_search_locations[0]
    app = SimpleNamespace(
        builder=SimpleNamespace(
            theme=SimpleNamespace(
                get_theme_dirs=lambda: ["/nowhere", f"{theme}/theme/pydata_sphinx_theme"]
            )
        )
    )
    return icons._theme_folder(app) / "vendor" / "fontawesome" / "webfonts"


def test_icons_of_a_page_are_found_with_their_style_and_code(icons: ModuleType) -> None:
    codes = icons.read_names(SHEET)
    assert codes == {"fa-bars": 0xF0C9, "fa-navicon": 0xF0C9, "fa-github": 0xF09B}
    html = '<i class="fa-solid fa-bars fa-lg"></i><i class="x fa-brands fa-github"></i>'
    assert icons.find_in_page(html, codes, SHEET) == {(0, 0xF0C9), (2, 0xF09B)}


def test_icons_of_widgets_are_found_in_their_state(icons: ModuleType) -> None:
    codes = icons.read_names(SHEET)
    html = '{"description": "", "icon": "bars", "tooltip": null}'
    assert icons.find_in_page(html, codes, SHEET) == {(0, 0xF0C9)}


def test_an_icon_that_does_not_exist_is_named(icons: ModuleType) -> None:
    with pytest.raises(icons.UnknownIconError, match="'fa-no-such'"):
        icons.find_in_page('<i class="fas fa-no-such"></i>', icons.read_names(SHEET), SHEET)


def test_icons_of_sheets_and_scripts_are_found_without_the_list_of_all(
    icons: ModuleType, tmp_path: Path
) -> None:
    (tmp_path / "styles").mkdir()
    (tmp_path / "styles" / "theme.css").write_text(SHEET + ':root{--x:"\uf002"}')
    (tmp_path / "own.css").write_text('a::after{content:"\\f107"}')
    (tmp_path / "own.js").write_text('icon.className = "fa-solid fa-bars";')
    found = icons.find_anywhere(tmp_path, icons.read_names(SHEET))
    assert found == {0xF002, 0xF107, 0xF0C9}


def test_the_fonts_hold_what_is_asked_for_and_no_more(icons: ModuleType, fonts: Path) -> None:
    content = icons.cut_font(fonts / "fa-solid-900.ttf", {0xF0C9, 0xF107, 0xF8FE}, "Some Name")
    font = TTFont(io.BytesIO(content))
    assert set(font.getBestCmap()) == {0xF0C9, 0xF107}
    names = {str(record) for record in font["name"].names if record.nameID in icons.NAME_IDS}
    assert not any("Awesome" in name for name in names)
    assert icons.cut_font(fonts / "fa-brands-400.ttf", {0xF0C9}, "Some Name") == b""


def test_the_same_icons_make_the_same_sheet(icons: ModuleType, fonts: Path) -> None:
    used = {(0, 0xF0C9), (1, 0xF0C5), (2, 0xF09B)}
    first = icons.make_sheet(fonts, used, {0xF107})
    assert first == icons.make_sheet(fonts, used, {0xF107})
    assert first.count("@font-face") == 3
    assert "Font Awesome" in first  # whose icons they are
    assert icons.make_sheet(fonts, set(), set()) == icons.LICENSE


def test_a_theme_without_font_awesome_is_refused(icons: ModuleType) -> None:
    theme = SimpleNamespace(get_theme_dirs=list)
    with pytest.raises(FileNotFoundError, match="Font Awesome"):
        icons._theme_folder(SimpleNamespace(builder=SimpleNamespace(theme=theme)))


@pytest.mark.parametrize("kind", ["epub", "html"])
def test_the_script_gives_way_to_the_sheet_in_every_page(
    kind: str,
    icons: ModuleType,
    fonts: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(icons, "_theme_folder", lambda _: fonts.parents[2])
    (tmp_path / "_static" / "styles").mkdir(parents=True)
    (tmp_path / "_static" / "styles" / "pydata-sphinx-theme.css").write_text(SHEET)
    page = tmp_path / "page.html"
    page.write_text('<script defer src="_static/scripts/fontawesome.js?digest=1"></script>')
    app = SimpleNamespace(outdir=tmp_path, builder=SimpleNamespace(name=kind))
    icons.replace_font_awesome(app, None)
    if kind == "html":
        first = page.read_text()
        assert 'href="_static/icon_fonts.css?v=' in first
        assert "fontawesome" not in first
        # another icon, another version: a browser must not use the sheet it has kept
        page.write_text(first + '<i class="fa-solid fa-bars"></i>')
        icons.replace_font_awesome(app, None)
        assert first not in page.read_text()
    else:
        assert not (tmp_path / "_static" / icons.SHEET).exists()


def test_pictures_after_the_first_wait_and_all_hold_their_place(tmp_path: Path) -> None:
    hook = load("pictures")
    Image.new("RGB", (8, 6)).save(tmp_path / "a.png")
    app = SimpleNamespace(srcdir=tmp_path, builder=SimpleNamespace(images={"a.png": "a.png"}))
    tag = '<img alt="one" src="../_images/a.png" />'
    context = {"body": f"{tag} text {tag}"}
    hook.size_and_delay(app, "", "", context, None)
    first, second = context["body"].split(" text ")
    assert "loading" not in first
    assert 'loading="lazy"' in second
    for made in (first, second):
        assert 'width="8" height="6"' in made
        assert 'alt="one"' in made
    before = context["body"]
    hook.size_and_delay(app, "", "", context, None)
    assert context["body"].count('loading="lazy"') == before.count('loading="lazy"')


@pytest.mark.parametrize(
    ("size", "is_broad"), [((1440, 560), True), ((1440, 1000), False), ((800, 300), False)]
)
def test_only_large_pictures_side_by_side_may_be_wider_than_the_text(
    size: tuple[int, int], is_broad: bool, tmp_path: Path
) -> None:
    Image.new("RGB", size).save(tmp_path / "a.png")
    app = SimpleNamespace(srcdir=tmp_path, builder=SimpleNamespace(images={"a.png": "a.png"}))
    context = {"body": '<img alt="one" src="_images/a.png" />'}
    load("pictures").size_and_delay(app, "", "", context, None)
    assert ("data-broad" in context["body"]) is is_broad


def test_pictures_of_cells_keep_every_pixel(tmp_path: Path) -> None:
    hook = load("pictures")
    picture = Image.effect_noise((32, 16), 80).convert("RGBA")
    picture.putalpha(Image.linear_gradient("L").resize((32, 16)))
    picture.save(tmp_path / "a.png")
    converter = hook.WebpConverter.__new__(hook.WebpConverter)
    assert converter.convert(tmp_path / "a.png", tmp_path / "page.webp")
    with Image.open(tmp_path / "page.webp") as kept:
        assert kept.tobytes() == picture.tobytes()


def test_pictures_are_converted_once_and_never_half(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hook = load("pictures")
    source = tmp_path / "a.png"
    Image.effect_noise((32, 16), 80).save(source)
    kept = hook.make_webp(source).read_bytes()
    assert [path.name for path in sorted(tmp_path.iterdir())] == ["a.png", "a.webp"]
    with monkeypatch.context() as patch:
        patch.setattr(hook.Image, "open", lambda _: pytest.fail("converted again"))
        assert hook.make_webp(source).read_bytes() == kept
        assert hook.ahead.begin(source) is hook.ahead.begin(source)
    (tmp_path / "a.webp").unlink()

    def stop(_picture: Image.Image, path: Path, *_args: object, **_options: object) -> NoReturn:
        path.write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(hook.Image.Image, "save", stop)
    with pytest.raises(KeyboardInterrupt):
        hook.make_webp(source)
    assert not (tmp_path / "a.webp").exists()


def test_pictures_of_a_page_that_was_read_are_converted_before_they_are_asked_for(
    tmp_path: Path,
) -> None:
    hook = load("pictures")
    folder = tmp_path / "_build" / "jupyter_execute"
    folder.mkdir(parents=True)
    Image.effect_noise((32, 16), 80).save(folder / "a.png")
    tree = nodes.section()
    for uri in ("_build/jupyter_execute/a.png", "book/_static/cover.png"):
        tree += nodes.image(uri=uri)
    app = SimpleNamespace(srcdir=tmp_path, builder=SimpleNamespace(format="html"))
    hook.convert_ahead(app, tree)
    assert [path.name for path in hook.ahead.begun] == ["a.png"]
    assert hook.ahead.begin(folder / "a.png").result() == folder / "a.webp"


@pytest.mark.parametrize(
    ("uri", "expected"),
    [("_build/jupyter_execute/abc.png", True), ("book/_static/cover.png", False)],
)
def test_only_pictures_of_cells_are_converted(uri: str, expected: bool) -> None:
    hook = load("pictures")
    converter = hook.WebpConverter.__new__(hook.WebpConverter)
    app = SimpleNamespace(builder=SimpleNamespace(format="html"))
    converter.document = SimpleNamespace(settings=SimpleNamespace(env=SimpleNamespace(app=app)))
    node = {"uri": uri, "candidates": {"*": uri}}
    assert converter.match(node) is expected


def test_files_that_no_page_uses_leave_the_site(tmp_path: Path) -> None:
    hook = load("lean")
    (tmp_path / "_static" / "locales" / "de").mkdir(parents=True)
    (tmp_path / "_static" / "sphinx-thebe.js").write_text("")
    (tmp_path / "_static" / "quiz.js").write_text("")
    hook.drop_files(SimpleNamespace(outdir=tmp_path, builder=SimpleNamespace(name="html")), None)
    assert [path.name for path in (tmp_path / "_static").iterdir()] == ["quiz.js"]


def test_settings_of_thebe_leave_the_page() -> None:
    hook = load("lean")
    sheets = [SimpleNamespace(filename=name) for name in ("book.css", "sphinx-thebe.css")]
    body = (
        '<p>text</p><script type="text/x-thebe-config">{}</script> '
        "<script>kernelName = 'python3'</script><p>stamp</p>"
    )
    context: dict[str, Any] = {"body": body, "css_files": sheets}
    hook.drop_tags(None, "", "", context, None)
    assert context["body"] == "<p>text</p><p>stamp</p>"
    assert [sheet.filename for sheet in context["css_files"]] == ["book.css"]
