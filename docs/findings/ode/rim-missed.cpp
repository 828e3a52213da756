// ODE 0.16.2: missed
// Expected e1, e1.base at t = 64, point (0, 0.9375, -0.390625); got a miss.
// the exact answer: e1, e1.base at t = 64
// e1:
//   t = 64
//     = 64
// e1.base:
//   t = 64
//     = 64
// e1:
//   t = 64.125
//     = 513/8
// the first point:
//   x = 0
//   y = 0.9375
//   z = -0.390625
// ambiguous: rim
// as good: e1 at t = 64
// as good: e1.base at t = 64
// as good: e1 at t = 64.125
//
// c++ -std=c++17 -O2 rim-missed.cpp -lode && ./a.out
#include <ode/ode.h>

#include <cstdio>

int main() {
  dInitODE2(0);
  const char* names[1];
  dGeomID geometries[1];
  names[0] = "e1";
  geometries[0] = dCreateCylinder(nullptr, 1.015625, 1.0);
  dGeomSetPosition(geometries[0], 0.5, 0.0, 0.0);
  const dMatrix3 rotation0 = {0.0, -0.0, 1.0, 0,
                             0.0, 1.0, 0.0, 0,
                             -1.0, 0.0, 0.0, 0};
  dGeomSetRotation(geometries[0], rotation0);

  dGeomID ray = dCreateRay(nullptr, 1e30);
  dGeomRaySet(ray, -64.0, 64.9375, 111.609375, 1.0, -1.0, -1.75);
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
  std::puts("expected: hit e1 144");
}
