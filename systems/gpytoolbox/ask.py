"""Asks Gpytoolbox by ray_mesh_intersect, all rays of a scene at once."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from importlib.metadata import version

import gpytoolbox
import numpy


def build(points, faces):
    mesh = numpy.array(points, float), numpy.array(faces, numpy.int32)

    def ask(rays):
        origins, directions = (numpy.array(column) for column in zip(*rays))
        hits = zip(*gpytoolbox.ray_mesh_intersect(origins, directions, *mesh))
        return [None if face < 0 else (face, t, {"uv": weights[1:]}) for t, face, weights in hits]

    return ask


protocol.serve("Gpytoolbox", version("gpytoolbox"), protocol.of_faces(build))
