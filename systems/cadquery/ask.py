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


def face(element):
    if element.tipo == "triangulo":
        polygon = BRepBuilderAPI_MakePolygon(*(gp_Pnt(*vertex) for vertex in element.vertices), True)
        return BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face()
    centre = gp_Pnt(*element.centro)
    if element.tipo == "esfera":
        return BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(centre, gp_Dir(0, 0, 1)), element.radio)).Face()
    axis = gp_Dir(*element.vector)
    if element.tipo == "plano":
        return BRepBuilderAPI_MakeFace(gp_Pln(centre, axis)).Face()
    if element.tipo == "disco":
        rim = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, axis), element.radio)).Edge()
        return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(rim).Wire(), True).Face()
    frame, around = gp_Ax3(centre, axis), 2 * math.pi
    if element.tipo == "cilindro":
        return BRepBuilderAPI_MakeFace(gp_Cylinder(frame, element.radio), 0, around, 0, element.altura).Face()
    cone = gp_Cone(frame, -math.atan(element.proporcion), element.radii()[0])
    slant = element.altura * math.hypot(1, element.proporcion)
    return BRepBuilderAPI_MakeFace(cone, 0, around, 0, slant).Face()


def load(elements):
    faces = {element.name: face(element) for element in elements}
    compound, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(compound)
    for each in faces.values():
        builder.Add(compound, each)
    intersector = IntCurvesFace_ShapeIntersector()
    intersector.Load(compound, CONFUSION)

    def first(p, v):
        intersector.PerformNearest(gp_Lin(gp_Pnt(*p), gp_Dir(*v)), 0, INFINITE)
        hits = [(intersector.WParameter(i), intersector.Face(i)) for i in range(1, intersector.NbPnt() + 1)]
        if not hits:
            return None
        length, hit = min(hits, key=lambda hit: hit[0])
        return next(name for name, face in faces.items() if face.IsSame(hit)), length

    return protocol.each(first)


protocol.serve("OpenCASCADE", OCP.__version__, load)
