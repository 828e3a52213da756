"""Asks Panda3D by a CollisionRay of a CollisionPolygon for each triangle, or by rayTestClosest of its Bullet."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import math

from panda3d.bullet import BulletRigidBodyNode, BulletTriangleMesh, BulletTriangleMeshShape, BulletWorld
from panda3d.core import (CollisionHandlerQueue, CollisionNode, CollisionPolygon, CollisionRay, CollisionTraverser, LPoint3,
                          LVector3, NodePath, PandaSystem)


def polygons_of(points, faces):
    root, queue, traverser = NodePath("scene"), CollisionHandlerQueue(), CollisionTraverser()
    for i, face in enumerate(faces):
        polygon = CollisionNode(str(i))
        polygon.add_solid(CollisionPolygon(*(LPoint3(*points[j]) for j in face)))
        root.attach_new_node(polygon)
    ray, asker = CollisionRay(), CollisionNode("ray")
    asker.add_solid(ray)
    path = root.attach_new_node(asker)
    traverser.add_collider(path, queue)

    def first(p, v):
        ray.set_origin(*p)
        ray.set_direction(*v)
        traverser.traverse(root)
        queue.sort_entries()
        if not queue.get_num_entries():
            return None
        hit = queue.get_entry(0)
        return int(hit.get_into_node().get_name()), None, hit.get_surface_point(root), {"normal": hit.get_surface_normal(root)}

    return first


def bullet_of(points, faces):
    mesh, node, world = BulletTriangleMesh(), BulletRigidBodyNode("mesh"), BulletWorld()
    for face in faces:
        mesh.add_triangle(*(LPoint3(*points[i]) for i in face))
    node.add_shape(BulletTriangleMeshShape(mesh, dynamic=False))
    world.attach(node)

    def first(p, v):
        f = protocol.past(max(math.dist(p, point) for point in points), v)
        start = LPoint3(*p)
        hit = world.ray_test_closest(start, start + LVector3(*v) * f)
        if not hit.has_hit():
            return None
        return hit.get_triangle_index(), f * hit.get_hit_fraction(), {"normal": hit.get_hit_normal()}

    return first


build = bullet_of if sys.argv[1:] == ["bullet"] else polygons_of
protocol.serve("Panda3D", PandaSystem.get_version_string(), protocol.rays_of_faces(build))
