"""Asks raylib by GetRayCollisionMesh of one mesh; it does not say which triangle."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from importlib.metadata import version

from raylib import ffi, rl

IDENTITY = ffi.new("Matrix *", {name: 1 for name in ("m0", "m5", "m10", "m15")})[0]


def build(points, faces):
    vertices = ffi.new("float[]", [x for face in faces for i in face for x in points[i]])
    mesh = ffi.new("Mesh *", {"vertexCount": 3 * len(faces), "triangleCount": len(faces), "vertices": vertices})

    def first(p, v):
        hit = rl.GetRayCollisionMesh(ffi.new("Ray *", [p, protocol.unit(v)])[0], mesh[0], IDENTITY)
        point, normal = ([of.x, of.y, of.z] for of in (hit.point, hit.normal))
        return (None, hit.distance, point, {"normal": normal}) if hit.hit else None

    return lambda rays, alive=vertices: protocol.each(first)(rays)


protocol.serve("raylib", version("raylib"), protocol.of_faces(build))
