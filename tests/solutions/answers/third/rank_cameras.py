"""Right answers to rank_cameras, as strangers wrote them."""
import copy
import math

import mujoco
import numpy as np


# 1. mj_forward
def rank_forward(model, data, point_world):
    mujoco.mj_forward(model, data)
    distances = np.linalg.norm(data.cam_xpos - point_world, axis=1)
    ids = np.argsort(distances)
    return ids, distances[ids]


# 2. only what says where things are
def rank_kinematics(model, data, point_world):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)        # some cameras follow a center of mass
    mujoco.mj_camlight(model, data)
    offset = data.cam_xpos - np.asarray(point_world)
    squares = np.einsum("ij,ij->i", offset, offset)
    order = np.argsort(squares, kind="stable")
    return order, np.sqrt(squares[order])


# 3. beginner: loops, selection sort
def rank_beginner(model, data, point_world):
    mujoco.mj_forward(model, data)
    ids = []
    distances = []
    for i in range(model.ncam):
        dx = data.cam_xpos[i][0] - point_world[0]
        dy = data.cam_xpos[i][1] - point_world[1]
        dz = data.cam_xpos[i][2] - point_world[2]
        ids.append(i)
        distances.append(math.sqrt(dx * dx + dy * dy + dz * dz))
    for i in range(len(ids)):
        smallest = i
        for j in range(i + 1, len(ids)):
            if distances[j] < distances[smallest]:
                smallest = j
        ids[i], ids[smallest] = ids[smallest], ids[i]
        distances[i], distances[smallest] = distances[smallest], distances[i]
    return np.array(ids, dtype=int), np.array(distances, dtype=float)


# 4. a copy: data stays as it is, to the last byte
def rank_copy(model, data, point_world):
    mine = copy.copy(data)
    mujoco.mj_forward(model, mine)
    pairs = sorted((math.dist(mine.camera(i).xpos, point_world), i) for i in range(model.ncam))
    ids = np.fromiter((i for _, i in pairs), dtype=np.int32, count=len(pairs))
    return ids, np.array([d for d, _ in pairs])


# 5. mj_copyData and mj_fwdPosition
def rank_copydata(model, data, point_world):
    scratch = mujoco.MjData(model)
    mujoco.mj_copyData(scratch, model, data)
    mujoco.mj_fwdPosition(model, scratch)
    distances = np.sqrt(((scratch.cam_xpos - point_world) ** 2).sum(axis=1))
    ids = np.lexsort((np.arange(model.ncam), distances))
    return ids, np.take(distances, ids)


# 6. Java
class RankedCamera:
    def __init__(self, number, distance):
        self.number, self.distance = number, distance

    def __lt__(self, other):
        return self.distance < other.distance


class CameraRanking:
    def __init__(self, model, data):
        if model.ncam != len(data.cam_xpos):
            raise ValueError("model and data do not belong together")
        self._model, self._data = model, data

    def update(self):
        mujoco.mj_forward(self._model, self._data)
        return self

    def sorted_by_distance(self, point):
        for number in range(self._model.ncam):
            yield RankedCamera(number, float(np.linalg.norm(self._data.cam_xpos[number] - point)))


def rank_java(model, data, point_world):
    ranking = sorted(CameraRanking(model, data).update().sorted_by_distance(point_world))
    return (np.array([r.number for r in ranking], dtype=np.int64),
            np.array([r.distance for r in ranking], dtype=np.float64))


# 7. a fresh MjData with positions only; MuJoCo's own distance
def rank_fresh(model, data, point_world):
    fresh = mujoco.MjData(model)
    fresh.qpos[:] = data.qpos
    fresh.mocap_pos[:] = data.mocap_pos
    fresh.mocap_quat[:] = data.mocap_quat
    mujoco.mj_forward(model, fresh)
    point = np.array(point_world, dtype=np.float64)
    d = {i: mujoco.mju_norm3(fresh.cam_xpos[i] - point) for i in range(model.ncam)}
    ids = np.array(sorted(d, key=d.get), dtype=int)
    return ids, np.array([d[i] for i in ids.tolist()], dtype=float)


# 8. the state vector, set into another MjData
def rank_state(model, data, point_world):
    spec = mujoco.mjtState.mjSTATE_INTEGRATION
    state = np.empty(mujoco.mj_stateSize(model, spec))
    mujoco.mj_getState(model, data, state, spec)
    other = mujoco.MjData(model)
    mujoco.mj_setState(model, other, state, spec)
    mujoco.mj_forward(model, other)
    table = np.column_stack([np.arange(model.ncam), np.hypot(np.hypot(
        *(other.cam_xpos[:, :2] - point_world[:2]).T), other.cam_xpos[:, 2] - point_world[2])])
    table = table[table[:, 1].argsort()]
    return table[:, 0].astype(int), table[:, 1]


ANSWERS = [rank_forward, rank_kinematics, rank_beginner, rank_copy, rank_copydata, rank_java,
           rank_fresh, rank_state]
