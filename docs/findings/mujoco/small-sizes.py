# MuJoCo 4.0.0: missed
# Expected e0 at t = 1.3234889800848443e-23, point (2.6469779601696886e-23, -2.6469779601696886e-23, 6.617444900424222e-24); got a miss.
# the exact answer: e0 at t = 1.3234889800848443e-23
# e0:
#   t = 1.323488980084844279794253907311940565705e-23
#     = 1/75557863725914323419136
# the first point:
#   x = 2.646977960169688559588507814623881131411e-23
#   y = -2.646977960169688559588507814623881131411e-23
#   z = 6.617444900424221398971269536559702828526e-24
#
# pip install mujoco && python small-sizes.py
import mujoco
import numpy

names = []
spec = mujoco.MjSpec()
names.append("e0")
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[6.617444900424222e-24, 0, 0], pos=[2.6469779601696886e-23, -2.6469779601696886e-23, 0.0])
model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_kinematics(model, data)

p = numpy.array([2.6469779601696886e-23, -2.6469779601696886e-23, 0.0])
v = numpy.array([0.0, 0.0, 0.5])
geom = numpy.zeros(1, numpy.int32)
x = mujoco.mj_ray(model, data, p, v, None, True, -1, geom)
print(f"got: hit {names[geom[0]]} {x!r}" if geom[0] >= 0 else "got: miss")
print("expected: hit e0 1.3234889800848443e-23")
