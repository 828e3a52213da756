# VTK 9.7.2 vtkCellTreeLocator: wrong element
# Expected m:383 at t = 7.833333333333333, point (0.5, 0.5833333333333334, -0.5); got m:39 at t = 8.125000000000002, point (0.06249999999999645, 0.4374999999999991, -0.5).
# the exact answer: m:383 at t = 7.833333333333333
# m:383:
#   t = 7.833333333333333333333333333333333333333
#     = 47/6
# m:39:
#   t = 8.125
#     = 65/8
# the first point:
#   x = 0.5
#   y = 0.5833333333333333333333333333333333333333
#   z = -0.5
#
# pip install vtk && python not-first.py
from vtkmodules.vtkCommonCore import VTK_DOUBLE, reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonDataModel import vtkCellTreeLocator

points, triangles, names = vtkPoints(), vtkCellArray(), []
points.SetDataType(VTK_DOUBLE)
corners = [(0.0, 0.5, -1.0), (0.0, 0.5, 0.0), (0.5, 0.0, 0.0)]
triangles.InsertNextCell(3, [points.InsertNextPoint(corner) for corner in corners])
names.append("m:39")
corners = [(0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)]
triangles.InsertNextCell(3, [points.InsertNextPoint(corner) for corner in corners])
names.append("m:123")
corners = [(0.0, 0.5, 0.0), (1.0, 1.0, -1.0), (0.0, 0.0, 0.0)]
triangles.InsertNextCell(3, [points.InsertNextPoint(corner) for corner in corners])
names.append("m:383")
surface = vtkPolyData()
surface.SetPoints(points)
surface.SetPolys(triangles)
locator = vtkCellTreeLocator()
locator.SetDataSet(surface)
locator.BuildLocator()

p, v, f = (12.25, 4.5, -0.5), (-1.5, -0.5, -0.0), 32.0
t, x, parametric, sub, cell = reference(0.0), [0.0] * 3, [0.0] * 3, reference(0), reference(0)
end = [a + f * b for a, b in zip(p, v)]
met = locator.IntersectWithLine(p, end, 0.0, t, x, parametric, sub, cell)
print(f"got: hit {names[cell.get()]} {f * t.get()!r} {x[0]!r} {x[1]!r} {x[2]!r}" if met else "got: miss")
print("expected: hit m:383 7.833333333333333")
