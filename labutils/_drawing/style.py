"""Colors and sizes of all figures, whatever draws them."""

from __future__ import annotations

#: Width of a figure in inches; the text column is 7.2 inches at 100 px per inch.
WIDTHS = {"full": 7.2, "half": 3.6}

#: Okabe-Ito: eight colors that stay apart for every kind of color vision.
CATEGORY_COLORS = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#D55E00",
    "#56B4E9",
    "#CC79A7",
    "#F0E442",
    "#8A8A8A",
)

#: Mid gray: contrast above 4:1 on the book's paper and on its dark ground. No color reaches 4.5:1
#: on both; figures ask for 3:1.
INK = "#767b85"

# In points.
FONT_SIZE = 11  # on a phone a figure is half as wide
TITLE_SIZE = 12
END_LABEL_SHIFT = 6  # from the end of a curve to its name

#: Signs of mathematics in texts, which are neither a hyphen nor the letter x.
MINUS = "\N{MINUS SIGN}"
TIMES = "\N{MULTIPLICATION SIGN}"

#: Room between a picture and the color bar on its right, as a share of the picture's width.
BAR_GAP = 0.02

#: Of SVG: the page shows 100 page pixels per inch of a figure.
PIXELS_PER_INCH = 100
PIXELS_PER_POINT = PIXELS_PER_INCH / 72
