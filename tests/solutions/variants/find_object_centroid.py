"""Right answers to find_object_centroid, written in ways that the card does not contain."""

import cv2
import numpy as np


def centroid_by_components(mask: np.ndarray) -> tuple[int, ...] | None:
    count, _, stats, centers = cv2.connectedComponentsWithStats(mask)
    # A line has no area for cv2.contourArea: at least two pixels each way are needed.
    good = [n for n in range(1, count) if min(stats[n, 2], stats[n, 3]) > 1]
    if not good:
        return None
    return tuple(int(c) for c in centers[max(good, key=lambda n: stats[n, 4])])


def centroid_rounded_as_array(mask: np.ndarray) -> np.ndarray | None:
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    areas = [cv2.contourArea(contour) for contour in contours]
    if not areas or max(areas) == 0:
        return None
    m = cv2.moments(contours[int(np.argmax(areas))])
    return np.rint([m["m10"] / m["m00"], m["m01"] / m["m00"]]).astype(np.int32)


def centroid_as_list(mask: np.ndarray) -> list[np.int64] | None:
    found = centroid_rounded_as_array(mask)
    return None if found is None else [np.int64(found[0]), np.int64(found[1])]


VARIANTS = [centroid_by_components, centroid_rounded_as_array, centroid_as_list]
