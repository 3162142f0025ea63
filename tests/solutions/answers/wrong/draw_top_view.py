"""Wrong answers to draw_top_view, as strangers wrote them."""
import cv2
import numpy as np


def _right(points_world, colors, low, high, pixels_per_meter):
    H, W = (int(round(float(high[i] - low[i]) * pixels_per_meter)) for i in range(2))
    out = np.zeros((H, W, 3), np.uint8)
    top = np.full((H, W), -np.inf)
    for (x, y, z), c in zip(points_world, colors):
        r = int(np.floor((high[0] - x) * pixels_per_meter))
        k = int(np.floor((high[1] - y) * pixels_per_meter))
        if 0 <= r < H and 0 <= k < W and z > top[r, k]:
            top[r, k] = z
            out[r, k] = np.round(255 * c)
    return out


def w_x_y_swapped(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    col = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_y_to_the_right(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((points_world[:, 1] - low[1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_x_down(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((points_world[:, 0] - low[0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_cuts_toward_zero(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = ((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = ((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_rounds_to_pixel(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.rint((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.rint((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_last_wins(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    ok = (row >= 0) & (row < H) & (col >= 0) & (col < W)
    picture = np.zeros((H, W, 3), np.uint8)
    picture[row[ok], col[ok]] = np.rint(255 * colors[ok])
    return picture


def w_lowest_wins(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(-points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_colors_not_sorted_along(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    points = points_world[np.argsort(points_world[:, 2])]
    row = np.floor((high[0] - points[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for r, c, color in zip(row, col, colors):
        if 0 <= r < H and 0 <= c < W:
            picture[r, c] = np.rint(255 * color)
    return picture


def w_height_map_from_zero(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    highest = np.zeros((H, W))
    for (x, y, z), color in zip(points_world, colors):
        r = int(np.floor((high[0] - x) * pixels_per_meter))
        c = int(np.floor((high[1] - y) * pixels_per_meter))
        if 0 <= r < H and 0 <= c < W and z > highest[r, c]:
            highest[r, c] = z
            picture[r, c] = np.rint(255 * color)
    return picture


def w_height_not_stored(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    highest = np.full((H, W), -np.inf)
    for (x, y, z), color in zip(points_world, colors):
        r = int(np.floor((high[0] - x) * pixels_per_meter))
        c = int(np.floor((high[1] - y) * pixels_per_meter))
        if 0 <= r < H and 0 <= c < W:
            if z > highest[r, c]:
                picture[r, c] = np.rint(255 * color)
            highest[r, c] = z
    return picture


def w_colors_cut(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = (255 * colors[i]).astype(np.uint8)
    return picture


def w_times_256(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.floor(256 * colors[i]).astype(int).astype(np.uint8)
    return picture


def w_colors_not_scaled(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.round(colors[i]) * 255
    return picture


def w_size_cut(points_world, colors, low, high, pixels_per_meter):
    H, W = ((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_size_ceil(points_world, colors, low, high, pixels_per_meter):
    H, W = np.ceil((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_height_and_width_swapped(points_world, colors, low, high, pixels_per_meter):
    W, H = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_clips_to_map(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    row, col = np.clip(row, 0, H - 1), np.clip(col, 0, W - 1)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_nothing_left_out(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_negative_wraps(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if abs(row[i]) < H and abs(col[i]) < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_limits_included(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        x, y, _ = points_world[i]
        if low[0] <= x <= high[0] and low[1] <= y <= high[1]:
            r = int((high[0] - x) * pixels_per_meter)
            c = int((high[1] - y) * pixels_per_meter)
            picture[r, c] = np.rint(255 * colors[i])
    return picture


def w_bgr(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return cv2.cvtColor(picture, cv2.COLOR_RGB2BGR)


def w_floats(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3))
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = colors[i]
    return picture


def w_white_ground(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.full((H, W, 3), 255, np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_mean_color(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    ok = (row >= 0) & (row < H) & (col >= 0) & (col < W)
    total, count = np.zeros((H, W, 3)), np.zeros((H, W, 1))
    np.add.at(total, (row[ok], col[ok]), colors[ok])
    np.add.at(count, (row[ok], col[ok]), 1)
    return np.rint(255 * total / np.maximum(count, 1)).astype(np.uint8)


def w_low_for_column(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[0] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_empty_crashes(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    highest = np.full((H, W), points_world[:, 2].min() - 1)
    for i in range(len(row)):
        if 0 <= row[i] < H and 0 <= col[i] < W and points_world[i, 2] > highest[row[i], col[i]]:
            highest[row[i], col[i]] = points_world[i, 2]
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_map_kept(points_world, colors, low, high, pixels_per_meter, _maps={}):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    picture = _maps.setdefault((H, W), np.zeros((H, W, 3), np.uint8))
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(255 * colors[i])
    return picture


def w_scales_input(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    colors *= 255
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    for i in np.argsort(points_world[:, 2]):
        if 0 <= row[i] < H and 0 <= col[i] < W:
            picture[row[i], col[i]] = np.rint(colors[i])
    return picture


WRONG = [
    (w_x_y_swapped, "row from y and column from x; every cloud"),
    (w_y_to_the_right, "y points right; every cloud"),
    (w_x_down, "x points down; every cloud"),
    (w_cuts_toward_zero, "cuts instead of floor: points just outside the upper limits fall into row or column 0; x a little above high_x"),
    (w_rounds_to_pixel, "rounds to the nearest pixel instead of floor; every cloud"),
    (w_last_wins, "last point wins instead of the highest; several points in a pixel"),
    (w_lowest_wins, "lowest point wins; several points in a pixel"),
    (w_colors_not_sorted_along, "points are sorted by height, colors are not; every cloud not in order of height"),
    (w_height_map_from_zero, "heights start at 0; points at or below z = 0"),
    (w_height_not_stored, "height of a hidden point overwrites the stored one; three points in a pixel: high, low, middle"),
    (w_colors_cut, "colors cut instead of rounded; most colors"),
    (w_times_256, "factor 256: 1.0 wraps to 0; pure colors"),
    (w_colors_not_scaled, "rounds before it multiplies: only 0 and 255; most colors"),
    (w_size_cut, "size cut instead of rounded; (high - low) * scale just below a whole number, or with a fraction above one half"),
    (w_size_ceil, "size rounded up; (high - low) * scale with a fraction below one half"),
    (w_height_and_width_swapped, "shape (columns, rows); maps that are not square"),
    (w_clips_to_map, "points outside land on the border; a point outside"),
    (w_nothing_left_out, "no test at all: IndexError or the opposite border; a point outside"),
    (w_negative_wraps, "negative rows and columns wrap around; a point beyond high"),
    (w_limits_included, "tests the meters with limits included: IndexError; a point exactly at low"),
    (w_bgr, "BGR; every cloud with color"),
    (w_floats, "floats from 0 to 1; every cloud"),
    (w_white_ground, "white where no point is; every map with an empty pixel"),
    (w_mean_color, "mean color instead of the highest point's; several points in a pixel"),
    (w_low_for_column, "copy-paste slip: high_x used for y; maps with other limits in x and y"),
    (w_empty_crashes, "min of nothing raises; an empty cloud"),
    (w_map_kept, "keeps the map between calls; second call with the same size"),
    (w_scales_input, "multiplies the caller's colors by 255; every cloud"),
]


def _cases():
    def make(seed, low, high, ppm, n=200):
        def case():
            r = np.random.default_rng(seed)
            lo, hi = np.array(low, float), np.array(high, float)
            p = np.c_[r.uniform(lo - 0.15, hi + 0.15, (n, 2)), r.uniform(-0.4, 0.8, n)]
            c = r.random((n, 3))
            c[::7] = [1, 0, 1]
            if n > 20:
                p[0] = [hi[0] + 0.001, (lo[1] + hi[1]) / 2, 2]
                p[1] = [lo[0], lo[1], 1.5]
                p[2] = [lo[0], (lo[1] + hi[1]) / 2, 1.6]
            return p, c, lo, hi, ppm
        return case
    return [make(0, [0, -0.5], [1, 0.5], 10), make(1, [0.2, -1], [1.1, 0.3], 8), make(2, [0, 0], [0.29, 0.58], 100, 400),
            make(3, [0, -0.5], [1, 0.5], 10), make(4, [0, 0], [0.5, 1], 10, 0), make(5, [0.1, 0], [0.35, 0.56], 9)]
