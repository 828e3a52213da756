# MuJoCo 4.0.0: missed
# Expected e0 at t = 0.153078696337331, point (-1.8851909777470017, 1.693842607325338, -0.0765393481686655); got a miss.
# the exact answer: e0 at t = 0.153078696337331
# e0:
#   t = 0.1530786963373310017463005114120667239632
#     = 768032186482348644203695079984/284966024355609571514437551571 − 5070602400912917605986812821504/3134626267911705286658813067281·√(3130650927019880475952064980007/1267650600228229401496703205376)
# e0.base:
#   t = 0.9140624928945726179971699871724139225653
#     = 125627792/137438953
# the first point:
#   x = -1.885190977747001748690274616440949957028
#   y = 1.693842607325337996507398977175866552074
#   z = -0.07653934816866550087315025570603336198158
#
# pip install mujoco && python cylinder-nearly-parallel.py
import mujoco
import numpy

names = []
spec = mujoco.MjSpec()
names.append("e0")
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, size=[2.0, 2251799813685248.0, 0],
                        pos=[0.0, 2107684601987072.0, 792633597231104.0],
                        quat=[0.8221922001256681, -0.5692099665786899, 0.0, 0.0])
model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_kinematics(model, data)

p = numpy.array([-2.0, 2.0, 0.0])
v = numpy.array([0.75, -2.0, -0.5])
geom = numpy.zeros(1, numpy.int32)
x = mujoco.mj_ray(model, data, p, v, None, True, -1, geom)
print(f"got: hit {names[geom[0]]} {x!r}" if geom[0] >= 0 else "got: miss")
print("expected: hit e0 0.153078696337331")
