"""Asks MeshLib by rayMeshIntersect, in the format that the first argument names: f32 or f64."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from importlib.metadata import version

import numpy
from meshlib import mrmeshnumpy, mrmeshpy as mr

Line, Vector = (mr.Line3f, mr.Vector3f) if sys.argv[1] == "f32" else (mr.Line3d, mr.Vector3d)


def part_of(points, faces):
    part = mr.MeshPart(mrmeshnumpy.meshFromFacesVerts(numpy.array(faces, numpy.int32), numpy.array(points, numpy.float32)))
    if part.mesh.topology.numValidFaces() != len(faces):
        raise ValueError("faces are left out of the mesh")
    return part


def build(points, faces):
    part = part_of(points, faces)

    def first(p, v):
        hit = mr.rayMeshIntersect(part, Line(Vector(*p), Vector(*v)))
        return (hit.proj.face.get(), hit.distanceAlongLine) if hit.mtp.valid() else None

    return first


def closest_of(points, faces):
    part = part_of(points, faces)

    def ask(p):
        found = mr.findProjection(mr.Vector3f(*p), part).proj
        return found.face.get(), None, [found.point.x, found.point.y, found.point.z]

    return ask


protocol.serve("MeshLib", f"{version('meshlib')} {sys.argv[1]}", protocol.rays_of_faces(build),
               load_closest=protocol.of_faces(closest_of))
