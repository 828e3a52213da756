// GLM 0.9.9.8 f64: misplaced
// Expected e0 at t = 4, point (0, 40, 0); got e3 at t = -35.77708763999664.
// A triangle behind the origin is a hit with a negative distance: nothing looks at the sign.
// the exact answer: e0 at t = 4
// e0:
//   t = 4
//     = 4
// the first point:
//   x = 0
//   y = 40
//   z = 0
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
  const V p(-4.0, 32.0, 0.0);
  const V v(0.4472135954999579, 0.8944271909999159, 0.0);  // v/|v|
  const char* nearest = nullptr;
  T least = 0, t = 0;
  glm::vec<2, T, glm::defaultp> where(0);
  if (glm::intersectRayTriangle(p, v, V(0.0, 0.0, 0.0), V(0.0, 0.0, 128.0), V(0.0, 128.0, 0.0), where, t) &&
      (!nearest || t < least))
    nearest = "e0", least = t;
  if (glm::intersectRayTriangle(p, v, V(0.0, 0.0, 128.0), V(0.0, 0.0, 0.0), V(-128.0, 0.0, 0.0), where, t) &&
      (!nearest || t < least))
    nearest = "e3", least = t;

  if (nearest)
    std::printf("got: hit %s %.17g\n", nearest, double(least));
  else
    std::puts("got: miss");
  std::puts("expected: hit e0 8.94427190999916");
}
