"""Asks Bullet by pybullet's rayTest, of a segment that no element is beyond; the argument `mesh` makes one body of all
triangles, of which it does not say which is met."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from importlib.metadata import version

import pybullet

STATIC, UNSEEN = 0, -1


def mesh(vertices, faces):
    shape = pybullet.createCollisionShape(pybullet.GEOM_MESH, vertices=vertices, indices=[i for face in faces for i in face],
                                          flags=pybullet.GEOM_FORCE_CONCAVE_TRIMESH)
    return pybullet.createMultiBody(STATIC, shape)


def body(element):
    if element.tipo == "triangulo":
        return mesh(element.vertices, [(0, 1, 2)])
    if element.tipo == "esfera":
        shape = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=element.radio)
        return pybullet.createMultiBody(STATIC, shape, UNSEEN, element.centro)
    if element.tipo == "caja":
        shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=element.half())
        return pybullet.createMultiBody(STATIC, shape, UNSEEN, element.centro, element.turn())
    if element.tipo == "capsula":
        radius, half, _ = element.half()
        shape = pybullet.createCollisionShape(pybullet.GEOM_CAPSULE, radius=radius, height=2 * half)
        return pybullet.createMultiBody(STATIC, shape, UNSEEN, element.centro, element.turn((2, 0, 1)))
    shape = pybullet.createCollisionShape(pybullet.GEOM_CYLINDER, radius=element.radio, height=element.altura)
    return pybullet.createMultiBody(STATIC, shape, UNSEEN, element.along(element.altura / 2), element.quaternion())


def load(elements):
    pybullet.resetSimulation()
    if sys.argv[1:] == ["mesh"]:
        names = {mesh(*protocol.mesh(elements)): None}
    else:
        names = {body(element): element.name for element in elements}

    def first(p, v):
        f = protocol.segment(elements, p, v)
        hit, _, fraction, _, normal = pybullet.rayTest(p, [a + f * b for a, b in zip(p, v)])[0]
        return (names[hit], f * fraction, {"normal": normal}) if hit >= 0 else None

    return protocol.each(first)


pybullet.connect(pybullet.DIRECT)
protocol.serve("pybullet", version("pybullet"), load)
