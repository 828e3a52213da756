"""Asks VTK by IntersectWithLine of the locator that the first argument names, of a segment that no point is beyond."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
import math

import numpy
from vtkmodules import vtkCommonDataModel, vtkFiltersFlowPaths, vtkFiltersGeneral
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import reference, vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

TOLERANCE = 0.0  # a distance beside a triangle; any other has rays meet small triangles that they pass by
modules = vtkCommonDataModel, vtkFiltersGeneral, vtkFiltersFlowPaths
Locator = next(getattr(module, sys.argv[1]) for module in modules if hasattr(module, sys.argv[1]))


def locator_of(points, faces):
    places, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    places.SetData(numpy_to_vtk(numpy.array(points, float), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(numpy.array(faces, numpy.int64).ravel(), deep=True))
    data.SetPoints(places)
    data.SetPolys(cells)
    locator = Locator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    return locator


def build(points, faces):
    locator = locator_of(points, faces)

    def first(p, v):
        f = protocol.past(max(math.dist(p, point) for point in points), v)
        t, sub, face, place, parametric = reference(0.0), reference(0), reference(0), [0.0] * 3, [0.0] * 3
        end = [a + f * b for a, b in zip(p, v)]
        if not locator.IntersectWithLine(p, end, TOLERANCE, t, place, parametric, sub, face):
            return None
        return face.get(), f * t.get(), place

    return first


def closest_of(points, faces):
    locator = locator_of(points, faces)

    def ask(p):
        face, sub, squared, place = reference(0), reference(0), reference(0.0), [0.0] * 3
        locator.FindClosestPoint(p, place, face, sub, squared)
        return face.get(), math.sqrt(squared.get()), place

    return ask


protocol.serve("VTK", f"{vtkVersion().GetVTKVersion()} {sys.argv[1]}", protocol.rays_of_faces(build),
               load_closest=protocol.of_faces(closest_of))
