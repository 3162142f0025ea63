"""Right answers to rank_cameras, as strangers wrote them."""
import copy
import heapq
import math

import mujoco
import numpy as np


def forward_and_argsort(model, data, point_world):
    """mj_forward, norms, stable argsort."""
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances, kind="stable")
    return ids, distances[ids]


def only_positions(model, data, point_world):
    """Updates only what cameras need (kinematics, centers of mass, cameras); sorts tuples in Python."""
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    pairs = []
    for i in range(model.ncam):
        d = math.sqrt(sum((float(data.cam_xpos[i, k]) - float(point_world[k])) ** 2 for k in range(3)))
        pairs.append((d, i))
    pairs.sort()
    return np.array([i for _, i in pairs], dtype=int), np.array([d for d, _ in pairs], dtype=np.float64)


def on_a_copy(model, data, point_world):
    """Leaves the caller's data alone: updates a copy; of equal distances the higher number comes first."""
    scratch = copy.copy(data)
    mujoco.mj_forward(model, scratch)
    square = ((scratch.cam_xpos - np.asarray(point_world)) ** 2).sum(axis=1)
    ids = np.lexsort((-np.arange(model.ncam), square))
    return ids, np.sqrt(square[ids])


def fresh_data(model, data, point_world):
    """New MjData with the joint angles and mocap poses copied over; camera by camera through data.cam(i)."""
    other = mujoco.MjData(model)
    other.qpos[:] = data.qpos
    if model.nmocap:
        other.mocap_pos[:] = data.mocap_pos
        other.mocap_quat[:] = data.mocap_quat
    mujoco.mj_fwdPosition(model, other)
    distance = {i: math.dist(other.cam(i).xpos, point_world) for i in range(model.ncam)}
    ids = sorted(distance, key=distance.get)
    return np.array(ids, dtype=np.int64), np.array([distance[i] for i in ids], dtype=np.float64)


def selection_sort(model, data, point_world):
    """mj_fwdPosition and a selection sort by hand; ids as int32."""
    mujoco.mj_fwdPosition(model, data)
    left = {i: np.hypot(np.hypot(*(data.cam_xpos[i, :2] - point_world[:2])), data.cam_xpos[i, 2] - point_world[2])
            for i in range(model.ncam)}
    ids = np.zeros(model.ncam, dtype=np.int32)
    distances = np.zeros(model.ncam)
    for place in range(model.ncam):
        nearest = min(left, key=lambda i: left[i])
        ids[place], distances[place] = nearest, left.pop(nearest)
    return ids, distances


class _Ranking:
    def __init__(self, model, data):
        mujoco.mj_forwardSkip(model, data, mujoco.mjtStage.mjSTAGE_NONE, 1)
        self.places = [tuple(float(k) for k in data.cam_xpos[i]) for i in range(model.ncam)]

    def from_point(self, point):
        heap = [(math.dist(place, [float(k) for k in point]), number) for number, place in enumerate(self.places)]
        heapq.heapify(heap)
        while heap:
            yield heapq.heappop(heap)


def with_a_heap(model, data, point_world):
    """A class, mj_forwardSkip without sensors, a heap popped by a generator."""
    order = list(_Ranking(model, data).from_point(point_world))
    return np.array([n for _, n in order], dtype=np.intp), np.array([d for d, _ in order], dtype=np.float64)


def structured_sort(model, data, point_world):
    """Structured array sorted by field; mj_copyData into scratch data."""
    scratch = mujoco.MjData(model)
    mujoco.mj_copyData(scratch, model, data)
    mujoco.mj_kinematics(model, scratch)
    mujoco.mj_comPos(model, scratch)
    mujoco.mj_camlight(model, scratch)
    table = np.zeros(model.ncam, dtype=[("distance", "f8"), ("id", "i8")])
    table["id"] = np.arange(model.ncam)
    offset = scratch.cam_xpos - np.reshape(point_world, (1, 3))
    table["distance"] = np.sqrt(np.einsum("ij,ij->i", offset, offset))
    table.sort(order="distance")
    return table["id"].copy(), table["distance"].copy()


ANSWERS = [forward_and_argsort, only_positions, on_a_copy, fresh_data, selection_sort, with_a_heap, structured_sort]
