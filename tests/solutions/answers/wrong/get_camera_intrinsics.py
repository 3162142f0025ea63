"""Wrong answers to get_camera_intrinsics, as strangers wrote them."""
import mujoco
import numpy as np


def _right(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError("no camera")
    if model.cam_projection[i] != mujoco.mjtProjection.mjPROJ_PERSPECTIVE:
        raise ValueError("orthographic")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0 and sy > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]]), float(fov_y)


def _find(model, camera_name):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError(f"no camera {camera_name}")
    if model.cam_projection[i] == mujoco.mjtProjection.mjPROJ_ORTHOGRAPHIC:
        raise ValueError(f"{camera_name} is orthographic")
    return i


def w_always_fovy(model, camera_name, width, height):
    i = _find(model, camera_name)
    fov_y = np.deg2rad(model.cam_fovy[i])
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]]), float(fov_y)


def w_key_error(model, camera_name, width, height):
    cam = model.camera(camera_name)
    i = cam.id
    if model.cam_projection[i] == mujoco.mjtProjection.mjPROJ_ORTHOGRAPHIC:
        raise ValueError("orthographic")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx * width / sx, ly * height / sy
        cx, cy = cx - px * width / sx, cy - py * height / sy
        fov_y = 2 * np.arctan(sy / 2 / ly)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = (height / 2) / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_minus_one_is_last(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if model.cam_projection[i] == mujoco.mjtProjection.mjPROJ_ORTHOGRAPHIC:
        raise ValueError("orthographic")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    if model.cam_sensorsize[i].any():
        sx, sy = model.cam_sensorsize[i]
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_orthographic_accepted(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i == -1:
        raise ValueError(f"camera {camera_name} not found")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_old_attribute(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i == -1:
        raise ValueError(f"camera {camera_name} not found")
    if model.cam_orthographic[i]:
        raise ValueError("orthographic camera")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_zero_is_missing(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if not i or i < 0:
        raise ValueError(f"camera {camera_name} not found")
    if model.cam_projection[i]:
        raise ValueError("orthographic")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_plus_principal(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx + px / sx * width, cy + py / sy * height
        fov_y = 2 * np.arctan(sy / (2 * ly))
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_principal_from_corner(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = px / sx * width, py / sy * height
        fov_y = 2 * np.arctan(sy / (2 * ly))
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_principal_forgotten(model, camera_name, width, height):
    i = _find(model, camera_name)
    if model.cam_sensorsize[i].all():
        fx, fy = model.cam_intrinsic[i, :2] / model.cam_sensorsize[i] * [width, height]
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    K = np.array([[fx, 0, (width - 1) / 2], [0, fy, (height - 1) / 2], [0, 0, 1]])
    return K, float(fov_y)


def w_own_resolution(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        w, h = model.cam_resolution[i]
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * w, ly / sy * h
        cx, cy = cx - px / sx * w, cy - py / sy * h
        fov_y = 2 * np.arctan(sy / 2 / ly)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_fov_in_degrees(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    fov_y = float(model.cam_fovy[i])
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
    else:
        fx = fy = height / 2 / np.tan(np.deg2rad(fov_y) / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), fov_y


def w_tangent_of_degrees(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fx = fy = height / 2 / np.tan(model.cam_fovy[i] / 2)
        fov_y = np.deg2rad(model.cam_fovy[i])
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_corner_center_for_sensor(model, camera_name, width, height):
    i = _find(model, camera_name)
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = width * (0.5 - px / sx), height * (0.5 - py / sy)
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        cx, cy = (width - 1) / 2, (height - 1) / 2
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_square_pixels_for_sensor(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        f = ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / f)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        f = height / 2 / np.tan(fov_y / 2)
    return np.array([[f, 0, cx], [0, f, cy], [0, 0, 1]]), float(fov_y)


def w_y_copied_from_x(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sx * height
        cx, cy = cx - px / sx * width, cy - py / sx * height
        fov_y = 2 * np.arctan(sy / 2 / ly)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_head_camera(model, camera_name, width, height):
    _find(model, camera_name)
    fov_y = np.deg2rad(model.camera("head_camera").fovy[0])
    f = height / 2 / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]]), float(fov_y)


def w_swapped_return(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return float(fov_y), np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def w_free_camera_fovy(model, camera_name, width, height):
    i = _find(model, camera_name)
    fov_y = np.deg2rad(model.vis.global_.fovy)
    f = height / 2 / np.tan(fov_y / 2)
    if model.cam_sensorsize[i].any():
        fx, fy, cx, cy = model.cam_intrinsic[i]
        sx, sy = model.cam_sensorsize[i]
        fy = fy / sy * height
        K = np.array([[fx / sx * width, 0, (width - 1) / 2 - cx / sx * width],
                      [0, fy, (height - 1) / 2 - cy / sy * height], [0, 0, 1]])
        return K, float(2 * np.arctan(height / 2 / fy))
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]]), float(fov_y)


def w_fixed_size(model, camera_name, width=640, height=480):
    i = _find(model, camera_name)
    W, H = 640, 480
    cx, cy = (W - 1) / 2, (H - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * W, ly / sy * H
        cx, cy = cx - px / sx * W, cy - py / sy * H
        fov_y = 2 * np.arctan(H / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = H / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_principal_scaled_by_focal(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px * 1000, cy - py * 1000  # meters to millimeters
        fov_y = 2 * np.arctan(sy / 2 / ly)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)


def w_cached_by_name(model, camera_name, width, height, _cache={}):
    if camera_name in _cache:
        return _cache[camera_name]
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov_y = 2 * np.arctan(height / 2 / fy)
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov_y / 2)
    _cache[camera_name] = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), float(fov_y)
    return _cache[camera_name]


def w_only_K(model, camera_name, width, height):
    i = _find(model, camera_name)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0:
        lx, ly, px, py = model.cam_intrinsic[i]
        fx, fy = lx / sx * width, ly / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
    else:
        fx = fy = height / 2 / np.tan(np.deg2rad(model.cam_fovy[i]) / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


WRONG = [
    (w_always_fovy, "ignores the sensor: K from fovy; a camera with sensorsize"),
    (w_key_error, "KeyError instead of ValueError; unknown name"),
    (w_minus_one_is_last, "id -1 indexes the last camera: no error; unknown name"),
    (w_orthographic_accepted, "no error for an orthographic camera; orthographic camera"),
    (w_old_attribute, "model.cam_orthographic of another MuJoCo version does not exist here; every camera that exists"),
    (w_zero_is_missing, "takes id 0 for missing; the first camera"),
    (w_plus_principal, "sign of the principal offset; a sensor camera with an offset"),
    (w_principal_from_corner, "principal taken as distance from the corner, not from the middle; every sensor camera"),
    (w_principal_forgotten, "principal offset is left out; a sensor camera with an offset"),
    (w_own_resolution, "scales with the camera's resolution instead of the picture's size; a sensor camera at another size than its resolution"),
    (w_fov_in_degrees, "fov_y in degrees; every camera"),
    (w_tangent_of_degrees, "tangent of degrees; cameras with fovy"),
    (w_corner_center_for_sensor, "W/2 instead of (W-1)/2 in the sensor branch; sensor cameras"),
    (w_square_pixels_for_sensor, "fx = fy for sensor cameras; sensor and picture of different aspect"),
    (w_y_copied_from_x, "copy-paste slip: sensor width used for y; sensors that are not square"),
    (w_head_camera, "always the head camera; other cameras, or models without a head_camera"),
    (w_swapped_return, "return order swapped; every camera"),
    (w_free_camera_fovy, "field of view of the free camera instead of the camera's own; fovy other than visual/global"),
    (w_fixed_size, "640 x 480 written into the code; other sizes"),
    (w_principal_scaled_by_focal, "principal offset in millimeters instead of pixels; a sensor camera with an offset"),
    (w_cached_by_name, "remembers K per name; the same name at another size or in another model"),
    (w_only_K, "fov_y is not returned; every camera"),
]

_XML = """<mujoco><visual><global fovy='45'/></visual><worldbody><geom size='.1'/>
<camera name='head_camera' fovy='55'/><camera name='overview' fovy='70'/>
<camera name='sensor' sensorsize='0.006 0.004' resolution='600 400' focal='0.005 0.0045' principal='0.0005 -0.0003'/>
<camera name='ortho' projection='orthographic' fovy='2'/>
<camera name='last' fovy='30'/></worldbody></mujoco>"""


def _cases():
    m = mujoco.MjModel.from_xml_string(_XML)
    L = [("head_camera", 640, 480), ("head_camera", 320, 200), ("overview", 640, 480), ("sensor", 640, 480),
         ("sensor", 200, 200), ("nope", 640, 480), ("ortho", 640, 480), ("last", 41, 31)]
    return [lambda t=t: (m, *t) for t in L]
