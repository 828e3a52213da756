// A structure over a scene that was edited: `bvh` follows edits one by one, every other is made anew. Either way each
// engine answers as over the same elements that were never edited, which another scene has, in another order of rows.
#include <set>
#include <string>

#include "durero/accel/bvh.hpp"
#include "durero/accel/structure.hpp"
#include "durero/engine/engine.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// A hit with its elements by name.
struct Named {
  model::Resultado resultado;
  std::set<std::string> elementos;
  double t;
  glm::dvec3 punto;
  bool operator==(const Named&) const = default;
};

std::vector<Named> named(const scene::Scene& scene, const std::vector<scene::Hit>& hits) {
  std::vector<Named> all;
  for (const scene::Hit& hit : hits) {
    Named of{hit.resultado, {}, hit.t, hit.punto};
    for (const scene::ElementRef e : hit.elementos) of.elementos.insert(scene.name(e).name());
    all.push_back(of);
  }
  return all;
}

/// Every engine over the edited scene, and the hierarchy that followed the edits, as `analytic` over the other.
void check_as_never_edited(const scene::Scene& edited, const accel::Bvh& followed, std::size_t rays, Random& random) {
  const scene::Scene other = io::read_scene(io::Source("scene", io::scene_text(edited)));
  std::vector<scene::Query> queries;
  while (queries.size() < rays) {
    const scene::Query query{random_ray(random)};
    queries.push_back(query);
  }
  const auto expected = named(other, engine::first_hits(*engine::find("analytic")->prepare(other), queries));
  for (const engine::EngineRow& row : engine::engines()) {
    if (!row.exact_bytes || row.name == "exact") continue;
    INFO(row.name << " over " << edited.size() << " elements");
    REQUIRE(named(edited, engine::first_hits(*row.prepare(edited), queries)) == expected);
  }
  std::vector<scene::Hit> hits;
  trace::Counts unseen;
  for (const scene::Query& query : queries) {
    const scene::Hit hit = trace::first_hit_among(accel::CandidateSource(followed), query.rayo, query.en, unseen);
    hits.push_back(hit);
  }
  REQUIRE(named(edited, hits) == expected);
}

/// So many edits at random, about as many additions as removals once there are `elements`.
void check_edits(std::size_t edits, std::size_t elements, std::size_t every, std::size_t rays) {
  Random random(12);
  scene::Scene scene;
  accel::Bvh followed(scene);
  std::vector<std::string> names;
  for (std::size_t edit = 1; edit <= edits; ++edit) {
    if (names.empty() || random.chance(names.size() > elements ? 1 : 2, 3)) {
      names.push_back("n" + std::to_string(edit));
      scene.apply(random_addition(random, names.back()));
      followed.added(*scene.find(names.back()));
    } else {
      std::swap(names[random.below(names.size())], names.back());
      const scene::ElementRef gone = *scene.find(names.back());
      scene.apply(model::Eliminar_Elemento{model::Elemento(names.back())});
      followed.removed(gone);
      names.pop_back();
    }
    if (edit % every == 0) check_as_never_edited(scene, followed, rays, random);
  }
}

}  // namespace

TEST_CASE("over an edited scene every engine answers as over one that was never edited") {
  check_edits(fewer_when_sanitized(400), 60, 100, 100);
}
TEST_CASE("after ten thousand edits every engine answers as over a scene that was never edited", "[long]") {
  check_edits(10'000, 200, 200, 500);
}
