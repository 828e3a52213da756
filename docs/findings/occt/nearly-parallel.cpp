// OpenCASCADE 7.6.3 faces: phantom
// Expected a miss; got e0 at t = 27465355019573.11.
// the exact answer: a miss
//
// c++ -std=c++17 -O2 -I/usr/include/opencascade nearly-parallel.cpp -lTKPrim -lTKTopAlgo -lTKGeomAlgo -lTKBRep -lTKG3d -lTKGeomBase
//   -lTKMath -lTKernel && ./a.out
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <Precision.hxx>
#include <TopoDS_Face.hxx>
#include <cstdio>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>

int main() {
  const char* names[1];
  TopoDS_Shape shapes[1];
  names[0] = "e0";
  const gp_Ax2 axes0(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0));
  shapes[0] = BRepPrimAPI_MakeCylinder(axes0, 1.0, 35184372088832.0).Shape();

  const gp_Lin line(gp_Pnt(26132879507456.0, -8450936930304.0, 0.0), gp_Dir(-1.2623465061187744, 0.4082217812538147, 0.0));
  int nearest = -1;
  double least = 0;
  for (int i = 0; i < 1; ++i) {
    IntCurvesFace_ShapeIntersector intersector;
    intersector.Load(shapes[i], Precision::Confusion());
    intersector.Perform(line, 0, RealLast());
    for (int k = 1; intersector.IsDone() && k <= intersector.NbPnt(); ++k) {
      const double t = intersector.WParameter(k);
      if (t > 0 && (nearest < 0 || t < least)) nearest = i, least = t;
    }
  }

  if (nearest < 0)
    std::puts("got: miss");
  else
    std::printf("got: hit %s %.17g\n", names[nearest], least);
  std::puts("expected: miss");
}
