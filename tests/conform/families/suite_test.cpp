#include "durero/conform/families/suite.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "conform/hits.hpp"
#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::test;
using namespace durero::conform;

namespace {

const Family& generic() { return *find_family("generic"); }

bool is_same(const ExactAnswer& a, const ExactAnswer& b) {
  return identical(a.hit, b.hit) && a.ambiguity == b.ambiguity &&
         std::equal(a.permissible.begin(), a.permissible.end(), b.permissible.begin(), b.permissible.end(), identical);
}

bool has_same_rays(const SuiteCase& a, const SuiteCase& b) {
  const std::size_t common = std::min(a.the_case.rays.size(), b.the_case.rays.size());
  return std::equal(a.the_case.rays.begin(), a.the_case.rays.begin() + static_cast<std::ptrdiff_t>(common),
                    b.the_case.rays.begin());
}

}  // namespace

TEST_CASE("a suite has as many rays of each family as it is asked for, 16 a case") {
  const SuiteOptions options{.rays = 50};
  CHECK(cases(options, generic()) == 4);
  CHECK(suite_case(options, generic(), 0).the_case.rays.size() == 16);
  CHECK(suite_case(options, generic(), 3).the_case.rays.size() == 2);
  CHECK(suite_case(options, generic(), 3).name() == "generic/0003");
  CHECK(cases({.rays = 48}, generic()) == 3);
  CHECK(cases({.rays = 1}, generic()) == 1);
}

TEST_CASE("any case can be made alone: it is the same whatever else is asked for, and no two are alike") {
  const SuiteOptions few{.rays = 100}, many{.rays = 1000};
  CHECK(has_same_rays(suite_case(few, generic(), 0), suite_case(many, generic(), 0)));
  CHECK(has_same_rays(suite_case(few, generic(), 1), suite_case(many, generic(), 1)));
  std::set<double> first;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (std::uint64_t number = 0; number < 15; ++number)
      first.insert(suite_case({.seed = seed, .rays = 1000}, generic(), number).the_case.rays[0].rayo.p().x());
  }
  CHECK(first.size() >= 43);  // of 45 a coordinate or two may agree
}

TEST_CASE("the families are those that are asked for, in their order, and all without being asked") {
  CHECK(chosen_families({}).size() == families().size());
  const auto chosen = chosen_families({.families = {find_family("tie"), find_family("apex")}});
  REQUIRE(chosen.size() == 2);
  CHECK(chosen[0]->name == "apex");
  CHECK(chosen[1]->name == "tie");
  CHECK(cases({.tipos = {model::Tipo::soy_esfera}}, *find_family("apex")) == 0);
  CHECK(cases({.tipos = {model::Tipo::soy_esfera}}, generic()) == 64);
}

TEST_CASE("no ray names what it starts on, and every number is one of binary32 without being asked") {
  const SuiteOptions options{.rays = 64};
  for (const char* name : {"on_surface", "in_surface", "edge"}) {
    const SuiteCase of = suite_case(options, *find_family(name), 0);
    for (const scene::Query& ray : of.the_case.rays) {
      CHECK(ray.en.empty());
      const glm::dvec3 p = ray.rayo.p().xyz();
      CHECK(glm::dvec3(glm::vec3(p)) == p);
    }
  }
}

TEST_CASE("the answers are the truths, of every family, open and solid") {
  std::size_t rays = 0, ambiguous = 0;
  for (const Caps caps : {Caps::open, Caps::solid}) {
    const SuiteOptions options{.seed = 7, .rays = 100, .caps = caps};
    for (const Family& family : families()) {
      for (std::uint64_t number = 0; number < cases(options, family); ++number) {
        SuiteCase of = suite_case(options, family, number);
        answer(of);
        REQUIRE(of.truths.size() == of.the_case.rays.size());
        for (std::size_t i = 0; i < of.truths.size(); ++i) {
          INFO(of.name() << ", ray " << i << ": " << text(of.the_case.rays[i]));
          const ExactAnswer expected = SceneTruths(of.the_case.scene, 1, of.bodies).of(of.the_case.rays[i]);
          INFO(text(of.truths[i].hit) << " but " << text(expected.hit));
          CHECK(is_same(of.truths[i], expected));
          ambiguous += of.truths[i].ambiguity != Ambiguity::none;
          ++rays;
        }
      }
    }
  }
  CHECK(rays == 2 * families().size() * 100);
  CHECK(ambiguous > rays / 10);
}

TEST_CASE("solids are those of the scene") {
  const SuiteOptions options{.rays = 320, .caps = Caps::solid};
  std::size_t solids = 0;
  for (std::uint64_t number = 0; number < 5; ++number) {
    const SuiteCase of = suite_case(options, *find_family("rim"), number);
    for (const Solid& solid : of.solids) {
      const std::string& wall = of.the_case.scene.name(solid.wall).name();
      CHECK(of.the_case.scene.name(solid.discs.front()).name() == wall + ".base");
      if (solid.discs.size() > 1) CHECK(of.the_case.scene.name(solid.discs[1]).name() == wall + ".top");
      ++solids;
    }
  }
  CHECK(solids >= 5);
  CHECK(suite_case({.rays = 64}, *find_family("rim"), 0).solids.empty());
}

TEST_CASE("a disc that closes a solid is of one solid alone, and lies at an end of it and across its axis") {
  std::size_t discs = 0, shared_places = 0;
  for (const Family& family : families_of_few()) {
    const SuiteOptions options{.rays = 512, .caps = Caps::solid};
    for (std::uint64_t number = 0; number < cases(options, family); ++number) {
      const SuiteCase of = suite_case(options, family, number);
      const scene::Scene& scene = of.the_case.scene;
      std::set<scene::ElementRef> seen;
      std::set<std::array<double, 4>> places;
      for (const Solid& solid : of.solids) {
        for (const scene::ElementRef e : solid.discs) {
          REQUIRE(e.tipo == model::Tipo::soy_disco);
          const scene::Disc& disc = scene.shapes<scene::Disc>()[e.index];
          INFO(of.name() << ", " << scene.name(e).name());
          CHECK(seen.insert(e).second);
          shared_places += !places.insert({disc.centro.x, disc.centro.y, disc.centro.z, disc.radio}).second;
          scene.visit(solid.wall, [&]<class Wall>(const Wall& wall) {
            if constexpr (surface::Axial<Wall>) {
              CHECK((disc.vector == wall.vector || disc.vector == -wall.vector));
              CHECK((disc.centro == wall.centro || disc.centro == wall.centro + wall.altura * wall.vector));
            }
          });
          ++discs;
        }
      }
    }
  }
  CHECK(discs > 600);
  CHECK(shared_places > 5);  // two solids that end in one place have a disc each
}

TEST_CASE("shadow rays end before, near and behind the first hits, the same for the same options") {
  const SuiteOptions first{.rays = 64}, shadow{.rays = 64, .question = QuestionKind::shadow};
  std::size_t before = 0, near = 0, behind = 0;
  for (const Family& family : families_of_few()) {
    for (std::uint64_t number = 0; number < 4; ++number) {
      SuiteCase of = suite_case(shadow, family, number), again = of, usual = of;
      for (SuiteCase* each : {&of, &again, &usual}) answer(*each);
      ask_question(of, shadow);
      ask_question(again, shadow);
      ask_question(usual, first);
      CHECK(of.ranges == again.ranges);
      CHECK(usual.ranges.empty());
      REQUIRE(of.ranges.size() == of.truths.size());
      for (std::size_t ray = 0; ray < of.ranges.size(); ++ray) {
        const double end = of.ranges[ray].end, t = of.truths[ray].hit.t;
        CHECK((end > 0 && std::isfinite(end) && end == static_cast<double>(static_cast<float>(end))));
        if (of.truths[ray].hit.resultado != model::Resultado::hit) continue;
        before += end<t, behind += end> t, near += std::abs(end / t - 1) < 0x1p-10;
      }
    }
  }
  CHECK(before > 300);
  CHECK(behind > 300);
  CHECK(near > 200);
}
