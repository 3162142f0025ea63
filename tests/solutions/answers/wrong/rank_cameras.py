"""Wrong answers to rank_cameras, as strangers wrote them."""
import mujoco
import numpy as np


def _right(model, data, point_world):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    d = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(d, kind="stable")
    return ids, d[ids]


def w_stale(model, data, point_world):
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_kinematics_only(model, data, point_world):
    mujoco.mj_kinematics(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_local_positions(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(model.cam_pos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_start_pose(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(model.cam_pos0 - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_body_positions(model, data, point_world):
    mujoco.mj_forward(model, data)
    places = data.xpos[model.cam_bodyid]
    distances = np.linalg.norm(places - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_swapped_return(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return distances[ids], ids


def w_farthest_first(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(-distances)
    return ids, distances[ids]


def w_distances_by_number(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    return np.argsort(distances), distances


def w_ranks_not_numbers(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ranks = np.argsort(np.argsort(distances))
    return ranks, np.sort(distances)


def w_ground_distance(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos[:, :2] - point_world[:2], axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_squared(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = ((data.cam_xpos - point_world) ** 2).sum(axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_axis_forgotten(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.array([np.linalg.norm(data.cam_xpos - point_world)] * model.ncam)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_along_axis(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.zeros(model.ncam)
    for i in range(model.ncam):
        forward = -data.cam_xmat[i].reshape(3, 3)[:, 2]
        distances[i] = forward @ (point_world - data.cam_xpos[i])
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_names(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    order = np.argsort(distances)
    return [model.camera(i).name for i in order], distances[order]


def w_dict_by_distance(model, data, point_world):
    mujoco.mj_forward(model, data)
    found = {}
    for i in range(model.ncam):
        found[float(np.linalg.norm(data.cam_xpos[i] - point_world))] = i
    keys = sorted(found)
    return np.array([found[k] for k in keys]), np.array(keys)


def w_dict_by_name(model, data, point_world):
    mujoco.mj_forward(model, data)
    found = {}
    for i in range(model.ncam):
        found[model.camera(i).name] = np.linalg.norm(data.cam_xpos[i] - point_world)
    names = sorted(found, key=found.get)
    ids = np.array([model.camera(n).id for n in names])
    return ids, np.array([found[n] for n in names])


def w_last_camera_missing(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.array([np.linalg.norm(data.cam_xpos[i] - point_world)
                          for i in range(model.ncam - 1)])
    ids = distances.argsort()
    return ids, distances[ids]


def w_counts_from_one(model, data, point_world):
    mujoco.mj_forward(model, data)
    pairs = [(np.linalg.norm(pos - point_world), i)
             for i, pos in enumerate(data.cam_xpos, start=1)]
    pairs.sort()
    return np.array([i for _, i in pairs]), np.array([d for d, _ in pairs])


def w_steps(model, data, point_world):
    mujoco.mj_step(model, data)
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_step_one_behind(model, data, point_world):
    before = data.time
    mujoco.mj_step(model, data)
    data.time = before
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_fresh_data(model, data, point_world):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_rounded(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.round(np.linalg.norm(data.cam_xpos - point_world, axis=1), 2)
    ids = np.argsort(distances, kind="stable")
    return ids, distances[ids]


def w_millimeters(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = 1000 * np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_moves_cameras(model, data, point_world):
    mujoco.mj_forward(model, data)
    offsets = data.cam_xpos
    offsets -= point_world
    distances = np.sqrt((offsets ** 2).sum(axis=1))
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_no_com_pos(model, data, point_world):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


def w_nearest_only(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    best = int(np.argmin(distances))
    return best, float(distances[best])


WRONG = [
    (w_stale, "positions are not brought up to date; a joint moved since the last mj_forward"),
    (w_kinematics_only, "mj_kinematics moves bodies but not cameras; a moved joint under a camera"),
    (w_local_positions, "model.cam_pos is in the frame of the body, not the world; a camera on a body that is not at the origin"),
    (w_start_pose, "model.cam_pos0 is the global offset from the body's start, not the place now; moved or displaced bodies"),
    (w_body_positions, "place of the camera's body instead of the camera; a camera off its body's origin"),
    (w_swapped_return, "return order swapped; every input"),
    (w_farthest_first, "sorted the wrong way; two cameras or more"),
    (w_distances_by_number, "distances are not sorted along; cameras not in order of distance already"),
    (w_ranks_not_numbers, "answers the rank of each camera, not the sorted numbers; orders whose permutation is not its own inverse (3 cameras or more)"),
    (w_ground_distance, "leaves out the height; cameras at other heights than the point"),
    (w_squared, "squared distances; every distance but 0 and 1"),
    (w_axis_forgotten, "norm without axis: one number for all cameras; two cameras or more"),
    (w_along_axis, "depth along the optical axis instead of distance; points off the axis or behind"),
    (w_names, "names instead of numbers; every input"),
    (w_dict_by_distance, "dictionary keyed by distance loses a camera; two cameras equally far (same place)"),
    (w_dict_by_name, "looks cameras up by name: KeyError; a camera without a name"),
    (w_last_camera_missing, "loop ends one camera early; every input"),
    (w_counts_from_one, "numbers counted from 1; every input"),
    (w_steps, "mj_step lets time pass, so the joints move on; joints that move"),
    (w_step_one_behind, "mj_step brings positions up to date but also moves the state on; data with moving joints is changed (side effect only)"),
    (w_fresh_data, "computes with fresh data, ignores the state given; any moved joint"),
    (w_rounded, "distances rounded to centimeters; every input"),
    (w_millimeters, "millimeters; every input"),
    (w_moves_cameras, "subtracts the point in place: cam_xpos of the caller is destroyed; seen in data.cam_xpos after the call (side effect only)"),
    (w_no_com_pos, "without mj_comPos cameras that track a center of mass stay behind; trackcom cameras after a joint moved"),
    (w_nearest_only, "answers only the nearest camera; every input"),
]

_XML = """<mujoco><worldbody><geom type='sphere' size='.1'/>
<camera pos='1 2 0.3'/>
<body pos='0 0 1'><joint type='hinge' axis='0 1 0'/><geom type='box' size='.1 .1 .1' pos='.3 0 0' mass='1'/>
<camera name='head' pos='.5 .1 .2' xyaxes='0 -1 0 0 0 1'/>
<camera name='twin' pos='.5 .1 .2' xyaxes='1 0 0 0 1 0'/></body>
<body pos='-1 0 .5'><joint type='slide' axis='1 0 0'/><geom type='sphere' size='.1' mass='1'/>
<body pos='.5 0 0'><joint type='slide' axis='0 0 1'/><geom type='sphere' size='.1' mass='5'/></body>
<camera name='track' mode='trackcom' pos='0 -2 .4'/></body>
<camera pos='-1 .5 2'/>
</worldbody></mujoco>"""


def _cases():
    def make(point, q, xml=_XML):
        def case():
            m = mujoco.MjModel.from_xml_string(xml)
            d = mujoco.MjData(m)
            mujoco.mj_forward(m, d)
            if q is not None:
                d.qpos[:] = q
                d.qvel[:] = 1.5
            return m, d, np.array(point, float)
        return case
    return [make([0.2, 0.3, 0.4], None), make([0.2, 0.3, 0.4], [0.8, 0.4, 0.5]), make([-1, -2, 1], [2.0, -0.7, -0.3]),
            make([1, 0, 0], None, "<mujoco><worldbody><geom size='.1'/><camera name='a' pos='3 0 0'/></worldbody></mujoco>"),
            make([2, 0.5, 1], [-1.0, 0.2, 1])]


def _same(a, b):
    try:
        i, d = a
        return (isinstance(i, np.ndarray) and i.dtype.kind == "i" and i.shape == b[0].shape and d.dtype == np.float64 and d.shape == b[1].shape
                and np.allclose(d, b[1], atol=1e-9, rtol=0) and (np.array_equal(i, b[0]) or
                np.array_equal([b[1][list(b[0]).index(k)] for k in i], b[1]) and len(set(i)) == len(i)))
    except Exception:
        return False


def _post(args, result):
    model, data, _ = args
    fresh = mujoco.MjData(model)
    fresh.qpos[:] = data.qpos
    mujoco.mj_forward(model, fresh)
    if not np.allclose(fresh.cam_xpos, data.cam_xpos):
        return "cam_xpos destroyed"
