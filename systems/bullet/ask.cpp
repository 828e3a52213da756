// Asks Bullet: btCollisionWorld::rayTest from p to p + L·v, with L a power of two that reaches behind the whole scene.
// Its fraction times L is t. Balls are cast by convexSweepTest on the same way.
#include "../ask.hpp"

#include <btBulletCollisionCommon.h>

#include <memory>

using namespace ask;

static btVector3 bt(const Vec& a) { return {btScalar(a[0]), btScalar(a[1]), btScalar(a[2])}; }

// The local z along d, at that place.
static btTransform frame(const Vec& d, const Vec& place) {
  const auto [a, b] = beside(d);
  btMatrix3x3 rotation;
  for (int i = 0; i < 3; ++i) rotation[i].setValue(btScalar(a[i]), btScalar(b[i]), btScalar(d[i]));
  return btTransform(rotation, bt(place));
}

struct Body {
  std::unique_ptr<btTriangleMesh> mesh;
  std::unique_ptr<btCollisionShape> shape;
  std::unique_ptr<btCollisionObject> object = std::make_unique<btCollisionObject>();
};

// The axes of the shape along three sides of a body.
static btTransform frame(const Element& e, int x, int y, int z) {
  const Vec a = unit(e.side(x)), b = unit(e.side(y)), c = unit(e.side(z));
  btMatrix3x3 rotation;
  for (int i = 0; i < 3; ++i) rotation[i].setValue(btScalar(a[i]), btScalar(b[i]), btScalar(c[i]));
  return btTransform(rotation, bt(e.centro()));
}

static Body body_of(const Element& e) {
  Body body;
  btTransform place = btTransform::getIdentity();
  if (e.is("esfera")) {
    body.shape = std::make_unique<btSphereShape>(btScalar(e.numbers[3]));
    place.setOrigin(bt(e.centro()));
  } else if (e.is("plano")) {
    body.shape = std::make_unique<btStaticPlaneShape>(bt(e.vector()), btScalar(dot(e.vector(), e.centro())));
  } else if (e.is("triangulo")) {
    body.mesh = std::make_unique<btTriangleMesh>();
    body.mesh->addTriangle(bt(e.vec(0)), bt(e.vec(3)), bt(e.vec(6)));
    body.shape = std::make_unique<btBvhTriangleMeshShape>(body.mesh.get(), true);
  } else if (e.is("caja")) {
    body.shape = std::make_unique<btBoxShape>(btVector3(btScalar(e.half(0)), btScalar(e.half(1)), btScalar(e.half(2))));
    place = frame(e, 0, 1, 2);
  } else if (e.is("capsula")) {
    body.shape = std::make_unique<btCapsuleShapeZ>(btScalar(e.half(0)), btScalar(2 * e.half(1)));
    place = frame(e, 2, 0, 1);
  } else {
    const btScalar r = btScalar(e.base_radius()), h = btScalar(e.altura());
    if (e.is("cilindro"))
      body.shape = std::make_unique<btCylinderShapeZ>(btVector3(r, r, h / 2));
    else
      body.shape = std::make_unique<btConeShapeZ>(r, h);
    if (e.is("cono")) body.shape->setMargin(0);  // which a cone adds to its surface
    place = frame(e.vector(), e.centro() + e.altura() / 2 * e.vector());
  }
  body.object->setCollisionShape(body.shape.get());
  body.object->setWorldTransform(place);
  return body;
}

// Of a point of the element and of all its points from there; of a plane, which has no end, where the ray meets it.
static double reach(const Element& e, const Ray& ray) {
  const Vec q = e.vec(0) - ray.p;
  const double speed = std::sqrt(dot(ray.v, ray.v)), away = std::sqrt(dot(q, q));
  if (e.is("esfera")) return (away + e.numbers[3]) / speed;
  if (e.is("plano")) {
    const double t = dot(q, e.vector()) / dot(ray.v, e.vector());
    return std::isfinite(t) && t > 0 ? t : 0;
  }
  double size = 0;
  if (e.is("triangulo")) {
    for (int i : {3, 6}) {
      const Vec edge = e.vec(i) - e.vec(0);
      size = std::fmax(size, std::sqrt(dot(edge, edge)));
    }
  } else if (e.is_body()) {
    size = e.half(0) + e.half(1) + e.half(2);
  } else {
    size = e.base_radius() + e.altura();
  }
  return (away + size) / speed;
}

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of) {
    for (const Element& e : of.elements) {
      bodies_.push_back(body_of(e));
      bodies_.back().object->setUserIndex(int(bodies_.size()) - 1);
      world_.addCollisionObject(bodies_.back().object.get());
    }
    world_.updateAabbs();
  }
  ~Asked() {
    for (Body& body : bodies_) world_.removeCollisionObject(body.object.get());
  }

  void ask(const Ray& ray) {
    double farthest = 0;
    for (const Element& e : of_->elements) farthest = std::fmax(farthest, reach(e, ray));
    const double L = std::exp2(std::ceil(std::log2(farthest + ray.radius / std::sqrt(dot(ray.v, ray.v)))) + 1);
    const btVector3 from = bt(ray.p), to = bt(ray.p + L * ray.v);
    if (ray.is_cast) return cast(btScalar(ray.radius), from, to, L);
    btCollisionWorld::ClosestRayResultCallback result(from, to);
    world_.rayTest(from, to, result);
    if (!result.hasHit()) return miss();
    const btVector3& n = result.m_hitNormalWorld;
    hit(of_->elements[std::size_t(result.m_collisionObject->getUserIndex())].name,
        double(result.m_closestHitFraction) * L, {n.x(), n.y(), n.z()});
  }

 private:
  void cast(btScalar radius, const btVector3& from, const btVector3& to, double L) {
    const btSphereShape ball(radius);
    btCollisionWorld::ClosestConvexResultCallback result(from, to);
    world_.convexSweepTest(&ball, btTransform(btQuaternion::getIdentity(), from),
                           btTransform(btQuaternion::getIdentity(), to), result);
    if (!result.hasHit()) return miss();
    const btVector3& q = result.m_hitPointWorld;
    touch(of_->elements[std::size_t(result.m_hitCollisionObject->getUserIndex())].name,
          double(result.m_closestHitFraction) * L, {q.x(), q.y(), q.z()});
  }

  const Scene* of_;
  std::vector<Body> bodies_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

int main() {
  const int version = btGetVersion();
  return answer("Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100),
                [](const Scene& scene) { return Asked(scene); });
}
