# Mitsuba 3.9.1 scalar_rgb: misplaced
# Expected e2 at t = 8.267049127450021e-09, point (-156.93294363176824, -42.08046764187812, 27.02682254729271); got e2 at t = 9.935669140759273e-07.
# Where |v| is large, the sphere's nearest point to the line is computed with one division by |v| where |v|² is needed.
# the exact answer: e2 at t = 8.267049127450021e-09
# e2:
#   t = 8.267049127450021240442575867340876682088e-9
#     = 469/55834574848 − 1/4796153459164483420160·√(405459434740135944519680)
# e2:
#   t = 8.53257731465226429140838567112066177945e-9
#     = 469/55834574848 + 1/4796153459164483420160·√(405459434740135944519680)
# the first point:
#   x = -156.9329436317682289779378408377210016646
#   y = -42.08046764187812522647459099473479800245
#   z = 27.02682254729270840882486366491159933415
#
# pip install mitsuba && python sphere-direction.py
import mitsuba

mitsuba.set_variant("scalar_rgb")
from mitsuba import ScalarTransform4f as Transform


def triangle(name, *vertices):
    mesh = mitsuba.Mesh(name, 3, 1)
    parameters = mitsuba.traverse(mesh)
    parameters["vertex_positions"] = [x for vertex in vertices for x in vertex]
    parameters["faces"] = [0, 1, 2]
    parameters.update()
    return mesh


def disk(centre, radius, *axes):
    return Transform([[*(radius * axis[i] for axis in axes), centre[i]] for i in range(3)] + [[0, 0, 0, 1]])


scene = mitsuba.load_dict({
    "type": "scene",
    "e2": {"type": "sphere", "center": [-128.0, -34.0, 16.0], "radius": 32.0},
})
hit = scene.ray_intersect(mitsuba.Ray3f([-512.0, 384.0, -115.0], [42949672960.0, -51539607552.0, 17179869184.0]))
print(f"got: hit {hit.shape.id()} {hit.t!r}" if hit.is_valid() else "got: miss")
print("expected: hit e2 8.267049127450021e-09")
