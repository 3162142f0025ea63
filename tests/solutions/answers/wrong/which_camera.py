"""Wrong answers to which_camera, as strangers wrote them."""
import cv2
import numpy as np


def _right(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = height / 2 / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    k = int(np.argmin(errors))
    return k, float(errors[k])


def w_corner_center(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        u = f * points[:, 0] / points[:, 2] + width / 2
        v = f * points[:, 1] / points[:, 2] + height / 2
        errors.append(np.hypot(u - pixels[:, 0], v - pixels[:, 1]).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_width_for_focal(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (width / 2) / np.tan(fov / 2)
        u = f * points[:, 0] / points[:, 2] + (width - 1) / 2
        v = f * points[:, 1] / points[:, 2] + (height - 1) / 2
        errors.append(np.hypot(u - pixels[:, 0], v - pixels[:, 1]).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_pixels_as_row_column(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        u = f * points[:, 0] / points[:, 2] + (width - 1) / 2
        v = f * points[:, 1] / points[:, 2] + (height - 1) / 2
        errors.append(np.linalg.norm(np.stack([v, u], axis=1) - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_y_up(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        u = (width - 1) / 2 + f * points[:, 0] / points[:, 2]
        v = (height - 1) / 2 - f * points[:, 1] / points[:, 2]
        errors.append(np.hypot(u - pixels[:, 0], v - pixels[:, 1]).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_median(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.median(np.linalg.norm(uv - pixels, axis=1)))
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_rms(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.sqrt(np.mean(np.sum((uv - pixels) ** 2, axis=1))))
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_sum(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).sum())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_norm_without_axis(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels) / len(points))
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_mean_of_coordinates(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.abs(uv - pixels).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_only_columns(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        u = f * points[:, 0] / points[:, 2] + (width - 1) / 2
        errors.append(np.abs(u - pixels[:, 0]).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_signed_mean(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm((uv - pixels).mean(axis=0)))
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_degrees(points, pixels, fovs, width, height):
    errors = []
    for fov in np.deg2rad(fovs):
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_counts_from_one(points, pixels, fovs, width, height):
    best, best_error = None, np.inf
    for i, fov in enumerate(fovs, 1):
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        error = np.linalg.norm(uv - pixels, axis=1).mean()
        if error < best_error:
            best, best_error = i, error
    return best, float(best_error)


def w_error_of_last(points, pixels, fovs, width, height):
    best, best_error = 0, np.inf
    for i, fov in enumerate(fovs):
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        error = np.linalg.norm(uv - pixels, axis=1).mean()
        if error < best_error:
            best, best_error = i, error
    return best, float(error)


def w_best_not_updated(points, pixels, fovs, width, height):
    best, best_error = 0, 1e9
    for i, fov in enumerate(fovs):
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        error = float(np.linalg.norm(uv - pixels, axis=1).mean())
        if error < best_error:
            best = i
    return best, error


def w_first_good_enough(points, pixels, fovs, width, height):
    for i, fov in enumerate(fovs):
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        error = float(np.linalg.norm(uv - pixels, axis=1).mean())
        if error < 5.0:
            return i, error


def w_answers_fov(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return float(fovs[best]), float(errors[best])


def w_swapped_return(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    return float(min(errors)), int(np.argmin(errors))


def w_sorts_fovs(points, pixels, fovs, width, height):
    fovs = np.sort(fovs)
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_hard_coded_size(points, pixels, fovs, width=640, height=480):
    K = np.eye(3)
    errors = []
    for fov in fovs:
        K[0, 0] = K[1, 1] = 240 / np.tan(fov / 2)
        K[:2, 2] = 319.5, 239.5
        uv = cv2.projectPoints(points, np.zeros(3), np.zeros(3), K, None)[0][:, 0]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_whole_pixels(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv.astype(int) - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_last_camera_missing(points, pixels, fovs, width, height):
    errors = []
    for i in range(len(fovs) - 1):
        f = (height / 2) / np.tan(fovs[i] / 2)
        uv = f * points[:, :2] / points[:, 2:] + [(width - 1) / 2, (height - 1) / 2]
        errors.append(np.linalg.norm(uv - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_ray_length(points, pixels, fovs, width, height):
    errors = []
    distance = np.linalg.norm(points, axis=1)
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        u = f * points[:, 0] / distance + (width - 1) / 2
        v = f * points[:, 1] / distance + (height - 1) / 2
        errors.append(np.hypot(u - pixels[:, 0], v - pixels[:, 1]).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


def w_moves_pixels(points, pixels, fovs, width, height):
    pixels -= [(width - 1) / 2, (height - 1) / 2]
    errors = []
    for fov in fovs:
        f = (height / 2) / np.tan(fov / 2)
        errors.append(np.linalg.norm(f * points[:, :2] / points[:, 2:] - pixels, axis=1).mean())
    best = int(np.argmin(errors))
    return best, float(errors[best])


WRONG = [
    (w_corner_center, "middle of the picture at W/2, H/2: half a pixel of error; every input"),
    (w_width_for_focal, "focal length from the width; pictures that are not square"),
    (w_pixels_as_row_column, "compares (v, u) with pixels (u, v); every input"),
    (w_y_up, "y taken as up; points off the middle row"),
    (w_median, "median instead of mean distance; noise that is not the same for all points"),
    (w_rms, "root mean square instead of mean distance; noise that is not the same for all points"),
    (w_sum, "sum of the distances; more than one point"),
    (w_norm_without_axis, "norm of the whole array divided by N; more than one point"),
    (w_mean_of_coordinates, "mean of |du| and |dv| instead of mean distance; every noisy input"),
    (w_only_columns, "only u is compared; points in the middle column, and error_px always"),
    (w_signed_mean, "norm of the mean offset: errors cancel; points spread evenly around the middle"),
    (w_degrees, "takes the fovs as degrees; every input"),
    (w_counts_from_one, "counts the cameras from 1; every input"),
    (w_error_of_last, "error of the last camera instead of the best; the best one is not the last"),
    (w_best_not_updated, "best error is never updated, the last camera always wins; the best one is not the last"),
    (w_first_good_enough, "takes the first camera below 5 px, None where there is none; two similar fields of view, or noise above 5 px"),
    (w_answers_fov, "answers the field of view instead of the number; every input"),
    (w_swapped_return, "return order swapped; every input"),
    (w_sorts_fovs, "number in the sorted list, not in the one given; unsorted fovs"),
    (w_hard_coded_size, "640 x 480 written into the code; other sizes"),
    (w_whole_pixels, "projected pixels cut to whole numbers; every input"),
    (w_last_camera_missing, "loop ends one camera early; the last camera took the picture"),
    (w_ray_length, "divides by the length of the ray instead of z; points off the axis"),
    (w_moves_pixels, "changes the caller's pixels in place; seen in pixels after the call (side effect only)"),
]


def _cases():
    def make(fovs, k, w, h, noise, n=12, seed=0, middle=False):
        def case():
            r = np.random.default_rng(seed)
            p = r.uniform([-0.5, -0.4, 1], [0.5, 0.4, 3], (n, 3))
            if middle:
                p = np.concatenate([p, p * [-1, -1, 1]])
            f = h / 2 / np.tan(fovs[k] / 2)
            uv = f * p[:, :2] / p[:, 2:] + [(w - 1) / 2, (h - 1) / 2]
            return p, uv + r.normal(0, noise, uv.shape), np.array(fovs), w, h
        return case
    return [make([0.6, 0.9, 1.2], 1, 640, 480, 0.4), make([1.1, 0.5, 0.8], 0, 320, 200, 0.6, seed=1),
            make([1.0, 0.98, 0.7], 1, 640, 480, 0.3, seed=2), make([0.7, 0.8, 1.0], 2, 400, 400, 0.5, seed=3, middle=True),
            make([0.5, 1.0, 0.7], 2, 640, 480, 9.0, seed=4)]
