#include "durero/conform/judge/truth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "conform/changed.hpp"
#include "conform/families/candidate.hpp"
#include "conform/hits.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using namespace durero::conform;
using model::Resultado;

namespace {

/// What is permissible beside the hit, each as its elements and t: "esfera#0 4; miss".
std::string said(const ExactAnswer& of) {
  std::string text{name(of.ambiguity)};
  for (const scene::Hit& hit : of.permissible) {
    text += ';';
    for (const scene::ElementRef e : hit.elementos)
      scene::with_shape(
          e.tipo, [&]<class Shape>(std::type_identity<Shape>) { text += fmt::format(" {}#{}", Shape::word, e.index); });
    text += hit.resultado == Resultado::hit ? fmt::format(" {}", hit.t) : " miss";
  }
  return text;
}

std::string said(const scene::Scene& scene, const glm::dvec3& p, const glm::dvec3& v) {
  const scene::Query query{ray(p, v), {}};
  const ExactAnswer found = truth(scene, query);
  CHECK(identical(found.hit, surface::exact::first_hit(scene, query.rayo)));
  return said(found);
}

const glm::dvec3 down(0, 0, -1), forward(1, 0, 0);

/// A bound of a flat element that it meets is 0.
bool meets_flat_at_edge(const AnsweredQuery& q, model::Tipo tipo) {
  return any_met_element(q, [&](const ElementQuadratic& c) {
    return c.e.tipo == tipo && number::sign(c.f.B) != 0 &&
           std::any_of(c.f.bounds.begin(), c.f.bounds.end(),
                       [](const auto& bound) { return number::sign(bound.C) == 0; });
  });
}

/// The class, by the questions that say which families a ray is of.
Ambiguity by_questions(const AnsweredQuery& q) {
  const bool lies_in =
      conform::in_surface(q) || any_met_element(q, [](const ElementQuadratic& c) { return roots(c.f).every; });
  if (lies_in) return Ambiguity::in_surface;
  if (conform::apex(q)) return Ambiguity::apex;
  if (meets_flat_at_edge(q, model::Tipo::soy_triangulo)) return Ambiguity::edge;
  if (conform::rim(q) || meets_flat_at_edge(q, model::Tipo::soy_disco)) return Ambiguity::rim;
  if (conform::tangent(q)) return Ambiguity::tangent;
  return conform::tie(q) ? Ambiguity::tie : Ambiguity::none;
}

/// The hit is one of those that the truth leaves, up to the change in t that a small change of the data makes; a
/// stretch leaves all between its ends.
bool leaves(const ExactAnswer& of, const scene::Hit& hit) {
  const auto near = [&](const scene::Hit& other) {
    return other.resultado == hit.resultado && std::abs(other.t - hit.t) <= 0x1p-12 * (1 + hit.t) &&
           std::includes(other.elementos.begin(), other.elementos.end(), hit.elementos.begin(), hit.elementos.end());
  };
  return near(of.hit) || std::any_of(of.permissible.begin(), of.permissible.end(), near);
}

}  // namespace

TEST_CASE("an ordinary hit and a miss are the only answers") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 5});
  add(scene, scene::Plane{{0, 0, -9}, {0, 0, 1}});
  CHECK(said(scene, {1, 0, 8}, down) == "none");
  CHECK(said(scene, {1, 0, 2}, down) == "none");  // from inside
  CHECK(said(scene, {8, 0, 8}, -down) == "none");
  // It just misses the sphere, exactly: no answer but that of the plane behind.
  CHECK(said(scene, {0x1.4000000000001p2, 0, 8}, down) == "none");
}

TEST_CASE("a tangent may miss, and what is behind it is then hit") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 5});
  CHECK(said(scene, {5, 0, 8}, down) == "tangent; miss");
  add(scene, scene::Sphere{{5, 0, -20}, 5});
  CHECK(said(scene, {5, 0, 8}, down) == "tangent; esfera#1 23");
  add(scene, scene::Sphere{{5, 0, -40}, 5});
  CHECK(said(scene, {5, 0, 8}, down) == "tangent; esfera#1 23");
}

TEST_CASE("through a rim, an edge or a vertex it may pass") {
  scene::Scene scene;
  add(scene, scene::Cylinder{{0, 0, 0}, 5, {0, 0, 1}, 10});
  CHECK(said(scene, {-8, 0, 10}, forward) == "rim; cilindro#0 13; miss");
  CHECK(said(scene, {-8, 0, 0}, forward) == "rim; cilindro#0 13; miss");
  CHECK(said(scene, {-8, 0, 11}, {3, 0, -1}) == "rim; cilindro#0 4.333333333333333");  // the other side is within
  CHECK(said(scene, {-8, 0, 5}, forward) == "none");
  scene::Scene flat;
  add(flat, scene::Disc{{0, 0, 0}, 5, {0, 0, 1}});
  CHECK(said(flat, {3, 4, 8}, down) == "rim; miss");
  CHECK(said(flat, {3, 3, 8}, down) == "none");
  add(flat, scene::Triangle{{glm::dvec3(0, 0, 4), glm::dvec3(8, 0, 4), glm::dvec3(0, 8, 4)}});
  CHECK(said(flat, {3, 0, 8}, down) == "edge; disco#0 8");
  CHECK(said(flat, {0, 8, 8}, down) == "edge; miss");
  CHECK(said(flat, {1, 1, 8}, down) == "none");
}

TEST_CASE("through an apex it may pass") {
  scene::Scene scene;
  add(scene, scene::Cone{{0, 0, 0}, 0.5, {0, 0, 1}, 8});
  CHECK(said(scene, {-8, 0, 8}, forward) == "apex; miss");
  CHECK(said(scene, {-8, 0, 4}, forward) == "none");
}

TEST_CASE("of several elements at one point each may be answered alone") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 5});
  add(scene, scene::Sphere{{0, 0, 1}, 4});
  add(scene, scene::Plane{{0, 0, -9}, {0, 0, 1}});
  CHECK(said(scene, {0, 0, 8}, down) == "tie; esfera#0 3; esfera#1 3");
  add(scene, scene::Cone{{0, 0, 0}, 0.5, {0, 0, 1}, 5});
  CHECK(said(scene, {0, 0, 8}, down) == "apex; esfera#0 3; esfera#1 3; cono#0 3");
  // Behind the tangent of one element two are at one point.
  scene::Scene behind;
  add(behind, scene::Sphere{{5, 0, 0}, 5});
  add(behind, scene::Plane{{0, 0, -9}, {0, 0, 1}});
  add(behind, scene::Plane{{0, 0, -9}, {0, 0, -1}});
  CHECK(said(behind, {0, 0, 8}, down) == "tangent; plano#0 plano#1 17; plano#0 17; plano#1 17");
}

TEST_CASE("of a stretch in a surface both ends may be answered, and what is behind") {
  scene::Scene scene;
  add(scene, scene::Cylinder{{0, 0, 0}, 5, {0, 0, 1}, 10});
  CHECK(said(scene, {5, 0, 18}, down) == "in_surface; cilindro#0 18; miss");
  CHECK(said(scene, {5, 0, 4}, down) == "in_surface; cilindro#0 0; cilindro#0 4; miss");
  add(scene, scene::Plane{{0, 0, -9}, {0, 0, 1}});
  CHECK(said(scene, {5, 0, 4}, down) == "in_surface; cilindro#0 0; cilindro#0 4; plano#0 13");
  CHECK(said(scene, {5, 0, -9}, forward) == "in_surface; plano#0 0; miss");
  // In the plane of a disc, at its rim alone.
  scene::Scene flat;
  add(flat, scene::Disc{{0, 0, 0}, 5, {0, 0, 1}});
  CHECK(said(flat, {-9, 5, 0}, forward) == "in_surface; miss");
  CHECK(said(flat, {-9, 4, 0}, forward) == "in_surface; disco#0 12; miss");
}

TEST_CASE("over all families the class is what the questions of the families say") {
  std::map<Ambiguity, std::size_t> counted;
  for (const Family& family : families_of_few()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const Case of = generate(family, seed, 40);
      for (std::size_t i = 0; i < of.rays.size(); ++i) {
        const AnsweredQuery q{of.scene, of.rays[i],
                              surface::exact::first_hit(of.scene, of.rays[i].rayo, of.rays[i].en)};
        const ExactAnswer found = truth(of.scene, of.rays[i]);
        INFO(replay(family, seed, 40, i) << ": " << said(found));
        CHECK(identical(found.hit, q.hit));
        CHECK(name(found.ambiguity) == name(by_questions(q)));
        CHECK((found.permissible.empty()) == (found.ambiguity == Ambiguity::none));
        if (shared_edge(q)) CHECK((found.ambiguity == Ambiguity::edge || found.ambiguity == Ambiguity::in_surface));
        if (tie(q)) CHECK(found.permissible.size() >= q.hit.elementos.size());
        ++counted[found.ambiguity];
      }
    }
  }
  CHECK(counted.size() == 7);
  for (const auto& [ambiguity, count] : counted) {
    INFO(name(ambiguity));
    CHECK(count > 100);
  }
}

TEST_CASE("a truth is the same where the certified steps decline every element, and the exact one is asked alone") {
  // Beyond 2¹⁰⁰ no number is ordinary.
  std::size_t rays = 0;
  for (const Family& family : families_of_few()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const Case of = generate(family, seed, 40);
      Scaling scaling;
      const Change by = scaled_whole(scaling, 120);
      const scene::Scene great = changed(of.scene, by);
      for (std::size_t i = 0; i < of.rays.size(); ++i) {
        const scene::Query& ray = of.rays[i];
        const scene::Query far{test::ray(by.point(ray.rayo.p().xyz()), by.direction(ray.rayo.v().xyz())), ray.en};
        if (!scaling.exact) break;
        INFO(replay(family, seed, 40, i));
        CHECK(said(truth(of.scene, ray)) == said(truth(great, far)));
        ++rays;
      }
    }
  }
  CHECK(rays > 12 * 40 * families_of_few().size() / 2);
}

TEST_CASE("what a small change of the ray makes of an answer is left by the truth, and no other answer is") {
  // On the grid every margin that is not 0 is far greater than 2⁻⁴⁵, so a change of that size stands for all smaller.
  Random random(11);
  std::map<Ambiguity, std::size_t> changed;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Family& family = *find_family("grid_snapped");
    const Case of = generate(family, seed, 60);
    for (std::size_t i = 0; i < of.rays.size(); ++i) {
      const ExactAnswer found = truth(of.scene, of.rays[i]);
      for (int j = 0; j < 4; ++j) {
        const glm::dvec3 p = of.rays[i].rayo.p().xyz() + random.in_cube(0x1p-45);
        const glm::dvec3 v = of.rays[i].rayo.v().xyz() + random.in_cube(0x1p-45);
        const scene::Hit hit = surface::exact::first_hit(of.scene, ray(p, v));
        if (found.ambiguity == Ambiguity::in_surface) continue;
        // What the ray just misses exactly, at its origin or beside it, the change may hit.
        const AnsweredQuery q{of.scene, of.rays[i], found.hit};
        if (starts_exactly_on(q) || (!leaves(found, hit) && coincides(q) && hit.resultado == Resultado::hit &&
                                     (found.hit.resultado == Resultado::miss || hit.t < found.hit.t)))
          continue;
        INFO(replay(family, seed, 60, i) << ": " << said(found) << "\nhit " << text(found.hit) << "\nnow "
                                         << text(hit));
        CHECK(leaves(found, hit));
        if (hit.elementos != found.hit.elementos || hit.resultado != found.hit.resultado) ++changed[found.ambiguity];
      }
    }
  }
  CHECK(changed[Ambiguity::none] == 0);
  for (const Ambiguity seen : {Ambiguity::tangent, Ambiguity::rim}) {
    INFO(name(seen));
    CHECK(changed[seen] > 10);
  }
}
