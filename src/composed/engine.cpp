#include "durero/composed/engine.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "durero/accel/box_tree.hpp"
#include "durero/composed/figure.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/scene/remainder.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/ray.hpp"

namespace durero::composed {
namespace {

using model::Resultado;
using scene::ElementRef;
using scene::Hit;
using scene::Query;
using surface::exact::ElementPoint;
using surface::exact::RayStretch;

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The bodies of a scene, those with a finite box in a tree.
class BodyIndex {
 public:
  explicit BodyIndex(const scene::Scene& scene) {
    std::vector<surface::Box> boxes;
    std::vector<Body> apart;
    scene.for_each([&](ElementRef e, const auto&) {
      const scene::Body* const body = scene.body(e);
      if (body == nullptr) return;
      Body made{e, figure(*body)};
      const surface::Box box = made.figure->box();
      if (std::isfinite(box.low.x) && std::isfinite(box.high.x)) {
        boxes.push_back(box);
        all_.push_back(std::move(made));
      } else {
        apart.push_back(std::move(made));
      }
    });
    tree_ = accel::BoxTree(boxes);
    in_tree_ = all_.size();
    std::ranges::move(apart, std::back_inserter(all_));
    place_.resize(scene.shapes<scene::Sphere>().size());
    for (std::size_t i = 0; i < all_.size(); ++i) place_[all_[i].element.index] = i;
  }

  /// visit(element, figure, on) for each body that the ray may meet at 0 < t ≤ limit(), until it answers true.
  template <class Limit, class Visit>
  bool any(const Query& query, Limit limit, Visit visit) const {
    const trace::Ray ray(query.rayo);
    const scene::Origin en(query.en);
    const auto ask = [&](std::size_t i) {
      const bool on = en.contains(all_[i].element);
      return all_[i].figure->may_meet(query.rayo, on) && visit(all_[i].element, *all_[i].figure, on);
    };
    const bool is_ordinary = ray.ordinary;
    if (is_ordinary && tree_.any(ray, limit, ask)) return true;
    for (std::size_t i = is_ordinary ? in_tree_ : 0; i < all_.size(); ++i)
      if (ask(i)) return true;
    return false;
  }

  /// The figure of an element. Precondition: it has a body.
  const Figure& operator[](ElementRef element) const { return *all_[place_[element.index]].figure; }

 private:
  struct Body {
    ElementRef element;
    std::unique_ptr<const Figure> figure;
  };

  std::vector<Body> all_;  // first those of the tree
  std::size_t in_tree_ = 0;
  std::vector<std::size_t> place_;  // of the bodies, by their places among the spheres
  accel::BoxTree tree_;
};

/// The search of one ray among the bodies, beside what it meets first of the other elements. A parameter that is less
/// when rounded is less; where both round to one number, exact ones decide.
class NearestOfBoth {
 public:
  /// Begins with what the ray meets first of the elements of the tables.
  NearestOfBoth(const Query& query, Hit plain) : query_(query), plain_(std::move(plain)) {
    if (plain_.resultado == Resultado::hit) limit_ = plain_.t;
  }

  /// No body beyond this parameter can change the answer.
  double limit() const {
    return plain_.resultado == Resultado::no_minimum || !without_minimum_.empty() ? no_limit
                                                                                  : std::nextafter(limit_, no_limit);
  }

  void take(ElementRef element, const First& met) {
    if (met.no_minimum) without_minimum_.push_back(element);
    if (!met.t) return;
    const double t = round_to_binary64(*met.t);
    if (t > limit_) return;
    const auto order = t_ ? surface::exact::order(*met.t, *t_) : std::strong_ordering::less;
    if (order > 0) return;
    if (order < 0) {
      t_ = *met.t;
      elements_.clear();
      limit_ = t;
    }
    elements_.push_back(element);
  }

  /// The answer. `exactly()` is the exact parameter of the hit of the tables, where it is known.
  template <class Exactly>
  Hit hit(Exactly exactly) {
    const bool plain_has_none = plain_.resultado == Resultado::no_minimum;
    if (plain_has_none || !without_minimum_.empty()) {
      if (plain_has_none)
        without_minimum_.insert(without_minimum_.end(), plain_.elementos.begin(), plain_.elementos.end());
      std::ranges::sort(without_minimum_);
      return {.resultado = Resultado::no_minimum, .elementos = std::move(without_minimum_)};
    }
    if (!t_) return std::move(plain_);
    const auto order = plain_.resultado == Resultado::hit ? against(exactly) : std::strong_ordering::less;
    if (order > 0) return std::move(plain_);
    if (order == 0) elements_.insert(elements_.end(), plain_.elementos.begin(), plain_.elementos.end());
    std::ranges::sort(elements_);
    return surface::exact::rounded_hit(query_.rayo, *t_, std::move(elements_));
  }

 private:
  /// The order of the nearest body and the hit of the tables.
  template <class Exactly>
  std::strong_ordering against(Exactly exactly) const {
    const double t = round_to_binary64(*t_);
    if (t != plain_.t) return t < plain_.t ? std::strong_ordering::less : std::strong_ordering::greater;
    const std::optional<Parameter> other = exactly();
    return other ? surface::exact::order(*t_, *other) : std::strong_ordering::equal;
  }

  const Query& query_;
  Hit plain_;
  double limit_ = no_limit;  // of parameters, rounded
  std::optional<Parameter> t_;
  scene::ElementSet elements_, without_minimum_;
};

class ComposedEngine final : public engine::Engine {
 public:
  ComposedEngine(const engine::EngineRow& row, std::string_view hierarchy, const scene::GroupedScene& input)
      : is_exact_(row.exact_bytes),
        plain_(input, [&](ElementRef e) { return input.scene.body(e) != nullptr; }),
        of_plain_(engine::prepared(row, hierarchy, plain_.scene())),
        bodies_(input.scene) {}

  void first_hits(std::span<const Query> queries, std::span<Hit> hits) const override {
    const std::vector<Query> own = plain_.queries(queries);
    of_plain_->first_hits(own, hits);
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      Hit plain = std::move(hits[i]);
      const scene::ElementSet of_table = plain.elementos;
      plain.elementos = plain_.elements(of_table);
      hits[i] = first_hit(queries[i], std::move(plain), [&]() { return parameter(own[i], of_table); });
    });
  }

  void occluded_segments(std::span<const Query> queries, std::span<bool> occluded) const override {
    of_plain_->occluded_segments(plain_.queries(queries), occluded);
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      occluded[i] = occluded[i] ||
                    bodies_.any(
                        queries[i], [] { return 1.0; },
                        [&](ElementRef, const Figure& figure, bool on) { return figure.hides(queries[i].rayo, on); });
    });
  }

  std::optional<std::vector<ElementPoint>> points_between(const scene::Scene& scene, const Query& query,
                                                          RayStretch stretch,
                                                          const surface::exact::Passes& passes) const override {
    auto points = of_plain_->points_between(plain_.scene().scene, plain_.query(query), stretch,
                                            [&](ElementRef e) { return passes(plain_.element(e)); });
    if (!points) return std::nullopt;
    for (ElementPoint& each : *points) each.element = plain_.element(each.element);
    if (!add_points_of_bodies(query, stretch, passes, *points)) return std::nullopt;
    std::ranges::stable_sort(*points, {}, [&](const ElementPoint& each) { return scene.name(each.element); });
    return points;
  }

  glm::dvec3 normal(const scene::Scene& scene, ElementRef element, const glm::dvec3& point) const override {
    return scene.body(element) == nullptr ? Engine::normal(scene, element, point) : bodies_[element].normal(point);
  }

 private:
  template <class Exactly>
  Hit first_hit(const Query& query, Hit plain, Exactly exactly) const {
    NearestOfBoth nearest(query, std::move(plain));
    bodies_.any(
        query, [&] { return nearest.limit(); },
        [&](ElementRef element, const Figure& figure, bool on) {
          nearest.take(element, figure.first(query.rayo, on));
          return false;
        });
    return nearest.hit(exactly);
  }

  /// Adds the points of bodies on a stretch; false where a body passes no light, or the ray runs along one.
  bool add_points_of_bodies(const Query& query, RayStretch stretch, const surface::exact::Passes& passes,
                            std::vector<ElementPoint>& points) const {
    const double limit = stretch == RayStretch::segment ? 1 : no_limit;
    return !bodies_.any(
        query, [&] { return limit; },
        [&](ElementRef element, const Figure& figure, bool on) {
          const auto met = figure.parameters(query.rayo, on, stretch);
          if (!met || (!met->empty() && !passes(element))) return true;
          for (const Parameter& t : *met)
            points.push_back({element, surface::exact::rounded_hit(query.rayo, t, {}).punto});
          return false;
        });
  }

  /// The exact parameter of a hit of those elements; nothing where the engine does not answer exactly.
  std::optional<Parameter> parameter(const Query& own, const scene::ElementSet& of_table) const {
    if (!is_exact_) return std::nullopt;
    return first_parameter(plain_.scene().scene, own, of_table[0]);
  }

  bool is_exact_;
  scene::Remainder plain_;  // the elements without a body
  std::unique_ptr<const engine::Engine> of_plain_;
  BodyIndex bodies_;
};

}  // namespace

std::unique_ptr<const engine::Engine> prepared(const engine::EngineRow& row, std::string_view hierarchy,
                                               const scene::GroupedScene& input) {
  if (!input.scene.has_bodies()) return engine::prepared(row, hierarchy, input);
  return std::make_unique<const ComposedEngine>(row, hierarchy, input);
}

Parameter first_parameter(const scene::Scene& scene, const Query& query, ElementRef element) {
  if (const scene::Body* const body = scene.body(element))
    return figure(*body)->first(query.rayo, scene::Origin(query.en).contains(element)).t.value();
  return surface::exact::reach(scene, element, query.rayo, query.en).first();
}

std::unique_ptr<const engine::Engine> prepared(const engine::EngineRow& row, const scene::Scene& scene) {
  if (!scene.has_bodies()) return row.prepare(scene);
  return std::make_unique<const ComposedEngine>(row, engine::automatic, scene::GroupedScene{scene});
}

}  // namespace durero::composed
