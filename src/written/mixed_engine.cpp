#include "mixed_engine.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "durero/composed/engine.hpp"
#include "durero/scene/remainder.hpp"

namespace durero::written {
namespace {

using model::Resultado;
using scene::ElementRef;
using scene::Hit;
using scene::Query;
using surface::exact::ElementPoint;

class MixedEngine final : public engine::Engine {
 public:
  MixedEngine(const scene::Scene& scene, std::vector<SurfaceElement> surfaces)
      : surfaces_(std::move(surfaces)),
        others_({scene}, [&](ElementRef e) { return surface_of(e) != nullptr; }),
        of_others_(composed::prepared(*engine::find(engine::default_engine), others_.scene().scene)) {}

  void first_hits(std::span<const Query> queries, std::span<Hit> hits) const override {
    const std::vector<Query> own = others_.queries(queries);
    of_others_->first_hits(own, hits);
    tbb::parallel_for(std::size_t{0}, queries.size(),
                      [&](std::size_t i) { hits[i] = first_hit(queries[i], own[i], std::move(hits[i])); });
  }

  void occluded_segments(std::span<const Query> queries, std::span<bool> occluded) const override {
    of_others_->occluded_segments(others_.queries(queries), occluded);
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      const Query& query = queries[i];
      occluded[i] = occluded[i] || std::ranges::any_of(surfaces_, [&](const SurfaceElement& element) {
                      return element.surface.hides(query.rayo, element.has_origin_of(query));
                    });
    });
  }

  std::optional<std::vector<ElementPoint>> points_between(const scene::Scene& scene, const Query& query,
                                                          surface::exact::RayStretch stretch,
                                                          const surface::exact::Passes& passes) const override {
    auto points = of_others_->points_between(others_.scene().scene, others_.query(query), stretch,
                                             [&](ElementRef e) { return passes(others_.element(e)); });
    if (!points) return std::nullopt;
    for (ElementPoint& each : *points) each.element = others_.element(each.element);
    if (!add_points(surfaces_, query, stretch, passes, *points)) return std::nullopt;
    std::ranges::stable_sort(*points, {}, [&](const ElementPoint& each) { return scene.name(each.element); });
    return points;
  }

  glm::dvec3 normal(const scene::Scene& scene, ElementRef element, const glm::dvec3& point) const override {
    if (const SurfaceElement* const own = surface_of(element)) return own->surface.normal(point);
    const ElementRef other = others_.scene().scene.find(scene.name(element).name()).value();
    return of_others_->normal(others_.scene().scene, other, point);
  }

 private:
  /// The element at that place, where the text defines it; otherwise null.
  const SurfaceElement* surface_of(ElementRef place) const {
    const auto found = std::ranges::lower_bound(surfaces_, place, {}, &SurfaceElement::place);
    return found != surfaces_.end() && found->place == place ? &*found : nullptr;
  }

  /// The nearest of what the ray meets of the others, and of the surfaces. A parameter that is less when rounded is
  /// less; where both round to one number, exact ones decide.
  Hit first_hit(const Query& query, const Query& own, Hit of_others) const {
    SurfaceSearch search(query);
    for (const SurfaceElement& element : surfaces_) search.ask(element);
    const scene::ElementSet met = std::exchange(of_others.elementos, others_.elements(of_others.elementos));
    if (search.empty()) return of_others;
    if (of_others.resultado == Resultado::hit) {
      const std::optional<double> t = search.rounded_t();
      if (t && of_others.t < *t) return of_others;
      if (!t || of_others.t == *t) {
        const auto exactly = composed::first_parameter(others_.scene().scene, own, met[0]);
        for (const ElementRef e : of_others.elementos) search.meet(e, exactly);
      }
    }
    if (of_others.resultado == Resultado::no_minimum)
      for (const ElementRef e : of_others.elementos) search.approach(e, std::nullopt);
    return search.hit();
  }

  std::vector<SurfaceElement> surfaces_;  // ascending
  scene::Remainder others_;
  std::unique_ptr<const engine::Engine> of_others_;
};

}  // namespace

std::unique_ptr<const engine::Engine> mixed_engine(const scene::Scene& scene, std::vector<SurfaceElement> surfaces) {
  return std::make_unique<const MixedEngine>(scene, std::move(surfaces));
}

}  // namespace durero::written
