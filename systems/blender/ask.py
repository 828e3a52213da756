"""Asks Blender by BVHTree.ray_cast of its mathutils."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import bpy
from mathutils.bvhtree import BVHTree


def tree_of(points, faces):
    return BVHTree.FromPolygons(points, faces, all_triangles=True)


def build(points, faces):
    tree = tree_of(points, faces)

    def first(p, v):
        place, normal, face, distance = tree.ray_cast(p, protocol.unit(v))
        return None if place is None else (face, distance, place, {"normal": normal})

    return first


def closest_of(points, faces):
    tree = tree_of(points, faces)

    def ask(p):
        place, _, face, distance = tree.find_nearest(p)
        return face, distance, place

    return ask


protocol.serve("Blender", bpy.app.version_string, protocol.rays_of_faces(build), load_closest=protocol.of_faces(closest_of))
