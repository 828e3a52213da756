#include "durero/conform/families/families.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "conform/families/candidate.hpp"
#include "conform/families/family_table.hpp"
#include "durero/scene/addition.hpp"
#include "durero/surface/equation.hpp"
#include "durero/surface/exact.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

constexpr std::uint64_t scenes = 20;
constexpr std::size_t rays_a_scene = 100;

double part(std::size_t some, std::size_t all) { return static_cast<double>(some) / static_cast<double>(all); }

Count count_of(const Family& family, std::uint64_t first_seed, const CaseOptions& options) {
  Count counted;
  for (std::uint64_t i = 0; i < scenes; ++i) {
    INFO(family.name << ", seed " << first_seed + i);
    const auto drawn = generate(family, first_seed + i, rays_a_scene, options);
    REQUIRE(drawn);
    counted += count(family, drawn->the_case, drawn->bodies);
  }
  return counted;
}

/// At least the stated part of the rays is of the family, and a part of those exactly.
void check_floors(const FamilyRow& row, const Floors& floors, const CaseOptions& options) {
  const std::uint64_t seed = 2026;
  const Count counted = count_of(row.family, seed, options);
  const double members = part(counted.members, counted.rays), exact = part(counted.exact, counted.rays);
  fmt::print("{:20} members {:5.1f} % (floor {:2.0f}), exact {:5.1f} % (floor {:2.0f})\n", row.family.name,
             100 * members, 100 * floors.members, 100 * exact, 100 * floors.exact);
  INFO(row.family.name << ", replay: generate(*find_family(\"" << row.family.name << "\"), " << seed << " + i, 100)");
  CHECK(counted.rays == scenes * rays_a_scene);
  CHECK(members >= floors.members);
  CHECK(exact >= floors.exact);
}

void add(std::uint64_t& hash, double x) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
  hash ^= hash >> 29;
}

/// Of every byte of the case.
std::uint64_t fingerprint(const Case& of) {
  std::uint64_t hash = of.scene.size();
  const auto add_all = [&](const glm::dvec3& v) {
    for (const double x : {v.x, v.y, v.z}) add(hash, x);
  };
  const auto add_stored = [&]<class Stored>(const Stored& stored) {
    if constexpr (std::is_same_v<Stored, double>)
      add(hash, stored);
    else if constexpr (std::is_same_v<Stored, glm::dvec3>)
      add_all(stored);
    else
      for (const glm::dvec3& corner : stored) add_all(corner);
  };
  of.scene.for_each([&]<class Shape>(scene::ElementRef, const Shape& shape) {
    scene::for_each_attribute<Shape>([&](const auto& attribute) { add_stored(shape.*attribute.field); });
  });
  for (const scene::Query& ray : of.rays) {
    add_all(ray.rayo.p().xyz());
    add_all(ray.rayo.v().xyz());
    for (const scene::ElementRef e : ray.en) add(hash, static_cast<double>(e.index) + 1);
  }
  return hash;
}

/// Its axis is none of ±x, ±y, ±z, the only ones of length exactly 1.
bool is_tilted(const scene::Scene& scene, scene::ElementRef e) {
  return scene.visit(e, []<class Shape>(const Shape& shape) {
    if constexpr (surface::Axial<Shape>)
      return (shape.vector.x != 0) + (shape.vector.y != 0) + (shape.vector.z != 0) > 1;
    else
      return false;
  });
}

/// Of every number of the case, but of discs where solids have them.
bool holds_only_binary32(const Case& of, Caps caps = Caps::open) {
  bool holds = true;
  const auto check = [&](double x) {
    holds = holds && std::isfinite(x) && static_cast<double>(static_cast<float>(x)) == x;
  };
  const auto check_all = [&]<class Stored>(const Stored& stored) {
    if constexpr (std::is_same_v<Stored, double>)
      check(stored);
    else if constexpr (std::is_same_v<Stored, glm::dvec3>)
      check(stored.x), check(stored.y), check(stored.z);
    else
      for (const glm::dvec3& corner : stored) check(corner.x), check(corner.y), check(corner.z);
  };
  of.scene.for_each([&]<class Shape>(scene::ElementRef, const Shape& shape) {
    if (caps == Caps::solid && Shape::tipo == model::Tipo::soy_disco) return;
    scene::for_each_attribute<Shape>([&](const auto& attribute) { check_all(shape.*attribute.field); });
  });
  for (const scene::Query& ray : of.rays) check_all(ray.rayo.p().xyz()), check_all(ray.rayo.v().xyz());
  return holds;
}

/// Its discs lie at the ends of the wall, of the radius there, up to a rounding to binary64; each has the name of the
/// wall's end, or is a disc that the scene has there anyway.
void check_solid(const scene::Scene& scene, const Solid& solid) {
  const bool has_top = solid.wall.tipo != model::Tipo::soy_cono;
  REQUIRE(solid.discs.size() == (has_top ? 2 : 1));
  scene.visit(solid.wall, [&]<class Shape>(const Shape& wall) {
    if constexpr (surface::Axial<Shape>) {
      for (std::size_t i = 0; i < solid.discs.size(); ++i) {
        REQUIRE(solid.discs[i].tipo == model::Tipo::soy_disco);
        const scene::Disc& disc = scene.shapes<scene::Disc>()[solid.discs[i].index];
        const double s = i == 0 ? 0 : wall.altura;
        double radius = 0;
        if constexpr (requires { wall.proporcion; }) radius = wall.proporcion * (wall.altura - s);
        if constexpr (requires { wall.radio; }) radius += wall.radio;
        CHECK(disc.radio == Approx(radius).epsilon(0x1p-50));
        const glm::dvec3 far = disc.centro - (wall.centro + s * wall.vector);
        CHECK(glm::length(far) <= 0x1p-50 * (glm::length(wall.centro) + s));
        CHECK(glm::length(glm::cross(disc.vector, wall.vector)) == 0);
      }
    }
  });
}

}  // namespace

TEST_CASE("of every family at least the stated part of the rays is truly of it, and a part of those exactly") {
  for (const FamilyRow& row : family_table()) {
    if (!row.is_of_meshes()) check_floors(row, row.floors, {});
  }
}

TEST_CASE("the same of binary32 numbers") {
  for (const FamilyRow& row : family_table()) {
    if (!row.is_of_meshes())
      check_floors(row, row.of_binary32.floors.value_or(row.floors), {.numbers = NumberFormat::binary32});
  }
}

TEST_CASE("a family is the same from the same seed, on every platform, and another from another") {
  std::uint64_t all = 0;
  std::set<std::uint64_t> seen;
  for (const Family& family : families_of_few()) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const std::uint64_t one = fingerprint(generate(family, seed, 20));
      CHECK(one == fingerprint(generate(family, seed, 20)));
      seen.insert(one);
      all = std::rotl(all, 1) ^ one;
    }
    // The first rays do not depend on how many are asked for.
    const Case few = generate(family, 1, 5), more = generate(family, 1, 9);
    for (std::size_t i = 0; i < few.rays.size(); ++i) CHECK(few.rays[i].rayo == more.rays[i].rayo);
  }
  CHECK(seen.size() == families_of_few().size() * 50);
  CHECK(all ==
        0xf8230fbdd2f08b56);  // changes where a generator does: then the cases are others, and this number is a new one
}

TEST_CASE("also axes that are no exact unit vectors have exactly degenerate rays") {
  for (const char* name : {"perpendicular", "rim", "tangent", "zero_b", "tie", "near_axial"}) {
    const Family& family = *find_family(name);
    std::size_t exact = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Case some = generate(family, seed, 50);
      for (const scene::Query& ray : some.rays) {
        if (!membership(family, some, ray).exact) continue;
        const scene::Hit hit = surface::exact::first_hit(some.scene, ray.rayo, ray.en);
        for (const scene::ElementRef e : hit.elementos) exact += is_tilted(some.scene, e);
        if (hit.resultado == model::Resultado::miss) exact += is_tilted(some.scene, {model::Tipo::soy_cilindro, 0});
      }
    }
    INFO(name);
    CHECK(exact > 20);
  }
}

TEST_CASE("every number is one of the format that is asked for, and the axes still point anywhere") {
  const CaseOptions options{.numbers = NumberFormat::binary32};
  std::size_t tilted = 0, between_planes = 0;
  for (const Family& family : families_of_few()) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const DrawnCase drawn = *generate(family, seed, 30, options);
      INFO(family.name << ", seed " << seed);
      CHECK(holds_only_binary32(drawn.the_case));
      const Range range = parameter(family, NumberFormat::binary32);
      CHECK((range.least <= drawn.parameter && drawn.parameter <= range.greatest));
      drawn.the_case.scene.for_each([&](scene::ElementRef e, const auto& shape) {
        tilted += is_tilted(drawn.the_case.scene, e);
        if constexpr (requires { shape.vector; }) {
          const glm::dvec3 d = glm::abs(shape.vector);
          between_planes += std::min({d.x, d.y, d.z}) > 0.1;
        }
      });
    }
  }
  CHECK(tilted > 500);
  CHECK(between_planes > 300);
  // And binary64 numbers are no binary32 ones.
  CHECK_FALSE(holds_only_binary32(generate(families_of_few()[0], 2, 30)));
}

TEST_CASE("scenes have elements of the types that are asked for, and a family that needs another has none") {
  using enum model::Tipo;
  const auto has_scenes = [](const char* name, const std::vector<model::Tipo>& tipos) {
    const auto drawn = generate(*find_family(name), 3, 20, {.tipos = tipos});
    if (!drawn) return false;
    drawn->the_case.scene.for_each(
        [&](scene::ElementRef e, const auto&) { CHECK(std::find(tipos.begin(), tipos.end(), e.tipo) != tipos.end()); });
    return true;
  };
  const std::vector<model::Tipo> spheres{soy_esfera};
  for (const char* name : {"generic", "far_origin", "tie", "huge_ratio", "scale", "rotation", "parked"})
    CHECK(has_scenes(name, spheres));
  for (const char* name : {"near_axial", "apex", "rim", "cap", "disc", "flat", "edge", "vertex", "sliver", "coplanar"})
    CHECK_FALSE(has_scenes(name, spheres));
  CHECK(has_scenes("rim", {soy_cono}));
  CHECK(has_scenes("cap", {soy_cilindro, soy_disco}));
  CHECK_FALSE(has_scenes("cap", {soy_cilindro}));
  CHECK(has_scenes("coplanar", {soy_triangulo}));
  CHECK(has_scenes("coplanar", {soy_disco}));
  CHECK(has_scenes("disc", {soy_disco}));
  CHECK(has_scenes("flat", {soy_plano}));
  CHECK(has_scenes("vertex", {soy_triangulo}));
  CHECK(has_scenes("near_axial", {soy_cilindro, soy_cono}));
}

/// Whether all the elements are the same triangle, or the same disc.
bool are_one_surface(const scene::Scene& scene, const scene::ElementSet& elements) {
  return std::ranges::all_of(elements, [&](scene::ElementRef e) {
    return scene.visit(e, [&]<class Shape>(const Shape& shape) {
      const Shape first = scene.shapes<Shape>()[elements[0].index];
      if constexpr (requires { shape.vertices; })
        return shape.vertices == first.vertices;
      else
        return shape.centro == first.centro;
    });
  });
}

TEST_CASE("a system of triangles or discs alone has the families that need no axis and no inside") {
  using enum model::Tipo;
  const std::set<std::string_view> none{"near_axial", "perpendicular", "near_generator", "second_nappe", "apex",
                                        "rim",        "long_thin",     "inside",         "tangent",      "zero_b",
                                        "in_surface", "flat",          "grazing",        "cap"};
  const std::set<std::string_view> of_triangles{"edge", "sliver", "vertex"};
  for (const model::Tipo tipo : {soy_triangulo, soy_disco}) {
    for (const Family& family : families_of_few()) {
      Count count;
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto drawn = generate(family, seed, 24, {.tipos = {tipo}});
        if (!drawn) continue;
        count += conform::count(family, drawn->the_case, drawn->bodies);
        for (const scene::Query& ray : drawn->the_case.rays) CHECK(are_one_surface(drawn->the_case.scene, ray.en));
      }
      const bool has_none = none.contains(family.name) ||
                            (tipo == soy_disco ? of_triangles.contains(family.name) : family.name == "disc");
      INFO(family.name << ": " << count.members << " of " << count.rays);
      CHECK((count.rays == 0) == has_none);
      CHECK(20 * count.members >= 3 * count.rays);
    }
  }
}

TEST_CASE("solids are closed by discs of the model, and rays go to these and start within") {
  const CaseOptions options{.numbers = NumberFormat::binary32, .caps = Caps::solid};
  std::size_t solids = 0, to_discs = 0, at_rims = 0, inside = 0, rays = 0;
  for (const char* name : {"generic", "cap", "rim", "tie", "inside", "far_origin"}) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const DrawnCase drawn = *generate(*find_family(name), seed, 40, options);
      const auto& [scene, queries] = drawn.the_case;
      INFO(name << ", seed " << seed);
      CHECK(holds_only_binary32(drawn.the_case, options.caps));
      std::size_t axial = 0;
      scene.for_each([&]<class Shape>(scene::ElementRef, const Shape&) { axial += surface::Axial<Shape>; });
      CHECK(drawn.solids.size() == axial);
      for (const Solid& solid : drawn.solids) check_solid(scene, solid), ++solids;
      for (const scene::Query& query : queries) {
        const AnsweredQuery q{scene, query, surface::exact::first_hit(scene, query.rayo, query.en)};
        to_discs += any_hit_element(q, [](const ElementQuadratic& c) { return c.e.tipo == model::Tipo::soy_disco; });
        at_rims += cap(q);
        inside += any_element(q, [](const ElementQuadratic& c) { return is_inside(c); });
        ++rays;
      }
    }
  }
  CHECK(solids > 200);
  CHECK(to_discs > rays / 10);
  CHECK(at_rims > 100);
  CHECK(inside > rays / 10);
}

TEST_CASE("the elements of the family scale are the same at every scale") {
  const Family& family = *find_family("scale");
  std::set<double> sizes;
  std::set<std::string> elements;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const DrawnCase drawn = *generate(family, seed, 1, {.numbers = NumberFormat::binary32});
    const scene::Scene& scene = drawn.the_case.scene;
    std::string all;
    scene.for_each([&]<class Shape>(scene::ElementRef, const Shape& shape) {
      if constexpr (requires { shape.centro; })
        all += fmt::format("{} {:a} ", Shape::word, std::ldexp(shape.centro.x, -drawn.parameter));
      if constexpr (requires { shape.altura; }) sizes.insert(shape.altura);
    });
    elements.insert(all);
  }
  CHECK(elements.size() == 1);
  CHECK(sizes.size() > 20);
}

TEST_CASE("parked elements differ in one number alone, by so many units in its last place") {
  std::size_t differ = 0;
  for (const NumberFormat numbers : {NumberFormat::binary32, NumberFormat::binary64}) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const DrawnCase drawn = *generate(*find_family("parked"), seed, 1, {.numbers = numbers});
      const scene::Scene& scene = drawn.the_case.scene;
      const auto one = *scene.find("e0"), other = *scene.find("e1");
      REQUIRE(one.tipo == other.tipo);
      if (one.tipo == model::Tipo::soy_triangulo) continue;
      INFO("seed " << seed);
      std::size_t changed = 0;
      scene::with_shape(one.tipo, [&]<class Shape>(std::type_identity<Shape>) {
        const Shape &a = scene.shapes<Shape>()[one.index], &b = scene.shapes<Shape>()[other.index];
        const double half = numbers == NumberFormat::binary32 ? 0x1p-24 : 0x1p-53;
        scene::for_each_attribute<Shape>([&](const auto& attribute) {
          const auto compare = [&](double x, double y) {
            if (x == y) return;
            ++changed;
            const double units =
                std::abs(x - y) / (2 * half * std::ldexp(1, std::ilogb(std::max(std::abs(x), std::abs(y)))));
            if (x != 0 && y != 0) CHECK((units >= 0.4 * drawn.parameter && units <= drawn.parameter));
          };
          if constexpr (std::is_same_v<decltype(a.*attribute.field), const double&>)
            compare(a.*attribute.field, b.*attribute.field);
          else if constexpr (std::is_same_v<decltype(a.*attribute.field), const glm::dvec3&>)
            for (int i = 0; i < 3; ++i) compare((a.*attribute.field)[i], (b.*attribute.field)[i]);
        });
      });
      CHECK(changed == 1);
      ++differ;
    }
  }
  CHECK(differ > 80);
}

TEST_CASE("rays of the family margin pass a bound by the part of the size that was drawn, on either side") {
  for (const NumberFormat numbers : {NumberFormat::binary32, NumberFormat::binary64}) {
    std::size_t rays = 0, past = 0, inside = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const DrawnCase drawn = *generate(*find_family("margin"), seed, 40, {.numbers = numbers});
      const auto& [scene, queries] = drawn.the_case;
      for (const scene::Query& query : queries) {
        const AnsweredQuery q{scene, query, surface::exact::first_hit(scene, query.rayo, query.en)};
        const bool is_past = beside_bound_by(q, drawn.parameter - 1, drawn.parameter + 1);
        ++rays, past += is_past, inside += is_past && hits(q);
      }
    }
    INFO(past << " of " << rays << " by that part, " << inside << " of them hits");
    CHECK(past > rays * 9 / 10);
    CHECK(inside > rays / 3);
    CHECK(inside < rays * 4 / 5);
  }
}

TEST_CASE("families are found by name; each has a kind, a reason and a range") {
  std::set<std::string_view> names;
  for (const Family& family : families()) {
    CHECK(find_family(family.name) == &family);
    CHECK(names.insert(family.name).second);
    CHECK_FALSE(family.kind.empty());
    CHECK_FALSE(family.reason.empty());
    CHECK(family.parameter.least < family.parameter.greatest);
    CHECK(row_of(family).floors.members > 0);
    CHECK(row_of(family).floors.exact > 0);
  }
  // The lines of the design's table, apex and rim apart, without determinism; two of planes, five of discs and
  // triangles; five of the conformance suite. Then eleven of meshes and nine of bodies.
  CHECK(names.size() == 36 + 11 + 9);
  CHECK(families_of_few().size() == 36);
  CHECK(families_of_meshes().size() == 11);
  CHECK(families_of_meshes().front().name == "mesh_solid");
  CHECK(families_of_bodies().size() == 9);
  CHECK(families_of_bodies().front().name == "bodies");
  CHECK(find_family("of_no_such_name") == nullptr);
  CHECK_THROWS_AS(generate(Family{"of_no_such_name", "", "", {}}, 1, 1), std::invalid_argument);
}

TEST_CASE("each membership also says no somewhere") {
  const Case generic = generate(*find_family("generic"), 4, 200);
  for (const Family& family : families_of_few()) {
    INFO(family.name);
    const Count counted = count(family, generic);
    CHECK(counted.members < counted.rays);
    CHECK(counted.exact < counted.rays / 2);
  }
}
