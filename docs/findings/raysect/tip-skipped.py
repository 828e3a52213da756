# Raysect 0.9.1: far root
# Expected e1.base at t = 251, point (15, -15, 0); got e1 at t = 256.
# the exact answer: e1.base at t = 251
# e1.base:
#   t = 251
#     = 251
# e1:
#   t = 256
#     = 256
# the first point:
#   x = 15
#   y = -15
#   z = 0
#
# pip install raysect && python tip-skipped.py
from raysect.core import AffineMatrix3D, Point3D, Ray, Vector3D, World, translate
from raysect.primitive import Cone, Cylinder, Mesh, Sphere

world = World()
frame = AffineMatrix3D([[1.0, -0.0, 0.0, 0.0],
                        [-0.0, 1.0, 0.0, 0.0],
                        [-0.0, -0.0, 1.0, 0.0], [0, 0, 0, 1]])
Cone(25.0, 25.0, world, frame, name="e1")

hit = world.hit(Ray(Point3D(768.0, -768.0, -1255.0), Vector3D(-3.0, 3.0, 5.0)))
print(f"got: hit {hit.primitive.name} {hit.ray_distance!r}" if hit else "got: miss")
print("expected: hit e1 251")
