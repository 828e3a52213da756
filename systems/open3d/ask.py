"""Asks Open3D by RaycastingScene, all rays of a scene at once."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import numpy
import open3d
from open3d.core import Tensor


def scene_of(points, faces):
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(Tensor(numpy.array(points, numpy.float32)), Tensor(numpy.array(faces, numpy.uint32)))
    return scene


def asked(ask, *questions):
    """What ask() answers to these numbers: an array of each key."""
    answer = ask(Tensor(numpy.array(questions, numpy.float32)))
    return {key: value.numpy() for key, value in answer.items()}


def build(points, faces):
    scene = scene_of(points, faces)

    def ask(rays):
        hits = asked(scene.cast_rays, *([*p, *v] for p, v in rays))
        columns = zip(hits["primitive_ids"], hits["t_hit"], hits["primitive_normals"], hits["primitive_uvs"])
        return [None if numpy.isinf(t) else (face, t, {"normal": n, "uv": uv}) for face, t, n, uv in columns]

    return ask


def shadows_of(points, faces):
    scene = scene_of(points, faces)
    return lambda p, v, end: scene.test_occlusions(Tensor(numpy.array([[*p, *v]], numpy.float32)), 0.0, end).numpy()[0]


def all_of(points, faces):
    scene = scene_of(points, faces)

    def ask(p, v):
        hits = asked(scene.list_intersections, [*p, *v])
        return list(zip(hits["primitive_ids"], hits["t_hit"]))

    return ask


def closest_of(points, faces):
    scene = scene_of(points, faces)

    def ask(p):
        found = asked(scene.compute_closest_points, p)
        return found["primitive_ids"][0], None, found["points"][0]

    return ask


protocol.serve("Open3D", open3d.__version__, *(protocol.of_faces(of) for of in (build, shadows_of)),
               load_all=protocol.of_faces(all_of), load_closest=protocol.of_faces(closest_of))
