#include "durero/conform/families.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "durero/surface/exact.hpp"
#include "members.hpp"
#include "recipes.hpp"

namespace durero::conform {
namespace {

namespace r = recipes;

// Names, kinds and reasons as in the table of the design; issues are those of the projects named.
constexpr Family table[] = {
    {"generic",
     "random scenes and rays of moderate scale",
     "the ordinary case",
     {"elements", 1, 8},
     0.9,
     0.12,
     r::as_many,
     r::generic,
     hits,
     coincides},
    {"far_origin",
     "an element from 10³ to 10⁸ of its sizes away",
     "mitsuba3#512, OSPRay#179",
     {"log2 of the distance", 10, 27},
     0.85,
     0.1,
     r::some,
     r::far_origin,
     from_far,
     coincides},
    {"large_offset",
     "the whole scene far from 0",
     "pbrt-v3#265, mitsuba2#171",
     {"log2 of the offset", 10, 27},
     0.85,
     0.1,
     r::large_offset,
     r::generic,
     far_from_zero,
     coincides},
    {"distance_limit",
     "hits at distances from 10⁶ to 10³⁰",
     "POV-Ray#469, POV-Ray#215",
     {"log2 of the scale", 15, 93},
     0.85,
     0.1,
     r::scaled_up,
     r::generic,
     hits_far,
     coincides},
    {"tiny",
     "sizes from 10⁻³ to 10⁻³⁰",
     "celeritas#1897: absolute epsilons",
     {"log2 of the scale", -106, -17},
     0.85,
     0.1,
     r::scaled_up,
     r::generic,
     hits_tiny,
     coincides},
    {"huge_ratio",
     "small elements beside one 10⁶ to 10¹² as large",
     "OSPRay#600",
     {"log2 of the ratio", 26, 40},
     0.9,
     0.1,
     r::huge_ratio,
     r::near_small,
     sizes_differ,
     coincides},
    {"direction_scale",
     "v times a power of two",
     "Embree#230: t must scale with it",
     {"log2 of the factor", -60, 60},
     0.6,
     0.08,
     r::some,
     r::direction_scale,
     long_or_short,
     coincides},
    {"near_axial",
     "nearly or exactly parallel to a cylinder's axis",
     "McCode#986, celeritas#627, VisRTX#73",
     {"−log2 of the slope", 20, 42},
     0.99,
     0.2,
     r::near_axial,
     r::near_axial,
     nearly_axial,
     axial},
    {"perpendicular",
     "the axial part of v exactly 0",
     "OSPRay#482, OSPRay#302",
     {"log2 of the distance", 0, 6},
     0.8,
     0.8,
     r::some_axial,
     r::perpendicular,
     perpendicular,
     perpendicular},
    {"near_generator",
     "nearly or exactly along a generator",
     "Geant4 PR#116, OpenMC#143",
     {"−log2 of the angle", 26, 40},
     0.99,
     0.15,
     r::some_axial,
     r::near_generator,
     nearly_generator,
     generator},
    {"second_nappe",
     "a root on the mirrored nappe comes first",
     "pbrt-v3#168",
     {"eighths past the apex", 1, 8},
     0.9,
     0.06,
     r::some_cones,
     r::second_nappe,
     mirrored_first,
     coincides},
    {"apex",
     "through the apex, and beside it by a unit in the last place",
     "raysect#8, SIREN#186",
     {"log2 of the distance", 0, 6},
     0.99,
     0.2,
     r::some_cones,
     r::apex,
     nearly_apex,
     apex},
    {"rim",
     "through a rim, and beside it by a unit in the last place",
     "VisRTX#334",
     {"log2 of the distance", 0, 6},
     0.95,
     0.3,
     r::rim,
     r::rim,
     nearly_rim,
     rim},
    {"long_thin",
     "altura from 10³ to 10⁷ radii",
     "OSPRay#600, Embree#332",
     {"log2 of the ratio", 10, 24},
     0.8,
     0.12,
     r::long_thin,
     r::long_thin,
     long_and_thin,
     coincides},
    {"inside",
     "from inside: the exit",
     "Embree#320, three.js#15454",
     {"quarters of the way to the axis", 1, 4},
     0.85,
     0.12,
     r::some,
     r::inside,
     inside,
     coincides},
    {"on_surface",
     "from the surface, exactly and nearly, named and not",
     "pbrt-v3#44, OSPRay#279",
     {"% named", 60, 80},
     0.9,
     0.35,
     r::with_twin,
     r::on_surface,
     starts_on,
     starts_exactly_on},
    {"near_origin",
     "the first point at 10⁻³ to 10⁻¹⁵ of the size",
     "a near root passed over for the far one",
     {"−log2 of the distance", 11, 50},
     0.8,
     0.08,
     r::some,
     r::near_origin,
     hits_near,
     coincides},
    {"tangent",
     "D = 0, and beside it by a unit in the last place",
     "raytracing.github.io#1057, RTK#440",
     {"log2 of the distance", 0, 6},
     0.99,
     0.2,
     r::tangent,
     r::tangent,
     nearly_tangent,
     tangent},
    {"zero_b",
     "the half-linear coefficient B exactly 0",
     "ArborX#461",
     {"% from a centre", 10, 40},
     0.85,
     0.35,
     r::some,
     r::zero_b,
     nearly_zero_b,
     zero_b},
    {"tie",
     "two elements at one point",
     "OpenMC#260, Embree#20: all are the answer",
     {"log2 of the distance", 0, 6},
     0.75,
     0.55,
     r::tie,
     r::tie,
     nearly_tie,
     tie},
    {"in_surface",
     "the ray lies in the surface",
     "a segment, or no minimum",
     {"eighths of altura from a point", 0, 16},
     0.95,
     0.15,
     r::some_axial,
     r::in_surface,
     nearly_in_surface,
     in_surface},
    {"axis_parallel",
     "coordinates of v 0, −0 or subnormal",
     "pbrt-v4#359",
     {"log2 of the distance", 0, 6},
     0.75,
     0.55,
     r::some,
     r::axis_parallel,
     aligned,
     exactly_aligned},
    {"degenerate_numbers",
     "subnormal numbers, and near overflow",
     "squares that overflow or vanish in either format",
     {"log2 of the scale", -1072, 1003},
     0.6,
     0.08,
     r::degenerate_numbers,
     r::degenerate_numbers,
     beyond_binary32,
     coincides},
    {"grid_snapped",
     "every coordinate a small multiple of 1/4",
     "Geant4's solid tests: every coincidence happens",
     {"elements", 2, 6},
     0.99,
     0.12,
     r::grid,
     r::grid,
     on_grid,
     coincides},
};

/// A stream of its own for each family and seed.
std::uint64_t seed_of(const Family& family, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : family.name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash ^ (seed * 0x9e3779b97f4a7c15);
}

bool is_ray(const Shot& shot) {
  const auto finite = [](const glm::dvec3& x) {
    return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
  };
  return finite(shot.p) && finite(shot.v) && shot.v != glm::dvec3(0);
}

std::string name_of(std::size_t place) { return "e" + std::to_string(place); }

scene::Query query(const scene::Scene& scene, const Shot& shot) {
  scene::Query ray{{model::Punto(shot.p), model::Vector(shot.v)}, {}};
  for (const std::size_t place : shot.on) ray.en.push_back(*scene.find(name_of(place)));
  std::sort(ray.en.begin(), ray.en.end());
  return ray;
}

}  // namespace

std::span<const Family> families() { return table; }

const Family* find_family(std::string_view name) {
  const auto* found = std::find_if(std::begin(table), std::end(table), [&](const Family& f) { return f.name == name; });
  return found == std::end(table) ? nullptr : found;
}

Case generate(const Family& family, std::uint64_t seed, std::size_t rays) {
  Random random(seed_of(family, seed));
  const int parameter = random.integer(family.parameter.least, family.parameter.greatest);
  const std::vector<Body> bodies = family.bodies(random, parameter);
  Case made;
  for (std::size_t i = 0; i < bodies.size(); ++i) made.scene.apply(bodies[i].operation(model::Elemento(name_of(i))));
  while (made.rays.size() < rays) {
    const Shot shot = family.shot(random, parameter, bodies);
    if (is_ray(shot)) made.rays.push_back(query(made.scene, shot));
  }
  return made;
}

Membership membership(const Family& family, const Case& the_case, const scene::Query& ray) {
  const scene::Hit hit = surface::exact::first_hit(the_case.scene, ray.rayo, ray.en);
  const Ray_And_Hit seen{the_case.scene, ray, hit};
  const bool exact = family.is_exact(seen);
  return {family.is_member(seen), exact};
}

Count& Count::operator+=(const Count& other) {
  rays += other.rays;
  members += other.members;
  exact += other.exact;
  return *this;
}

Count count(const Family& family, const Case& the_case) {
  Count counted{.rays = the_case.rays.size()};
  for (const scene::Query& ray : the_case.rays) {
    const Membership is = membership(family, the_case, ray);
    counted.members += is.member;
    counted.exact += is.member && is.exact;
  }
  return counted;
}

}  // namespace durero::conform
