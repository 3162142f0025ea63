"""Wrong answers to fill_invalid_depth, as strangers wrote them."""
import cv2
import numpy as np


def _right(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    kernel = np.ones((3, 3), np.uint8)
    while not valid.all():
        far = cv2.dilate(out, kernel)
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_nearest_neighbor_depth(depth_metric):
    out = depth_metric.copy()
    valid = (out > 0.01) & (out < 10)
    out[~valid] = np.inf
    while not valid.all():
        near = cv2.erode(out, np.ones((3, 3), np.uint8))
        new = ~valid & np.isfinite(near)
        out[new] = near[new]
        valid |= new
    return out


def w_mean_of_neighbors(depth_metric):
    out = depth_metric.copy()
    valid = (out > 0.01) & (out < 10)
    out[~valid] = 0
    while not valid.all():
        kernel = np.ones((3, 3), np.float32)
        total = cv2.filter2D(out, -1, kernel, borderType=cv2.BORDER_CONSTANT)
        count = cv2.filter2D(valid.astype(np.float32), -1, kernel, borderType=cv2.BORDER_CONSTANT)
        new = ~valid & (count > 0.5)
        out[new] = total[new] / count[new]
        valid |= new
    return out


def w_inpaint(depth_metric):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    clean = np.where(valid, depth_metric, 0).astype(np.float32)
    return cv2.inpaint(clean, (~valid).astype(np.uint8), 3, cv2.INPAINT_NS)


def w_sequential(depth_metric):
    out = depth_metric.copy()
    h, w = out.shape
    valid = (out > 0.01) & (out < 10)
    while not valid.all():
        for v in range(h):
            for u in range(w):
                if not valid[v, u]:
                    win = np.s_[max(v - 1, 0):v + 2, max(u - 1, 0):u + 2]
                    if valid[win].any():
                        out[v, u] = out[win][valid[win]].max()
                        valid[v, u] = True
    return out


def w_four_neighbors(depth_metric):
    out = depth_metric.copy()
    valid = (out > 0.01) & (out < 10)
    out[~valid] = 0
    cross = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))
    while not valid.all():
        far = cv2.dilate(out, cross)
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_one_round(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    far = cv2.dilate(out, np.ones((3, 3), np.uint8))
    return np.where(valid, out, far)


def w_dilates_valid_too(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    while (out == 0).any():
        out = cv2.dilate(out, np.ones((3, 3), np.uint8))
    return out


def w_nan_only(depth_metric):
    out = depth_metric.copy()
    invalid = np.isnan(out)
    out[invalid] = 0
    while invalid.any():
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        new = invalid & (far > 0)
        if not new.any():
            break
        out[new] = far[new]
        invalid &= ~new
    return out


def w_zero_only(depth_metric):
    out = depth_metric.copy()
    while (out == 0).any():
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        if far.max() == 0:
            break
        out = np.where(out == 0, far, out)
    return out


def w_far_plane_valid(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01)
    out[~valid] = 0
    while not valid.all():
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_ten_is_valid(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out <= 10)
    out[~valid] = 0
    while not valid.all():
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_zero_limit(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0) & (out < 10)
    out[~valid] = 0
    while not valid.all():
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_changes_input(depth_metric):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    depth_metric[~valid] = 0
    while not valid.all():
        far = cv2.dilate(depth_metric, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        depth_metric[new] = far[new]
        valid |= new
    return depth_metric


def w_float64(depth_metric):
    out = depth_metric.astype(np.float64)
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    while not valid.all():
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_roll_wraps(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    while not valid.all():
        shifts = [np.roll(out, (a, b), (0, 1)) for a in (-1, 0, 1) for b in (-1, 0, 1)]
        far = np.max(shifts, axis=0)
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_border_left_out(depth_metric):
    out = depth_metric.copy()
    h, w = out.shape
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    changed = True
    while changed:
        changed = False
        old, ok = out.copy(), valid.copy()
        for v in range(1, h - 1):
            for u in range(1, w - 1):
                if not ok[v, u] and ok[v - 1:v + 2, u - 1:u + 2].any():
                    out[v, u] = old[v - 1:v + 2, u - 1:u + 2][ok[v - 1:v + 2, u - 1:u + 2]].max()
                    valid[v, u] = changed = True
    return out


def w_negative_slice(depth_metric):
    out = depth_metric.copy()
    h, w = out.shape
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    for _ in range(h + w):
        old, ok = out.copy(), valid.copy()
        for v in range(h):
            for u in range(w):
                win = np.s_[v - 1:v + 2, u - 1:u + 2]
                if not ok[v, u] and ok[win].any():
                    out[v, u] = old[win][ok[win]].max()
                    valid[v, u] = True
    return out


def w_five_by_five(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    while not valid.all():
        far = cv2.dilate(out, np.ones((5, 5), np.uint8))
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_global_farthest(depth_metric):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    return np.where(valid, depth_metric, depth_metric[valid].max()).astype(np.float32)


def w_ten_rounds(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    out[~valid] = 0
    for _ in range(10):
        far = cv2.dilate(out, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        out[new] = far[new]
        valid |= new
    return out


def w_nearest_valid_pixel(depth_metric):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    rows, cols = np.nonzero(valid)
    out = depth_metric.copy()
    for v, u in np.argwhere(~valid):
        k = np.argmin((rows - v) ** 2 + (cols - u) ** 2)
        out[v, u] = depth_metric[rows[k], cols[k]]
    return out


def w_row_from_the_left(depth_metric):
    out = depth_metric.copy()
    valid = np.isfinite(out) & (out > 0.01) & (out < 10)
    for row, ok in zip(out, valid):
        known = np.nonzero(ok)[0]
        if len(known):
            row[~ok] = np.interp(np.nonzero(~ok)[0], known, row[known])
    return out


def w_whole_millimeters(depth_metric):
    mm = np.nan_to_num(1000 * depth_metric, nan=0, posinf=0, neginf=0)
    mm = np.clip(mm, 0, 65535).astype(np.uint16)
    valid = (mm > 10) & (mm < 10000)
    mm[~valid] = 0
    while not valid.all():
        far = cv2.dilate(mm, np.ones((3, 3), np.uint8))
        new = ~valid & (far > 0)
        mm[new] = far[new]
        valid |= new
    return mm.astype(np.float32) / 1000


def w_infinity_wins(depth_metric):
    out = depth_metric.copy()
    valid = (out > 0.01) & (out < 10)
    while not valid.all():
        far = cv2.dilate(np.nan_to_num(out), np.ones((3, 3), np.uint8))
        near_valid = cv2.dilate(valid.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        new = ~valid & near_valid
        out[new] = far[new]
        valid |= new
    return out


def w_returns_nothing(depth_metric):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    if not valid.all():
        out = np.where(valid, depth_metric, 0).astype(np.float32)
        while not valid.all():
            far = cv2.dilate(out, np.ones((3, 3), np.uint8))
            new = ~valid & (far > 0)
            out[new] = far[new]
            valid |= new
        return out


WRONG = [
    (w_nearest_neighbor_depth, "takes the closest neighbor instead of the farthest; a hole between two depths"),
    (w_mean_of_neighbors, "takes the mean of the neighbors, edges blur; a hole between two depths"),
    (w_inpaint, "cv2.inpaint smooths across the hole; a hole between two depths"),
    (w_sequential, "filled pixels count at once, in the same round; holes of two or more pixels beside different depths"),
    (w_four_neighbors, "four neighbors; a hole with a farther diagonal neighbor"),
    (w_one_round, "one round only; holes wider than two pixels"),
    (w_dilates_valid_too, "valid pixels grow too; a valid pixel beside a farther one"),
    (w_nan_only, "only NaN counts as invalid; 0 or the far plane"),
    (w_zero_only, "only 0 counts as invalid; NaN, 12 m"),
    (w_far_plane_valid, "upper limit forgotten; a pixel at the far plane"),
    (w_ten_is_valid, "<= 10 instead of < 10; a pixel of exactly 10 m"),
    (w_zero_limit, "lower limit 0 instead of 0.01 m; a pixel of 0.005 m"),
    (w_changes_input, "fills the caller's array; every input with holes"),
    (w_float64, "float64 instead of float32; every input"),
    (w_roll_wraps, "np.roll makes opposite borders neighbors; a hole at the border"),
    (w_border_left_out, "loops leave out the border; holes at the border"),
    (w_negative_slice, "v-1 = -1 makes an empty window at the first row and column; holes at the top or left border"),
    (w_five_by_five, "5 x 5 window; holes with a farther depth two pixels away"),
    (w_global_farthest, "fills with the farthest depth of the picture; several depths"),
    (w_ten_rounds, "stops after 10 rounds; a hole more than 20 pixels wide"),
    (w_nearest_valid_pixel, "copies the nearest valid pixel, not the farthest of the neighbors; a hole between two depths"),
    (w_row_from_the_left, "interpolates along rows; a hole between two depths"),
    (w_whole_millimeters, "goes through whole millimeters, valid depths change; depths with fractions of a millimeter"),
    (w_infinity_wins, "invalid values larger than the valid ones take part in the maximum; infinity or 12 m in the hole"),
    (w_returns_nothing, "answers None where nothing is to fill; a picture without holes"),
]


def _cases():
    def a():
        r = np.random.default_rng(0)
        d = r.uniform(0.5, 3, (9, 12)).astype(np.float32)
        d[2:6, 3:8] = np.nan
        d[0, :3] = 0
        d[8, 10:] = 12
        d[4, 11] = np.inf
        d[7, 0] = 10.0
        d[6, 6] = 0.005
        d[3, 4] = 11.5
        return (d,)

    def b():
        d = np.zeros((5, 60), np.float32)
        d[2, 0], d[0, 59] = 1.0, 2.0
        return (d,)

    def c():
        return (np.full((3, 4), 1.25, np.float32),)

    def e():
        d = np.full((6, 7), 1.0, np.float32)
        d[:, 4:] = 2.0
        d[1:5, 2:5] = 0
        return (d,)
    return [a, b, c, e]
