"""Wrong answers to measure_object_size, as strangers wrote them."""
import cv2
import numpy as np


def _right(mask, depth_metric, K):
    d = depth_metric.astype(np.float64)
    valid = (mask > 0) & np.isfinite(d) & (d > 0.01) & (d < 10)
    keep = valid & (np.abs(d - np.median(d[valid])) <= 0.05)
    v, u = np.nonzero(keep)
    z = d[keep]
    return float(np.ptp((u - K[0, 2]) * z / K[0, 0])), float(np.ptp((v - K[1, 2]) * z / K[1, 1]))


def w_mean_depth(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = depth_metric[valid].mean()
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_median_with_invalid(mask, depth_metric, K):
    inside = mask > 0
    middle = np.median(depth_metric[inside])
    keep = inside & (depth_metric > 0.01) & (depth_metric < 10) & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(x.max() - x.min()), float(y.max() - y.min())


def w_border_kept(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    v, u = np.nonzero(valid)
    z = depth_metric[valid].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_relative_limit(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05 * middle)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_half_of_limit(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (depth_metric > middle - 0.05 / 2) & (depth_metric < middle + 0.05 / 2)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_swapped_return(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(y)), float(np.ptp(x))


def w_u_v_swapped(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    u, v = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_no_center(mask, depth_metric, K):
    # the center cancels in the difference
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = u * z / K[0, 0], v * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_pixels_times_median(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = float(np.median(depth_metric[valid]))
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    return float((u.max() - u.min()) * middle / K[0, 0]), float((v.max() - v.min()) * middle / K[1, 1])


def w_bounding_rect(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = float(np.median(depth_metric[valid]))
    x, y, w, h = cv2.boundingRect(mask)
    return w * middle / K[0, 0], h * middle / K[1, 1]


def w_one_pixel_more(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x) + middle / K[0, 0]), float(np.ptp(y) + middle / K[1, 1])


def w_mask_equals_one(mask, depth_metric, K):
    valid = (mask == 1) & (depth_metric > 0.01) & (depth_metric < 10)
    if not valid.any():
        return 0.0, 0.0
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_mask_as_index(mask, depth_metric, K):
    z = depth_metric[mask]
    z = z[(z > 0.01) & (z < 10)]
    middle = np.median(z)
    keep = (mask > 0) & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_fx_for_y(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[0, 0]
    return float(np.ptp(x)), float(np.ptp(y))


def w_limit_in_centimeters(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (100 * np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_lower_limit_forgotten(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    if not keep.any():
        return 0.0, 0.0
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_upper_limit_forgotten(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    if not keep.any():
        return 0.0, 0.0
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_nearest_instead_of_median(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    front = depth_metric[valid].min()
    keep = valid & (depth_metric - front <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_one_sided(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (depth_metric - middle <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_median_of_picture(mask, depth_metric, K):
    ok = (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[ok])
    keep = ok & (mask > 0) & (np.abs(depth_metric - middle) <= 0.05)
    if not keep.any():
        return 0.0, 0.0
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_percentiles(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    x0, x1 = np.percentile(x, [1, 99])
    y0, y1 = np.percentile(y, [1, 99])
    return float(x1 - x0), float(y1 - y0)


def w_millimeters(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = 1000 * depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_erodes_mask(mask, depth_metric, K):
    inner = cv2.erode(mask, np.ones((3, 3), np.uint8))
    valid = (inner > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.ptp(x)), float(np.ptp(y))


def w_largest_minus_center(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    z = depth_metric[keep].astype(float)
    x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
    return float(np.max(np.abs(x))) * 2, float(np.max(np.abs(y))) * 2


def w_numbers_of_pixels(mask, depth_metric, K):
    valid = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[valid])
    keep = valid & (np.abs(depth_metric - middle) <= 0.05)
    v, u = np.nonzero(keep)
    return float(np.ptp(u)), float(np.ptp(v))


WRONG = [
    (w_mean_depth, "mean instead of median depth; a mask with enough background at its border"),
    (w_median_with_invalid, "invalid pixels take part in the median; many invalid pixels, or one NaN"),
    (w_border_kept, "the 0.05 m rule is missing; background in the mask"),
    (w_relative_limit, "5 percent instead of 0.05 m; depths away from 1 m"),
    (w_half_of_limit, "0.05 m taken as the whole band; points 0.03 to 0.05 m from the median"),
    (w_swapped_return, "(height, width); objects that are not square"),
    (w_u_v_swapped, "np.nonzero unpacked as (u, v); objects that are not square"),
    (w_no_center, "leaves out the principal point, which cancels only at equal depth; tilted sides"),
    (w_pixels_times_median, "pixel extent times median depth; tilted sides"),
    (w_bounding_rect, "box of the whole mask times median depth, also one pixel too many; every mask"),
    (w_one_pixel_more, "adds the width of one pixel; every mask"),
    (w_mask_equals_one, "looks for 1 in a mask of 0 and 255; every mask"),
    (w_mask_as_index, "uint8 mask used as an index, not as a condition: rows 0 and 255; IndexError for fewer than 256 rows, else another median"),
    (w_fx_for_y, "copy-paste slip: fx for y; fx other than fy"),
    (w_limit_in_centimeters, "limit mixes centimeters and meters: 0.5 mm; sides that are not flat"),
    (w_lower_limit_forgotten, "0 counts as valid; more holes of 0 than valid pixels, or some that move the median"),
    (w_upper_limit_forgotten, "far plane counts as valid; many far-plane pixels in the mask"),
    (w_nearest_instead_of_median, "nearest depth instead of the median; one pixel far too near, deep objects"),
    (w_one_sided, "forgets the absolute value: pixels in front stay; a nearer thing at the border"),
    (w_median_of_picture, "median of the whole picture; an object away from the rest"),
    (w_percentiles, "1 and 99 percent instead of smallest and largest; every mask"),
    (w_millimeters, "millimeters; every mask"),
    (w_erodes_mask, "erodes the mask first, which takes a pixel off each side; masks that end where the object ends"),
    (w_largest_minus_center, "twice the largest distance from the axis; objects off the axis"),
    (w_numbers_of_pixels, "pixels instead of meters; every mask"),
]


def _cases():
    K = np.array([[70.0, 0, 31.5], [0, 80.0, 23.5], [0, 0, 1]])

    def make(seed, z, tilt, kind):
        def case():
            r = np.random.default_rng(seed)
            D = np.full((48, 64), 2.5, np.float32)
            M = np.zeros((48, 64), np.uint8)
            D[10:30, 20:50] = z + tilt * np.linspace(-1, 1, 30) + 0.003 * r.random((20, 30))
            M[8:32, 18:52] = 255
            if kind == "holes":
                D[12:28, 24:44] = 0
            if kind == "far":
                D[12:28, 24:44] = 12
                D[8:10] = z
            if kind == "front":
                D[28:32, 18:22] = z - 0.3
                D[11, 40] = np.nan
            if kind == "off":
                M[:] = 0
                M[10:30, 20:50] = 255
                D[15, 30] = np.nan
            if kind == "zeros":
                D[11:29, 21:49] = 0
            return M, D, K.copy()
        return case
    return [make(0, 0.8, 0.0, ""), make(1, 0.8, 0.045, ""), make(2, 0.7, 0.02, "holes"), make(3, 0.7, 0.04, "far"),
            make(4, 1.8, 0.03, "front"), make(5, 0.6, 0.044, "off"), make(6, 1.9, 0.08, "off"), make(7, 0.9, 0.01, "zeros")]
