// Asks OpenCASCADE: `faces` are the faces of solids, by IntCurvesFace_ShapeIntersector; `quadric` is
// IntAna_IntConicQuad, whose surfaces have no ends and whose cones have both nappes: the points between the ends are
// chosen here, and the nearest of them.
#include "../ask.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <IntAna_IntConicQuad.hxx>
#include <IntAna_Quadric.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <memory>

using namespace ask;

static gp_Pnt point(const Vec& a) { return {a[0], a[1], a[2]}; }
static gp_Dir direction(const Vec& a) { return {a[0], a[1], a[2]}; }
static gp_Lin line(const Ray& ray) { return {point(ray.p), direction(ray.v)}; }

static TopoDS_Shape shape_of(const Element& e) {
  if (e.is("esfera")) return BRepPrimAPI_MakeSphere(point(e.centro()), e.numbers[3]).Shape();
  if (e.is("plano")) return BRepBuilderAPI_MakeFace(gp_Pln(point(e.centro()), direction(e.vector()))).Shape();
  if (e.is("triangulo"))
    return BRepBuilderAPI_MakeFace(
               BRepBuilderAPI_MakePolygon(point(e.vec(0)), point(e.vec(3)), point(e.vec(6)), true).Wire(), true)
        .Shape();
  const gp_Ax2 axes(point(e.centro()), direction(e.vector()));
  if (e.is("disco"))
    return BRepBuilderAPI_MakeFace(
               gp_Pln(gp_Ax3(axes)),
               BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, e.numbers[6])).Edge()).Wire(), true)
        .Shape();
  if (e.is("cilindro")) return BRepPrimAPI_MakeCylinder(axes, e.numbers[6], e.altura()).Shape();
  return BRepPrimAPI_MakeCone(axes, e.base_radius(), e.top_radius(), e.altura()).Shape();
}

// The parameters at which a line meets an element, of which those behind its origin are passed over.
struct Faces {
  explicit Faces(const Element& e) : shape(shape_of(e)) { intersector.Load(shape, Precision::Confusion()); }

  std::vector<double> meet(const Ray& ray) {
    intersector.Perform(line(ray), 0, RealLast());
    std::vector<double> ts;
    for (int i = 1; intersector.IsDone() && i <= intersector.NbPnt(); ++i) ts.push_back(intersector.WParameter(i));
    return ts;
  }

  TopoDS_Shape shape;
  IntCurvesFace_ShapeIntersector intersector;
};

static IntAna_Quadric quadric_of(const Element& e) {
  const gp_Ax3 axes(point(e.centro()), e.is("esfera") ? gp_Dir(0, 0, 1) : direction(e.vector()));
  if (e.is("esfera")) return gp_Sphere(axes, e.numbers[3]);
  if (e.is("cilindro")) return gp_Cylinder(axes, e.numbers[6]);
  const double proporcion = e.is("cono") ? e.numbers[6] : e.numbers[7];  // it grows towards centro
  return gp_Cone(gp_Ax3(point(e.top()), direction(-1 * e.vector())), std::atan(proporcion), e.top_radius());
}

struct Quadric {
  explicit Quadric(const Element& of) : e(of), quadric(quadric_of(of)) {}

  std::vector<double> meet(const Ray& ray) {
    const gp_Lin asked = line(ray);
    const IntAna_IntConicQuad points(asked, quadric);
    std::vector<double> ts;
    if (!points.IsDone() || points.IsInQuadric() || points.IsParallel()) return ts;
    for (int i = 1; i <= points.NbPoints(); ++i) {
      const gp_Pnt at = points.Point(i);
      const Vec q = Vec{at.X(), at.Y(), at.Z()} - e.centro();
      const double s = e.is("esfera") ? 0 : dot(q, e.vector());
      if (e.is("esfera") || (s >= 0 && s <= e.altura())) ts.push_back(points.ParamOnConic(i));
    }
    return ts;
  }

  Element e;
  IntAna_Quadric quadric;
};

template <class Asker>
class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of) {
    try {
      for (const Element& e : of.elements) askers_.push_back(std::make_unique<Asker>(e));
    } catch (const Standard_Failure& failure) {
      refused_ = failure.GetMessageString();
      refused_ += " ";
      refused_ += failure.DynamicType()->Name();
    }
  }

  void ask(const Ray& ray) {
    if (!refused_.empty()) return refused(refused_.c_str());
    if (ray.is_about_all) return all_hits(ray, all_met(ray));
    const Element* nearest = nullptr;
    double least = 0;
    for (std::size_t i = 0; i < askers_.size(); ++i) {
      for (const double t : askers_[i]->meet(ray)) {
        if (t <= 0 || (nearest != nullptr && t >= least)) continue;
        nearest = &of_->elements[i];
        least = t;
      }
    }
    nearest == nullptr ? miss() : hit(nearest->name, least);
  }

 private:
  std::vector<Listed> all_met(const Ray& ray) {
    std::vector<Listed> all;
    for (std::size_t i = 0; i < askers_.size(); ++i) {
      for (const double t : askers_[i]->meet(ray)) all.push_back({t, of_->elements[i].name});
    }
    return all;
  }

  const Scene* of_;
  std::vector<std::unique_ptr<Asker>> askers_;
  std::string refused_;
};

int main(int, char** argv) {
  const std::string kind = argv[1], system = "OpenCASCADE " OCC_VERSION_COMPLETE " " + kind;
  if (kind == "faces") return answer(system, [](const Scene& scene) { return Asked<Faces>(scene); });
  return answer(system, [](const Scene& scene) { return Asked<Quadric>(scene); });
}
