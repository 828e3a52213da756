// surface::exact against a second reading of the Z text that shares nothing with it but the numbers.
#include "reference.hpp"

#include "durero/surface/exact.hpp"
#include "hits.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// all_hits is ascending, and begins with what first_hit answers.
void check_crossings(const scene::Scene& scene, const scene::Query& ray, const scene::Hit& hit) {
  const auto crossings = surface::exact::all_hits(scene, ray.rayo, ray.en);
  CHECK(crossings.empty() == (hit.resultado == model::Resultado::miss));
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const auto &before = crossings[i - 1].segment.begin, &begin = crossings[i].segment.begin;
    if (before) CHECK((begin && *before <= *begin));
  }
  for (std::size_t i = 0; i < hit.elementos.size(); ++i) CHECK(crossings[i].elemento == hit.elementos[i]);
  if (hit.resultado == model::Resultado::hit) CHECK(number::round_to_binary64(*crossings[0].segment.begin) == hit.t);
}

}  // namespace

TEST_CASE("the exact oracle and a plain second reading of the Z text give the same bytes on every family") {
  std::size_t compared = 0, hits = 0, ties = 0, without_minimum = 0;
  for (const conform::Family& family : conform::families_of_few()) {
    const std::uint64_t scenes = family.name == "degenerate_numbers" ? 5 : 15;  // long rationals
    for (std::uint64_t seed = 100; seed < 100 + scenes; ++seed) {
      const conform::Case made = generate(family, seed, 25);
      for (std::size_t i = 0; i < made.rays.size(); ++i) {
        const scene::Query& ray = made.rays[i];
        const scene::Hit exact = surface::exact::first_hit(made.scene, ray.rayo, ray.en);
        const scene::Hit reference = reference_first_hit(made.scene, ray.rayo, ray.en);
        check_crossings(made.scene, ray, exact);
        ++compared;
        hits += exact.resultado == model::Resultado::hit;
        ties += exact.resultado == model::Resultado::hit && exact.elementos.size() > 1;
        without_minimum += exact.resultado == model::Resultado::no_minimum;
        if (identical(exact, reference)) continue;
        INFO(replay(family, seed, 25, i) << "\n  ray       " << text(ray) << "\n  exact     " << text(exact)
                                         << "\n  reference " << text(reference));
        CHECK(false);
      }
    }
  }
  INFO(compared << " compared, " << hits << " hits, " << ties << " ties, " << without_minimum << " no_minimum");
  CHECK(hits > compared / 2);
  CHECK(ties > 100);
  CHECK(without_minimum > 50);
}
