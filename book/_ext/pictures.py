"""Let a page load fast however many pictures it shows.

What a cell draws is stored as lossless WebP, pixel by pixel what it was as PNG and half as
large. Pictures below the first one load when the reader comes near them. Each has its
size in its tag, so that the text does not jump when it comes.
"""

import re
from pathlib import Path
from typing import Any

from docutils import nodes
from PIL import Image
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms.images import ImageConverter

EXECUTED = "jupyter_execute"  # where the pictures that cells draw lie
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

    def convert(self, source: Path, target: Path) -> bool:
        """Write the picture, unless an earlier build has: the name holds its checksum."""
        if not Path(target).exists():
            with Image.open(source) as picture:
                picture.save(target, "WEBP", lossless=True, quality=80, method=4)
        return True


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
        return f"<img {' '.join(attributes)} />"

    if "body" in context:
        context["body"] = TAG.sub(complete, context["body"])


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.add_post_transform(WebpConverter)
    app.connect("html-page-context", size_and_delay, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
