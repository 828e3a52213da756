#include "durero/trace/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace durero::trace {
namespace {

/// The ball about the point of the axis at the given height. With w − centro = s·d + e, d² within 2⁻⁵⁰ of 1 and e·d of
/// s times that, squared distances from the axis's point are those of a unit axis up to 2⁻⁴⁷ of them: the factor pays
/// for that and for rounding. The rounded centre is off by at most 4u(|centro| + height) in each component.
Ball on_axis(const glm::dvec3& centro, const glm::dvec3& vector, double height, double radius) {
  const double extent = std::abs(centro.x) + std::abs(centro.y) + std::abs(centro.z) + height;
  return {centro + height * vector, radius * (1 + 0x1p-40) + 0x1p-48 * extent};
}

}  // namespace

Ball ball(const scene::Sphere& sphere) { return {sphere.centro, sphere.radio}; }

Ball ball(const scene::Cylinder& cylinder) {
  const double half = cylinder.altura / 2;
  return on_axis(cylinder.centro, cylinder.vector, half, std::sqrt(cylinder.radio * cylinder.radio + half * half));
}

Ball ball(const scene::Cone& cone) {
  // Through the base's rim and the apex; where that is smaller than the ball on the base itself, the latter.
  const double k = cone.proporcion, h = cone.altura;
  const double height = std::max(0.0, h * (1 - k * k) / 2);
  return on_axis(cone.centro, cone.vector, height, std::max(h - height, std::sqrt(height * height + k * h * (k * h))));
}

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
    balls_.push_back(ball(shape));
    elements_.push_back(e);
  });
  balls_.pad();
}

}  // namespace durero::trace
