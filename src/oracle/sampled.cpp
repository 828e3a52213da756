#include "durero/oracle/sampled.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace durero::oracle::sampled {
namespace {

using model::Tipo;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The ray at unit speed.
struct Line {
  explicit Line(const model::Rayo& ray)
      : p(ray.p().xyz()), speed(glm::length(ray.v().xyz())), v(ray.v().xyz() / speed) {}
  glm::dvec3 p;
  double speed;
  glm::dvec3 v;
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
    const double along = glm::dot(to_center, line_.v);
    const glm::dvec3 apart = to_center - line_.v * std::max(0.0, along);
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
      const double foot = std::max(0.0, glm::dot(q, line_.v));
      const glm::dvec3 apart = q - line_.v * foot;
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

/// potencia along the ray, around a point x of it: a·u² + 2b·u + c; and s + u·s_step, the advance along the axis.
struct Local {
  double a, b, c;
  double s = 0, s_step = 0, altura = infinity;  // a sphere has no rim, so its altura is infinite
};

Local expand(const scene::Sphere& e, const glm::dvec3& x, const glm::dvec3& v) {
  const glm::dvec3 q = x - e.centro;
  return {1, glm::dot(q, v), glm::dot(q, q) - e.radio * e.radio};
}

/// Of the square of the distance from the axis, as the printed text has it: |q − s·d|².
template <class Axial>
Local expand_distance(const Axial& e, const glm::dvec3& x, const glm::dvec3& v) {
  const glm::dvec3 q = x - e.centro;
  const double s = glm::dot(q, e.vector), s_step = glm::dot(v, e.vector);
  const glm::dvec3 away = q - e.vector * s, step = v - e.vector * s_step;
  return {glm::dot(step, step), glm::dot(away, step), glm::dot(away, away), s, s_step, e.altura};
}

Local expand(const scene::Cylinder& e, const glm::dvec3& x, const glm::dvec3& v) {
  Local local = expand_distance(e, x, v);
  local.c -= e.radio * e.radio;
  return local;
}

Local expand(const scene::Cone& e, const glm::dvec3& x, const glm::dvec3& v) {
  Local local = expand_distance(e, x, v);
  const double k = e.proporcion, left = e.altura - local.s;
  local.a -= k * k * local.s_step * local.s_step;
  local.b += k * k * left * local.s_step;
  local.c -= k * k * left * left;
  return local;
}

/// The slack for the rounding of distances: 2⁻⁴⁰ of the lengths at hand, which a few dozen roundings do not reach.
double rounding(const Cover& cover, const Line& line) {
  const Ball& all = cover.balls.front();
  return 0x1p-40 * (glm::length(line.p - all.center) + all.radius);
}

/// Why the ray need not meet the element near the candidate's foot; `unsound` where nothing explains it.
Verdict explain(const scene::Scene& scene, scene::ElementRef ref, const Cover& cover, const Line& line, double foot) {
  const double slack = rounding(cover, line);
  const double delta = cover.delta, eta = reach_ratio * delta;
  const Local at = scene.visit(ref, [&](const auto& shape) { return expand(shape, line.p + line.v * foot, line.v); });
  const double discriminant = at.b * at.b - at.a * at.c;
  if (discriminant < std::pow(cover.gradient / reach_ratio, 2)) return Verdict::grazing;
  const double root = at.c / -(at.b + std::copysign(std::sqrt(discriminant), at.b));  // the nearer root
  if (foot + root <= slack) return Verdict::origin;
  const double s = at.s + root * at.s_step;
  const double beyond = std::isinf(at.altura) ? -infinity : std::max(-s, s - at.altura);
  if (beyond >= -slack && beyond <= delta + eta + slack) return Verdict::rim;
  return Verdict::unsound;
}

/// The point that a claim speaks of: of a segment that starts at the origin, the origin.
glm::dvec3 claimed_point(const Line& line, const scene::Hit& claim) {
  return claim.resultado == model::Resultado::hit ? claim.punto : line.p;
}

bool names(const scene::Hit& claim, scene::ElementRef element) {
  return std::find(claim.elementos.begin(), claim.elementos.end(), element) != claim.elementos.end();
}

}  // namespace

std::string_view name(Verdict verdict) noexcept {
  constexpr std::string_view names[] = {"agrees", "grazing", "rim", "origin", "incomplete", "unsound"};
  return names[static_cast<int>(verdict)];
}

Oracle::Oracle(const scene::Scene& scene, double fineness) : scene_(scene) {
  elements_.reserve(scene.size());
  scene.for_each([&](scene::ElementRef ref, const auto& shape) { elements_.push_back({ref, cover(shape, fineness)}); });
}

std::vector<Ball> Oracle::bounds() const {
  std::vector<Ball> balls;
  balls.reserve(elements_.size());
  for (const Element& element : elements_) balls.push_back(element.cover.balls.front());
  return balls;
}

scene::Hit Oracle::first_hit(const model::Rayo& ray) const {
  const Line line(ray);
  scene::Hit hit;
  double best = infinity;
  for (const Element& element : elements_) {
    const auto candidate = nearest(element.cover, line);
    if (!candidate || candidate->distance >= best) continue;
    best = candidate->distance;
    hit = {model::Resultado::hit, best / line.speed, candidate->sample, {element.ref}};
  }
  return hit;
}

Verdict Oracle::judge(const model::Rayo& ray, const scene::Hit& claimed) const {
  const Line line(ray);
  const glm::dvec3 point = claimed_point(line, claimed);
  const double claim = claimed.resultado == model::Resultado::miss ? infinity : glm::length(point - line.p);
  Verdict verdict = Verdict::agrees;
  for (const Element& element : elements_) {
    const Cover& cover = element.cover;
    const double slack = rounding(cover, line);
    if (names(claimed, element.ref) && !near_sample(cover, point, slack)) return Verdict::incomplete;
    const auto candidate = nearest(cover, line);
    if (!candidate || claim <= candidate->distance + reach_ratio * cover.delta + slack) continue;
    const Verdict reason = explain(scene_, element.ref, cover, line, candidate->distance);
    if (reason == Verdict::unsound) return reason;
    verdict = std::max(verdict, reason);
  }
  return verdict;
}

}  // namespace durero::oracle::sampled
