// Asks Bullet: btCollisionWorld::rayTest of one btBvhTriangleMeshShape, of a segment that no point is beyond. Balls
// are cast by convexSweepTest on the same way.
#include <btBulletCollisionCommon.h>

#include <memory>

#include "../ask.hpp"

using namespace ask;

static btVector3 bt(const Vec& a) { return {btScalar(a[0]), btScalar(a[1]), btScalar(a[2])}; }

struct FirstFace : btCollisionWorld::ClosestRayResultCallback {
  using ClosestRayResultCallback::ClosestRayResultCallback;
  btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override {
    face = result.m_localShapeInfo->m_triangleIndex;
    return ClosestRayResultCallback::addSingleResult(result, in_world);
  }
  int face = -1;
};

struct FirstTouch : btCollisionWorld::ClosestConvexResultCallback {
  using ClosestConvexResultCallback::ClosestConvexResultCallback;
  btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool in_world) override {
    face = result.m_localShapeInfo->m_triangleIndex;
    return ClosestConvexResultCallback::addSingleResult(result, in_world);
  }
  int face = -1;
};

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of), mesh_(mesh_of(of)) {
    for (const Element& e : of.elements) triangles_.addTriangle(bt(e.vec(0)), bt(e.vec(3)), bt(e.vec(6)));
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
    object_.setCollisionShape(shape_.get());
    world_.addCollisionObject(&object_);
  }
  ~Asked() { world_.removeCollisionObject(&object_); }

  void ask(const Ray& ray) {
    const double f = segment(mesh_, ray);
    const btVector3 from = bt(ray.p), to = bt(ray.p + f * ray.v);
    if (ray.is_cast) return cast(btScalar(ray.radius), from, to, f);
    FirstFace first(from, to);
    world_.rayTest(from, to, first);
    if (!first.hasHit()) return miss();
    const btVector3& n = first.m_hitNormalWorld;
    hit(of_->elements[std::size_t(first.face)].name, double(first.m_closestHitFraction) * f, {n.x(), n.y(), n.z()});
  }

 private:
  void cast(btScalar radius, const btVector3& from, const btVector3& to, double f) {
    const btSphereShape ball(radius);
    FirstTouch first(from, to);
    world_.convexSweepTest(&ball, btTransform(btQuaternion::getIdentity(), from),
                           btTransform(btQuaternion::getIdentity(), to), first);
    if (!first.hasHit()) return miss();
    const btVector3& q = first.m_hitPointWorld;
    touch(of_->elements[std::size_t(first.face)].name, double(first.m_closestHitFraction) * f, {q.x(), q.y(), q.z()});
  }

  const Scene* of_;
  Mesh mesh_;
  btTriangleMesh triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
  btCollisionObject object_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

int main() {
  const int version = btGetVersion();
  return answer("Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100) + " mesh",
                [](const Scene& scene) { return Asked(scene); });
}
