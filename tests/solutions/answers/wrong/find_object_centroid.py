"""Wrong answers to find_object_centroid, as strangers wrote them."""
import cv2
import numpy as np


def _check(mask):
    m = np.asarray(mask)
    if m.dtype not in (np.uint8, np.bool_):
        raise TypeError("mask must be uint8 or bool")
    if m.ndim != 2:
        raise ValueError("mask must have one channel")
    return m


def _right(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] // M["m00"]), int(M["m01"] // M["m00"])


def w_row_first(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m01"] / M["m00"]), int(M["m10"] / M["m00"])


def w_first_contour(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(contours[0])
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_longest_contour(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=len))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_longest_arc(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=lambda c: cv2.arcLength(c, True)))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_whole_mask(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    M = cv2.moments(m, binaryImage=True)
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_pixels_of_largest_component(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    n, labels, stats, centers = cv2.connectedComponentsWithStats(m)
    if n < 2:
        return None
    i = 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))
    return int(centers[i][0]), int(centers[i][1])


def w_rounds(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return round(M["m10"] / M["m00"]), round(M["m01"] / M["m00"])


def w_middle_of_box(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    c = max(contours, key=cv2.contourArea)
    if cv2.contourArea(c) == 0:
        return None
    x, y, w, h = cv2.boundingRect(c)
    return x + (w - 1) // 2, y + (h - 1) // 2


def w_no_area_crashes(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_empty_crashes(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] > 0:
        return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])
    return None


def w_zero_for_none(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    cx, cy = 0, 0
    if contours:
        M = cv2.moments(max(contours, key=cv2.contourArea))
        if M["m00"] > 0:
            cx, cy = int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])
    return cx, cy


def w_pair_of_none(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if len(contours) == 0:
        return None, None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None, None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_bool_crashes(mask):
    m = _check(mask)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_threshold_127(mask):
    m = _check(mask).astype(np.uint8)
    _, m = cv2.threshold(m, 127, 255, cv2.THRESH_BINARY)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_only_255(mask):
    m = _check(mask)
    m = (m == 255).astype(np.uint8) if m.dtype == np.uint8 else m.astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_enclosing_circle(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    c = max(contours, key=cv2.contourArea)
    if cv2.contourArea(c) == 0:
        return None
    (x, y), _ = cv2.minEnclosingCircle(c)
    return int(x), int(y)


def w_floats(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return M["m10"] / M["m00"], M["m01"] / M["m00"]


def w_mean_of_outline(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    c = max(contours, key=cv2.contourArea)
    if cv2.contourArea(c) == 0:
        return None
    x, y = c.reshape(-1, 2).mean(axis=0)
    return int(x), int(y)


def w_float_accepted(mask):
    m = (np.asarray(mask) != 0).astype(np.uint8)
    if m.ndim != 2:
        raise ValueError("mask must have one channel")
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_color_accepted(mask):
    m = np.asarray(mask)
    if m.dtype not in (np.uint8, np.bool_):
        raise TypeError("mask must be uint8 or bool")
    if m.ndim == 3:
        m = m[..., 0]
    m = (m != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_minimum_area(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    c = max(contours, key=cv2.contourArea)
    if cv2.contourArea(c) < 100:  # noise
        return None
    M = cv2.moments(c)
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_three_values(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    _, contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_first_with_no_area(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    best, best_area = None, 0
    for c in contours:
        M = cv2.moments(c)
        if M["m00"] == 0:
            return None
        if M["m00"] > best_area:
            best, best_area = (int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])), M["m00"]
    return best


def w_moments_as_image(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    c = max(contours, key=cv2.contourArea)
    if cv2.contourArea(c) == 0:
        return None
    filled = np.zeros(m.shape, np.uint8)
    cv2.drawContours(filled, [c], -1, 1)  # outline only
    M = cv2.moments(filled, True)
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_inner_contours(mask):
    m = (_check(mask) != 0).astype(np.uint8)
    m = 1 - m
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


def w_changes_input(mask):
    m = _check(mask)
    if m.dtype == np.uint8:
        m[m > 0] = 255
    m = m.astype(np.uint8)
    contours, _ = cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


WRONG = [
    (w_row_first, "(y, x) instead of (x, y); every object off the diagonal"),
    (w_first_contour, "first contour instead of the largest; two objects"),
    (w_longest_contour, "contour with the most points instead of the largest area; a long thin object beside a compact one"),
    (w_longest_arc, "longest outline instead of the largest area; a long thin object beside a compact one"),
    (w_whole_mask, "center of all white pixels; two objects, holes, lines"),
    (w_pixels_of_largest_component, "center and size from pixels, so holes count, and lines have an area; a ring open to one side of its hole, a line"),
    (w_rounds, "rounds to the nearest instead of down; centers with a fraction above one half"),
    (w_middle_of_box, "middle of the bounding box; objects that are not symmetric"),
    (w_no_area_crashes, "divides by zero; a line or a dot"),
    (w_empty_crashes, "max of nothing raises; an empty mask"),
    (w_zero_for_none, "(0, 0) instead of None; an empty mask, a dot"),
    (w_pair_of_none, "(None, None) instead of None; an empty mask, a dot"),
    (w_bool_crashes, "bool goes to findContours: cv2.error; a bool mask"),
    (w_threshold_127, "values up to 127 are outside; masks with 1, bool masks"),
    (w_only_255, "only 255 is inside; masks with 1 or 128"),
    (w_enclosing_circle, "middle of the enclosing circle; objects that are not symmetric"),
    (w_floats, "floats instead of whole numbers; every object"),
    (w_mean_of_outline, "mean of the points of the outline; objects that are not symmetric"),
    (w_float_accepted, "float and int masks pass; float32 mask"),
    (w_color_accepted, "takes the first of three channels; (H, W, 3) mask"),
    (w_minimum_area, "None for objects below 100 pixels; small objects"),
    (w_three_values, "three return values as in OpenCV 3: ValueError; every mask"),
    (w_first_with_no_area, "None as soon as any contour has no area; an object and a speck"),
    (w_moments_as_image, "center of the drawn outline, not of the area; objects that are not symmetric"),
    (w_inner_contours, "inside and outside exchanged; every mask"),
    (w_changes_input, "writes 255 into the caller's mask; masks with other values than 0 and 255"),
]


def _cases():
    def m(f, dtype=np.uint8, shape=(60, 80)):
        def case():
            a = np.zeros(shape, np.uint8)
            f(a)
            return (a.astype(dtype),)
        return case

    def two(a):
        a[5:25, 10:35] = 255
        a[12:20, 35:50] = 255
        a[40:42, 2:78] = 255
        a[50, 70] = 255

    def tri(a):
        for i in range(24):
            a[20 + i, 12:13 + i] = 1

    def ring(a):
        a[5:45, 5:60] = 128
        a[8:30, 20:57] = 0

    def line(a):
        a[7, 3:40] = 255

    def small(a):
        a[30:36, 50:57] = 255
        a[33:36, 57:60] = 255

    def small_and_long(a):
        a[50:52, 2:75] = 255
        a[3:23, 50:70] = 255

    def diag(a):
        for i in range(20):
            a[10 + i, 5:6 + i // 2] = 255
    return [m(two), m(tri), m(ring), m(line), m(small), m(lambda a: None), m(tri, bool), m(diag), m(small_and_long),
            m(tri, np.float32), m(small, np.int32), lambda: (np.zeros((20, 20, 3), np.uint8),)]
