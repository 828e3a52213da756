#include "durero/trace/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "durero/surface/surfaces.hpp"

namespace durero::trace {

void Balls::push_back(const Ball& ball) {
  x.push_back(ball.centre.x);
  y.push_back(ball.centre.y);
  z.push_back(ball.centre.z);
  const glm::dvec3& m = ball.centre;
  radius.push_back(ball.radius + 0x1p-49 * (std::abs(m.x) + std::abs(m.y) + std::abs(m.z)));
}

void Balls::pad() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  while (x.size() % block != 0) push_back({{nan, nan, nan}, nan});
}

Tables::Tables(const scene::Scene& scene) : scene_(&scene) {
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (!ordinary(shape)) {
      extraordinary_.push_back(e);
      return;
    }
    balls_.push_back(surface::ball(shape));
    elements_.push_back(e);
  });
  balls_.pad();
}

}  // namespace durero::trace
