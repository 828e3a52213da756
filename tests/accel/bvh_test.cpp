// That its answers are those of `analytic` is tests/engine/same_bytes_test; here is what it does for them, and that it
// follows edits.
#include "durero/accel/bvh.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>

#include "durero/accel/structure.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/surface/surfaces.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Build;
using accel::Bvh;
using accel::BvhGlassner;
using accel::Hierarchy;
using accel::Work;

static_assert(accel::Structure<Bvh> && accel::Structure<BvhGlassner>);

namespace {

/// A structure that counts, for the search.
template <class S>
struct Counted {
  const S& structure;
  Work& work;
  bool by_distance = true;  ///< otherwise every candidate is asked for, however near the nearest hit

  const scene::Scene& scene() const { return structure.scene(); }
  std::span<const scene::ElementRef> extraordinary() const { return structure.extraordinary(); }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    ++work.rays;
    return structure.any(
        ray, [&] { return by_distance ? limit() : trace::no_limit; }, visit, work);
  }
};

template <class S>
scene::Hit first_hit(const S& structure, const model::Rayo& rayo, Work& work, bool by_distance = true) {
  trace::Counts unseen;
  return trace::first_hit_among(Counted<S>{structure, work, by_distance}, rayo, {}, unseen);
}

double tests(const Work& work) { return double(work.volumes + work.candidates); }

/// Spheres, cylinders and cones in the unit cube, smaller where they are more.
scene::Scene crowd(std::size_t elements, Random& random) {
  const double size = 0.25 / std::cbrt(double(elements));
  scene::Scene scene;
  scene.put_off_audits();
  for (std::size_t i = 0; i < elements; ++i) {
    const glm::dvec3 centre = (random.in_cube(1) + 1.0) / 2.0;
    const double radius = size * random.uniform(0.5, 1), length = size * random.uniform(1.5, 3);
    if (i % 3 == 0)
      add(scene, scene::Sphere{centre, radius});
    else if (i % 3 == 1)
      add(scene, scene::Cylinder{centre, radius, random.axis().xyz(), length});
    else
      add(scene, scene::Cone{centre, radius / length, random.axis().xyz(), length});
  }
  return scene;
}

model::Rayo primary_ray(Random& random) {
  const glm::dvec3 eye(0.5, 0.5, -1.2), through = (random.in_cube(1) + 1.0) / 2.0;
  return ray(eye, glm::dvec3(through.x, through.y, 0) - eye);
}

}  // namespace

TEST_CASE("a leaf's volume is not tested, nor is there any for one element or none") {
  scene::Scene scene;
  Work none;
  CHECK(first_hit(Bvh(scene), ray({0, 0, -5}, {0, 0, 1}), none).resultado == model::Resultado::miss);
  CHECK(none == Work{.rays = 1});
  add(scene, scene::Sphere{{0, 0, 0}, 1});
  const auto check = [&](const auto& structure, const Work& expected, double y = 9) {
    Work work;
    CHECK(first_hit(structure, ray({0, y, -5}, {0, 0, 1}), work).resultado == model::Resultado::miss);
    CHECK(work == expected);
  };
  check(Bvh(scene), {.rays = 1, .cells = 1, .candidates = 1});
  check(BvhGlassner(scene), {.rays = 1, .cells = 1, .candidates = 1});
  add(scene, scene::Sphere{{0, 9, 0}, 1});
  Work both;
  CHECK(first_hit(Bvh(scene), ray({0, 9, -5}, {0, 0, 1}), both).resultado == model::Resultado::hit);
  CHECK(both == Work{.rays = 1, .volumes = 1, .nodes = 1, .cells = 2, .candidates = 2});
  check(Bvh(scene), {.rays = 1, .volumes = 1, .by_miss = 1}, 20);
}

TEST_CASE("volumes beyond the nearest hit are passed over, and counted apart from those that are missed") {
  scene::Scene scene;
  for (const double z : {0.0, 100.0, 200.0})
    for (const double x : {0.0, 3.0}) add(scene, scene::Sphere{{x, 0, z}, 1});
  const Bvh bvh(scene, Build::top_down, 2);
  Work near, all, literal;
  const model::Rayo rayo = ray({0, 0, -5}, {0, 0, 1});
  const scene::Hit hit = first_hit(bvh, rayo, near);
  CHECK(hit.t == 4);
  CHECK(first_hit(bvh, rayo, all, false) == hit);
  CHECK(first_hit(BvhGlassner(scene), rayo, literal) == hit);
  CHECK(near.by_distance > 0);
  CHECK(near.by_miss == 0);
  CHECK(near.nodes == 2);
  CHECK(literal.by_distance + literal.nodes == literal.volumes);
  CHECK(all.by_distance == 0);
  CHECK(near.candidates == 2);
  CHECK(all.candidates == 6);
  CHECK(literal.candidates >= 2);
}

TEST_CASE("pruning by distance saves tests, and no answer depends on it, on the build or on the order of children") {
  Random random(1);
  const scene::Scene scene = crowd(fewer_when_sanitized(2700) + 300, random);
  const BvhGlassner literal(scene);
  const Bvh bvh(scene);
  std::vector<Bvh> others;
  for (unsigned children = 2; children <= 8; ++children) others.emplace_back(scene, Build::top_down, children);
  others.emplace_back(scene, Build::incremental);
  Work with, without, of_text;
  for (int i = 0; i < 300; ++i) {
    const model::Rayo rayo = primary_ray(random);
    const scene::Hit hit = first_hit(bvh, rayo, with);
    CHECK(first_hit(bvh, rayo, without, false) == hit);
    CHECK(first_hit(literal, rayo, of_text) == hit);
    for (const Bvh& other : others) {
      Work unseen;
      CHECK(first_hit(other, rayo, unseen) == hit);
    }
  }
  CHECK(tests(with) < tests(of_text));
  CHECK(tests(of_text) < tests(without));
  CHECK(without.by_distance == 0);
  CHECK(with.by_distance > 0);
  CHECK(with.volumes == with.by_miss + with.by_distance + with.nodes);
}

TEST_CASE("a test of a volume reads the limit alone") {
  const surface::Box box{{-1, -1, -1}, {1, 1, 1}};
  const accel::Beam beam(trace::Ray(ray({0, 0, -3}, {0, 0, 1})));
  Work work;
  CHECK(entry_into(box, beam, trace::no_limit, work) == 2);
  CHECK(entry_into(box, beam, 2, work) == 2);
  CHECK(entry_into(box, beam, 1.5, work) == std::nullopt);
  CHECK(entry_into(box, accel::Beam(trace::Ray(ray({0, 0, -3}, {0, 0, -1}))), 9, work) == std::nullopt);
  CHECK(work == Work{.volumes = 4, .by_miss = 1, .by_distance = 1});
}

namespace {

/// Uniform lines that meet the root's box, without a limit: the mean number of tests of children is the cost, within
/// three standard errors.
void check_cost(const Bvh& bvh, std::size_t lines, Random& random) {
  const Hierarchy& tree = bvh.hierarchy();
  const surface::Box& root = tree[tree.root()].box;
  const double cost = accel::weight<double>(tree) / accel::area<double>(root);
  const glm::dvec3 middle = (root.low + root.high) / 2.0;
  const double radius = glm::length(root.high - middle);
  double sum = 0, squares = 0;
  for (std::size_t met = 0; met < lines;) {
    const glm::dvec3 along = glm::normalize(random.direction());
    const glm::dvec3 across = glm::normalize(glm::cross(along, glm::dvec3(along.y, along.z, -along.x)));
    const double angle = random.uniform(0, 6.283185307179586), off = radius * std::sqrt(random.uniform(0, 1));
    const glm::dvec3 aside = off * (std::cos(angle) * across + std::sin(angle) * glm::cross(along, across));
    Work work;
    const auto limit = [] { return trace::no_limit; };
    bvh.any(
        trace::Ray(ray(middle + aside - 2 * radius * along, along)), limit, [](auto) { return false; }, work);
    if (work.nodes == 0) continue;
    ++met;
    const double children = tests(work) - 1;  // the root itself
    sum += children;
    squares += children * children;
  }
  const double mean = sum / double(lines),
               deviation = std::sqrt((squares / double(lines) - mean * mean) / double(lines));
  INFO("cost " << cost << ", mean " << mean << " ± " << deviation);
  CHECK(std::abs(mean - cost) < 3 * deviation);
  CHECK(deviation < 0.02 * cost);
}

}  // namespace

TEST_CASE("the cost of Goldsmith and Salmon foretells the tests of a line") {
  Random random(5);
  const scene::Scene scene = crowd(200, random);
  check_cost(Bvh(scene), 20000, random);
  check_cost(Bvh(scene, Build::incremental), 20000, random);
}

TEST_CASE("the cost of Goldsmith and Salmon foretells the tests of a million lines", "[long]") {
  Random random(6);
  const scene::Scene scene = crowd(200, random);
  for (const Build build : {Build::top_down, Build::incremental, Build::every_place})
    check_cost(Bvh(scene, build), 1'000'000, random);
}

namespace {

/// Tests a primary ray, on crowds of these sizes: a line in the logarithm of the number fits them, and as a power of
/// the number they would grow with less than this.
void check_growth(std::initializer_list<std::size_t> sizes, std::size_t rays, double greatest_power) {
  Random random(7);
  std::vector<double> x, y;
  for (const std::size_t size : sizes) {
    const scene::Scene scene = crowd(size, random);
    const Bvh bvh(scene);
    Work work;
    for (std::size_t i = 0; i < rays; ++i) first_hit(bvh, primary_ray(random), work);
    x.push_back(std::log(double(size)));
    y.push_back(tests(work) / double(rays));
    UNSCOPED_INFO(size << " elements: " << y.back() << " tests a ray, " << bvh.size().depth << " deep, "
                       << bvh.size().bytes / size << " bytes an element");
  }
  const double n = double(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i], syy += y[i] * y[i];
  const double fit = (n * sxy - sx * sy) * (n * sxy - sx * sy) / ((n * sxx - sx * sx) * (n * syy - sy * sy));
  const double power = (std::log(y.back()) - std::log(y.front())) / (x.back() - x.front());
  CAPTURE(fit, power);
  CHECK(fit > 0.95);
  CHECK(power < greatest_power);
}

}  // namespace

TEST_CASE("tests a ray grow with the logarithm of the number of elements") {
  check_growth({100, 1000, 10000}, 2000, 0.3);
}
TEST_CASE("tests a ray grow with the logarithm up to a million elements", "[long]") {
  check_growth({100, 1000, 10'000, 100'000, 1'000'000}, 20000, 0.2);
}

TEST_CASE("a hierarchy of elements that lie far from each other saves nothing; of the same in two heaps it does") {
  // Four unit balls at corners of a cube, no two of them nearer than others, with five radii between them: each box
  // about some of them is more than half the whole, so that none pays.
  scene::Scene far, heaps;
  for (const glm::dvec3 at : {glm::dvec3(0, 0, 0), {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}) {
    add(far, scene::Sphere{5.0 * at, 1});
    add(heaps, scene::Sphere{glm::dvec3(at.x * 20, at.y, at.z), 1});
  }
  const auto tests_of = [](const scene::Scene& scene) {
    const Bvh bvh(scene);
    const surface::Box& box = bvh.hierarchy()[bvh.hierarchy().root()].box;
    Random random(11);
    Work work;
    for (int met = 0; met < 2000;) {
      const glm::dvec3 along = random.direction(), share = (random.in_cube(1) + 1.0) / 2.0;
      const glm::dvec3 through = box.low + share * (box.high - box.low);
      Work one;
      bvh.any(
          trace::Ray(ray(through - 100.0 * glm::normalize(along), along)), [] { return trace::no_limit; },
          [](auto) { return false; }, one);
      if (one.nodes == 0) continue;
      ++met;
      work += one;
    }
    return tests(work) / 2000;
  };
  CHECK(Bvh(far).hierarchy().inner_nodes() == 1);
  CHECK(Bvh(far, Build::incremental).hierarchy().inner_nodes() == 1);
  CHECK(Bvh(far, Build::every_place).hierarchy().inner_nodes() == 1);
  CHECK(tests_of(far) == 5);  // without a hierarchy it is 4
  CHECK(Bvh(heaps).hierarchy().inner_nodes() == 3);
  CHECK(tests_of(heaps) < 5);
}

namespace {

/// Every element of the scene has one place, its leaf its box, and each box holds those below.
void check_describes(const Bvh& bvh) {
  std::set<scene::ElementRef> seen(bvh.extraordinary().begin(), bvh.extraordinary().end());
  REQUIRE(seen.size() == bvh.extraordinary().size());
  const Hierarchy& tree = bvh.hierarchy();
  std::vector<Hierarchy::Number> left;
  if (!tree.empty()) left.push_back(tree.root());
  while (!left.empty()) {
    const Hierarchy::Number number = left.back();
    const Hierarchy::Node& node = tree[number];
    left.pop_back();
    if (node.is_leaf()) {
      const surface::Box box = bvh.scene().visit(node.element, [](const auto& shape) { return surface::box(shape); });
      REQUIRE((box.low == node.box.low && box.high == node.box.high));
      REQUIRE(seen.insert(node.element).second);
      continue;
    }
    surface::Box box = tree[node.child].box;
    std::uint32_t leaves = 0, arity = 0;
    tree.any_child(number, [&](Hierarchy::Number child) {
      box = accel::around(box, tree[child].box);
      leaves += tree[child].leaves;
      ++arity;
      left.push_back(child);
      REQUIRE(tree[child].parent == number);
      return false;
    });
    REQUIRE((box.low == node.box.low && box.high == node.box.high));
    REQUIRE(leaves == node.leaves);
    REQUIRE(arity == node.arity);
    REQUIRE(arity >= 2);
    REQUIRE(arity <= accel::usual_children);
  }
  REQUIRE(seen.size() == bvh.scene().size());
}

/// Edits at random, additions about as often as removals once there are `elements`.
void check_edits(std::size_t edits, std::size_t elements, std::size_t every, std::uint64_t seed) {
  Random random(seed);
  scene::Scene scene = random_scene(random, elements);
  Bvh bvh(scene);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < elements; ++i) names.push_back("e" + std::to_string(i));
  for (std::size_t edit = 0; edit < edits; ++edit) {
    const bool grow = names.empty() || random.chance(names.size() > elements ? 1 : 2, 3);
    if (grow) {
      names.push_back("n" + std::to_string(edit));
      const bool tiny = random.chance(1, 20);  // no ordinary element
      scene.apply(tiny ? model::Operation(model::Agregar_Esfera{model::Elemento(names.back()),
                                                                model::Punto(random.in_cube(1)), 1e-40})
                       : random_addition(random, names.back()));
      bvh.added(*scene.find(names.back()));
    } else {
      const std::size_t i = random.below(names.size());
      const scene::ElementRef e = *scene.find(names[i]);
      scene.apply(model::Eliminar_Elemento{model::Elemento(names[i])});
      bvh.removed(e);
      names[i] = names.back();
      names.pop_back();
    }
    if (edit % every != 0) continue;
    INFO("seed " << seed << ", edit " << edit);
    check_describes(bvh);
    const Bvh rebuilt(scene);
    CHECK(rebuilt.extraordinary().size() == bvh.extraordinary().size());
    for (int i = 0; i < 10; ++i) {
      const model::Rayo rayo = random_ray(random);
      Work unseen;
      const scene::Hit hit = first_hit(bvh, rayo, unseen);
      CHECK(hit == first_hit(rebuilt, rayo, unseen));
      CHECK(hit == trace::first_hit(scene, rayo));
    }
  }
}

}  // namespace

TEST_CASE("what has been taken out makes room: edits need no more memory than the elements that are there") {
  Random random(9);
  scene::Scene scene = crowd(500, random);
  Bvh bvh(scene);
  const auto put_elsewhere = [&] {
    const std::uint32_t row = std::uint32_t(random.below(scene.shapes<scene::Sphere>().size()));
    const scene::ElementRef gone{model::Tipo::soy_esfera, row};
    const model::Elemento name = scene.name(gone);
    scene.apply(model::Eliminar_Esfera{name});
    bvh.removed(gone);
    scene.apply(model::Agregar_Esfera{name, model::Punto(random.in_cube(1)), 0.02});
    bvh.added(*scene.find(name.name()));
  };
  for (int i = 0; i < 2000; ++i) put_elsewhere();
  const std::size_t bytes = bvh.size().bytes;
  for (std::size_t i = 0; i < fewer_when_sanitized(20000); ++i) put_elsewhere();
  CHECK(bvh.size().bytes <= bytes + bytes / 8);
  check_describes(bvh);
}

TEST_CASE("after edits it answers as one that is made anew") {
  check_edits(fewer_when_sanitized(400), 60, 5, 1);
  check_edits(fewer_when_sanitized(400), 3, 5, 2);
}
TEST_CASE("after ten thousand edits it answers as one that is made anew", "[long]") {
  check_edits(10'000, 200, 20, 3);
  check_edits(10'000, 0, 20, 4);
}

TEST_CASE("elements that are all the same, and such as lie apart ever farther, make no deep tree") {
  scene::Scene scene;
  scene.put_off_audits();
  for (int i = 0; i < 5000; ++i) add(scene, scene::Sphere{{0, 0, 0}, 1});
  CHECK(Bvh(scene).size().depth < 12);
  CHECK(Bvh(scene, Build::incremental).size().depth < 12);
  scene::Scene spread;
  for (int i = -96; i < 96; ++i) add(spread, scene::Sphere{glm::dvec3(std::ldexp(1.0, i)), std::ldexp(1.0, i - 2)});
  CHECK(Bvh(spread, Build::top_down, 2).size().depth <= 40 + 8);
}

namespace {

void group(const scene::Scene& scene, scene::Groups& groups, const char* name, scene::Group of) {
  REQUIRE(groups.apply_total(scene::Grouping{name, std::move(of)}, scene).ok());
}

std::string name_of(const scene::Scene& scene, std::uint32_t sphere) {
  return scene.name({model::Tipo::soy_esfera, sphere}).name();
}

/// The names of the elements below a node.
std::set<std::string> below(const Bvh& bvh, Hierarchy::Number node) {
  const Hierarchy& tree = bvh.hierarchy();
  if (tree[node].is_leaf()) return {bvh.scene().name(tree[node].element).name()};
  std::set<std::string> all;
  tree.any_child(node, [&](Hierarchy::Number child) {
    all.merge(below(bvh, child));
    return false;
  });
  return all;
}

}  // namespace

TEST_CASE("a hierarchy that is made by hand is honoured, and may cost less than the automatic one") {
  bool cheaper = false;
  for (std::uint64_t seed = 1; seed <= 200 && !cheaper; ++seed) {
    Random random(seed);
    scene::Scene scene;
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 centre = random.in_cube(1);
      add(scene, scene::Sphere{centre, random.uniform(0.1, 0.5)});
    }
    const Bvh automatic(scene);
    for (std::uint32_t i = 1; i < 4; ++i) {
      const std::uint32_t j = i % 3 + 1, k = j % 3 + 1;
      scene::Groups groups;
      group(scene, groups, "one", {{name_of(scene, 0), name_of(scene, i)}, {}});
      group(scene, groups, "other", {{name_of(scene, j), name_of(scene, k)}, {}});
      const Bvh by_hand(scene, groups);
      check_describes(by_hand);
      CHECK(by_hand.hierarchy().inner_nodes() == 3);
      CHECK(by_hand.hierarchy().depth() == 2);
      std::set<std::set<std::string>> halves;
      by_hand.hierarchy().any_child(by_hand.hierarchy().root(), [&](Hierarchy::Number child) {
        halves.insert(below(by_hand, child));
        return false;
      });
      CHECK(halves ==
            std::set{std::set{name_of(scene, 0), name_of(scene, i)}, std::set{name_of(scene, j), name_of(scene, k)}});
      cheaper = cheaper || accel::weight<double>(by_hand.hierarchy()) < accel::weight<double>(automatic.hierarchy());
      const model::Rayo rayo = random_ray(random);
      Work unseen;
      CHECK(first_hit(by_hand, rayo, unseen) == first_hit(automatic, rayo, unseen));
    }
  }
  CHECK(cheaper);
}

TEST_CASE("by hand a group of groups is a node above them") {
  scene::Scene scene;
  for (int i = 0; i < 4; ++i) add(scene, scene::Sphere{{3.0 * i, 0, 0}, 1});
  scene::Groups groups;
  group(scene, groups, "pair", {{name_of(scene, 0), name_of(scene, 1)}, {}});
  group(scene, groups, "three", {{name_of(scene, 2)}, {"pair"}});
  const Bvh bvh(scene, groups);
  check_describes(bvh);
  CHECK(bvh.hierarchy().inner_nodes() == 3);
  CHECK(bvh.hierarchy().depth() == 3);
}

TEST_CASE("by hand a group of one is its thing, one of nothing is no node, and what is in none is under the root") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0, 0, 0}, 1});
  add(scene, scene::Sphere{{3, 0, 0}, 1});
  const scene::ElementRef plane = add(scene, scene::Plane{{0, 0, 9}, {0, 0, 1}});
  scene::Groups groups;
  const std::string a = name_of(scene, 0), b = name_of(scene, 1);
  CHECK(Bvh(scene, groups).hierarchy().depth() == 1);
  group(scene, groups, "one", {{a}, {}});
  group(scene, groups, "one-again", {{}, {"one"}});
  group(scene, groups, "nothing", {});
  group(scene, groups, "plane", {{scene.name(plane).name()}, {"nothing"}});
  const Bvh bvh(scene, groups);
  check_describes(bvh);
  CHECK(bvh.hierarchy().depth() == 1);
  CHECK(bvh.extraordinary().size() == 1);
  group(scene, groups, "both", {{b}, {"one-again", "plane"}});
  CHECK(Bvh(scene, groups).hierarchy().depth() == 1);
  const scene::Scene nothing;
  CHECK(Bvh(nothing, groups).hierarchy().empty());
  Bvh edited(scene, groups);
  edited.added(add(scene, scene::Sphere{{9, 0, 0}, 1}));
  check_describes(edited);
}
