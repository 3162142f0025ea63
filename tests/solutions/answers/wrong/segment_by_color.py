"""Wrong answers to segment_by_color, as strangers wrote them."""
import cv2
import numpy as np


def _check(rgb_image, target_hsv_range):
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8:
        raise TypeError("the picture must be uint8")
    if rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("the picture must be (H, W, 3)")
    try:
        low, high = target_hsv_range
        low, high = np.array(low, float), np.array(high, float)
    except Exception:
        raise ValueError("the range must be two triples")
    if low.shape != (3,) or high.shape != (3,):
        raise ValueError("the range must be two triples")
    for t in (low, high):
        if (t < 0).any() or (t > [179, 255, 255]).any():
            raise ValueError("outside OpenCV's limits")
    if (low[1:] > high[1:]).any():
        raise ValueError("low > high")
    return rgb, low.astype(int), high.astype(int)


def _right(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV).astype(int)
    h = hsv[..., 0]
    inside = (h >= low[0]) | (h <= high[0]) if low[0] > high[0] else (h >= low[0]) & (h <= high[0])
    inside = inside & (hsv[..., 1:] >= low[1:]).all(-1) & (hsv[..., 1:] <= high[1:]).all(-1)
    mask = inside.astype(np.uint8) * 255
    k = np.ones((5, 5), np.uint8)
    return cv2.morphologyEx(cv2.morphologyEx(mask, cv2.MORPH_OPEN, k), cv2.MORPH_CLOSE, k)


def _ranges(hsv, low, high):
    if low[0] > high[0]:
        a = cv2.inRange(hsv, low, np.array([179, high[1], high[2]]))
        b = cv2.inRange(hsv, np.array([0, low[1], low[2]]), high)
        return a | b
    return cv2.inRange(hsv, low, high)


def w_bgr(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_BGR2HSV)
    mask = _ranges(hsv, low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_no_wrap(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    mask = cv2.inRange(hsv, low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_wrap_swapped(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    mask = cv2.inRange(hsv, np.minimum(low, high), np.maximum(low, high))
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_wrap_joined_by_and(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    if low[0] > high[0]:
        a = cv2.inRange(hsv, low, np.array([179, high[1], high[2]]))
        b = cv2.inRange(hsv, np.array([0, low[1], low[2]]), high)
        mask = cv2.bitwise_and(a, b)
    else:
        mask = cv2.inRange(hsv, low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_wrap_ignores_saturation(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    if low[0] > high[0]:
        a = cv2.inRange(hsv, low, np.array([179, 255, 255]))
        b = cv2.inRange(hsv, np.array([0, 0, 0]), high)
        mask = a | b
    else:
        mask = cv2.inRange(hsv, low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_close_then_open(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)
    return cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)


def w_not_cleaned(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    return _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)


def w_only_opened(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    opened = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((5, 5), np.uint8))
    closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8))
    return opened


def w_close_from_raw(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    opened = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    closed = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)
    return closed


def w_three_by_three(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((3, 3), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_ellipse(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (5, 5))
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_full_hue(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV_FULL), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_halves_hue_again(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    low[0], high[0] = low[0] // 2, high[0] // 2  # degrees to OpenCV
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_exclusive_limits(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    h, s, v = hsv[..., 0], hsv[..., 1], hsv[..., 2]
    if low[0] > high[0]:
        hue = (h > low[0]) | (h < high[0])
    else:
        hue = (h > low[0]) & (h < high[0])
    inside = hue & (s > low[1]) & (s < high[1]) & (v > low[2]) & (v < high[2])
    mask = np.uint8(inside) * 255
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_bool(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k) > 0


def w_zero_one(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high) // 255
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_float_accepted(rgb_image, target_hsv_range):
    rgb = np.asarray(rgb_image)
    if rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("the picture must be (H, W, 3)")
    if rgb.dtype != np.uint8:
        rgb = (255 * rgb).astype(np.uint8)
    _, low, high = _check(rgb, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_range_not_checked(rgb_image, target_hsv_range):
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8 or rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("the picture must be uint8 RGB")
    low, high = np.array(target_hsv_range[0]), np.array(target_hsv_range[1])
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_hue_up_to_255(rgb_image, target_hsv_range):
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8 or rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("the picture must be uint8 RGB")
    low, high = np.array(target_hsv_range)
    if low.min() < 0 or high.min() < 0 or low.max() > 255 or high.max() > 255:
        raise ValueError("limits must lie in 0..255")
    if low[1] > high[1] or low[2] > high[2]:
        raise ValueError("low > high")
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_wrap_forbidden(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    if (low > high).any():
        raise ValueError("low must not be above high")
    mask = cv2.inRange(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_saturation_wraps_too(rgb_image, target_hsv_range):
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8 or rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("the picture must be uint8 RGB")
    low, high = np.array(target_hsv_range)
    if low.shape != (3,) or (low < 0).any() or (high > [179, 255, 255]).any():
        raise ValueError("limits")
    if (high < 0).any() or (low > [179, 255, 255]).any():
        raise ValueError("limits")
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    inside = np.ones(hsv.shape[:2], bool)
    for c in range(3):
        if low[c] > high[c]:
            inside &= (hsv[..., c] >= low[c]) | (hsv[..., c] <= high[c])
        else:
            inside &= (hsv[..., c] >= low[c]) & (hsv[..., c] <= high[c])
    mask = np.uint8(inside) * 255
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_cleans_each_half(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    k = np.ones((5, 5), np.uint8)

    def clean(m):
        return cv2.morphologyEx(cv2.morphologyEx(m, cv2.MORPH_OPEN, k), cv2.MORPH_CLOSE, k)
    if low[0] <= high[0]:
        return clean(cv2.inRange(hsv, low, high))
    a = clean(cv2.inRange(hsv, low, np.array([179, high[1], high[2]])))
    b = clean(cv2.inRange(hsv, np.array([0, low[1], low[2]]), high))
    return cv2.bitwise_or(a, b)


def w_blurs_first(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    rgb = cv2.GaussianBlur(rgb, (5, 5), 0)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_always_red(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    mask = cv2.inRange(hsv, (0, 100, 100), (10, 255, 255)) | cv2.inRange(hsv, (160, 100, 100), (179, 255, 255))
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_needs_array(rgb_image, target_hsv_range):
    if rgb_image.dtype != np.uint8 or rgb_image.ndim != 3 or rgb_image.shape[2] != 3:
        raise ValueError("the picture must be uint8 RGB")
    _, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


def w_two_iterations(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k, iterations=2)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k, iterations=2)


def w_erode_dilate(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    mask = _ranges(cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV), low, high)
    k = np.ones((5, 5), np.uint8)
    return cv2.dilate(cv2.erode(mask, k), k)


def w_value_upper_forgotten(rgb_image, target_hsv_range):
    rgb, low, high = _check(rgb_image, target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    high = np.array([high[0], 255, 255])
    mask = _ranges(hsv, low, high)
    k = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, k)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)


WRONG = [
    (w_bgr, "picture taken for BGR; every colored picture"),
    (w_no_wrap, "inRange with low hue above high hue finds nothing; ranges that wrap"),
    (w_wrap_swapped, "sorts the limits: a range that wraps means its opposite; ranges that wrap"),
    (w_wrap_joined_by_and, "both halves joined by and; ranges that wrap"),
    (w_wrap_ignores_saturation, "each half of a wrapping range has only one of the limits for saturation and value; pale or dark reds"),
    (w_close_then_open, "closing before opening; specks and holes close together"),
    (w_not_cleaned, "no opening and closing; a picture with specks or holes"),
    (w_only_opened, "answers the opened mask, not the closed one; holes that opening leaves"),
    (w_close_from_raw, "copy-paste slip: closes the raw mask; specks"),
    (w_three_by_three, "3 x 3 ones; specks of 3 or 4 pixels"),
    (w_ellipse, "ellipse instead of ones; corners of rectangles"),
    (w_full_hue, "hue from 0 to 255 (HSV_FULL); every range but near 0"),
    (w_halves_hue_again, "takes the limits for degrees and halves them; every range that does not reach both ends"),
    (w_exclusive_limits, "limits are exclusive; colors on a limit, such as saturation 255"),
    (w_bool, "bool instead of uint8; every input"),
    (w_zero_one, "1 instead of 255 inside; every mask that is not empty"),
    (w_float_accepted, "float pictures are converted, not refused; float32 picture"),
    (w_range_not_checked, "no error for bad ranges; hue 200, saturation low > high"),
    (w_hue_up_to_255, "hue limit checked against 255; hue 200"),
    (w_wrap_forbidden, "raises for ranges that wrap; ranges that wrap"),
    (w_saturation_wraps_too, "saturation and value wrap too, no error; low saturation above the high one"),
    (w_cleans_each_half, "cleans the two halves of a wrapping range before joining them; an object with hues on both sides of the seam"),
    (w_blurs_first, "blurs the picture first; outlines and specks"),
    (w_always_red, "range ignored, always red; any other color"),
    (w_needs_array, "uses .dtype of the argument: AttributeError; a uint8 picture as a list of its rows (array-like)"),
    (w_two_iterations, "two iterations act like a 9 x 9 square; objects narrower than 9 pixels"),
    (w_erode_dilate, "closing is missing: erosion and dilation are the opening alone; holes"),
    (w_value_upper_forgotten, "upper limits of saturation and value ignored; colors above them"),
]


def _picture(seed=0):
    r = np.random.default_rng(seed)
    hsv = np.zeros((60, 90, 3), np.uint8)
    hsv[..., :] = (100, 40, 120)
    hsv[5:25, 5:25] = (178, 200, 180)
    hsv[5:25, 25:40] = (3, 210, 200)
    hsv[30:50, 5:30] = (60, 255, 160)
    hsv[30:37, 35:60] = (60, 180, 100)
    hsv[40:58, 35:60] = (25, 200, 255)
    hsv[5:25, 45:60] = (4, 60, 90)
    hsv[5:28, 65:85] = (120, 220, 200)
    noise = r.random((60, 90)) < 0.06
    hsv[noise] = np.stack([r.integers(0, 180, noise.sum()), r.integers(0, 256, noise.sum()), r.integers(0, 256, noise.sum())], 1)
    hsv[10:22:1, 20:30:3] = (179, 200, 180)
    hsv[10:22:1, 21:30:3] = (2, 200, 180)
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB)


def _cases():
    p = _picture()
    pure = np.zeros((30, 40, 3), np.uint8)
    pure[5:20, 5:25, 1] = 255
    L = [(p, ((170, 120, 50), (6, 255, 255))), (p, ((50, 100, 50), (70, 255, 200))), (p, ((20, 100, 50), (30, 255, 255))),
         (p, ((110, 100, 50), (130, 230, 255))), (pure, ((60, 255, 255), (60, 255, 255))), (p, ((50, 100, 50), (70, 190, 120))),
         (p, ((170, 100, 50), (200, 255, 255))), (p, ((0, 200, 50), (10, 100, 255))), (p.astype(np.float32) / 255, ((0, 100, 50), (10, 200, 255))),
         (p[..., 0], ((0, 100, 50), (10, 200, 255))), (p, ((0, 100), (10, 200))), (p, ((-1, 100, 0), (10, 200, 255))),
         (p, ((0, 10, 200), (10, 200, 100))), (p, ((0, 0, 0), (179, 255, 256)))]
    return [lambda t=t: (t[0].copy(), t[1]) for t in L] + [lambda: (list(p), L[1][1])]
