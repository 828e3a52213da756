"""Asks MuJoCo Warp by rays, on the processor, of a scene whose geoms are all of the world body."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import mujoco
import mujoco_warp
import warp

warp.config.quiet = True
warp.set_device("cpu")
ALL_GROUPS = mujoco_warp._src.types.vec6(-1, -1, -1, -1, -1, -1)


def add(element, world):
    if element.tipo == "esfera":
        world.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[element.radio, 0, 0], pos=element.centro)
    else:
        half = element.altura / 2
        x, y, z, w = element.quaternion()
        world.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, size=[element.radio, half, 0], pos=element.along(half),
                       quat=[w, x, y, z])


def load(elements):
    spec = mujoco.MjSpec()
    for element in elements:
        add(element, spec.worldbody)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    model, data = mujoco_warp.put_model(model), mujoco_warp.put_data(model, data)

    def ask(rays):
        shape = 1, len(rays)
        origins = warp.array([[p for p, _ in rays]], dtype=warp.vec3)
        directions = warp.array([[v for _, v in rays]], dtype=warp.vec3)
        distances, geoms = warp.empty(shape, dtype=float), warp.empty(shape, dtype=int)
        mujoco_warp.rays(model, data, origins, directions, ALL_GROUPS, True, warp.full(len(rays), -1), distances, geoms,
                         warp.empty(shape, dtype=warp.vec3))
        hits = zip(geoms.numpy()[0], distances.numpy()[0])
        return [(elements[geom].name, x) if geom >= 0 else None for geom, x in hits]

    return ask


protocol.serve("MuJoCo Warp", mujoco_warp.__version__, load)
