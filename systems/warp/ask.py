"""Asks Warp by mesh_query_ray on the processor, all rays of a scene at once."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import numpy
import warp as wp

wp.config.quiet = True
FARTHEST = wp.constant(float(numpy.finfo(numpy.float32).max))
VECTORS, WHOLE, REAL = wp.array(dtype=wp.vec3), wp.array(dtype=int), wp.array(dtype=float)


@wp.kernel
def cast(mesh: wp.uint64, p: VECTORS, v: VECTORS, face: WHOLE, t: REAL, normal: VECTORS, weights: VECTORS):
    i = wp.tid()
    hit = wp.mesh_query_ray(mesh, p[i], v[i], FARTHEST)
    face[i] = -1
    if hit.result:
        face[i] = hit.face
        t[i] = hit.t
        normal[i] = hit.normal
        weights[i] = wp.vec3(hit.u, hit.v, hit.sign)


@wp.kernel
def occlude(mesh: wp.uint64, p: wp.vec3, v: wp.vec3, end: float, hit: WHOLE):
    hit[0] = int(wp.mesh_query_ray_anyhit(mesh, p, v, end))


@wp.kernel
def count(mesh: wp.uint64, p: wp.vec3, v: wp.vec3, hits: WHOLE):
    hits[0] = wp.mesh_query_ray_count_intersections(mesh, p, v)


@wp.kernel
def project(mesh: wp.uint64, p: wp.vec3, face: WHOLE, place: VECTORS):
    found = wp.mesh_query_point_no_sign(mesh, p, FARTHEST)
    face[0] = -1
    if found.result:
        face[0] = found.face
        place[0] = wp.mesh_eval_position(mesh, found.face, found.u, found.v)


def mesh_of(points, faces):
    return wp.Mesh(wp.array(points, dtype=wp.vec3), wp.array(numpy.array(faces).ravel(), dtype=int))


def build(points, faces):
    mesh = mesh_of(points, faces)

    def ask(rays):
        n = len(rays)
        outputs = [wp.zeros(n, dtype) for dtype in (int, float, wp.vec3, wp.vec3)]
        wp.launch(cast, n, [mesh.id, *(wp.array(column, dtype=wp.vec3) for column in zip(*rays))], outputs)
        columns = zip(*(output.numpy() for output in outputs))
        return [None if face < 0 else (face, t, {"normal": normal, "front": sign > 0, "uv": (v, 1 - float(u) - float(v))})
                for face, t, normal, (u, v, sign) in columns]

    return ask


def closest_of(points, faces):
    mesh = mesh_of(points, faces)

    def ask(p):
        face, place = wp.zeros(1, int), wp.zeros(1, wp.vec3)
        wp.launch(project, 1, [mesh.id, wp.vec3(p)], [face, place])
        return None if face.numpy()[0] < 0 else (face.numpy()[0], None, place.numpy()[0])

    return ask


def whole(kernel):
    """build() of a question whose answer is a number."""

    def of(points, faces):
        mesh = mesh_of(points, faces)

        def ask(p, v, *end):
            number = wp.zeros(1, int)
            wp.launch(kernel, 1, [mesh.id, wp.vec3(p), wp.vec3(v), *end], [number])
            return int(number.numpy()[0])

        return ask

    return of


wp.set_device("cpu")
wp.load_module()  # compiled here, and not while a ray waits
protocol.serve("Warp", wp.__version__, protocol.of_faces(build), protocol.of_faces(whole(occlude)),
               load_count=protocol.of_faces(whole(count)), load_closest=protocol.of_faces(closest_of))
