#include "durero/oracle/sampled.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "crossing.hpp"
#include "element_surface.hpp"
#include "nearest.hpp"

namespace durero::oracle::sampled {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// The slack for the rounding of distances: 2⁻⁴⁰ of the lengths at hand, which a few dozen roundings do not reach.
double rounding(const BallNode& all, const ScaledRay& line) {
  return 0x1p-40 * (glm::length(line.p - all.center) + all.radius);
}

/// The point that a claim speaks of: of a segment that starts at the origin, the origin.
glm::dvec3 claimed_point(const ScaledRay& line, const scene::Hit& claim) {
  return claim.resultado == model::Resultado::hit ? claim.punto : line.p;
}

ScaledRay checked_line(const model::Rayo& ray) {
  for (const double x : {ray.p().x(), ray.p().y(), ray.p().z()}) {
    if (std::abs(x) > greatest_origin) {
      out_of_range("a ray's origin has a coordinate of", x, fmt::format("coordinates up to {}", greatest_origin));
    }
  }
  return ScaledRay(ray);
}

bool contains(const scene::ElementSet& elements, scene::ElementRef element) {
  return std::ranges::find(elements, element) != elements.end();
}

bool names(const scene::Hit& claim, scene::ElementRef element) { return contains(claim.elementos, element); }

/// Whether one of these has a line that samples of the element may be near.
template <class WithLine>
bool is_near_any(const ElementSurface& element, const std::vector<WithLine>& all) {
  return std::ranges::any_of(all, [&](const WithLine& one) {
    return may_hold_candidate(element.outline.ball, element.outline.delta, one.line);
  });
}

}  // namespace

std::string_view name(SampledVerdict verdict) noexcept {
  constexpr std::array<std::string_view, verdict_count> names{"agrees", "grazing",    "rim",
                                                              "origin", "incomplete", "unsound"};
  return names[static_cast<std::size_t>(verdict)];
}

struct Oracle::Part {
  std::span<const ElementSurface> elements;
  std::span<const Cover> covers;
};

struct Oracle::Judged {
  Judged(const model::Rayo& ray, const scene::Hit& claimed)
      : line(checked_line(ray)),
        claim(&claimed),
        point(claimed_point(line, claimed)),
        distance(claimed.resultado == model::Resultado::miss ? endless : glm::length(point - line.p)) {}

  void hold_against(const Part& part) {
    for (std::size_t i = 0; i < part.elements.size() && agrees(verdict); ++i)
      verdict = std::max(verdict, verdict_of(part.elements[i], part.covers[i]));
  }

  SampledVerdict verdict_of(const ElementSurface& element, const Cover& cover) {
    const bool is_named = names(*claim, element.ref);
    const bool is_near = may_hold_candidate(element.outline.ball, element.outline.delta, line);
    if (!is_named && !is_near) return SampledVerdict::agrees;
    const double slack = rounding(element.outline.ball, line);
    if (is_named && !holds_point(element, cover, slack)) return SampledVerdict::incomplete;
    const auto candidate = nearest(cover, line);
    if (!candidate || distance <= candidate->distance + 8 * cover.delta + slack) return SampledVerdict::agrees;
    return crossing(element, line, distance, cover.delta / 1024, slack);
  }

  /// Whether the point may be one of the element's. Of a solid one surface with a sample near is enough, and all of
  /// them are asked before the verdict.
  bool holds_point(const ElementSurface& element, const Cover& cover, double slack) {
    const bool is_covered = !element.surface.goes_on_at(point, slack);
    const bool may_be_near = !is_covered || near_sample(cover, point, slack);
    if (!element.solid) return may_be_near;
    if (!contains(solids, element.ref)) solids.push_back(element.ref);
    if (may_be_near && !contains(near_solids, element.ref)) near_solids.push_back(element.ref);
    return element.solid->may_have(point, slack);
  }

  /// The verdict when all surfaces were held against it: each solid that the claim names has a sample near.
  SampledVerdict decided() const {
    return solids.size() == near_solids.size() ? verdict : std::max(verdict, SampledVerdict::incomplete);
  }

  ScaledRay line;
  const scene::Hit* claim;
  glm::dvec3 point;
  double distance;
  SampledVerdict verdict = SampledVerdict::agrees;
  scene::ElementSet solids{}, near_solids{};  // that the claim names; that have a sample near its point
};

struct Oracle::First {
  explicit First(const model::Rayo& ray) : line(checked_line(ray)) {}

  void look_among(const Part& part) {
    for (std::size_t i = 0; i < part.elements.size(); ++i) {
      const ElementSurface& element = part.elements[i];
      if (!may_hold_candidate(element.outline.ball, element.outline.delta, line, distance)) continue;
      const auto candidate = nearest(part.covers[i], line);
      if (!candidate || candidate->distance >= distance) continue;
      distance = candidate->distance;
      hit = {model::Resultado::hit, line.parameter(distance), candidate->sample, {element.ref}};
    }
  }

  ScaledRay line;
  double distance = endless;
  scene::Hit hit;
};

Oracle::Oracle(const scene::Scene& scene, double fineness, std::size_t most_bytes)
    : fineness_(fineness), most_bytes_(most_bytes), elements_(surfaces_of(scene, fineness)) {
  if (end_of_part(0) < elements_.size()) return;
  kept_ = covers(elements_, [](const ElementSurface&) { return true; });
}

Oracle::~Oracle() = default;

std::vector<BallNode> Oracle::bounds() const {
  std::vector<BallNode> balls;
  balls.reserve(elements_.size());
  for (const ElementSurface& element : elements_) balls.push_back(element.outline.ball);
  return balls;
}

std::size_t Oracle::end_of_part(std::size_t first) const {
  std::size_t last = first, bytes = 0;
  while (last < elements_.size() && (last == first || elements_[last].outline.bytes <= most_bytes_ - bytes))
    bytes += elements_[last++].outline.bytes;
  return last;
}

template <class IsWanted>
std::vector<Cover> Oracle::covers(std::span<const ElementSurface> of, IsWanted is_wanted) const {
  std::vector<Cover> made(of.size());
  tbb::parallel_for(std::size_t{0}, of.size(), [&](std::size_t i) {
    if (is_wanted(of[i])) made[i] = of[i].cover(fineness_);
  });
  return made;
}

template <class Visit, class IsWanted>
void Oracle::for_each_part(Visit visit, IsWanted is_wanted) const {
  if (!kept_.empty()) return visit(Part{elements_, kept_});
  for (std::size_t first = 0; first < elements_.size();) {
    const std::size_t last = end_of_part(first);
    const auto elements = std::span(elements_).subspan(first, last - first);
    const std::vector<Cover> made = covers(elements, is_wanted);
    visit(Part{elements, made});
    first = last;
  }
}

void Oracle::first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const {
  std::vector<First> first;
  first.reserve(queries.size());
  for (const scene::Query& query : queries) first.emplace_back(query.rayo);
  const auto look = [&](const Part& part) {
    tbb::parallel_for(std::size_t{0}, first.size(), [&](std::size_t i) { first[i].look_among(part); });
  };
  for_each_part(look, [&](const ElementSurface& element) { return is_near_any(element, first); });
  for (std::size_t i = 0; i < first.size(); ++i) hits[i] = std::move(first[i].hit);
}

std::vector<SampledVerdict> Oracle::judge(std::span<const scene::Query> queries, std::span<const scene::Hit> claimed,
                                          const Done& done) const {
  std::vector<Judged> judged;
  judged.reserve(queries.size());
  std::vector<scene::ElementRef> named;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    judged.emplace_back(queries[i].rayo, claimed[i]);
    named.insert(named.end(), claimed[i].elementos.begin(), claimed[i].elementos.end());
  }
  std::ranges::sort(named);
  const auto hold = [&](const Part& part) {
    const auto some = [&](const tbb::blocked_range<std::size_t>& of) {
      for (std::size_t i = of.begin(); i < of.end(); ++i) judged[i].hold_against(part);
      done(of.size() * part.elements.size());
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, judged.size()), some);
  };
  for_each_part(hold, [&](const ElementSurface& element) {
    return std::ranges::binary_search(named, element.ref) || is_near_any(element, judged);
  });
  std::vector<SampledVerdict> verdicts;
  for (const Judged& one : judged) verdicts.push_back(one.decided());
  return verdicts;
}

scene::Hit Oracle::first_hit(const model::Rayo& ray) const {
  const scene::Query query{ray, {}};
  scene::Hit hit;
  first_hits({&query, 1}, {&hit, 1});
  return hit;
}

SampledVerdict Oracle::judge(const model::Rayo& ray, const scene::Hit& claimed) const {
  const scene::Query query{ray, {}};
  return judge({&query, 1}, {&claimed, 1}).front();
}

}  // namespace durero::oracle::sampled
