"""Asks Mitsuba 3 by Scene.ray_intersect, in the variant that the first argument names; after `mesh` of one mesh."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import mitsuba

variant = sys.argv[1]
mitsuba.set_variant(variant)
import drjit  # isort: skip


def to_world(element):
    """Takes the unit disk of the xy plane to the element."""
    columns = zip(*element.rotation())
    x, y, z = ([element.radio * a for a in column] for column in columns)
    return mitsuba.ScalarTransform4f([[x[i], y[i], z[i], element.centro[i]] for i in range(3)] + [[0, 0, 0, 1]])


def mesh_of(name, points, faces):
    mesh = mitsuba.Mesh(name, len(points), len(faces))
    parameters = mitsuba.traverse(mesh)
    parameters["vertex_positions"] = [x for point in points for x in point]
    parameters["faces"] = [i for face in faces for i in face]
    parameters.update()
    return mesh


def shape(element):
    if element.tipo == "esfera":
        return {"type": "sphere", "center": element.centro, "radius": element.radio}
    if element.tipo == "cilindro":
        ends = {"p0": element.centro, "p1": element.along(element.altura)}
        return {"type": "cylinder", "radius": element.radio, **ends}
    if element.tipo == "disco":
        return {"type": "disk", "to_world": to_world(element)}
    return mesh_of(element.name, element.vertices, [(0, 1, 2)])


def claims_of_packet(scene, rays):
    """All rays at once, as the variants of arrays have it."""
    columns = list(zip(*((*p, *v) for p, v in rays)))
    hits = scene.ray_intersect(mitsuba.Ray3f(mitsuba.Point3f(*columns[:3]), mitsuba.Vector3f(*columns[3:])))
    number = lambda shapes: drjit.reinterpret_array(mitsuba.UInt32, shapes)
    name = {number(mitsuba.ShapePtr(shape))[0]: shape.id() for shape in scene.shapes()}
    columns = zip(hits.is_valid(), number(hits.shape), hits.t)
    return [(name[shape], t) if valid else None for valid, shape, t in columns]


def scene_of(elements):
    return mitsuba.load_dict({"type": "scene", **{element.name: shape(element) for element in elements}})


def load(elements):
    scene = scene_of(elements)
    if not variant.startswith("scalar"):
        return lambda rays: claims_of_packet(scene, rays)

    triangles = {element.name for element in elements if element.tipo == "triangulo"}

    def first(p, v):
        hit = scene.ray_intersect(mitsuba.Ray3f(p, v))
        if not hit.is_valid():
            return None
        name = hit.shape.id()
        return name, hit.t, {"normal": hit.n, "uv": hit.uv} if name in triangles else {"normal": hit.n}

    return protocol.each(first)


def first_of_mesh(points, faces):
    scene = mitsuba.load_dict({"type": "scene", "mesh": mesh_of("mesh", points, faces)})

    def first(p, v):
        hit = scene.ray_intersect(mitsuba.Ray3f(p, v))
        return (hit.prim_index, hit.t, {"normal": hit.n}) if hit.is_valid() else None

    return first


def load_shadows(elements):
    scene = scene_of(elements)

    def is_hit(p, v, end):
        ray = mitsuba.Ray3f(p, v)
        ray.maxt = end
        return scene.ray_test(ray)

    return is_hit


is_mesh = sys.argv[2:] == ["mesh"]
protocol.serve("Mitsuba", f"{mitsuba.__version__} {variant}", protocol.rays_of_faces(first_of_mesh) if is_mesh else load,
               load_shadows)
