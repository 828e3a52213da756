"""Asks Newton by intersect_ray, on the processor."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import newton
import warp

warp.config.quiet = True
warp.set_device("cpu")
WORLD = -1


def add(element, builder):
    if element.tipo == "triangulo":
        builder.add_shape_mesh(WORLD, mesh=newton.Mesh(element.vertices, [0, 1, 2], compute_inertia=False))
    elif element.tipo == "esfera":
        at = warp.transform(element.centro, warp.quat_identity())
        builder.add_shape_sphere(WORLD, xform=at, radius=element.radio)
    elif element.tipo == "plano":
        at = warp.transform(element.centro, warp.quat(*element.quaternion()))
        builder.add_shape_plane(xform=at, width=0.0, length=0.0)
    else:
        half = element.altura / 2
        at = warp.transform(element.along(half), warp.quat(*element.quaternion()))
        add_shape = builder.add_shape_cylinder if element.tipo == "cilindro" else builder.add_shape_cone
        add_shape(WORLD, xform=at, radius=element.radii()[0], half_height=half)


def load(elements):
    builder = newton.ModelBuilder()
    for element in elements:
        add(element, builder)
    model = builder.finalize()

    def ask(rays):
        count = len(rays)
        origins = warp.array([p for p, _ in rays], dtype=warp.vec3)
        directions = warp.array([protocol.unit(v) for _, v in rays], dtype=warp.vec3)
        lengths, shapes = warp.empty(count, dtype=float), warp.empty(count, dtype=int)
        newton.intersect_ray(model, ray_origins=origins, ray_directions=directions, ray_worlds=warp.full(count, WORLD),
                             out_dist=lengths, out_shape_id=shapes)
        hits = zip(shapes.numpy(), lengths.numpy())
        return [(elements[shape].name, length) if shape >= 0 else None for shape, length in hits]

    return ask


protocol.serve("Newton", newton.__version__, load)
