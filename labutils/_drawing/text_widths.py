"""How wide a text is, so that a layout can make room for it before any browser draws it."""

from __future__ import annotations

from labutils._drawing.style import MINUS, TIMES

#: The font of Matplotlib's figures, and one with the same widths where that is missing.
FONT_FAMILY = "'DejaVu Sans',Verdana,Geneva,sans-serif"

#: Share of the font size: an exponent, and how high it is raised.
EXPONENT_SIZE = 0.7
EXPONENT_RISE = 0.4

_FIRST = 32  # the space
# Advance widths of DejaVu Sans from the space to the tilde, in thousandths of the font size.
_ASCII = (
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
    636, 636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531,
    1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787,
    603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500,
    500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
    635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
)  # fmt: skip
_OTHERS = {MINUS: 838, TIMES: 838, "°": 500, "µ": 636, "·": 318, "²": 401, "³": 401}
_UNKNOWN = 640


def measure(text: str, size: float) -> float:
    """Return the width of a text in the unit of its size."""
    return size / 1000 * sum(_measure_character(character) for character in text)


def _measure_character(character: str) -> int:
    place = ord(character) - _FIRST
    if 0 <= place < len(_ASCII):
        return _ASCII[place]
    return _OTHERS.get(character, _UNKNOWN)


def wrap(text: str, size: float, width: float) -> list[str]:
    """Break a text into lines between words, none wider than `width` if its words are not."""
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and measure(longer, size) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
