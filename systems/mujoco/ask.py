"""Asks MuJoCo by mj_ray for the first geom of a scene whose geoms are all of the world body; the argument `mesh` makes one
geom of all triangles, of which it does not say which is met."""

import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import mujoco
import numpy

GEOMS = {"esfera": mujoco.mjtGeom.mjGEOM_SPHERE, "cilindro": mujoco.mjtGeom.mjGEOM_CYLINDER,
         "caja": mujoco.mjtGeom.mjGEOM_BOX, "capsula": mujoco.mjtGeom.mjGEOM_CAPSULE,
         "elipsoide": mujoco.mjtGeom.mjGEOM_ELLIPSOID}


def add(element, world):
    if element.tipo == "esfera":
        world.add_geom(type=GEOMS["esfera"], size=[element.radio, 0, 0], pos=element.centro)
    elif element.tipo == "capsula":
        radius, half, _ = element.half()
        x, y, z, w = element.turn((2, 0, 1))
        world.add_geom(type=GEOMS["capsula"], size=[radius, half, 0], pos=element.centro, quat=[w, x, y, z])
    elif element.tipo in protocol.BODIES:
        x, y, z, w = element.turn()
        world.add_geom(type=GEOMS[element.tipo], size=element.half(), pos=element.centro, quat=[w, x, y, z])
    else:
        half = element.altura / 2
        x, y, z, w = element.quaternion()
        world.add_geom(type=GEOMS[element.tipo], size=[element.radio, half, 0], pos=element.along(half),
                       quat=[w, x, y, z])


def add_mesh(elements, spec):
    points, faces = protocol.mesh(elements)
    spec.add_mesh(name="mesh", uservert=[x for point in points for x in point], userface=[i for face in faces for i in face],
                  inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="mesh", contype=0, conaffinity=0)


def load(elements):
    is_mesh = sys.argv[1:] == ["mesh"]
    spec = mujoco.MjSpec()
    if is_mesh:
        add_mesh(elements, spec)
    for element in [] if is_mesh else elements:
        add(element, spec.worldbody)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    geom, normal = numpy.zeros(1, numpy.int32), numpy.zeros(3)

    def first(p, v):
        if math.hypot(*v) < mujoco.mjMINVAL:
            raise ValueError("mj_ray would end the process: vector length is too small")
        x = mujoco.mj_ray(model, data, numpy.array(p), numpy.array(v), None, True, -1, geom, normal)
        if geom[0] < 0:
            return None
        return None if is_mesh else elements[geom[0]].name, x, {"normal": tuple(normal)}

    return protocol.each(first)


protocol.serve("MuJoCo", mujoco.mj_versionString(), load)
