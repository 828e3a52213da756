// Asks ODE: dCollide of a ray with each geometry, of which the least depth is nearest.
#include "../ask.hpp"

#include <ode/ode.h>

using namespace ask;

static dGeomID cylinder(const Element& e) {
  dGeomID geometry = dCreateCylinder(nullptr, e.numbers[6], e.altura());
  const Vec d = e.vector(), middle = e.centro() + e.altura() / 2 * d;
  const auto [a, b] = beside(d);
  const dMatrix3 rotation = {a[0], b[0], d[0], 0, a[1], b[1], d[1], 0, a[2], b[2], d[2], 0};  // its axis is the local z
  dGeomSetPosition(geometry, middle[0], middle[1], middle[2]);
  dGeomSetRotation(geometry, rotation);
  return geometry;
}

// The axes of the geometry along the sides of a body; of a capsule its z is along y.
static dGeomID body(const Element& e) {
  const bool is_box = e.is("caja");
  const double x = e.half(0), y = e.half(1), z = e.half(2);
  dGeomID geometry = is_box ? dCreateBox(nullptr, 2 * x, 2 * y, 2 * z) : dCreateCapsule(nullptr, x, 2 * y);
  const Vec a = unit(e.side(is_box ? 0 : 2)), b = unit(e.side(is_box ? 1 : 0)), c = unit(e.side(is_box ? 2 : 1));
  const dMatrix3 rotation = {a[0], b[0], c[0], 0, a[1], b[1], c[1], 0, a[2], b[2], c[2], 0};
  dGeomSetPosition(geometry, e.numbers[0], e.numbers[1], e.numbers[2]);
  dGeomSetRotation(geometry, rotation);
  return geometry;
}

static dGeomID sphere(const Element& e) {
  dGeomID geometry = dCreateSphere(nullptr, e.numbers[3]);
  dGeomSetPosition(geometry, e.numbers[0], e.numbers[1], e.numbers[2]);
  return geometry;
}

static dGeomID plane(const Element& e) {
  const Vec n = e.vector();
  return dCreatePlane(nullptr, n[0], n[1], n[2], dot(n, e.centro()));
}

static dGeomID geometry_of(const Element& e) {
  return e.is_body() ? body(e) : e.is("esfera") ? sphere(e) : e.is("plano") ? plane(e) : cylinder(e);
}

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of), ray_(dCreateRay(nullptr, 1e30)) {
    for (const Element& e : of.elements) geometries_.push_back(geometry_of(e));
  }
  ~Asked() {
    for (dGeomID geometry : geometries_) dGeomDestroy(geometry);
    dGeomDestroy(ray_);
  }

  void ask(const Ray& ray) const {
    dGeomRaySet(ray_, ray.p[0], ray.p[1], ray.p[2], ray.v[0], ray.v[1], ray.v[2]);
    const Element* nearest = nullptr;
    double least = 0;
    for (std::size_t i = 0; i < geometries_.size(); ++i) {
      dContactGeom contact;
      if (dCollide(ray_, geometries_[i], 1, &contact, sizeof contact) == 0) continue;
      if (nearest != nullptr && contact.depth >= least) continue;
      nearest = &of_->elements[i];
      least = contact.depth;
    }
    nearest == nullptr ? miss() : hit(nearest->name, least);
  }

 private:
  const Scene* of_;
  dGeomID ray_;
  std::vector<dGeomID> geometries_;
};

int main() {
  dInitODE2(0);
  return answer("ODE 0.16.2", [](const Scene& scene) { return Asked(scene); });
}
