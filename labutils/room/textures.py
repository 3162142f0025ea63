"""Draw the textures of the rooms: the same seed gives the same bytes.

NumPy alone draws them, because what OpenCV draws differs between its versions. None of them is
stored: a room draws its own when it is made.
"""

from __future__ import annotations

import numpy as np

#: Side of a wall's and of an object's texture in pixels.
WALL_SIZE, OBJECT_SIZE = 1024, 256
#: How much of its range a gray level of noise spans on a poster, from coarse to fine.
_BLURS = (24.0, 8.0, 3.0, 1.2)


def make_noise(rng: np.random.Generator, size: int, sigma_x: float, sigma_y: float) -> np.ndarray:
    """Return smooth noise that tiles without a seam.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of the white noise.
    size : int
        Width and height in pixels.
    sigma_x, sigma_y : float
        Standard deviation of the blur along columns and along rows, in pixels.

    Returns
    -------
    numpy.ndarray, shape (size, size), float64
        Zero mean, unit variance.
    """
    white = rng.standard_normal((size, size))
    # A Gaussian blur done in the frequency domain is periodic, hence no seam.
    freq_x = np.fft.rfftfreq(size)[None, :]
    freq_y = np.fft.fftfreq(size)[:, None]
    low_pass = np.exp(-2 * np.pi**2 * ((freq_x * sigma_x) ** 2 + (freq_y * sigma_y) ** 2))
    noise = np.fft.irfft2(np.fft.rfft2(white) * low_pass, s=(size, size))
    noise -= noise.mean()
    return noise / noise.std()


def make_grain(
    rng: np.random.Generator, size: int, base: tuple[float, float, float], contrast: float
) -> np.ndarray:
    """Return a surface with detail of every size, as stone has it.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of the noise.
    size : int
        Width and height in pixels.
    base : tuple of float
        Mean red, green and blue, 0 to 255.
    contrast : float
        Standard deviation in gray levels.

    Returns
    -------
    ndarray, uint8, shape (size, size, 3)
        RGB.
    """
    detail = sum(make_noise(rng, size, blur, blur) for blur in _BLURS) / np.sqrt(len(_BLURS))
    return _to_bytes(np.array(base) + contrast * detail[..., None])


def make_poster(rng: np.random.Generator, size: int = WALL_SIZE, shapes: int = 260) -> np.ndarray:
    """Return a wall full of colored rectangles, discs, rings and triangles.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of places, sizes and colors.
    size : int
        Width and height in pixels.
    shapes : int
        How many there are; later ones cover earlier ones.

    Returns
    -------
    ndarray, uint8, shape (size, size, 3)
        RGB.
    """
    base = tuple(float(one) for one in rng.integers(110, 190, 3))
    picture = make_grain(rng, size, (base[0], base[1], base[2]), 14).astype(np.float64)
    for _ in range(shapes):
        _draw_shape(rng, picture)
    # Print is never quite even: without this, the inside of a large shape could not be matched.
    picture += 6 * make_noise(rng, size, 0.8, 0.8)[..., None]
    return _to_bytes(picture)


def make_wallpaper(
    rng: np.random.Generator, size: int = 512, repeats: int = 8, rows: int = 6
) -> np.ndarray:
    """Return one ornament again and again along each row: what no window can tell apart.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of the ornament.
    size : int
        Width and height in pixels; a multiple of `repeats`.
    repeats : int
        How often the ornament stands in a row.
    rows : int
        How many rows there are.

    Returns
    -------
    ndarray, uint8, shape (size, size, 3)
        RGB.
    """
    u = np.arange(size) * repeats / size % 1.0 - 0.5
    v = np.arange(size)[:, None] * rows / size % 1.0 - 0.5
    distance = np.hypot(u, v)
    angle = np.arctan2(v, u)
    petals = distance < 0.24 + 0.12 * np.cos(int(rng.integers(4, 7)) * angle)
    stripe = np.abs(np.abs(u) - 0.5) < 0.06
    picture = np.broadcast_to(np.array([206.0, 198.0, 176.0]), (size, size, 3)).copy()
    picture[np.broadcast_to(stripe, petals.shape)] = rng.integers(60, 150, 3)
    picture[petals] = rng.integers(40, 140, 3)
    picture[distance < 0.09] = rng.integers(180, 250, 3)
    return _to_bytes(picture)


def make_cube(side: np.ndarray) -> np.ndarray:
    """Stack six sides for a cube texture, each turned differently."""
    turned = [np.rot90(side, turns) for turns in range(4)]
    return np.concatenate([*turned, side[::-1], side[:, ::-1]], axis=0)


def _draw_shape(rng: np.random.Generator, picture: np.ndarray) -> None:
    """Draw one shape in place; over the edge it goes on at the other side."""
    size = len(picture)
    half = int(rng.integers(size // 160, size // 16))
    center_u, center_v = (int(one) for one in rng.integers(0, size, 2))
    across = np.arange(-half, half + 1)
    u, v = across[None, :] / half, across[:, None] / half
    kind = int(rng.integers(4))
    if kind == 0:
        inside = (np.abs(u) <= rng.uniform(0.3, 1)) & (np.abs(v) <= rng.uniform(0.3, 1))
    elif kind == 1:
        inside = u**2 + v**2 <= 1 + 1e-9  # a tie, as of 0.6 and 0.8, is inside everywhere
    elif kind == 2:
        inside = np.abs(np.hypot(u, v) - 0.8) <= rng.uniform(0.08, 0.2)
    else:
        lean = rng.uniform(-0.6, 0.6)
        inside = (v >= -1) & (np.abs(u - lean * v) <= (v + 1) / 2)
    rows, columns = (center_v + across) % size, (center_u + across) % size
    block = np.ix_(rows, columns)
    inside = np.broadcast_to(inside, (across.size, across.size))
    picture[block] = np.where(inside[..., None], _pick_color(rng), picture[block])


def _pick_color(rng: np.random.Generator) -> np.ndarray:
    """Return a color as printed things have them: from dark to light, never glaring."""
    gray = rng.uniform(25, 225)
    tint = rng.uniform(-1, 1, 3)
    return gray + 45 * (tint - tint.mean())


def _to_bytes(picture: np.ndarray) -> np.ndarray:
    return np.round(np.clip(picture, 0, 255)).astype(np.uint8)
