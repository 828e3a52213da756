// Asks ODE: dCollide of a ray with one triangle mesh, for the closest hit.
#include <ode/ode.h>

#include "../ask.hpp"

using namespace ask;

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of), mesh_(mesh_of(of)), data_(dGeomTriMeshDataCreate()) {
    dGeomTriMeshDataBuildDouble(data_, mesh_.points.data(), sizeof(Vec), int(mesh_.points.size()), mesh_.faces.data(),
                                int(3 * mesh_.faces.size()), sizeof mesh_.faces[0]);
    geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    dGeomRaySetClosestHit(ray_, 1);
    dGeomRaySetBackfaceCull(ray_, 0);
  }
  ~Asked() {
    dGeomDestroy(geometry_);
    dGeomTriMeshDataDestroy(data_);
    dGeomDestroy(ray_);
  }

  void ask(const Ray& ray) const {
    dGeomRaySet(ray_, ray.p[0], ray.p[1], ray.p[2], ray.v[0], ray.v[1], ray.v[2]);
    dContactGeom contact;
    if (dCollide(ray_, geometry_, 1, &contact, sizeof contact) == 0) return miss();
    const dReal* n = contact.normal;
    hit(of_->elements[std::size_t(contact.side2)].name, contact.depth, {n[0], n[1], n[2]});
  }

 private:
  const Scene* of_;
  Mesh mesh_;
  dTriMeshDataID data_;
  dGeomID geometry_, ray_ = dCreateRay(nullptr, 1e30);
};

int main() {
  dInitODE2(0);
  return answer("ODE 0.16.2 mesh", [](const Scene& scene) { return Asked(scene); });
}
