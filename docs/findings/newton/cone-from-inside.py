# Newton 1.8.0: missed
# Expected e0.base at t = 0.25, point (0, 0, 0); got a miss.
# From inside a cone the far root is not tried.
# the exact answer: e0.base at t = 0.25
# e0.base:
#   t = 0.25
#     = 1/4
# the first point:
#   x = 0
#   y = 0
#   z = 0
#
# pip install newton && python cone-from-inside.py
import newton
import warp

warp.config.quiet = True
warp.set_device("cpu")
WORLD = -1
names = []
builder = newton.ModelBuilder()
names.append("e0")
at = warp.transform((0.0, 0.0, 1.0), warp.quat(-0.0, 0.0, 0.0, 1.0))
builder.add_shape_cone(WORLD, xform=at, radius=2.0, half_height=1.0)
model = builder.finalize()

p = warp.array([(0.0, 0.0, 0.125)], dtype=warp.vec3)
v = warp.array([(0.0, 0.0, -1.0)], dtype=warp.vec3)  # v/|v|
distances, shapes = warp.empty(1, dtype=float), warp.empty(1, dtype=int)
newton.intersect_ray(model, ray_origins=p, ray_directions=v, ray_worlds=warp.full(1, WORLD), out_dist=distances,
                     out_shape_id=shapes)
shape, distance = int(shapes.numpy()[0]), float(distances.numpy()[0])
print(f"got: hit {names[shape]} {distance!r}" if shape >= 0 else "got: miss")
print("expected: hit e0 0.125")
