# Raysect 0.9.1: far root
# Expected e2.base at t = 127.3359375, point (0, -10.625, -2.65625); got e2 at t = 128.
# the exact answer: e2.base at t = 127.3359375
# e2.base:
#   t = 127.3359375
#     = 16299/128
# e2:
#   t = 128
#     = 128
# the first point:
#   x = 0
#   y = -10.625
#   z = -2.65625
#
# pip install raysect && python tip-skipped.py
from raysect.core import AffineMatrix3D, Point3D, Ray, Vector3D, World, translate
from raysect.primitive import Cone, Cylinder, Mesh, Sphere

world = World()
frame = AffineMatrix3D([[0.0, -0.0, 1.0, 0.0],
                        [-0.0, 1.0, 0.0, 0.0],
                        [-1.0, -0.0, 0.0, 0.0], [0, 0, 0, 1]])
Cone(85.0, 21.25, world, frame, name="e2")

hit = world.hit(Ray(Point3D(-4074.75, -2048.0, -512.0), Vector3D(32.0, 16.0, 4.0)))
print(f"got: hit {hit.primitive.name} {hit.ray_distance!r}" if hit else "got: miss")
print("expected: hit e2 127.3359375")
