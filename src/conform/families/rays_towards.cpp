#include "durero/conform/families/rays_towards.hpp"

#include <cmath>

#include "durero/conform/judge/agreement.hpp"
#include "durero/surface/surfaces.hpp"
#include "durero/trace/ray.hpp"

namespace durero::conform {

std::vector<scene::Query> rays_towards(const scene::Scene& scene, std::size_t count, std::uint64_t seed) {
  std::vector<oracle::BallNode> balls;
  scene.for_each([&](scene::ElementRef, const auto& shape) {
    if (!trace::ordinary(shape)) return;
    const surface::Ball ball = surface::ball(shape);
    if (std::isfinite(ball.radius)) balls.push_back({ball.centre, ball.radius, 0, 0, 0});
  });
  std::vector<scene::Query> rays;
  if (balls.empty()) return rays;
  RaysTowards stream(std::move(balls), seed);
  while (rays.size() < count) {
    const scene::Query query{stream.next()};
    rays.push_back(query);
  }
  return rays;
}

}  // namespace durero::conform
