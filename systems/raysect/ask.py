"""Asks Raysect by World.hit."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import raysect
from raysect.core import AffineMatrix3D, Point3D, Ray, Vector3D, World, translate
from raysect.primitive import Box, Cone, Cylinder, Mesh, Sphere


def placed(element):
    rows = [[*row, c] for row, c in zip(element.rotation(), element.centro)]
    return AffineMatrix3D(rows + [[0, 0, 0, 1]])


def mapped(element):
    rows = [[*row, c] for row, c in zip(zip(*element.sides), element.centro)]
    return AffineMatrix3D(rows + [[0, 0, 0, 1]])


def add(element, world):
    name = element.name
    if element.tipo in ("caja", "copia_caja"):
        return Box(Point3D(-1, -1, -1), Point3D(1, 1, 1), world, mapped(element), name=name)
    if element.tipo in ("elipsoide", "copia_esfera"):
        return Sphere(1, world, mapped(element), name=name)
    if element.tipo == "esfera":
        return Sphere(element.radio, world, translate(*element.centro), name=name)
    if element.tipo == "cilindro":
        return Cylinder(element.radio, element.altura, world, placed(element), name=name)
    if element.tipo == "cono":
        return Cone(element.radii()[0], element.altura, world, placed(element), name=name)
    return Mesh(element.vertices, [[0, 1, 2]], closed=False, parent=world, name=name)


def load(elements):
    world = World()
    for element in elements:
        add(element, world)

    def first(p, v):
        hit = world.hit(Ray(Point3D(*p), Vector3D(*v)))
        return hit and (hit.primitive.name, hit.ray_distance)

    return protocol.each(first)


protocol.serve("Raysect", raysect.__version__, load)
