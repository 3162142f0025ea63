"""Let a page load fast however many pictures it shows.

What a cell draws is stored as lossless WebP, pixel by pixel what it was as PNG and half as
large. Pictures below the first one load when the reader comes near them. Each has its
size in its tag, so that the text does not jump when it comes.

To convert them takes as long as everything else Sphinx does. So it begins as soon as a page is
read, on the cores that Sphinx leaves idle. The results stay beside the pictures, whose names are
their checksums: to draw a page again converts nothing.
"""

import os
import re
import shutil
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

from docutils import nodes
from PIL import Image
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms.images import ImageConverter

EXECUTED = "jupyter_execute"  # where the pictures that cells draw lie
BROAD = 2  # times as wide as high: pictures side by side, which may be wider than the text
SHARP = 1280  # pixels: enough for that
TAG = re.compile(r'<img (?![^>]*\bloading=)([^>]*?src="[^"]*_images/([^"/]+)"[^>]*?)\s*/?>')


class WebpConverter(ImageConverter):
    """Convert the pictures that cells have drawn."""

    def match(self, node: nodes.image) -> bool:
        """Take the pictures of cells; those of the book itself stay as they are."""
        uri = str(node.get("uri", ""))
        return (
            self.app.builder.format == "html"
            and EXECUTED in uri
            and uri.endswith(".png")
            and "*" in node["candidates"]
        )

    def get_conversion_rule(self, _node: nodes.image) -> tuple[str, str]:
        """Name both formats; Sphinx does not know that browsers read the second."""
        return "image/png", "image/webp"

    def convert(self, source: str, target: str) -> bool:
        """Put the converted picture in its place; wait for it where that is needed."""
        if not Path(target).exists():
            shutil.copyfile(ahead.begin(Path(source)).result(), target)
        return True


class Ahead:
    """Pictures that are being converted."""

    def __init__(self) -> None:
        self.pool = ThreadPoolExecutor(os.cpu_count())  # the encoder lets other threads work
        self.begun: dict[Path, Future[Path]] = {}

    def begin(self, source: Path) -> Future[Path]:
        """See to it that a picture gets converted, once."""
        if source not in self.begun:
            self.begun[source] = self.pool.submit(make_webp, source)
        return self.begun[source]


ahead = Ahead()


def make_webp(source: Path) -> Path:
    """Convert a picture without loss, unless an earlier build has; return where it is."""
    target = source.with_suffix(".webp")
    if not target.exists():
        unfinished = source.with_suffix(".part")
        with Image.open(source) as picture:
            picture.save(unfinished, "WEBP", lossless=True, quality=80, method=4)
        unfinished.replace(target)
    return target


def convert_ahead(app: Sphinx, tree: nodes.document) -> None:
    """Begin to convert the pictures of a page that has just been read."""
    if app.builder.format == "html":
        for node in tree.findall(nodes.image):
            if EXECUTED in node["uri"] and node["uri"].endswith(".png"):
                ahead.begin(Path(app.srcdir, node["uri"]))


def size_and_delay(
    app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Write size and order of loading into the tags of the pictures of a page."""
    sources = {name: Path(app.srcdir, uri) for uri, name in app.builder.images.items()}
    count = 0

    def complete(tag: re.Match[str]) -> str:
        nonlocal count
        count += 1
        attributes = ['decoding="async"', tag[1]]
        if count > 1:  # the first picture may be on the first screen
            attributes.insert(0, 'loading="lazy"')
        source = sources.get(tag[2])
        if source and source.suffix != ".svg" and " width=" not in tag[1]:
            with Image.open(source) as picture:
                attributes.append(f'width="{picture.width}" height="{picture.height}"')
                if picture.width >= BROAD * picture.height and picture.width >= SHARP:
                    attributes.append("data-broad")
        return f"<img {' '.join(attributes)} />"

    if "body" in context:
        context["body"] = TAG.sub(complete, context["body"])


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.add_post_transform(WebpConverter)
    app.connect("doctree-read", convert_ahead, priority=900)  # when Sphinx has found the pictures
    app.connect("html-page-context", size_and_delay, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
