"""Asks Geant4's solids one by one, as its volumes may not overlap: DistanceToIn from outside, DistanceToOut from inside."""

import builtins
import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip

builtins.input = lambda _: "n"  # The import asks whether to fetch data of physics, which no solid needs.
import geant4_pybind as g4  # isort: skip

INFINITE = 9.0e99  # kInfinity


def solid(element):
    """The solid whose axis is z and whose middle is the origin."""
    name = element.name
    if element.tipo == "esfera":
        return g4.G4Orb(name, element.radio)
    half = element.altura / 2
    if element.tipo == "cilindro":
        return g4.G4Tubs(name, 0, element.radio, half, 0, 2 * math.pi)
    base, top = element.radii()
    return g4.G4Cons(name, 0, base, 0, top, half, 0, 2 * math.pi)


def to_solid(element):
    """Takes the scene to where the solid stands so."""
    if element.tipo == "esfera":
        return g4.G4AffineTransform(g4.G4ThreeVector(*element.centro)).Inverse()
    rotation = g4.G4RotationMatrix()
    rotation.rotateAxes(*(g4.G4ThreeVector(*column) for column in zip(*element.rotation())))
    middle = g4.G4ThreeVector(*element.along(element.altura / 2))
    return g4.G4AffineTransform(rotation.inverse(), middle).Inverse()


def distance(shape, p, v):
    """A point in the surface counts as inside where the ray enters there."""
    side = shape.Inside(p)
    inside = side == g4.kInside or side == g4.kSurface and shape.SurfaceNormal(p).dot(v) < 0
    return shape.DistanceToOut(p, v) if inside else shape.DistanceToIn(p, v)


def load(elements):
    solids = [(element.name, to_solid(element), solid(element)) for element in elements]

    def first(p, v):
        p, v = g4.G4ThreeVector(*p), g4.G4ThreeVector(*protocol.unit(v))
        hits = [(name, distance(shape, to.TransformPoint(p), to.TransformAxis(v))) for name, to, shape in solids]
        return protocol.nearest(hit for hit in hits if hit[1] < INFINITE)

    return protocol.each(first)


protocol.serve("Geant4", g4.G4Version.split()[1].removeprefix("geant4-"), load)
