# MuJoCo 4.0.0: missed
# Expected e1 at t = 503.99993704260874, point (-1.9687497540726904, -0.9843749850988388, 0.2500000586733149); got a miss.
# the exact answer: e1 at t = 503.99993704260874
# e1:
#   t = 503.9999370426087316699407164902529157312
#     = -2147483648 + 73786976294838206464·√(281475108831231/332306998946228968225951765070086144)
# the first point:
#   x = -1.968749754072690358085705923790050452075
#   y = -0.98437498509883880615234375
#   z = 0.2500000586733148715701805974753476318732
#
# pip install mujoco && python cylinder-nearly-parallel.py
import mujoco
import numpy

names = []
spec = mujoco.MjSpec()
names.append("e1")
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, size=[1.015625, 2.0, 0],
                        pos=[-2.0, 0.0, 0.0],
                        quat=[0.7071067811865475, -0.0, -0.7071067811865475, 0.0])
model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_kinematics(model, data)

p = numpy.array([0.0, -0.9843749850988388, 0.25])
v = numpy.array([-0.00390625, 0.0, 1.1641532182693481e-10])
geom = numpy.zeros(1, numpy.int32)
x = mujoco.mj_ray(model, data, p, v, None, True, -1, geom)
print(f"got: hit {names[geom[0]]} {x!r}" if geom[0] >= 0 else "got: miss")
print("expected: hit e1 503.99993704260874")
