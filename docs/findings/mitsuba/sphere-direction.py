# Mitsuba 3.9.1 scalar_rgb: misplaced
# Expected e0 at t = 1.7232647457496912e-09, point (-0.47320748548510877, 0.19048752419148535, 0.8601099806468118), outward normal (-0.47320748548510877, 0.19048752419148535, 0.8601099806468118), front; got e0 at t = 6.177060072332097e-07, normal (0.42423492670059204, 0.7071778178215027, -0.5656185746192932).
# Where |v| is large, the sphere's nearest point to the line is computed with one division by |v| where |v|² is needed.
# the exact answer: e0 at t = 1.7232647457496912e-09
# e0:
#   t = 1.723264745749691272021395074537699211561e-9
#     = 379/214748364800 − 1/176541105392923443200·√(53913998514135760896)
# e0:
#   t = 1.806447812042972302197354925462300788439e-9
#     = 379/214748364800 + 1/176541105392923443200·√(53913998514135760896)
# the first point:
#   x = -0.4732074854851087922500521996166931820314
#   y = 0.1904875241914853462499130006388446966143
#   z = 0.8601099806468117230000695994889242427086
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
    "e0": {"type": "sphere", "center": [0.0, 0.0, 0.0], "radius": 1.0},
})
hit = scene.ray_intersect(mitsuba.Ray3f([-10.1875, -16.0, 13.8125], [5637144576.0, 9395240960.0, -7516192768.0]))
print(f"got: hit {hit.shape.id()} {hit.t!r}" if hit.is_valid() else "got: miss")
print("expected: hit e0 1.7232647457496912e-09")
