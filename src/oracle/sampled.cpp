#include "durero/oracle/sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "crossing.hpp"

namespace durero::oracle::sampled {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The first candidate of one element: distance of its foot from the origin, and the sample.
struct Candidate {
  double distance;
  glm::dvec3 sample;
};

/// The sample within δ of the ray whose foot is nearest to the origin.
class Nearest {
 public:
  Nearest(const Cover& cover, const Line& line) : cover_(cover), line_(line) { visit(0); }

  std::optional<Candidate> candidate() const {
    if (foot_ == infinity) return std::nullopt;
    return Candidate{foot_, cover_.samples[which_]};
  }

 private:
  /// False where no sample of the ball is a candidate nearer than the one found.
  bool may_improve(const Ball& ball) const {
    const glm::dvec3 to_center = ball.center - line_.p;
    const double along = glm::dot(to_center, line_.direction);
    const glm::dvec3 apart = to_center - line_.direction * std::max(0.0, along);
    const double reach = (ball.radius + cover_.delta) * (1 + 0x1p-40) + 0x1p-40 * glm::length(to_center);
    return glm::dot(apart, apart) <= reach * reach && along - reach < foot_;
  }

  void visit(std::uint32_t index) {
    const Ball& ball = cover_.balls[index];
    if (!may_improve(ball)) return;
    if (ball.right == 0) return look(ball.first, ball.last);
    visit(index + 1);
    visit(ball.right);
  }

  void look(std::uint32_t first, std::uint32_t last) {
    const double limit = cover_.delta * cover_.delta;
    for (std::uint32_t i = first; i < last; ++i) {
      const glm::dvec3 q = cover_.samples[i] - line_.p;
      const double foot = std::max(0.0, glm::dot(q, line_.direction));
      const glm::dvec3 apart = q - line_.direction * foot;
      if (foot >= foot_ || glm::dot(apart, apart) > limit) continue;
      foot_ = foot;
      which_ = i;
    }
  }

  const Cover& cover_;
  const Line& line_;
  double foot_ = infinity;
  std::uint32_t which_ = 0;
};

std::optional<Candidate> nearest(const Cover& cover, const Line& line) { return Nearest(cover, line).candidate(); }

/// True when some sample lies within δ of the point. `slack` is for the rounding of the point.
bool near_sample(const Cover& cover, const glm::dvec3& point, double slack, std::uint32_t index = 0) {
  const Ball& ball = cover.balls[index];
  const double limit = cover.delta + slack;
  if (glm::length(ball.center - point) > ball.radius + limit) return false;
  if (ball.right != 0)
    return near_sample(cover, point, slack, index + 1) || near_sample(cover, point, slack, ball.right);
  return std::any_of(cover.samples.begin() + ball.first, cover.samples.begin() + ball.last,
                     [&](const glm::dvec3& sample) { return glm::length(sample - point) <= limit; });
}

/// The slack for the rounding of distances: 2⁻⁴⁰ of the lengths at hand, which a few dozen roundings do not reach.
double rounding(const Cover& cover, const Line& line) {
  const Ball& all = cover.balls.front();
  return 0x1p-40 * (glm::length(line.p - all.center) + all.radius);
}

/// The point that a claim speaks of: of a segment that starts at the origin, the origin.
glm::dvec3 claimed_point(const Line& line, const scene::Hit& claim) {
  return claim.resultado == model::Resultado::hit ? claim.punto : line.p;
}

[[noreturn]] void out_of_range(const std::string& what, double value, const std::string& expected) {
  throw std::domain_error(fmt::format("{} {}; expected {} (the sampled oracle's range)", what, value, expected));
}

void require_range(const Parametrisation& surface, const model::Elemento& e) {
  for (const double length : {surface.widest(), surface.length()}) {
    if (!(length >= least_length && length <= greatest_length)) {
      out_of_range(fmt::format("element {} has a length of", e.name()), length,
                   fmt::format("lengths from {} to {}", least_length, greatest_length));
    }
  }
  const glm::dvec3& center = surface.center();
  for (const double x : {center.x, center.y, center.z}) {
    if (std::abs(x) > greatest_length) {
      out_of_range(fmt::format("element {} has a coordinate of", e.name()), x,
                   fmt::format("coordinates up to {}", greatest_length));
    }
  }
}

Line checked_line(const model::Rayo& ray) {
  for (const double x : {ray.p().x(), ray.p().y(), ray.p().z()}) {
    if (std::abs(x) > greatest_origin) {
      out_of_range("a ray's origin has a coordinate of", x, fmt::format("coordinates up to {}", greatest_origin));
    }
  }
  return Line(ray);
}

/// How much wider than what stands about it a patch is.
constexpr double patch_width = 8;

/// The radius of the patch of a plane about this point: far enough for every other element of the scene, and their
/// shadows from most directions.
double patch_about(const scene::Scene& scene, const glm::dvec3& centro) {
  double farthest = 0;
  scene.for_each([&](scene::ElementRef, const auto& shape) {
    const Parametrisation other = shape;
    if (!other.is_patch()) farthest = std::max(farthest, glm::length(other.center() - centro) + other.size());
  });
  return farthest == 0 ? Parametrisation::default_patch : std::min(patch_width * farthest, greatest_length);
}

/// Whether the point is one of a plane beyond its patch, which has no samples.
bool beyond_patch(const Parametrisation& surface, const glm::dvec3& point, double slack) {
  return surface.is_patch() && glm::length(point - surface.center()) + slack > surface.widest();
}

bool names(const scene::Hit& claim, scene::ElementRef element) {
  return std::find(claim.elementos.begin(), claim.elementos.end(), element) != claim.elementos.end();
}

}  // namespace

std::string_view name(Verdict verdict) noexcept {
  constexpr std::array<std::string_view, verdict_count> names{"agrees", "grazing",    "rim",
                                                              "origin", "incomplete", "unsound"};
  return names[static_cast<std::size_t>(verdict)];
}

Oracle::Oracle(const scene::Scene& scene, double fineness) {
  elements_.reserve(scene.size());
  scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
    const double patch = [&] {
      if constexpr (std::is_same_v<Shape, scene::Plane>) return patch_about(scene, shape.centro);
      return 0.0;
    }();
    const Parametrisation surface(scene::ShapeView(shape), patch);
    require_range(surface, scene.name(e));
    elements_.push_back({e, surface, cover(surface, fineness)});
  });
}

std::vector<Ball> Oracle::bounds() const {
  std::vector<Ball> balls;
  balls.reserve(elements_.size());
  for (const Element& element : elements_) balls.push_back(element.cover.balls.front());
  return balls;
}

scene::Hit Oracle::first_hit(const model::Rayo& ray) const {
  const Line line = checked_line(ray);
  scene::Hit hit;
  double best = infinity;
  for (const Element& element : elements_) {
    const auto candidate = nearest(element.cover, line);
    if (!candidate || candidate->distance >= best) continue;
    best = candidate->distance;
    hit = {model::Resultado::hit, line.parameter(best), candidate->sample, {element.ref}};
  }
  return hit;
}

Verdict Oracle::judge(const model::Rayo& ray, const scene::Hit& claimed) const {
  const Line line = checked_line(ray);
  const glm::dvec3 point = claimed_point(line, claimed);
  const double claim = claimed.resultado == model::Resultado::miss ? infinity : glm::length(point - line.p);
  Verdict verdict = Verdict::agrees;
  for (const Element& element : elements_) {
    const Cover& cover = element.cover;
    const double slack = rounding(cover, line);
    const bool is_covered = !beyond_patch(element.surface, point, slack);
    if (names(claimed, element.ref) && is_covered && !near_sample(cover, point, slack)) return Verdict::incomplete;
    const auto candidate = nearest(cover, line);
    if (!candidate || claim <= candidate->distance + 8 * cover.delta + slack) continue;
    const Verdict reason = crossing(element.surface, line, claim, cover.delta / 1024, slack);
    if (reason == Verdict::unsound) return reason;
    verdict = std::max(verdict, reason);
  }
  return verdict;
}

}  // namespace durero::oracle::sampled
