#include "conform/draft.hpp"

#include <algorithm>
#include <cmath>

namespace durero::conform {
namespace {

bool is_disc_of_solid(const SuiteCase& of, scene::ElementRef e) {
  return std::ranges::any_of(of.solids, [&](const Solid& solid) { return std::ranges::count(solid.discs, e) > 0; });
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Draft::Draft(const SuiteCase& of) : p(of.the_case.rays[0].rayo.p().xyz()), v(of.the_case.rays[0].rayo.v().xyz()) {
  const scene::Scene& scene = of.the_case.scene;
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (!is_disc_of_solid(of, e)) elements.push_back({std::string(scene.name(e).name()), shape});
  });
  for (const scene::ElementRef e : of.the_case.rays[0].en) on.emplace_back(scene.name(e).name());
}

std::optional<SuiteCase> Draft::built(const SuiteCase& like) const {
  if (!is_finite(p) || !is_finite(v) || v == glm::dvec3(0)) return std::nullopt;
  SuiteCase of{.family = like.family, .number = like.number, .parameter = like.parameter, .the_case = {}};
  for (const Element& element : elements) {
    const model::Operation addition = std::visit(
        [&](const auto& shape) { return model::Operation(scene::addition(model::Elemento(element.name), shape)); },
        element.shape);
    if (!of.the_case.scene.apply_total(addition).ok()) return std::nullopt;
  }
  scene::Query ray{{model::Punto(p), model::Vector(v)}, {}};
  for (const std::string& name : on) {
    if (const auto e = of.the_case.scene.find(name)) ray.en.push_back(*e);
  }
  std::ranges::sort(ray.en);
  of.the_case.rays.push_back(std::move(ray));
  answer(of);
  return of;
}

Places places(AnyShape& any) {
  Places all;
  const auto add = [&]<class Shape>(Shape& shape) {
    scene::for_each_attribute<Shape>([&]<class Row>(const Row& attribute) {
      auto& stored = shape.*attribute.field;
      if constexpr (std::is_same_v<typename Row::Stored, scene::Corners>) {
        for (glm::dvec3& corner : stored) all.points.push_back(&corner);
      } else if constexpr (std::is_same_v<typename Row::Input, model::Punto>) {
        all.points.push_back(&stored);
      } else if constexpr (std::is_same_v<typename Row::Input, model::Vector>) {
        all.axes.push_back(&stored);
      } else {
        const bool is_ratio = attribute.component == &model::Escena::mi_proporcion;
        (is_ratio ? all.ratios : all.lengths).push_back(&stored);
      }
    });
  };
  std::visit(add, any);
  return all;
}

}  // namespace durero::conform
