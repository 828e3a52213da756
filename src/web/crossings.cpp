#include "crossings.hpp"

#include <algorithm>

#include "durero/composed/figure.hpp"
#include "durero/scene/body.hpp"
#include "durero/surface/exact.hpp"
#include "durero/surface/normal.hpp"

namespace durero::web {
namespace {

using Kind = ElementCrossing::Kind;

void add_reach(std::vector<ElementCrossing>& all, scene::ElementRef element, const surface::exact::Reach& reach) {
  if (reach.segment) all.push_back({element, Kind::segment, reach.segment->begin, reach.segment->end});
  for (const Parameter& t : reach.points()) all.push_back({element, Kind::point, t, t});
}

void add_body(std::vector<ElementCrossing>& all, scene::ElementRef element, const scene::Body& body,
              const model::Rayo& rayo, bool on) {
  const auto figure = composed::figure(body);
  if (const auto met = figure->parameters(rayo, on, surface::exact::RayStretch::whole)) {
    for (const Parameter& t : *met) all.push_back({element, Kind::point, t, t});
    return;
  }
  all.push_back({element, Kind::along, figure->first(rayo, on).t, std::nullopt});
}

}  // namespace

bool begins_before(const ElementCrossing& a, const ElementCrossing& b) {
  if (!a.t || !b.t) return !a.t && b.t;
  return surface::exact::order(*a.t, *b.t) < 0;
}

Crossings crossings_of(const scene::Scene& scene, const scene::Query& query) {
  Crossings found;
  trace::Counts counts;
  const scene::Origin en(query.en);
  const trace::Search search(scene, query.rayo, en, counts);
  scene.for_each([&](scene::ElementRef element, const auto&) {
    if (const scene::Body* const body = scene.body(element))
      return add_body(found.all, element, *body, query.rayo, en.contains(element));
    trace::Meeting met = search.meeting(element, trace::no_limit);
    if (met.kind != trace::Meeting::Kind::none)
      add_reach(found.all, element, surface::exact::reach(scene, element, query.rayo, en));
    found.decisions.push_back({element, std::move(met)});
  });
  std::ranges::stable_sort(found.all, begins_before);
  return found;
}

glm::dvec3 normal_of(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  if (const scene::Body* const body = scene.body(element)) return composed::figure(*body)->normal(point);
  return surface::normal(scene, element, point);
}

}  // namespace durero::web
