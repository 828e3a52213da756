# Raysect 0.9.1: missed
# Expected e0 at t = 7.8666934858405195, point (0.1333065141594801, -2.13330651415948, -0.9833366857300649); got a miss.
# The bounding box of a sphere has the radius alone: it leaves out that the transform stretches.
# the exact answer: e0 at t = 7.8666934858405195
# e0:
#   t = 7.866693485840519887697443705412533240565
#     = 338240/37393 − 16/37393·√(121444425/16)
# e0:
#   t = 10.22439308116399967478751337211534630908
#     = 338240/37393 + 16/37393·√(121444425/16)
# the first point:
#   x = 0.1333065141594801123025562945874667594351
#   y = -2.133306514159480112302556294587466759435
#   z = -0.9833366857300649859621804631765666550706
#
# pip install raysect && python stretched-sphere.py
from raysect.core import AffineMatrix3D, Point3D, Ray, Vector3D, World, translate
from raysect.primitive import Box, Cone, Cylinder, Mesh, Sphere

world = World()
frame = AffineMatrix3D([[-7.5, 0.0, 0.0, 0.0],
                        [0.0, 2.0, 0.75, 0.0],
                        [0.0, 1.5, -1.0, 0.0], [0, 0, 0, 1]])
Sphere(1, world, frame, name="e0")

hit = world.hit(Ray(Point3D(8.0, -10.0, 0.0), Vector3D(-1.0, 1.0, -0.125)))
print(f"got: hit {hit.primitive.name} {hit.ray_distance!r}" if hit else "got: miss")
print("expected: hit e0 7.8666934858405195")
