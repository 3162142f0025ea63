"""Wrong answers to camera_to_world, as strangers wrote them."""
import numpy as np

_FLIP = np.diag([1.0, -1.0, -1.0])


def _check(points, cam_xpos, cam_xmat):
    p = np.asarray(points)
    t, R = np.asarray(cam_xpos), np.asarray(cam_xmat)
    for a in (p, t, R):
        if a.dtype.kind not in "fiu":
            raise TypeError("real numbers")
    if p.ndim != 2 or p.shape[1] != 3:
        raise ValueError("points must be (N, 3)")
    if t.shape != (3,):
        raise ValueError("cam_xpos must be 3 numbers")
    if R.shape not in ((9,), (3, 3)):
        raise ValueError("cam_xmat must be 9 numbers")
    R = R.astype(float).reshape(3, 3)
    if not np.allclose(R @ R.T, np.eye(3), atol=1e-6) or np.linalg.det(R) < 0:
        raise ValueError("cam_xmat is no rotation")
    return p.astype(float), t.astype(float), R


def _right(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP).T + t


def w_no_flip(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ R.T + t


def w_flip_on_the_left(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (_FLIP @ R).T + t


def w_flip_only_z(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ np.diag([1, 1, -1])).T + t


def w_flip_only_y(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ np.diag([1, -1, 1])).T + t


def w_not_transposed(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP) + t


def w_matrix_times_rows(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return (R @ _FLIP) @ p + t


def w_minus_position(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP).T - t


def w_shift_before_turn(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return (p + t) @ (R @ _FLIP).T


def w_other_way(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return (p - t) @ R @ _FLIP


def w_fortran_order(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    R = np.asarray(cam_xmat, float).reshape((3, 3), order="F")
    return p @ (R @ _FLIP).T + t


def w_flat_only(points, cam_xpos, cam_xmat):
    cam_xmat = np.asarray(cam_xmat)
    if cam_xmat.shape != (9,):
        raise ValueError("cam_xmat must be 9 numbers")
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP).T + t


def w_square_only(points, cam_xpos, cam_xmat):
    p = np.asarray(points, float)
    R = np.asarray(cam_xmat, float)
    if p.ndim != 2 or p.shape[1] != 3 or R.shape != (3, 3) or np.shape(cam_xpos) != (3,):
        raise ValueError("shapes")
    if not np.allclose(R @ R.T, np.eye(3)) or np.linalg.det(R) < 0:
        raise ValueError("no rotation")
    return p @ (R @ _FLIP).T + np.asarray(cam_xpos, float)


def w_float32(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return (p @ (R @ _FLIP).T + t).astype(np.float32)


def w_dtype_of_points(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return (p @ (R @ _FLIP).T + t).astype(np.asarray(points).dtype)


def w_rotation_not_checked(points, cam_xpos, cam_xmat):
    p = np.asarray(points, dtype=float)
    t = np.asarray(cam_xpos, dtype=float)
    R = np.asarray(cam_xmat, dtype=float).reshape(3, 3)
    if p.ndim != 2 or p.shape[1] != 3 or t.shape != (3,):
        raise ValueError("shapes")
    return p @ (R @ _FLIP).T + t


def w_reflection_accepted(points, cam_xpos, cam_xmat):
    p = np.asarray(points, dtype=float)
    t = np.asarray(cam_xpos, dtype=float)
    R = np.asarray(cam_xmat, dtype=float).reshape(3, 3)
    if p.ndim != 2 or p.shape[1] != 3 or t.shape != (3,):
        raise ValueError("shapes")
    if not np.allclose(R @ R.T, np.eye(3), atol=1e-6):
        raise ValueError("cam_xmat is no rotation")
    return p @ (R @ _FLIP).T + t


def w_only_determinant_checked(points, cam_xpos, cam_xmat):
    p = np.asarray(points, dtype=float)
    t = np.asarray(cam_xpos, dtype=float)
    R = np.asarray(cam_xmat, dtype=float).reshape(3, 3)
    if p.ndim != 2 or p.shape[1] != 3 or t.shape != (3,):
        raise ValueError("shapes")
    if not np.isclose(np.linalg.det(R), 1):
        raise ValueError("cam_xmat is no rotation")
    return p @ (R @ _FLIP).T + t


def w_flips_input(points, cam_xpos, cam_xmat):
    _, t, R = _check(points, cam_xpos, cam_xmat)
    p = np.asarray(points)
    p[:, 1:] *= -1
    return p @ R.T + t


def w_flips_matrix_of_data(points, cam_xpos, cam_xmat):
    p, t, _ = _check(points, cam_xpos, cam_xmat)
    R = np.asarray(cam_xmat).reshape(3, 3)
    if R.dtype.kind == "f":
        R[:, 1] *= -1
        R[:, 2] *= -1
        return p @ R.T + t
    return p @ (R @ _FLIP).T + t


def w_four_columns(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    T = np.eye(4)
    T[:3, :3] = R @ _FLIP
    T[:3, 3] = t
    return np.hstack([p, np.ones((len(p), 1))]) @ T.T


def w_squeezed(points, cam_xpos, cam_xmat):
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return ((R @ _FLIP) @ p.T).T.squeeze() + t


def w_cuts_columns(points, cam_xpos, cam_xmat):
    p = np.asarray(points, dtype=float)[:, :3]
    _, t, R = _check(p, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP).T + t


def w_single_point_accepted(points, cam_xpos, cam_xmat):
    p = np.atleast_2d(np.asarray(points, dtype=float))
    p, t, R = _check(p, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP).T + t


def w_loop_of_list(points, cam_xpos, cam_xmat):
    _, t, R = _check(points, cam_xpos, cam_xmat)
    return np.array([R @ _FLIP @ np.asarray(p, float) + t for p in points])


def w_assert(points, cam_xpos, cam_xmat):
    p, t = np.asarray(points, float), np.asarray(cam_xpos, float)
    assert p.ndim == 2 and p.shape[1] == 3, "points must be (N, 3)"
    R = np.asarray(cam_xmat, float).reshape(3, 3)
    assert t.shape == (3,)
    assert np.allclose(R @ R.T, np.eye(3), atol=1e-6) and np.linalg.det(R) > 0, "no rotation"
    return p @ (R @ _FLIP).T + t


def w_list_without_array(points, cam_xpos, cam_xmat):
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("points must be (N, 3)")
    p, t, R = _check(points, cam_xpos, cam_xmat)
    return p @ (R @ _FLIP).T + t


WRONG = [
    (w_no_flip, "change of axes forgotten; every point off the x axis"),
    (w_flip_on_the_left, "diagonal matrix on the wrong side; every turned camera"),
    (w_flip_only_z, "turns z around but not y; points off the middle row"),
    (w_flip_only_y, "turns y around but not z; every point"),
    (w_not_transposed, "rows times R without the transpose; every R that is not symmetric"),
    (w_matrix_times_rows, "R @ points with (N, 3): ValueError, or columns mixed for N = 3; every input"),
    (w_minus_position, "subtracts the position; cameras off the origin"),
    (w_shift_before_turn, "adds the position before the turn; cameras off the origin"),
    (w_other_way, "world to camera; every input"),
    (w_fortran_order, "matrix read column by column; every R that is not symmetric"),
    (w_flat_only, "refuses shape (3, 3); cam_xmat as (3, 3)"),
    (w_square_only, "refuses 9 numbers; cam_xmat as (9,)"),
    (w_float32, "float32 answer; every input"),
    (w_dtype_of_points, "casts back to the points' dtype; float32 or integer points"),
    (w_rotation_not_checked, "no error for a matrix that is no rotation; zeros, 2 * identity"),
    (w_reflection_accepted, "orthogonal is not enough: a reflection passes; diag(1, 1, -1)"),
    (w_only_determinant_checked, "determinant 1 is not enough: a shear passes; diag(2, 0.5, 1)"),
    (w_flips_input, "turns y and z around in the caller's array; every array of points"),
    (w_flips_matrix_of_data, "turns columns of the caller's cam_xmat around; every float array"),
    (w_four_columns, "homogeneous answer (N, 4); every input"),
    (w_squeezed, "squeeze makes (3,) of one point; N = 1"),
    (w_cuts_columns, "takes the first three columns instead of refusing; (N, 4) points"),
    (w_single_point_accepted, "a single point of shape (3,) passes; shape (3,)"),
    (w_loop_of_list, "np.array of an empty list has shape (0,); N = 0"),
    (w_assert, "AssertionError instead of ValueError; bad shapes, no rotation"),
    (w_list_without_array, "uses .ndim of the argument: AttributeError; points as a list"),
]


def _cases():
    r = np.random.default_rng(0)
    q, _ = np.linalg.qr(r.normal(size=(3, 3)))
    q *= np.linalg.det(q)
    P = r.normal(size=(5, 3))
    t = np.array([0.3, -1.0, 1.4])
    L = [(P, t, q.ravel()), (P, t, q), (P.astype(np.float32), t, q), (P[:3], t, q.ravel()), (P[:1], t, q), (P[:0], t, q),
         (np.array([[1, 2, 3], [4, 5, 6]]), t, q.ravel()), (P, t, np.eye(3)),
         (P, t, np.zeros(9)), (P, t, 2 * np.eye(3)), (P, t, np.diag([1.0, 1, -1])), (P, t, np.diag([2.0, 0.5, 1])), (P[0], t, q),
         (np.hstack([P, P[:, :1]]), t, q), (P, t[:2], q), (P, t, q.ravel()[:8])]
    return [lambda a=a: tuple(x.copy() for x in a) for a in L] + [lambda: (P.tolist(), t.tolist(), q.ravel().tolist())]
