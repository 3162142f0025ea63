"""Show the theme's icons from small fonts instead of Font Awesome's script.

The theme loads all of Font Awesome, 1.5 MB of script, for some twenty icons. Once the
pages are written, this hook looks which icons they, the style sheets and the widgets use,
cuts these out of the theme's own copies of the Font Awesome fonts, and puts them into
``icon_fonts.css`` as data: a font in a file of its own does not load in Firefox when the
page is opened from a folder. ``icons.css`` says where they are used. As letters they take
the color of the text, also on paper and in a high-contrast theme.
"""

import base64
import hashlib
import io
import re
from pathlib import Path
from typing import TYPE_CHECKING, cast

from fontTools import subset
from fontTools.ttLib import TTFont
from sphinx.application import Sphinx
from sphinx.util import logging

if TYPE_CHECKING:
    from sphinx.builders.html import StandaloneHTMLBuilder

logger = logging.getLogger(__name__)

SHEET = "icon_fonts.css"
# CSS family, the file it is cut from, its weight, the classes that ask for it
FONTS = (
    ("Lab Book Icons", "fa-solid-900.ttf", 900, {"fa", "fas", "fa-solid"}),
    ("Lab Book Outlines", "fa-regular-400.ttf", 400, {"far", "fa-regular"}),
    ("Lab Book Brands", "fa-brands-400.ttf", 400, {"fab", "fa-brands"}),
)
STYLES = {name: style for style, (_, _, _, names) in enumerate(FONTS) for name in names}
LICENSE = """\
/*! Icons cut out of Font Awesome Free by Fonticons, Inc. (https://fontawesome.com).
    Icons: CC BY 4.0, https://creativecommons.org/licenses/by/4.0/. Fonts: SIL OFL 1.1,
    https://openfontlicense.org; cut down and renamed, as that license asks. */
"""
NAME_IDS = (1, 3, 4, 6, 16, 18, 21)  # of a font: family, full and PostScript names

ICON_RULE = re.compile(r'((?:\.fa-[a-z0-9-]+:before,?)+)\{content:"\\([0-9a-f]+)"\}')
CLASSES = re.compile(r'class="([^"]*\bfa[a-z]?\b[^"]*)"')
WIDGET_ICON = re.compile(r'"icon": ?"([a-z0-9-]+)"')  # in the state of a button
NAME = re.compile(r"fa-[a-z0-9-]+")
PRIVATE = re.compile(r"\\(e[0-9a-f]{3}|f[0-8][0-9a-f]{2})\b|([\ue000-\uf8ff])")
SCRIPT = re.compile(r'<script[^>]*src="([^"]*_static/)scripts/fontawesome\.js[^"]*"></script>')
LINK = re.compile(rf'(<link rel="stylesheet" href="[^"]*_static/{SHEET})\?v=\w*"')


class UnknownIconError(Exception):
    """A page names an icon that Font Awesome does not have."""


def read_names(sheet: str) -> dict[str, int]:
    """Return the code point of every icon that a sheet of Font Awesome names."""
    return {
        name: int(code, 16)
        for selectors, code in ICON_RULE.findall(sheet)
        for name in NAME.findall(selectors)
    }


def find_in_page(html: str, codes: dict[str, int], sheet: str) -> set[tuple[int, int]]:
    """List the icons of a page, as (style, code point)."""
    found = set()
    for classes in CLASSES.findall(html):
        names = classes.split()
        styles = [STYLES[name] for name in names if name in STYLES]
        for name in names if styles else ():
            if name in codes:
                found.add((styles[0], codes[name]))
            elif name.startswith("fa-") and name not in STYLES and f".{name}{{" not in sheet:
                raise UnknownIconError(f"no icon of Font Awesome is named {name!r}")
    for name in WIDGET_ICON.findall(html):
        if f"fa-{name}" in codes:
            found.add((0, codes[f"fa-{name}"]))
    return found


def find_anywhere(static: Path, codes: dict[str, int]) -> set[int]:
    """List the icons that style sheets draw and scripts add, whatever their style."""
    found = set()
    for path in (*static.glob("*.css"), *static.glob("styles/*.css")):
        if path.name != SHEET:
            sheet = ICON_RULE.sub("", path.read_text(encoding="utf-8"))
            found |= {
                int(code, 16) if code else ord(letter) for code, letter in PRIVATE.findall(sheet)
            }
    for path in (*static.glob("*.js"), *static.glob("scripts/*theme.js")):
        names = NAME.findall(path.read_text(encoding="utf-8"))
        found |= {codes[name] for name in names if name in codes}
    return found


def cut_font(path: Path, code_points: set[int], family: str) -> bytes:
    """Return a WOFF font with some glyphs of another; empty where it has none of them."""
    font = TTFont(path, recalcTimestamp=False)
    wanted = sorted(code_points & font.getBestCmap().keys())
    if not wanted:
        return b""
    cutter = subset.Subsetter(subset.Options(hinting=False, notdef_outline=True))
    cutter.populate(unicodes=wanted)
    cutter.subset(font)
    for record in font["name"].names:
        if record.nameID in NAME_IDS:
            record.string = family.replace(" ", "") if record.nameID == NAME_IDS[3] else family
    font.flavor = "woff"
    content = io.BytesIO()
    font.save(content)
    return content.getvalue()


def make_sheet(fonts: Path, used: set[tuple[int, int]], anywhere: set[int]) -> str:
    """Return the style sheet that carries the fonts."""
    faces = [LICENSE]
    for style, (family, name, weight, _) in enumerate(FONTS):
        wanted = {code for of, code in used if of == style}
        # what sheets and scripts draw is solid, or a brand: none asks for an outline
        wanted |= anywhere if name != "fa-regular-400.ttf" else set()
        if content := cut_font(fonts / name, wanted, family):
            data = base64.b64encode(content).decode()
            faces.append(
                f'@font-face{{font-family:"{family}";font-weight:{weight};font-display:block;'
                f'src:url(data:font/woff;base64,{data}) format("woff")}}\n'
            )
    return "".join(faces)


def replace_font_awesome(app: Sphinx, exception: Exception | None) -> None:
    """Write the sheet, link it from every page in the place of the script."""
    if exception or app.builder.name != "html":
        return
    static = Path(app.outdir, "_static")
    sheet = (static / "styles" / "pydata-sphinx-theme.css").read_text(encoding="utf-8")
    codes = read_names(sheet)
    pages = {path: path.read_text(encoding="utf-8") for path in Path(app.outdir).rglob("*.html")}
    used = set()
    for path, html in pages.items():
        try:
            used |= find_in_page(html, codes, sheet)
        except UnknownIconError as error:
            logger.warning("%s: %s", path.relative_to(app.outdir), error)
    # from the theme, not from the pages: an earlier build has taken them out there
    fonts = _theme_folder(app) / "vendor" / "fontawesome" / "webfonts"
    content = make_sheet(fonts, used, find_anywhere(static, codes))
    (static / SHEET).write_text(content, encoding="utf-8")
    version = hashlib.sha256(content.encode()).hexdigest()[:8]
    for path, html in pages.items():
        new = SCRIPT.sub(rf'<link rel="stylesheet" href="\1{SHEET}?v=" />', html)
        new = LINK.sub(rf'\1?v={version}"', new)
        if new != html:
            path.write_text(new, encoding="utf-8")


def _theme_folder(app: Sphinx) -> Path:
    """Find the static files of the theme that brings Font Awesome."""
    builder = cast("StandaloneHTMLBuilder", app.builder)  # its caller has looked
    for folder in builder.theme.get_theme_dirs():
        static = Path(folder, "static")
        if (static / "vendor" / "fontawesome").is_dir():
            return static
    raise FileNotFoundError("expected a theme that brings Font Awesome")


def setup(app: Sphinx) -> dict[str, object]:
    """Connect the hook to Sphinx."""
    app.connect("build-finished", replace_font_awesome)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
