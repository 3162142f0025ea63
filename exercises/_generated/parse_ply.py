"""Starter of the exercise parse_ply.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def parse_ply(text):
    """Read points and colors from the text of an ASCII PLY file.

    The header ends with the line ``end_header``. Its line ``element
    vertex N`` says that the first N lines after the header hold one
    point each, with one number of any type per ``property`` line that
    follows ``element vertex``, in that order. N may be 0. Numbers may
    have an exponent, as in ``1.5e-03``, and several spaces or tabs
    between them. Points have x, y and z, and either red, green and
    blue (0 to 255) or none of the three, in any order among other
    properties. There may be ``comment`` lines in the header, with any
    words, and other elements after the vertices.

    Parameters
    ----------
    text : str
        The whole file.

    The arguments stay as they are.

    Returns
    -------
    points : ndarray, float, (N, 3)
        x, y, z.
    colors : ndarray, float, (N, 3), or None
        Red, green, blue from 0 to 1, or None where the file has no
        colors.
    """
    raise NotImplementedError
