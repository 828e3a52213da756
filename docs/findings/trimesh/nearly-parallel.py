# trimesh 5.2.0 ray_triangle: missed
# Expected e2 at t = 89.37325037149455, point (45.78031386801616, 36.80802967788308, 53.150887066192475); got a miss.
# A line whose |v·n| is 10⁻⁵ or less, with v as it is given and n of length 1, counts as parallel to the plane of the triangle.
# the exact answer: e2 at t = 89.37325037149455
# e2:
#   t = 89.37325037149454746815835566722700872689
#     = 126956685792/1420522195
# the first point:
#   x = 45.78031386801615722246775595083186996596
#   y = 36.8080296778830768836561543482254425458
#   z = 53.15088706619247420488209971263419787679
#
# pip install trimesh rtree scipy && python nearly-parallel.py
import trimesh

points, names = [], []
points += [(0.0, 0.0, 0.0), (-45.0234375, -64.9111328125, 68.265625), (60.339599609375, 50.37841796875, 62.2265625)]
names.append("e2")
mesh = trimesh.Trimesh(points, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(names))], process=False)

intersector = trimesh.ray.ray_triangle.RayMeshIntersector(mesh)
faces, _, places = intersector.intersects_id([(-48.853515625, -61.278076171875, 35.640625)], [(1.0588607788085938, 1.0974884033203125, 0.1959228515625)], multiple_hits=False, return_locations=True)
print("got: hit", names[faces[0]], "-", *map(float, places[0])) if len(faces) else print("got: miss")
print("expected: hit e2 - 45.78031386801616 36.80802967788308 53.150887066192475")
