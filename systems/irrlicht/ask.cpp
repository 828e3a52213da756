// Asks Irrlicht by getCollisionPoint of one octree of triangles, of a segment that no point is beyond; it does not say
// which triangle in numbers.
#include "../ask.hpp"

#include <irrlicht/irrlicht.h>

using namespace ask;
using irr::core::vector3df;

static vector3df in(const Vec& a) { return {float(a[0]), float(a[1]), float(a[2])}; }

class Asked {
 public:
  Asked(const Scene& of, irr::scene::ISceneManager* manager) : mesh_(mesh_of(of)), manager_(manager) {
    auto* buffer = new irr::scene::SMeshBuffer;
    for (const Vec& a : mesh_.points) {
      irr::video::S3DVertex vertex;
      vertex.Pos = in(a);
      buffer->Vertices.push_back(vertex);
    }
    for (const auto& face : mesh_.faces)
      for (unsigned i : face) buffer->Indices.push_back(irr::u16(i));
    buffer->recalculateBoundingBox();
    auto* mesh = new irr::scene::SMesh;
    mesh->addMeshBuffer(buffer);
    mesh->recalculateBoundingBox();
    node_ = manager->addMeshSceneNode(mesh);
    selector_ = manager->createOctreeTriangleSelector(mesh, node_);
  }
  ~Asked() {
    selector_->drop();
    node_->remove();
  }

  void ask(const Ray& ray) const {
    const irr::core::line3df line(in(ray.p), in(ray.p + segment(mesh_, ray) * ray.v));
    vector3df place;
    irr::core::triangle3df triangle;
    irr::scene::ISceneNode* node = nullptr;
    const bool is_met = manager_->getSceneCollisionManager()->getCollisionPoint(line, selector_, place, triangle, node);
    is_met ? hit_at("-", {place.X, place.Y, place.Z}) : miss();
  }

 private:
  Mesh mesh_;
  irr::scene::ISceneManager* manager_;
  irr::scene::IMeshSceneNode* node_;
  irr::scene::ITriangleSelector* selector_;
};

int main() {
  irr::SIrrlichtCreationParameters quiet;
  quiet.DriverType = irr::video::EDT_NULL;
  quiet.LoggingLevel = irr::ELL_NONE;
  irr::scene::ISceneManager* manager = irr::createDeviceEx(quiet)->getSceneManager();
  return answer("Irrlicht " IRRLICHT_SDK_VERSION, [&](const Scene& scene) { return Asked(scene, manager); });
}
