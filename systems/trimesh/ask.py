"""Asks trimesh by the intersector that the first argument names, all rays of a scene at once."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import math
from importlib import import_module

import numpy
import trimesh

ray = import_module("trimesh.ray." + sys.argv[1])


def surface(points, faces):
    return trimesh.Trimesh(points, faces, process=False)


def build(points, faces):
    intersector = ray.RayMeshIntersector(surface(points, faces))

    def ask(rays):
        origins, directions = (numpy.array(column) for column in zip(*rays))
        hits = intersector.intersects_id(origins, directions, multiple_hits=False, return_locations=True)
        found = {i: (face, None, place) for face, i, place in zip(*hits)}
        return [found.get(i) for i in range(len(rays))]

    return ask


def all_of(points, faces):
    intersector = ray.RayMeshIntersector(surface(points, faces))

    def ask(p, v):
        hits = intersector.intersects_id([p], [v], multiple_hits=True, return_locations=True)
        claims = [(face, None, place) for face, _, place in zip(*hits)]
        return sorted(claims, key=lambda claim: math.dist(p, claim[2]))

    return ask


def closest_of(points, faces):
    mesh = surface(points, faces)

    def ask(p):
        (place,), (distance,), (face,) = trimesh.proximity.closest_point(mesh, [p])
        return face, distance, place

    return ask


protocol.serve("trimesh", f"{trimesh.__version__} {sys.argv[1]}", protocol.of_faces(build),
               load_all=protocol.of_faces(all_of), load_closest=protocol.of_faces(closest_of))
