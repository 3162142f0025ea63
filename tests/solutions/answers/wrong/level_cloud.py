"""Wrong answers to level_cloud, as strangers wrote them."""
import numpy as np


def _turn(n):
    axis = np.cross(n, [0, 0, 1.0])
    s, c = np.linalg.norm(axis), n[2]
    if s < 1e-12:
        return np.diag([1.0, np.sign(c), np.sign(c)])
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + k + k @ k * (1 - c) / s**2


def _search(points, threshold=0.006, rounds=600, seed=0):
    rng = np.random.default_rng(seed)
    best = None
    for _ in range(rounds):
        a, b, c = points[rng.choice(len(points), 3, replace=False)]
        n = np.cross(b - a, c - a)
        if np.linalg.norm(n) < 1e-9:
            continue
        n /= np.linalg.norm(n)
        near = np.abs((points - a) @ n) < threshold
        if best is None or near.sum() > best.sum():
            best = near
    for _ in range(3 if rounds > 3 else 0):
        n, d = _fit(points[best])
        best = np.abs(points @ n + d) < threshold
    return best


def _fit(p):
    center = p.mean(axis=0)
    n = np.linalg.svd(p - center, full_matrices=False)[2][2]
    return n, -n @ center


def _right(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_fits_everything(points):
    n, d = _fit(points)
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_three_points_only(points):
    rng = np.random.default_rng(0)
    best, plane = 0, None
    for _ in range(300):
        a, b, c = points[rng.choice(len(points), 3, replace=False)]
        n = np.cross(b - a, c - a)
        if np.linalg.norm(n) < 1e-9:
            continue
        n /= np.linalg.norm(n)
        count = (np.abs((points - a) @ n) < 0.01).sum()
        if count > best:
            best, plane = count, (n, -n @ a)
    n, d = plane
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_not_seeded(points):
    rng = np.random.default_rng()
    best, plane = 0, None
    for _ in range(60):
        a, b, c = points[rng.integers(0, len(points), 3)]
        n = np.cross(b - a, c - a)
        if np.linalg.norm(n) < 1e-9:
            continue
        n /= np.linalg.norm(n)
        count = (np.abs((points - a) @ n) < 0.01).sum()
        if count > best:
            best, plane = count, (n, -n @ a)
    n, d = plane
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_sign_not_fixed(points):
    near = _search(points)
    n, d = _fit(points[near])
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_normal_forward(points):
    near = _search(points)
    n, d = _fit(points[near])
    if n[2] < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_normal_up_in_picture(points):
    near = _search(points)
    n, d = _fit(points[near])
    if n[1] > 0:  # y points down in the camera
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_only_normal_flipped(points):
    near = _search(points)
    p = points[near]
    center = p.mean(axis=0)
    n = np.linalg.svd(p - center)[2][2]
    d = -n @ center
    if d < 0:
        n = -n
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_distances_along_z(points):
    p = points[_search(points)]
    A = np.c_[p[:, :2], np.ones(len(p))]
    a, b, c = np.linalg.lstsq(A, p[:, 2], rcond=None)[0]
    n = np.array([a, b, -1.0])
    length = np.linalg.norm(n)
    n, d = n / length, c / length
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_height_not_added(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T


def w_height_subtracted(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T - [0, 0, d]


def w_turned_back(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n) + [0, 0, d]


def w_any_rotation(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    x = np.cross([0, 1.0, 0], n)
    x /= np.linalg.norm(x)
    y = np.cross(n, x)
    R = np.stack([x, y, n])
    return np.array([*n, d]), points @ R.T + [0, 0, d]


def w_basis_from_svd(points):
    p = points[_search(points)]
    center = p.mean(axis=0)
    _, _, vt = np.linalg.svd(p - center, full_matrices=False)
    n = vt[2]
    d = -n @ center
    if d < 0:
        n, d = -n, -d
    R = np.stack([np.cross(vt[1], n), vt[1], n])
    return np.array([*n, d]), points @ R.T + [0, 0, d]


def w_normal_not_unit(points):
    rng = np.random.default_rng(1)
    near = _search(points)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    plane = np.array([*n, d])
    plane = plane / d  # so that the last number is 1
    return plane, points @ _turn(n).T + [0, 0, d]


def w_table_first(points):
    near = _search(points)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    ordered = np.concatenate([points[near], points[~near]])
    return np.array([*n, d]), ordered @ _turn(n).T + [0, 0, d]


def w_table_only(points):
    near = _search(points)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points[near] @ _turn(n).T + [0, 0, d]


def w_threshold_too_wide(points):
    near = _search(points, threshold=0.05)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_threshold_in_millimeters(points):
    near = _search(points, threshold=2.0)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_too_few_rounds(points):
    near = _search(points, rounds=3)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_last_instead_of_best(points):
    rng = np.random.default_rng(0)
    for _ in range(200):
        a, b, c = points[rng.choice(len(points), 3, replace=False)]
        n = np.cross(b - a, c - a)
        n /= np.linalg.norm(n)
        near = np.abs((points - a) @ n) < 0.01
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_largest_eigenvector(points):
    p = points[_search(points)]
    center = p.mean(axis=0)
    _, vectors = np.linalg.eigh(np.cov(p.T))
    n = vectors[:, -1]
    d = -n @ center
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_eigenvectors_in_rows(points):
    p = points[_search(points)]
    center = p.mean(axis=0)
    _, vectors = np.linalg.eigh(np.cov(p.T))
    n = vectors[0]
    d = -n @ center
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_not_centered(points):
    p = points[_search(points)]
    n = np.linalg.svd(p, full_matrices=False)[2][2]
    d = -n @ p.mean(axis=0)
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_float32(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    plane = np.array([*n, d], np.float32)
    return plane, (points @ _turn(n).T + [0, 0, d]).astype(np.float32)


def w_rodrigues_unscaled(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    k = np.cross(n, [0, 0, 1.0])
    K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    R = np.eye(3) + K + K @ K * (1 - n[2])
    return np.array([*n, d]), points @ R.T + [0, 0, d]


def w_axis_not_unit(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    axis = np.cross(n, [0, 0, 1.0])
    angle = np.arccos(n[2])
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    R = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    return np.array([*n, d]), points @ R.T + [0, 0, d]


def w_angle_in_degrees(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    axis = np.cross(n, [0, 0, 1.0])
    axis /= np.linalg.norm(axis)
    angle = np.rad2deg(np.arccos(n[2]))
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    R = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    return np.array([*n, d]), points @ R.T + [0, 0, d]


def w_arcsine_angle(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    axis = np.cross(n, [0, 0, 1.0])
    s = np.linalg.norm(axis)
    axis, angle = axis / s, np.arcsin(s)
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    R = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    return np.array([*n, d]), points @ R.T + [0, 0, d]


def w_around_the_middle(points):
    near = _search(points)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    center = points[near].mean(axis=0)
    return np.array([*n, d]), (points - center) @ _turn(n).T


def w_moves_input(points):
    near = _search(points)
    n, d = _fit(points[near])
    if d < 0:
        n, d = -n, -d
    points[:] = points @ _turn(n).T
    points[:, 2] += d
    return np.array([*n, d]), points


def w_median_height(points):
    n, d = _fit(points[_search(points)])
    d = -np.median(points[np.abs(points @ n + d) < 0.015] @ n)
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_library_not_installed(points):
    from sklearn.linear_model import RANSACRegressor
    model = RANSACRegressor(residual_threshold=0.01, random_state=0)
    model.fit(points[:, :2], points[:, 2])
    a, b = model.estimator_.coef_
    n = np.array([a, b, -1.0])
    length = np.linalg.norm(n)
    n, d = n / length, model.estimator_.intercept_ / length
    if d < 0:
        n, d = -n, -d
    return np.array([*n, d]), points @ _turn(n).T + [0, 0, d]


def w_swapped_return(points):
    n, d = _fit(points[_search(points)])
    if d < 0:
        n, d = -n, -d
    return points @ _turn(n).T + [0, 0, d], np.array([*n, d])


WRONG = [
    (w_fits_everything, "least squares over all points, objects too; any cloud with objects"),
    (w_three_points_only, "plane through three points, no fit afterwards; any noisy table"),
    (w_not_seeded, "no fixed seed and no fit: answers differ from call to call; any noisy table"),
    (w_sign_not_fixed, "sign left as the SVD gives it; clouds where d comes out negative"),
    (w_normal_forward, "normal points along +z, away from the camera; every camera that looks down at the table"),
    (w_normal_up_in_picture, "sign by the picture's y instead of d; a camera that is rolled upside down"),
    (w_only_normal_flipped, "turns the normal but not d; clouds where d comes out negative"),
    (w_distances_along_z, "least squares along z instead of perpendicular; a level camera (the table contains the z direction): off by a centimeter; at usual tilts only some 0.01 mm"),
    (w_height_not_added, "d is not added to z; every cloud"),
    (w_height_subtracted, "d is subtracted; every cloud"),
    (w_turned_back, "rotation transposed; every cloud"),
    (w_any_rotation, "some rotation with the right z axis, not the smallest; tilted cameras with a sideways tilt"),
    (w_basis_from_svd, "axes of the table's points as x and y, not the smallest rotation; every cloud"),
    (w_normal_not_unit, "plane scaled to d = 1; every cloud with d other than 1"),
    (w_table_first, "points of the table first, order changed; every cloud with objects"),
    (w_table_only, "only the points of the table; every cloud with objects"),
    (w_threshold_too_wide, "threshold of 50 mm takes objects in; objects 30 to 50 mm above the table"),
    (w_threshold_in_millimeters, "threshold 2.0 is two meters: every plane fits all; any cloud with objects"),
    (w_too_few_rounds, "three rounds of RANSAC; tables that hold less than most of the points"),
    (w_last_instead_of_best, "keeps the last plane instead of the best; any cloud with objects"),
    (w_largest_eigenvector, "eigenvector of the largest eigenvalue; every cloud"),
    (w_eigenvectors_in_rows, "eigenvectors taken as rows; every cloud"),
    (w_not_centered, "SVD without subtracting the mean; every cloud"),
    (w_float32, "float32; every cloud"),
    (w_rodrigues_unscaled, "Rodrigues formula with an axis of length sin: last term wrong; every tilted cloud"),
    (w_axis_not_unit, "axis not scaled to length 1; every tilted cloud"),
    (w_angle_in_degrees, "sine of degrees; every cloud"),
    (w_arcsine_angle, "angle by arcsine stays below 90 degrees; n with negative z, that is every camera that looks down"),
    (w_around_the_middle, "origin moved to the middle of the table; every cloud"),
    (w_moves_input, "writes the leveled points into the caller's array; every cloud"),
    (w_median_height, "median instead of mean for d: no least squares; noise that is not symmetric (half a millimeter), else some 0.01 mm"),
    (w_library_not_installed, "imports scikit-learn, which is not installed, and fits along z; every cloud"),
    (w_swapped_return, "return order swapped; every cloud"),
]


def _cases():
    def make(seed, tilt, roll, side, height, share=0.5, skew=False):
        def case():
            r = np.random.default_rng(seed)
            nt = int(400 * share)
            # in the table's frame: z up
            t = np.c_[r.uniform(-0.5, 0.5, (nt, 2)), 0.0019 * r.uniform(-1, 1, nt) ** 3]
            t[:, 2] += 0.0 if seed % 2 else 0.0004 * (r.random(nt) < 0.1)
            if skew:
                t[:, 2] = 0.0018 * (r.random(nt) < 0.3)
            k = 400 - nt
            o = np.c_[r.uniform(0.0, 0.4, (k, 2)), r.choice([0.034, 0.04, 0.2], k)]
            far = r.random(k) < 0.35
            o[far] = np.c_[np.full(far.sum(), 0.7), r.uniform(-0.6, 0.6, far.sum()), r.uniform(0.05, 0.6, far.sum())]
            p = np.concatenate([t, o])
            p = p[r.permutation(len(p))]
            # camera: z forward, y down; tilt 90 degrees looks straight down
            a = np.deg2rad(tilt)
            fwd = np.array([np.cos(a), 0, -np.sin(a)])
            right = np.array([0, -1.0, 0])
            down = np.cross(fwd, right)
            R = np.stack([right, down, fwd])
            c, s = np.cos(np.deg2rad(roll)), np.sin(np.deg2rad(roll))
            R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ R
            return ((p - [-0.6, side, height]) @ R.T,)
        return case
    return [make(0, 40, 0, 0.0, 0.5), make(1, 55, 15, 0.1, 0.7), make(2, 30, 170, 0.0, 0.6, 0.45), make(3, 0, 5, 0.1, 0.5),
            make(4, 70, -30, -0.2, 0.9, 0.42), make(5, 8, 3, 0, 0.3, 0.42), make(6, 45, 0, 0, 0.6, skew=True)]
