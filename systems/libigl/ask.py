"""Asks libigl by the class that the first argument names: AABB, all rays of a scene at once, or EmbreeIntersector."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import math
from importlib.metadata import version

import igl
import igl.embree
import numpy


def arrays(points, faces):
    return numpy.array(points, float), numpy.array(faces, numpy.int64)


def tree_of(points, faces):
    mesh = arrays(points, faces)
    tree = igl.AABB()
    tree.init(*mesh)

    def ask(rays):
        origins, directions = (numpy.array(column) for column in zip(*rays))
        hits = zip(*tree.intersect_ray_first(*mesh, origins, directions))
        return [None if face < 0 else (face, t, {"uv": uv}) for face, t, uv in hits]

    return ask


def closest_of(points, faces):
    mesh = arrays(points, faces)
    tree = igl.AABB()
    tree.init(*mesh)

    def ask(p):
        (squared,), (face,), (place,) = tree.squared_distance(*mesh, numpy.array([p]))
        return face, math.sqrt(squared), place

    return ask


def all_of(points, faces):
    mesh = arrays(points, faces)
    tree = igl.AABB()
    tree.init(*mesh)
    return lambda p, v: [hit[:2] for hit in tree.intersect_ray(*mesh, numpy.array([p]), numpy.array([v]))[0]]


def embree_of(points, faces):
    embree = igl.embree.EmbreeIntersector()
    embree.init(numpy.array(points, numpy.float32), numpy.array(faces, numpy.int32))

    def first(p, v):
        face, t, u, w = embree.intersectRay_first(numpy.array(p, numpy.float32), numpy.array(v, numpy.float32))
        return None if face < 0 else (face, t, {"uv": (u, w)})

    return first


is_tree = sys.argv[1] == "AABB"
protocol.serve("libigl", f"{version('libigl')} {sys.argv[1]}",
               protocol.of_faces(tree_of) if is_tree else protocol.rays_of_faces(embree_of),
               load_all=protocol.of_faces(all_of), load_closest=protocol.of_faces(closest_of))
