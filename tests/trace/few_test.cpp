// The batch in columns gives the exact answers over few elements, whatever its rays start on and however many they are.
#include "durero/trace/few.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;

namespace {

/// All elements, by names of their own: the rows of each table backwards.
class Few {
 public:
  explicit Few(const scene::Scene& scene) : scene_(&scene) {
    scene.for_each([&](ElementRef e, const auto& shape) {
      are_ordinary = are_ordinary && trace::ordinary(shape);
      leaves_.push_back(own(e));
    });
  }

  const scene::Scene& scene() const { return *scene_; }
  std::span<const ElementRef> extraordinary() const { return {}; }
  bool any(const trace::Ray&, auto, auto visit) const {
    return std::ranges::any_of(leaves_, [&](ElementRef leaf) { return visit(element(leaf)); });
  }
  void pairs(std::span<const trace::Ray>, auto, auto, auto) const { FAIL("not asked for"); }
  decltype(auto) visit(ElementRef leaf, auto visit) const { return scene_->visit(element(leaf), visit); }
  ElementRef element(ElementRef leaf) const { return own(leaf); }
  ElementRef own(ElementRef e) const {
    const auto rows = scene::with_shape(e.tipo, [&]<class Shape>(std::type_identity<Shape>) {
      return static_cast<std::uint32_t>(scene_->shapes<Shape>().size());
    });
    return {e.tipo, rows - 1 - e.index};
  }
  void ask_for_own(ElementRef) const {}
  void ask_for_shape(ElementRef) const {}
  std::span<const ElementRef> all_leaves() const { return leaves_; }

  bool are_ordinary = true;

 private:
  const scene::Scene* scene_;
  std::vector<ElementRef> leaves_;
};
static_assert(trace::FewCandidates<Few>);

bool finite(const glm::dvec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

/// Queries: so many rays, and a ray from each of their hits, which starts on the elements there.
std::vector<scene::Query> queries_of(const scene::Scene& scene, const Reals& numbers, int count) {
  std::vector<scene::Query> queries;
  for (int i = 0; i < count; ++i) {
    queries.push_back({*rays(numbers), {}});
    const scene::Hit hit = surface::exact::first_hit(scene, queries.back().rayo);
    if (hit.resultado != model::Resultado::hit || !finite(hit.punto)) continue;
    queries.push_back({{model::Punto(hit.punto), (*rays(numbers)).v()}, hit.elementos});
  }
  return queries;
}

void check_answers(const scene::Scene& scene, const std::vector<scene::Query>& queries) {
  const Few source(scene);
  RC_PRE(source.are_ordinary);
  std::vector<scene::Hit> hits(queries.size(), {.resultado = model::Resultado::no_minimum, .elementos = {{}, {}}});
  const auto blocked = std::make_unique<bool[]>(queries.size());
  trace::first_hits_in_columns(source, queries, hits);
  trace::occluded_segments_in_columns(source, queries, std::span(blocked.get(), queries.size()));
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto& [rayo, en] = queries[i];
    RC_ASSERT(hits[i] == surface::exact::first_hit(scene, rayo, en));
    RC_ASSERT(blocked[i] == surface::exact::occluded_segment(scene, rayo, en));
  }
}

void check_numbers(const Reals& of_scene, const Reals& of_rays) {
  const scene::Scene scene = some_of_each(of_scene, 2);
  check_answers(scene, queries_of(scene, of_rays, *rc::gen::inRange(1, 50)));
}

}  // namespace

TEST_CASE("the answers in columns are the exact ones") {
  property("ordinary scenes", [] { check_numbers(moderate(), moderate()); });
  property("grids, where coincidences are frequent", [] { check_numbers(dyadicGrid(), dyadicGrid()); });
  property("rays out of the ordinary", [] { check_numbers(moderate(), anyFinite()); });
}

TEST_CASE("a ray that starts on several elements is answered by its start, though its point is off them") {
  scene::Scene scene;
  const ElementRef one = add(scene, scene::Sphere{{0, 0, 0}, 1}), other = add(scene, scene::Sphere{{0, 0, 0}, 3});
  const scene::Query query{{{0, 0, -0.75}, {0, 0, 1}}, {one, other}};
  std::vector<scene::Hit> hits(1);
  trace::first_hits_in_columns(Few(scene), {&query, 1}, hits);
  CHECK(hits[0].t == 1.5);
  CHECK(hits[0] == surface::exact::first_hit(scene, query.rayo, query.en));
}

TEST_CASE("a ray that starts on an element is answered by a nearer one as a ray from elsewhere") {
  scene::Scene scene;
  const ElementRef start = add(scene, scene::Sphere{{0, 0, 0}, 5}),
                   inner = add(scene, scene::Sphere{{0.25, 0, 0.5}, 1});
  const scene::Query query{{{0, 0, -5}, {0, 0, 3}}, {start}};
  std::vector<scene::Hit> hits(1);
  trace::first_hits_in_columns(Few(scene), {&query, 1}, hits);
  CHECK(hits[0].elementos == scene::ElementSet{inner});
  CHECK(hits[0] == surface::exact::first_hit(scene, query.rayo, query.en));
}
