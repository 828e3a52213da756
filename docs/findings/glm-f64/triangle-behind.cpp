// GLM 0.9.9.8 f64: misplaced
// Expected e3 at t = 16, point (-64, -64, -112); got e0 at t = -35.77708763999664.
// A triangle behind the origin is a hit with a negative distance: nothing looks at the sign.
// the exact answer: e3 at t = 16
// e3:
//   t = 16
//     = 16
// the first point:
//   x = -64
//   y = -64
//   z = -112
// ambiguous: edge
// as good: a miss
//
// c++ -std=c++17 -O2 triangle-behind.cpp && ./a.out
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>

using T = double;
using V = glm::vec<3, T, glm::defaultp>;

int main() {
  const V p(-32.0, -64.0, -96.0);
  const V v(-0.8944271909999159, 0.0, -0.4472135954999579);  // v/|v|
  const char* nearest = nullptr;
  T least = 0, t = 0;
  glm::vec<2, T, glm::defaultp> where(0);
  if (glm::intersectRayTriangle(p, v, V(0.0, 0.0, 0.0), V(0.0, -256.0, 0.0), V(0.0, 0.0, -128.0), where, t) &&
      (!nearest || t < least))
    nearest = "e0", least = t;
  if (glm::intersectRayTriangle(p, v, V(0.0, 0.0, -128.0), V(0.0, 0.0, 0.0), V(-64.0, -64.0, -112.0), where, t) &&
      (!nearest || t < least))
    nearest = "e3", least = t;

  if (nearest)
    std::printf("got: hit %s %.17g\n", nearest, double(least));
  else
    std::puts("got: miss");
  std::puts("expected: hit e3 35.77708763999664");
}
