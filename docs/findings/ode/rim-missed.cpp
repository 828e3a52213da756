// ODE 0.16.2: missed
// Expected e0, e0.base at t = 4, point (-0.203125, -1.3125, 0); got a miss.
// the exact answer: e0, e0.base at t = 4
// e0:
//   t = 4
//     = 4
// e0.base:
//   t = 4
//     = 4
// e0.top:
//   t = 5
//     = 5
// the first point:
//   x = -0.203125
//   y = -1.3125
//   z = 0
// ambiguous: rim
// as good: e0 at t = 4
// as good: e0.base at t = 4
// as good: e0.top at t = 5
//
// c++ -std=c++17 -O2 rim-missed.cpp -lode && ./a.out
#include <ode/ode.h>

#include <cstdio>

int main() {
  dInitODE2(0);
  const char* names[1];
  dGeomID geometries[1];
  names[0] = "e0";
  geometries[0] = dCreateCylinder(nullptr, 1.328125, 0.5);
  dGeomSetPosition(geometries[0], 0.0, 0.0, -0.25);
  const dMatrix3 rotation0 = {-0.0, 1.0, 0.0, 0,
                             1.0, 0.0, 0.0, 0,
                             0.0, 0.0, -1.0, 0};
  dGeomSetRotation(geometries[0], rotation0);

  dGeomID ray = dCreateRay(nullptr, 1e30);
  dGeomRaySet(ray, 2.796875, -6.3125, 2.0, -0.75, 1.25, -0.5);
  int nearest = -1;
  double depth = dInfinity;
  for (int i = 0; i < 1; ++i) {
    dContactGeom contact;
    if (dCollide(ray, geometries[i], 1, &contact, sizeof contact) == 0 || contact.depth >= depth) continue;
    nearest = i;
    depth = contact.depth;
  }

  if (nearest < 0)
    std::puts("got: miss");
  else
    std::printf("got: hit %s %.17g\n", names[nearest], depth);
  std::puts("expected: hit e0 6.164414002968976");
}
