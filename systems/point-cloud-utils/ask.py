"""Asks Point Cloud Utils by ray_mesh_intersection, all rays of a scene at once, and the first twice: it misreads one row."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from importlib.metadata import version

import numpy
import point_cloud_utils


def arrays(points, faces):
    return numpy.array(points, numpy.float32), numpy.array(faces, numpy.int32)


def build(points, faces):
    mesh = arrays(points, faces)

    def ask(rays):
        origins, directions = (numpy.array([*column, column[0]], numpy.float32) for column in zip(*rays))
        hits = zip(rays, *point_cloud_utils.ray_mesh_intersection(*mesh, origins, directions))
        return [None if face < 0 else (face, t, {"uv": weights[1:]}) for _, face, weights, t in hits]

    return ask


def closest_of(points, faces):
    mesh = arrays(points, faces)

    def ask(p):
        twice = numpy.array([p, p], numpy.float32)
        (distance, _), (face, _), (weights, _) = point_cloud_utils.closest_points_on_mesh(twice, *mesh)
        return face, distance, weights @ mesh[0][mesh[1][face]]

    return ask


protocol.serve("Point Cloud Utils", version("point-cloud-utils"), protocol.of_faces(build),
               load_closest=protocol.of_faces(closest_of))
