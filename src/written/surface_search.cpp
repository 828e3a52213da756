#include "surface_search.hpp"

#include <algorithm>
#include <utility>

namespace durero::written {
namespace {

using algebra::Root;
using number::Dyadic;
using scene::ElementRef;

glm::dvec3 point_at(const model::Rayo& rayo, const Root& t) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  glm::dvec3 point;
  for (int i = 0; i < 3; ++i) point[i] = algebra::rounded_linear(Dyadic(p[i]), Dyadic(v[i]), t);
  return point;
}

double rounded(const Root& t) { return algebra::rounded_linear(Dyadic(), Dyadic(1), t); }

}  // namespace

void SurfaceSearch::ask(const SurfaceElement& element) {
  First first = element.surface.first(query_.rayo, element.has_origin_of(query_));
  if (auto* const root = std::get_if<Root>(&first)) meet(element.place, std::move(*root));
  if (auto* const after = std::get_if<After>(&first)) approach(element.place, std::move(after->t));
}

void SurfaceSearch::meet(ElementRef place, Root t) {
  const auto order = nearest_ ? algebra::compare(t, *nearest_) : std::strong_ordering::less;
  if (order > 0) return;
  if (order < 0) {
    nearest_ = std::move(t);
    met_.clear();
  }
  met_.push_back(place);
}

void SurfaceSearch::approach(ElementRef place, std::optional<Root> from) {
  const bool is_less = without_.empty() || (bound_ && (!from || algebra::compare(*from, *bound_) < 0));
  if (is_less) bound_ = std::move(from);
  without_.push_back(place);
}

std::optional<double> SurfaceSearch::rounded_t() const {
  if (!nearest_ || !without_.empty()) return std::nullopt;
  return rounded(*nearest_);
}

scene::Hit SurfaceSearch::hit() const {
  const bool is_nearest = nearest_ && (without_.empty() || (bound_ && algebra::compare(*nearest_, *bound_) <= 0));
  if (is_nearest) return at(*nearest_);
  scene::Hit none;
  none.resultado = without_.empty() ? model::Resultado::miss : model::Resultado::no_minimum;
  none.elementos.assign(without_.begin(), without_.end());
  std::ranges::sort(none.elementos);
  return none;
}

scene::Hit SurfaceSearch::at(const Root& t) const {
  scene::Hit hit;
  hit.resultado = model::Resultado::hit;
  hit.t = rounded(t);
  hit.punto = point_at(query_.rayo, t);
  hit.elementos.assign(met_.begin(), met_.end());
  std::ranges::sort(hit.elementos);
  return hit;
}

bool add_points(std::span<const SurfaceElement> elements, const scene::Query& query, surface::exact::RayStretch stretch,
                const surface::exact::Passes& passes, std::vector<surface::exact::ElementPoint>& points) {
  const RayPart part = stretch == surface::exact::RayStretch::segment ? RayPart::to_one : RayPart::whole;
  return std::ranges::all_of(elements, [&](const SurfaceElement& element) {
    const auto met = element.surface.parameters(query.rayo, element.has_origin_of(query), part);
    if (!met || (!met->empty() && !passes(element.place))) return false;
    for (const Root& t : *met) points.push_back({element.place, point_at(query.rayo, t)});
    return true;
  });
}

}  // namespace durero::written
