#include "conform/families/asked_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace durero::conform {
namespace {

double longest(const glm::dvec3& w) { return std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)}); }

/// A t of the order of the ray's way, where it meets nothing.
double usual_t(const scene::Query& ray) { return (1 + longest(ray.rayo.p().xyz())) / longest(ray.rayo.v().xyz()); }

/// The ends of ranges of a ray, in a format.
class RangeDraw {
 public:
  RangeDraw(NumberFormat numbers, Random& random) : is_narrow_(numbers == NumberFormat::binary32), random_(&random) {}

  double rounded(double t) const { return is_narrow_ ? static_cast<double>(static_cast<float>(t)) : t; }
  /// An end so near to t that the last bits decide, or a quarter of it away.
  double near(double t) { return rounded(t * (1 + random_->signed_power(is_narrow_ ? -22 : -50, -2))); }
  double far_behind(double t) { return rounded(t * std::ldexp(1, random_->integer(1, 20))); }
  double before(double t) { return rounded(t * random_->uniform(0, 1)); }

  double end_of_shadow(double at) {
    const std::size_t which = random_->below(4);
    const double end = which == 0 ? far_behind(at) : which == 1 ? before(at) : near(at);
    return std::isfinite(end) && end > 0 ? end : 1;
  }

  /// A range beside crossings, ascending; there are some.
  AskedRange range(const std::vector<double>& crossings) {
    const std::size_t first = random_->below(crossings.size());
    const std::size_t last = first + random_->below(crossings.size() - first);
    const double from = crossings[first], to = crossings[last];
    switch (random_->below(8)) {
      case 0:
        return {0, end_of_shadow(from)};
      case 1:
        return {before(from), far_behind(to)};
      case 2:
        return {rounded(from), random_->chance(1, 2) ? rounded(to) : far_behind(to)};
      case 3:
        return {near(to), near(from)};  // empty in most cases where there are several
      case 4:
        return between(crossings, first);
      case 5:
        return {near(from), far_behind(to)};
      default:
        return {near(from), near(to)};
    }
  }

 private:
  /// Between a crossing and the next, or behind the last.
  AskedRange between(const std::vector<double>& crossings, std::size_t first) {
    const double from = crossings[first];
    const double to = first + 1 < crossings.size() ? crossings[first + 1] : 2 * from;
    const auto within = [&] { return rounded(from + random_->uniform(0, 1) * (to - from)); };
    return {within(), within()};
  }

  bool is_narrow_;
  Random* random_;
};

/// The range with ends that are numbers.
AskedRange made_finite(AskedRange range) {
  const auto finite = [](double& end, double otherwise) {
    if (!std::isfinite(end) || end < 0) end = otherwise;
  };
  finite(range.begin, 0);
  finite(range.end, 1);
  return range;
}

}  // namespace

std::vector<AskedRange> shadow_ranges(const SuiteCase& of, NumberFormat numbers, Random& random) {
  RangeDraw draw(numbers, random);
  std::vector<AskedRange> all;
  for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
    const scene::Hit& hit = of.truths[ray].hit;
    const double at = hit.resultado == model::Resultado::hit ? hit.t : usual_t(of.the_case.rays[ray]);
    all.push_back({0, draw.end_of_shadow(at)});
  }
  return all;
}

std::vector<AskedRange> ranges_near_crossings(const SuiteCase& of, NumberFormat numbers, Random& random) {
  const SceneTruths truths(of.the_case.scene, of.the_case.rays.size(), of.bodies);
  RangeDraw draw(numbers, random);
  std::vector<AskedRange> all;
  for (const scene::Query& ray : of.the_case.rays) {
    std::vector<double> crossings = truths.crossings(ray);
    std::erase_if(crossings, [](double t) { return !std::isfinite(t) || t == 0; });
    if (crossings.empty()) crossings = {usual_t(ray)};
    all.push_back(made_finite(draw.range(crossings)));
  }
  return all;
}

}  // namespace durero::conform
