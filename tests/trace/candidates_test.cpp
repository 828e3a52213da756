// Any source that passes over nothing gives the exact answer, whatever it adds and in whatever order.
#include "durero/trace/candidates.hpp"

#include <algorithm>
#include <numeric>

#include "durero/surface/exact.hpp"
#include "durero/trace/tables.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

namespace {

/// Every element for every ray, in an order that is drawn; some ordinary ones are among the extraordinary.
class Shuffled {
 public:
  explicit Shuffled(const scene::Scene& scene) : scene_(&scene) {
    scene.for_each([&](ElementRef e, const auto& shape) {
      (trace::ordinary(shape) && *rc::gen::inRange(0, 8) != 0 ? elements_ : extraordinary_).push_back(e);
    });
    for (std::size_t i = 1; i < elements_.size(); ++i) {
      std::swap(elements_[i], elements_[*rc::gen::inRange<std::size_t>(0, i + 1)]);
    }
  }

  const scene::Scene& scene() const { return *scene_; }
  std::span<const ElementRef> extraordinary() const { return extraordinary_; }

  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit, Visit visit) const {
    REQUIRE(ray.ordinary);
    return std::any_of(elements_.begin(), elements_.end(), visit);
  }

  /// Element by element, so that packets mix the rays.
  template <class Limit, class Visitor, class Flush>
  void pairs(std::span<const trace::Ray> rays, Limit limit, Visitor take, Flush flush) const {
    for (const ElementRef e : elements_) {
      for (std::uint32_t number = 0; number < rays.size(); ++number) {
        if (limit(number) > 0) take(number, e);
      }
      if (e.index % 2 == 0) flush();
    }
  }

  void visit(ElementRef own, auto visit) const { scene_->visit(own, visit); }
  ElementRef element(ElementRef own) const { return own; }
  ElementRef own(ElementRef e) const { return e; }
  void ask_for_own(ElementRef) const {}
  void ask_for_shape(ElementRef) const {}

 private:
  const scene::Scene* scene_;
  std::vector<ElementRef> elements_, extraordinary_;
};
static_assert(trace::Candidates<Shuffled>);
static_assert(trace::Candidates<trace::Tables>);
static_assert(!trace::Candidates<scene::Scene>);

bool finite(const glm::dvec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

/// Rays, and rays from their hits that start on the elements hit.
std::vector<scene::Query> queries_of(const scene::Scene& scene, const Reals& numbers) {
  std::vector<scene::Query> queries;
  for (int i = 0; i < 8; ++i) {
    queries.push_back({*rays(numbers), {}});
    const scene::Hit hit = surface::exact::first_hit(scene, queries.back().rayo);
    if (hit.resultado != model::Resultado::hit || !finite(hit.punto)) continue;
    queries.push_back({{model::Punto(hit.punto), (*rays(numbers)).v()}, hit.elementos});
  }
  return queries;
}

void check_source(const Reals& numbers) {
  const scene::Scene scene = some_of_each(numbers, 3);
  const Shuffled source(scene);
  const std::vector<scene::Query> queries = queries_of(scene, numbers);
  std::vector<scene::Hit> hits(queries.size(), {.resultado = model::Resultado::no_minimum, .elementos = {{}}});
  trace::Counts alone, together;
  trace::first_hits_among(source, queries, hits, &together);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto& [rayo, en] = queries[i];
    const scene::Hit exact = surface::exact::first_hit(scene, rayo, en);
    RC_ASSERT(trace::first_hit_among(source, rayo, en, alone) == exact);
    RC_ASSERT(hits[i] == exact);
    RC_ASSERT(trace::occluded_among(source, rayo, en, alone) == surface::exact::occluded(scene, rayo, en));
    RC_ASSERT(trace::occluded_segment_among(source, rayo, en, alone) ==
              surface::exact::occluded_segment(scene, rayo, en));
  }
  RC_ASSERT(std::accumulate(together.element.begin(), together.element.end(), std::uint64_t{0}) > 0);
}

}  // namespace

TEST_CASE("the answers over any source of candidates are the exact ones") {
  property("ordinary scenes", [] { check_source(moderate()); });
  property("grids, where coincidences are frequent", [] { check_source(dyadicGrid()); });
  property("the whole range of binary64", [] { check_source(anyFinite()); });
}

namespace {

/// Passes over everything.
struct Nothing {
  const scene::Scene& of;
  const scene::Scene& scene() const { return of; }
  std::span<const ElementRef> extraordinary() const { return {}; }
  bool any(const trace::Ray&, auto, auto) const { return false; }
  void pairs(std::span<const trace::Ray>, auto, auto, auto) const {}
  void visit(ElementRef own, auto visit) const { of.visit(own, visit); }
  ElementRef element(ElementRef own) const { return own; }
  ElementRef own(ElementRef e) const { return e; }
  void ask_for_own(ElementRef) const {}
  void ask_for_shape(ElementRef) const {}
};
static_assert(trace::Candidates<Nothing>);

}  // namespace

TEST_CASE("an element that the ray starts on is asked though its source passes over it") {
  // The ray starts below the sphere's lowest point by a rounding, and is said to start on it.
  scene::Scene scene;
  const ElementRef sphere = add(scene, scene::Sphere{{0, 0, 0}, 1});
  const Nothing nothing{scene};
  trace::Counts counts;
  const model::Rayo up = ray({0, 0, -1 - 0x1p-52}, {0, 0, 1});
  CHECK(trace::first_hit_among(nothing, up, sphere, counts) == surface::exact::first_hit(scene, up, sphere));
  CHECK(trace::first_hit_among(nothing, up, sphere, counts).resultado == model::Resultado::hit);
  CHECK(trace::first_hit_among(nothing, up, {}, counts).resultado == model::Resultado::miss);
  CHECK(trace::occluded_among(nothing, up, sphere, counts));
}

TEST_CASE("blocks make up all queries, and run on every thread") {
  for (const std::size_t size : {0u, 1u, 255u, 256u, 257u, 1000u}) {
    std::vector<int> answered(size);
    trace::for_each_block(size, [&](std::size_t begin, std::size_t count) {
      for (std::size_t i = begin; i < begin + count; ++i) ++answered[i];
    });
    CHECK(std::count(answered.begin(), answered.end(), 1) == static_cast<std::ptrdiff_t>(size));
  }
}
