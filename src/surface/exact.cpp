#include "durero/surface/exact.hpp"

#include <algorithm>
#include <utility>

namespace durero::surface::exact {
namespace {

using model::Resultado;

/// The nearest point so far and the elements it lies on; the elements that have no nearest point.
struct NearestPoint {
  std::optional<Parameter> t;
  scene::ElementSet elementos, without_minimum;

  void take(scene::ElementRef e, const Reach& found) {
    if (found.empty()) return;
    if (found.no_minimum()) {
      without_minimum.push_back(e);
      return;
    }
    const auto against = t ? order(found.first(), *t) : std::strong_ordering::less;
    if (against > 0) return;
    if (against < 0) {
      t = found.first();
      elementos.clear();
    }
    elementos.push_back(e);
  }
};

/// The order of all_hits. An absent begin stands for t → 0⁺, before every parameter.
bool earlier(const Crossing& a, const Crossing& b) {
  if (!a.segment.begin || !b.segment.begin) {
    return std::pair(a.segment.begin.has_value(), a.elemento) < std::pair(b.segment.begin.has_value(), b.elemento);
  }
  const auto by_begin = order(*a.segment.begin, *b.segment.begin);
  return by_begin != 0 ? by_begin < 0 : a.elemento < b.elemento;
}

}  // namespace

Reach reach(const scene::Scene& scene, scene::ElementRef e, const model::Rayo& rayo, Origin en) {
  return scene.visit(e, [&](const auto& shape) { return reach(scene::ShapeView(shape), rayo, en.contains(e)); });
}

scene::Hit rounded_hit(const model::Rayo& rayo, const Parameter& t, scene::ElementSet elementos) {
  const auto coordinate = [&](double p, double v) { return number::round_to_binary64(number::linear(p, v, t)); };
  const glm::dvec3& p = rayo.p().xyz();
  const glm::dvec3& v = rayo.v().xyz();
  return {Resultado::hit,
          number::round_to_binary64(t),
          {coordinate(p.x, v.x), coordinate(p.y, v.y), coordinate(p.z, v.z)},
          std::move(elementos)};
}

scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  NearestPoint nearest;
  scene.for_each([&](scene::ElementRef e, const auto&) { nearest.take(e, reach(scene, e, rayo, en)); });
  if (!nearest.without_minimum.empty())
    return {.resultado = Resultado::no_minimum, .elementos = nearest.without_minimum};
  if (!nearest.t) return {};
  return rounded_hit(rayo, *nearest.t, std::move(nearest.elementos));
}

bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  return scene.any_of([&](scene::ElementRef e, const auto&) { return !reach(scene, e, rayo, en).empty(); });
}

bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  const Parameter one{.x = 1};
  return scene.any_of([&](scene::ElementRef e, const auto&) {
    const Reach found = reach(scene, e, rayo, en);
    return found.no_minimum() || (!found.empty() && order(found.first(), one) < 0);
  });
}

std::optional<std::vector<ElementPoint>> points_of(const scene::Scene& scene, scene::ElementSet elements,
                                                   const model::Rayo& rayo, Origin en, RayStretch stretch) {
  std::ranges::sort(elements, {}, [&](scene::ElementRef e) { return scene.name(e); });
  std::vector<ElementPoint> points;
  for (const scene::ElementRef e : elements) {
    const auto found = parameters_on(reach(scene, e, rayo, en), stretch);
    if (!found) return std::nullopt;
    for (const Parameter& t : *found) points.push_back({e, rounded_hit(rayo, t, {}).punto});
  }
  return points;
}

std::optional<std::vector<ElementPoint>> points_between(const scene::Scene& scene, const model::Rayo& rayo, Origin en,
                                                        RayStretch stretch, const Passes& passes) {
  scene::ElementSet met;
  const bool is_dark = scene.any_of([&](scene::ElementRef e, const auto&) {
    const Reach found = reach(scene, e, rayo, en);
    if (found.empty() || !(found.no_minimum() || lies_on(stretch, found.first()))) return false;
    met.push_back(e);
    return !passes(e);
  });
  return is_dark ? std::nullopt : points_of(scene, std::move(met), rayo, en, stretch);
}

std::vector<Crossing> all_hits(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  std::vector<Crossing> crossings;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    const Reach found = reach(scene, e, rayo, en);
    for (const Parameter& t : found.points()) crossings.push_back({e, {t, t}});
    if (found.segment) crossings.push_back({e, *found.segment});
  });
  std::stable_sort(crossings.begin(), crossings.end(), earlier);
  return crossings;
}

}  // namespace durero::surface::exact
