// Of every kind: that no ray that meets an element misses its volume; how well it fits, in closed form; what it costs.
#include "durero/accel/volume/volume.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/model/operaciones.hpp"
#include "durero/trace/analytic.hpp"
#include "durero/trace/search.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using accel::outline;
using accel::Outline;
using accel::PrecomputedRay;
using accel::projected;
using accel::Simple;
using accel::surface_of;
using accel::verdict;
using accel::Volume;
using accel::VolumeKind;
using accel::VolumeTest;
using accel::Work;
using std::numbers::pi;

namespace {

constexpr std::size_t all_slabs = accel::most_slabs;

std::vector<Simple> all_around(scene::ShapeView element) {
  std::vector<Simple> all;
  for (const VolumeKind& kind : accel::kinds()) all.push_back(kind.around(element, outline(element)));
  return all;
}

const VolumeKind& kind(std::string_view name) {
  for (const VolumeKind& kind : accel::kinds())
    if (kind.name == name) return kind;
  FAIL(name);
  return accel::kinds()[0];
}

/// Every volume of the element is met up to the limit.
void check_met(const std::vector<Simple>& volumes, const model::Rayo& rayo, double limit) {
  const trace::Ray ray(rayo);
  const PrecomputedRay asked(ray, all_slabs);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    if (verdict(volumes[i], asked, limit) == VolumeTest::met) continue;
    INFO(accel::kinds()[i].name << " from " << ray.p.x << ' ' << ray.p.y << ' ' << ray.p.z << " along " << ray.v.x
                                << ' ' << ray.v.y << ' ' << ray.v.z);
    CHECK(verdict(volumes[i], asked, limit) == VolumeTest::met);
  }
}

/// Rays about the element, near its edges and from afar: where one meets it, it meets each volume up to there.
std::size_t check_holds(Random& random, std::size_t elements, std::size_t rays) {
  std::size_t met = 0;
  while (elements-- > 0) {
    scene::Scene scene;
    scene.apply(random_addition(random, "e"));
    const scene::ElementRef e = *scene.find("e");
    if (e.tipo == model::Tipo::soy_plano) continue;
    scene.visit(e, [&](const auto& shape) {
      const std::vector<Simple> volumes = all_around(shape);
      const Outline around = accel::outline(shape);
      for (std::size_t i = 0; i < rays; ++i) {
        const std::size_t c = random.below(around.count);
        const double reach = random.chance(1, 2) ? 1 : random.uniform(0, 1);  // at a rim, a vertex, or within
        const glm::dvec3 aside = glm::normalize(glm::cross(around.axis, random.direction()));
        const glm::dvec3 target = around.centre[c] + reach * around.radius[c] * aside;
        const double far = std::ldexp(1.0, random.integer(-3, 30));
        const glm::dvec3 from = target + far * random.direction();
        const model::Rayo rayo = ray(from, random.chance(1, 8) ? glm::dvec3(0, 0, -random.sign()) : target - from);
        const scene::Hit hit = trace::first_hit(scene, rayo);
        if (hit.resultado != model::Resultado::hit) continue;
        ++met;
        check_met(volumes, rayo, std::nextafter(hit.t, trace::no_limit));
      }
    });
  }
  return met;
}

}  // namespace

TEST_CASE("a ray that meets an element meets its volume of each kind") {
  Random random(1);
  CHECK(check_holds(random, fewer_when_sanitized(400), 40) > fewer_when_sanitized(1000));
}
TEST_CASE("a ray that meets an element meets its volume of each kind, at length", "[long]") {
  Random random(2);
  CHECK(check_holds(random, 20'000, 500) > 1'000'000);
}

TEST_CASE("vertices, rims and apexes are met exactly at the limit") {
  Random random(3);
  const auto check = [&](scene::ShapeView element, std::initializer_list<glm::dvec3> extremes) {
    const std::vector<Simple> volumes = all_around(element);
    for (const glm::dvec3& w : extremes)
      for (std::size_t i = 0; i < fewer_when_sanitized(300); ++i) {
        // Whole numbers, so that w is p + v exactly.
        const int far = random.chance(1, 2) ? 20 : (1 << 30) - 1;
        const glm::dvec3 v = random.lattice_vector(far);
        check_met(volumes, ray(w - v, v), 1);
      }
  };
  const double r = 5;
  check(scene::Sphere{{7, 0, 0}, r}, {{12, 0, 0}, {7, 3, 4}, {3, 0, -3}, {7, -5, 0}, {7 + 2, 0, std::sqrt(21.0) * 0}});
  check(scene::Disc{{0, 0, 9}, r, {0, 0, 1}}, {{3, 4, 9}, {-4, 3, 9}, {0, 5, 9}, {5, 0, 9}, {0, 0, 9}});
  check(scene::Cylinder{{1, 0, 0}, r, {0, 0, 1}, 12}, {{4, 4, 0}, {4, 4, 12}, {1, -5, 12}, {6, 0, 0}, {-4, 0, 5}});
  check(scene::Cone{{0, 0, 0}, 0.5, {0, 1, 0}, 10}, {{3, 0, 4}, {0, 10, 0}, {-5, 0, 0}});
  check(scene::TruncatedCone{{0, 0, 0}, 5, 0.5, {1, 0, 0}, 10}, {{0, 6, 8}, {10, 3, 4}, {10, 0, -5}});
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 a = random.lattice_vector(9), b = a + random.lattice_vector(9), c = a + random.lattice_vector(9);
    if (glm::length(glm::cross(b - a, c - a)) > 0) check(scene::Triangle{{{a, b, c}}}, {a, b, c});
  }
}

TEST_CASE("the void area of a unit sphere in a cube, and of it in itself") {
  const scene::Sphere sphere{{0, 0, 0}, 1};
  const Outline around = accel::outline(sphere);
  const Simple cube = surface::Box{{-1, -1, -1}, {1, 1, 1}}, itself = surface::Ball{{0, 0, 0}, 1};
  const auto is = [](double x) { return Approx(x).epsilon(1e-6).margin(1e-9); };
  const glm::dvec3 edge = glm::normalize(glm::dvec3(1, 1, 0)), corner = glm::normalize(glm::dvec3(1, 1, 1));
  CHECK(void_area(cube, around, {1, 0, 0}) == is(0.858407));
  CHECK(void_area(cube, around, edge) == is(2.515262));
  CHECK(void_area(cube, around, corner) == is(3.786611));
  CHECK(void_area(itself, around, corner) == is(0));
  CHECK(mean_fit(cube, around) == is(2.858407));
  // The cube of side 2 in its sphere.
  CHECK((surface_of(surface::Ball{{0, 0, 0}, std::sqrt(3.0)}) - surface_of(cube)) / 4 == is(3 * pi - 6));
  // Slabs and oriented boxes are measured as polyhedra.
  CHECK(surface_of(accel::Slabs{{{-1, 1}, {-1, 1}, {-1, 1}}}) == is(24));
  CHECK(projected(accel::Slabs{{{-1, 1}, {-1, 1}, {-1, 1}}}, corner) == is(4 * std::sqrt(3.0)));
  const accel::Slabs octahedron{{{-9, 9}, {-9, 9}, {-9, 9}, {-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}}};
  CHECK(surface_of(octahedron) == is(4 * std::sqrt(3.0)));
  CHECK(projected(octahedron, {0, 0, 1}) == is(2));
}

TEST_CASE("the mean over directions of the void area is the mean fit, for each kind") {
  Random random(4);
  const scene::Cylinder cylinder{{0, 0, 0}, 0.5, {0.6, 0, 0.8}, 3};
  const Outline around = accel::outline(cylinder);
  const std::vector<Simple> volumes = all_around(cylinder);
  std::vector<double> sums(volumes.size());
  const std::size_t directions = 2000;
  for (std::size_t i = 0; i < directions; ++i) {
    const glm::dvec3 v = random.direction();
    for (std::size_t k = 0; k < volumes.size(); ++k) {
      const double gap = void_area(volumes[k], around, v);
      CHECK(gap > -1e-4);
      sums[k] += gap;
    }
  }
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    INFO(accel::kinds()[k].name);
    CHECK(sums[k] / double(directions) == Approx(mean_fit(volumes[k], around)).epsilon(0.04));
  }
  // Directions evenly from all over, by which the mean is known better.
  const std::size_t evenly = fewer_when_sanitized(5000);
  double around_ball = 0;
  std::vector<double> even(volumes.size());
  const Simple cube = surface::Box{{-1, -1, -1}, {1, 1, 1}};
  const Outline ball = accel::outline(scene::Sphere{{0, 0, 0}, 1});
  for (std::size_t i = 0; i < evenly; ++i) {
    const double z = 1 - (2.0 * double(i) + 1) / double(evenly), turn = double(i) * (3 - std::sqrt(5.0)) * pi;
    const glm::dvec3 v(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    around_ball += void_area(cube, ball, v);
    for (std::size_t k = 0; k < volumes.size(); ++k) even[k] += void_area(volumes[k], around, v);
  }
  CHECK(around_ball / double(evenly) == Approx(6 - pi).epsilon(1e-3));
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    INFO(accel::kinds()[k].name);
    CHECK(even[k] / double(evenly) == Approx(mean_fit(volumes[k], around)).epsilon(1e-3).margin(1e-3));
  }
  // The oriented box fits better than the box, and more slabs better than fewer.
  CHECK(mean_fit(volumes[2], around) < mean_fit(volumes[1], around));
  CHECK(mean_fit(volumes[5], around) <= mean_fit(volumes[4], around));
  CHECK(mean_fit(volumes[6], around) <= mean_fit(volumes[5], around));
}

TEST_CASE("an element that turns spoils the fit of volumes along common directions, not of one along its own axis") {
  const double half = std::sqrt(0.5);
  const scene::Cylinder upright{{0, 0, 0}, 0.25, {0, 0, 1}, 4}, turned{{0, 0, 0}, 0.25, {0, half, half}, 4};
  const auto fit = [](std::string_view name, const scene::Cylinder& cylinder) {
    return mean_fit(kind(name).around(cylinder, outline(cylinder)), outline(cylinder));
  };
  for (const std::string_view name : {"ball", "oriented-box", "ellipsoid"})
    CHECK(fit(name, turned) == Approx(fit(name, upright)).epsilon(1e-6));
  for (const std::string_view name : {"box", "slabs-3"}) CHECK(fit(name, turned) > 3 * fit(name, upright));
  // Of seven and thirteen slabs some lie across other directions, so that they lose less.
  CHECK(fit("slabs-13", turned) < 0.5 * fit("slabs-3", turned));
}

namespace {

/// Isotropic lines that meet the cube of side 2: the share that misses the unit sphere is 1 − π/6, within three
/// standard errors.
void check_share(std::size_t lines, Random& random) {
  const Simple cube = surface::Box{{-1, -1, -1}, {1, 1, 1}};
  const surface::Ball sphere{{0, 0, 0}, 1};
  std::size_t met = 0, missed = 0;
  while (met < lines) {
    const glm::dvec3 v = random.direction(), across = glm::normalize(glm::cross(v, glm::dvec3(v.y, v.z, -v.x)));
    const double angle = random.uniform(0, 2 * pi), off = std::sqrt(3 * random.uniform(0, 1));
    const glm::dvec3 aside = off * (std::cos(angle) * across + std::sin(angle) * glm::cross(v, across));
    const trace::Ray line(ray(aside - 4.0 * v, v));
    if (verdict(cube, PrecomputedRay(line, 0), trace::no_limit) != VolumeTest::met) continue;
    ++met;
    if (verdict(sphere, line, trace::no_limit) != VolumeTest::met) ++missed;
  }
  const double share = double(missed) / double(lines), expected = 1 - pi / 6;
  CHECK(std::abs(share - expected) < 3 * std::sqrt(expected * (1 - expected) / double(lines)));
}

}  // namespace

TEST_CASE("void areas foretell how many lines meet the volume and not the object") {
  Random random(5);
  check_share(fewer_when_sanitized(20000), random);
}
TEST_CASE("void areas foretell how many of a million lines meet the volume and not the object", "[long]") {
  Random random(5);
  check_share(1'000'000, random);
}

// An open cylinder is not convex: lines that go through both ends see nothing of it. So what Cauchy says of the hull is
// not what is seen, and the mean over directions is.
TEST_CASE(
    "of an open cylinder the lines that meet its box and not the cylinder are counted, not foretold by the hull") {
  const double r = 1, h = 1;
  const scene::Cylinder tube{{0, 0, -h / 2}, r, {0, 0, 1}, h};
  const Simple box = kind("box").around(tube, accel::outline(tube));
  // Of the projection at an angle θ to the axis: the hull's, less the lens in which the two ends cover each other.
  double hull = 0, seen = 0, boxes = 0;
  const int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps, sine = std::sqrt(1 - cosine * cosine), apart = h * sine / cosine;
    const double lens =
        apart >= 2 * r ? 0 : 2 * r * r * std::acos(apart / (2 * r)) - apart / 2 * std::sqrt(4 * r * r - apart * apart);
    hull += pi * r * r * cosine + 2 * r * h * sine;
    seen += pi * r * r * cosine + 2 * r * h * sine - cosine * lens;
  }
  boxes = surface_of(box) / 4 * steps;  // a box is convex
  const double expected = 1 - seen / boxes, of_hull = 1 - hull / boxes;
  Random random(7);
  scene::Scene scene;
  add(scene, tube);
  std::size_t met = 0, missed = 0;
  const std::size_t lines = fewer_when_sanitized(40000);
  while (met < lines) {
    const glm::dvec3 v = random.direction(), across = glm::normalize(glm::cross(v, glm::dvec3(v.y, v.z, -v.x)));
    const double angle = random.uniform(0, 2 * pi), off = 1.6 * std::sqrt(random.uniform(0, 1));
    const glm::dvec3 aside = off * (std::cos(angle) * across + std::sin(angle) * glm::cross(v, across));
    const model::Rayo line = ray(aside - 4.0 * v, v);
    if (verdict(box, PrecomputedRay(trace::Ray(line), 0), trace::no_limit) != VolumeTest::met) continue;
    ++met;
    missed += trace::first_hit(scene, line).resultado == model::Resultado::miss;
  }
  const double share = double(missed) / double(lines);
  INFO(share << " counted, " << expected << " of what is seen, " << of_hull << " of the hull");
  CHECK(std::abs(share - expected) < 3 * std::sqrt(expected * (1 - expected) / double(lines)));
  CHECK(share > of_hull + 0.05);
}

TEST_CASE("the wheel: along its axis the ball is best, across it the box") {
  const glm::dvec3 z(0, 0, 1), y(0, 1, 0);
  const scene::Cylinder wheel{{0, 0, -0.1}, 1, z, 0.2};
  const Outline around = accel::outline(wheel);
  const Simple ball = kind("ball").around(wheel, around), box = kind("box").around(wheel, around);
  const auto is = [](double x) { return Approx(x).epsilon(1e-5).margin(1e-6); };
  CHECK(void_area(ball, around, z) == is(0.031416));
  CHECK(void_area(box, around, z) == is(0.858407));
  CHECK(void_area(ball, around, y) == is(2.773009));
  CHECK(void_area(box, around, y) == is(0));
  CHECK(accel::cheapest(wheel, z, 10).name == "ball");
  CHECK(accel::cheapest(wheel, y, 10).name == "box");
  const double height = 1.045446;
  const scene::Cylinder even{{0, 0, -height / 2}, 1, z, height};
  const Outline around_even = accel::outline(even);
  CHECK(void_area(kind("ball").around(even, around_even), around_even, z) ==
        is(void_area(kind("box").around(even, around_even), around_even, z)));
}

TEST_CASE("the more slabs a kind has the dearer it is, and the ball is the cheapest of all") {
  for (const auto& [fewer, more] : {std::pair("slabs-3", "slabs-7"), {"slabs-7", "slabs-13"}})
    CHECK(kind(fewer).B < kind(more).B);
  for (const VolumeKind& any : accel::kinds()) CHECK(any.B >= kind("ball").B);
  CHECK(kind("oriented-box").B > kind("box").B);
}

TEST_CASE("what costs least is chosen: a dear volume only where it saves enough") {
  const double never_met[7] = {}, box_is_tight[7] = {0.9, 0.1, 0.1, 0.5, 0.1, 0.1, 0.1};
  double slabs_are[7] = {0.9, 0.9, 0.9, 0.9, 0.9, 0.5, 0.1};
  CHECK(accel::cheapest(never_met).name == "ball");
  CHECK(accel::cheapest(box_is_tight).name == "box");
  CHECK(accel::cheapest(slabs_are).name == "slabs-13");
  slabs_are[6] = 0.45;
  CHECK(accel::cheapest(slabs_are).name == "slabs-7");
  CHECK(accel::cheapest(scene::Sphere{{0, 0, 0}, 1}, 24).name == "ball");
  const double half = std::sqrt(0.5);
  const std::string_view of_needle = accel::cheapest(scene::Cylinder{{0, 0, 0}, 0.01, {half, half, 0}, 2}, 24).name;
  CHECK(of_needle != "ball");
  CHECK(of_needle != "box");
}

namespace {

struct Found {
  VolumeTest verdict;
  std::uint64_t tests;
};

Found of(const Volume& volume, const glm::dvec3& p, const glm::dvec3& v, double limit = trace::no_limit) {
  Work work;
  const trace::Ray line(ray(p, v));
  const VolumeTest found = verdict(volume, PrecomputedRay(line, all_slabs), limit, work);
  return {found, work.volumes};
}

}  // namespace

TEST_CASE("an intersection costs its tests up to the first that fails, a union up to the first that is met") {
  const Simple ball = surface::Ball{{0, 0, 0}, 2}, box = surface::Box{{-1, -1, -3}, {1, 1, 3}};
  const Volume both{{ball, box}, Volume::Rule::intersection}, either{{ball, box}, Volume::Rule::union_of};
  const glm::dvec3 x(1, 0, 0);
  const auto check = [&](const Volume& volume, const glm::dvec3& p, VolumeTest expected, std::uint64_t tests,
                         double limit = trace::no_limit) {
    const Found found = of(volume, p, x, limit);
    CHECK(found.verdict == expected);
    CHECK(found.tests == tests);
  };
  check(both, {-9, 0, 0}, VolumeTest::met, 2);
  check(both, {-9, 1.5, 0}, VolumeTest::missed, 2);
  check(both, {-9, 0, 2.5}, VolumeTest::missed, 1);
  check(both, {-9, 9, 9}, VolumeTest::missed, 1);
  check(either, {-9, 0, 0}, VolumeTest::met, 1);
  check(either, {-9, 1.5, 0}, VolumeTest::met, 1);
  check(either, {-9, 0, 2.5}, VolumeTest::met, 2);
  check(either, {-9, 9, 9}, VolumeTest::missed, 2);
  check(both, {-9, 0, 0}, VolumeTest::beyond, 1, 5);
  check(either, {-9, 0, 0}, VolumeTest::beyond, 2, 5);
  check(either, {-9, 0, 2.5}, VolumeTest::beyond, 2, 5);
  check(either, {-9, 1.5, 0}, VolumeTest::beyond, 2, 5);
}

namespace {

/// T of a volume over isotropic lines through the ball of radius 3, in nanoseconds a line, by the costs of its parts.
double T(const Volume& volume, std::span<const double> B, double of_object) {
  Random random(6);
  double sum = 0;
  const int lines = 4000;
  for (int i = 0; i < lines; ++i) {
    const glm::dvec3 v = random.direction(), across = glm::normalize(glm::cross(v, glm::dvec3(v.y, v.z, -v.x)));
    const double angle = random.uniform(0, 2 * pi), off = 3 * std::sqrt(random.uniform(0, 1));
    const glm::dvec3 aside = off * (std::cos(angle) * across + std::sin(angle) * glm::cross(v, across));
    const Found found = of(volume, aside - 9.0 * v, v);
    for (std::size_t k = 0; k < found.tests; ++k) sum += B[k];
    if (found.verdict == VolumeTest::met) sum += of_object;
  }
  return sum / lines;
}

double least_of_simple(scene::ShapeView element, double of_object) {
  double least = 1e9;
  for (const VolumeKind& kind : accel::kinds()) {
    const double B[] = {kind.B};
    least = std::min(least, T(Volume{{kind.around(element, outline(element))}}, B, of_object));
  }
  return least;
}

}  // namespace

TEST_CASE("there are objects that an intersection bounds for less than any kind, and such that a union does") {
  // A disc: the ball is cheap and turns most lines away, of what is left the ellipsoid, which is flat, turns away half.
  const double half = std::sqrt(0.5), third = std::sqrt(1.0 / 3);
  const scene::Disc disc{{0, 0, 0}, 1, {half, half, 0}};
  const VolumeKind &ball = kind("ball"), &ellipsoid = kind("ellipsoid");
  const double both[] = {ball.B, ellipsoid.B};
  const Volume intersection{{ball.around(disc, outline(disc)), ellipsoid.around(disc, outline(disc))}};
  CHECK(T(intersection, both, accel::I) < least_of_simple(disc, accel::I));
  // Two balls far apart as one object, for which a capsule stands: between them there is nothing.
  const glm::dvec3 d(third);
  const scene::Cylinder capsule{-2.5 * d, 0.5, d, 5};
  const double each[] = {ball.B, ball.B};
  const Volume ends{{surface::Ball{-2.0 * d, 0.5}, surface::Ball{2.0 * d, 0.5}}, Volume::Rule::union_of};
  CHECK(T(ends, each, 2 * accel::I) < least_of_simple(capsule, 2 * accel::I));
}
