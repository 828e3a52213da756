// Bullet 3.24: misplaced
// Expected e3 at t = 0.3333333333333333, point (-0.3333333333333333, 0.16666666666666666, -0.25), outward normal (-0.7427813527082074, 0.3713906763541037, -0.5570860145311556), front; got e3 at t = 0.32603153586387634, normal (-0.09430714696645737, 0.0041477191261947155, -0.9955345988273621).
// the exact answer: e3 at t = 0.3333333333333333
// e3:
//   t = 0.3333333333333333333333333333333333333333
//     = 1/3
// e3:
//   t = 0.375
//     = 3/8
// the first point:
//   x = -0.3333333333333333333333333333333333333333
//   y = 0.1666666666666666666666666666666666666667
//   z = -0.25
//
// c++ -std=c++17 -O2 -I/usr/include/bullet box-corner.cpp -lBulletDynamics -lBulletCollision -lLinearMath && ./a.out
#include <btBulletCollisionCommon.h>

#include <cstdio>

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  const char* names[1];
  {
    names[0] = "e3";
    btCollisionObject* object = new btCollisionObject;
    object->setCollisionShape(new btBoxShape(btVector3(0.375, 0.375, 0.25)));
    const btMatrix3x3 rotation(1.0, 0.0, 0.0, 0.0, 1.0, 0.0,
                               0.0, 0.0, 1.0);
    object->setWorldTransform(btTransform(rotation, btVector3(0.0, 0.0, 0.0)));
    object->setUserIndex(0);
    world.addCollisionObject(object);
  }
  world.updateAabbs();

  const double p[] = {0.0, 0.5, -0.5}, v[] = {-1.0, -1.0, 0.75}, f = 4.0;
  const btVector3 from(p[0], p[1], p[2]), to(p[0] + f * v[0], p[1] + f * v[1], p[2] + f * v[2]);
  btCollisionWorld::ClosestRayResultCallback result(from, to);
  world.rayTest(from, to, result);

  if (result.hasHit())
    std::printf("got: hit %s %.17g\n", names[result.m_collisionObject->getUserIndex()], f * result.m_closestHitFraction);
  else
    std::puts("got: miss");
  std::puts("expected: hit e3 0.3333333333333333");
}
