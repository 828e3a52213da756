"""Asks OpenCASCADE, as CadQuery's OCP binds it, by IntCurvesFace_ShapeIntersector, of a compound of faces."""

import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import OCP
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import (BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon,
                                BRepBuilderAPI_MakeWire)
from OCP.gp import gp_Ax2, gp_Ax3, gp_Circ, gp_Cone, gp_Cylinder, gp_Dir, gp_Lin, gp_Pln, gp_Pnt, gp_Sphere
from OCP.IntCurvesFace import IntCurvesFace_ShapeIntersector
from OCP.TopoDS import TopoDS_Compound

CONFUSION, INFINITE = 1e-7, 2e100  # Precision::Confusion and Precision::Infinite
LEAST = 2 * CONFUSION  # The intersector widens its range by the tolerance: from less on it answers the origin itself.


def face(*of):
    """A face that could not be made is null without an exception, and what meets it later ends the process."""
    maker = BRepBuilderAPI_MakeFace(*of)
    if not maker.IsDone():
        raise ValueError(maker.Error().name)
    return maker.Face()


def face_of(element):
    if element.tipo == "triangulo":
        polygon = BRepBuilderAPI_MakePolygon(*(gp_Pnt(*vertex) for vertex in element.vertices), True)
        return face(polygon.Wire(), True)
    centre = gp_Pnt(*element.centro)
    if element.tipo == "esfera":
        return face(gp_Sphere(gp_Ax3(centre, gp_Dir(0, 0, 1)), element.radio))
    axis = gp_Dir(*element.vector)
    if element.tipo == "plano":
        return face(gp_Pln(centre, axis))
    if element.tipo == "disco":
        rim = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, axis), element.radio)).Edge()
        return face(BRepBuilderAPI_MakeWire(rim).Wire(), True)
    frame, around = gp_Ax3(centre, axis), 2 * math.pi
    if element.tipo == "cilindro":
        return face(gp_Cylinder(frame, element.radio), 0, around, 0, element.altura)
    cone = gp_Cone(frame, -math.atan(element.proporcion), element.radii()[0])
    slant = element.altura * math.hypot(1, element.proporcion)
    return face(cone, 0, around, 0, slant)


def load(elements):
    faces = {element.name: face_of(element) for element in elements}
    compound, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(compound)
    for each in faces.values():
        builder.Add(compound, each)
    intersector = IntCurvesFace_ShapeIntersector()
    intersector.Load(compound, CONFUSION)

    def first(p, v):
        intersector.PerformNearest(gp_Lin(gp_Pnt(*p), gp_Dir(*v)), LEAST, INFINITE)
        hits = [(intersector.WParameter(i), intersector.Face(i)) for i in range(1, intersector.NbPnt() + 1)]
        if not hits:
            return None
        length, hit = min(hits, key=lambda hit: hit[0])
        return next(name for name, each in faces.items() if each.IsSame(hit)), length

    return protocol.each(first)


protocol.serve("OpenCASCADE", OCP.__version__, load)
