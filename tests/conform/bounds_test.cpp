// Every bound of every step, measured: |computed − exact|/bound over all families, over scaled copies of them that take
// up the whole range of exponents, over rays whose numbers have any exponents, and over cases found by climbing from
// the worst of these. No ratio may exceed 1. BOUNDS_SEED=N takes other cases; BOUNDS_REPLAY=LINE measures one case
// again.
#include <fmt/core.h>

#include <algorithm>
#include <random>

#include "bounds_measured.hpp"
#include "bounds_widths.hpp"
#include "conform/families/drawn_ray.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/scene/addition.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::test;
using conform::Family;
using conform::Random;

namespace {

/// visit(attribute, field) for each attribute of the element.
template <class Visit>
void for_each_field(Element& element, Visit visit) {
  std::visit(
      [&]<class Shape>(Shape& shape) {
        scene::for_each_attribute<Shape>([&](const auto& attribute) { visit(attribute, shape.*attribute.field); });
      },
      element);
}

/// The axis of the element, or null.
glm::dvec3* axis(Element& element) {
  glm::dvec3* found = nullptr;
  for_each_field(element, [&]<class Stored>(const auto& attribute, Stored& stored) {
    if constexpr (std::is_same_v<Stored, glm::dvec3>) {
      if (attribute.word == "vector") found = &stored;
    }
  });
  return found;
}

/// The numbers of a case that are free: all but the axis.
std::vector<double*> free_numbers(Specimen& specimen) {
  const glm::dvec3* d = axis(specimen.element);
  std::vector<double*> found;
  for_each_number(specimen, [&](double& x) {
    if (d == nullptr || (&x != &d->x && &x != &d->y && &x != &d->z)) found.push_back(&x);
  });
  return found;
}

bool is_unit(const glm::dvec3& d) {
  const Exact_Vector exact(d);
  return magnitude(dot(exact, exact) - Dyadic(1)) <= Dyadic(model::tolerancia_unidad);
}

/// The steps may be asked: every number is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰, and the element is one.
bool valid(Specimen specimen) {
  bool is_valid = specimen.v != glm::dvec3(0);
  for_each_number(specimen, [&](double x) {
    is_valid = is_valid && (x == 0 || (std::abs(x) >= 0x1p-100 && std::abs(x) <= 0x1p100));
  });
  if (!is_valid) return false;
  for_each_field(specimen.element, [&]<class Stored>(const auto&, const Stored& stored) {
    if constexpr (std::is_same_v<Stored, double>) is_valid = is_valid && stored > 0;
  });
  if (const auto* triangle = std::get_if<scene::Triangle>(&specimen.element))
    is_valid = is_valid && conform::are_corners(triangle->vertices);
  const glm::dvec3* d = axis(specimen.element);
  return is_valid && (d == nullptr || is_unit(*d));
}

/// All lengths times 2^k, v times 2^j.
Specimen scaled(Specimen specimen, int k, int j) {
  const auto times = [](double& x, int power) { x = std::ldexp(x, power); };
  for (int i = 0; i < 3; ++i) times(specimen.p[i], k), times(specimen.v[i], j);
  for_each_field(specimen.element, [&]<class Stored>(const auto& attribute, Stored& stored) {
    if (attribute.word == "proporcion" || attribute.word == "vector") return;
    for_each_coordinate(stored, [&](double& x) { times(x, k); });
  });
  return specimen;
}

/// Any exponents, each its own.
Specimen any_exponents(Random& random) {
  Specimen specimen;
  const auto tipo = static_cast<model::Tipo>(random.below(scene::shape_count));
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>) { specimen.element = Shape{}; });
  for_each_number(specimen, [&](double& x) { x = random.number(-100, 99); });
  for_each_field(specimen.element, [&]<class Stored>(const auto&, Stored& stored) {
    if constexpr (std::is_same_v<Stored, double>) stored = std::abs(stored);
  });
  if (glm::dvec3* d = axis(specimen.element)) *d = random.direction();
  return specimen;
}

/// One to three numbers a little or much changed, or the axis.
Specimen changed(Random& random, Specimen specimen) {
  const auto change = [&](double& x) {
    switch (random.below(4)) {
      case 0:
        x *= random.signed_power(-2, 2);
        break;
      case 1:
        x = std::copysign(std::ldexp(random.uniform(1, 2), x == 0 ? 0 : std::ilogb(x)), x);
        break;
      default:
        x += std::ldexp(random.signed_power(-52, -1), x == 0 ? 0 : std::ilogb(x));
    }
  };
  const std::vector<double*> of = free_numbers(specimen);
  for (int left = random.integer(1, 3); left > 0; --left) change(*of[random.below(of.size())]);
  if (glm::dvec3* d = axis(specimen.element); d != nullptr && random.chance(1, 4)) {
    const double size = random.signed_power(-52, 0);
    *d += size * random.in_cube(1);
    *d /= std::sqrt(d->x * d->x + d->y * d->y + d->z * d->z);
  }
  return specimen;
}

void measure(Table& table, const Specimen& specimen, bool generic = false) {
  if (valid(specimen)) table.add(specimen, generic, measured(specimen));
}

/// The element of each ray's first point, or any where it has none; as it is, and with all numbers scaled.
void measure_family(Table& table, const Family& family, std::uint64_t seed, std::size_t rays) {
  const conform::Case drawn = generate(family, seed, rays);
  Random random(seed);
  std::vector<scene::ElementRef> all;
  drawn.scene.for_each([&](scene::ElementRef e, const auto&) { all.push_back(e); });
  for (const scene::Query& ray : drawn.rays) {
    const scene::Hit hit = trace::first_hit(drawn.scene, ray.rayo, ray.en);
    const scene::ElementRef any = all[random.below(all.size())];
    const scene::ElementRef e = hit.elementos.empty() ? any : hit.elementos.front();
    Specimen specimen{{}, ray.rayo.p().xyz(), ray.rayo.v().xyz(), scene::Origin(ray.en).contains(e)};
    drawn.scene.visit(e, [&](const auto& shape) { specimen.element = shape; });
    const int k = random.integer(-99, 99), j = random.integer(-99, 99);
    measure(table, specimen, family.name == "generic");
    measure(table, scaled(specimen, k, j));
  }
}

/// A flat shape, of which generic scenes have none, alone and a generic ray.
Specimen generic_flat(conform::Draws& random) {
  constexpr std::array types{model::Tipo::soy_plano, model::Tipo::soy_disco, model::Tipo::soy_triangulo};
  const conform::FramedShape shape = any_shape(random, random.any_of(types));
  const conform::DrawnRay ray = ordinary(random, shape, random.integer(0, 4));
  scene::Scene alone;
  alone.apply(shape.addition(model::Elemento("e")));
  Specimen specimen{{}, ray.p, ray.v, false};
  alone.visit(*alone.find("e"), [&](const auto& of) { specimen.element = of; });
  return specimen;
}

/// Climbs from the worst case of each quantity and shape to worse ones.
void climb(Table& table, Random& random, std::size_t steps_each) {
  const auto rows = table.rows();
  for (const auto& [quantity, by_shape] : rows) {
    for (const Worst& start : by_shape) {
      if (start.all == 0) continue;
      Specimen best = start.where;
      double highest = start.all;
      for (std::size_t step = 0; step < steps_each; ++step) {
        const Specimen next = changed(random, best);
        if (!valid(next)) continue;
        const Ratios ratios = measured(next);
        table.add(next, false, ratios);
        for (const auto& [seen, ratio] : ratios) {
          if (seen == quantity && ratio >= highest) highest = ratio, best = next;
        }
      }
    }
  }
}

void print(const Table& table, std::uint64_t seed) {
  fmt::print("worst |computed − exact|/bound, BOUNDS_SEED={}; over generic rays, then over all\n", seed);
  fmt::print("{:9} {:16}", "step", "quantity");
  scene::for_each_shape([]<class Shape>(std::type_identity<Shape>) { fmt::print(" {:>15}", Shape::word); });
  fmt::print("\n");
  for (const auto& [quantity, by_shape] : table.rows()) {
    fmt::print("{:9} {:16}", quantity.step, quantity.name);
    for (const Worst& worst : by_shape) fmt::print(" {:7.4f} {:7.4f}", worst.generic, worst.all);
    const auto& worst = *std::max_element(by_shape.begin(), by_shape.end(),
                                          [](const Worst& a, const Worst& b) { return a.all < b.all; });
    fmt::print("  BOUNDS_REPLAY='{}'\n", line_of(worst.where));
  }
}

/// How many cases; a measure of the whole.
struct Extent {
  std::size_t scenes, any_exponents, steps_of_climbing;
};
constexpr Extent everyday{4, 2000, 1000}, for_long{80, 40000, 20000}, for_sanitizers{1, 200, 100};

Table measured_table(std::uint64_t seed, const Extent& extent) {
  Table table;
  conform::Draws random(seed);
  for (std::size_t scene = 0; scene < extent.scenes; ++scene) {
    for (const Family& family : conform::families_of_few()) measure_family(table, family, seed + scene, 25);
  }
  for (std::size_t i = 0; i < 250 * extent.scenes; ++i) measure(table, generic_flat(random), true);
  // Of generic rays ten times as many.
  for (std::size_t scene = extent.scenes; scene < 11 * extent.scenes; ++scene) {
    measure_family(table, *conform::find_family("generic"), seed + scene, 25);
  }
  for (std::size_t i = 0; i < extent.any_exponents; ++i) measure(table, any_exponents(random));
  climb(table, random, extent.steps_of_climbing);
  print(table, seed);
  return table;
}

/// No error exceeds its bound.
void check(const Table& table) {
  for (const auto& [quantity, by_shape] : table.rows()) {
    for (const Worst& worst : by_shape) {
      INFO(quantity.step << ' ' << quantity.name << ": BOUNDS_REPLAY='" << line_of(worst.where) << "'");
      CHECK(worst.all <= 1);
    }
  }
}

std::uint64_t seed_or(std::uint64_t otherwise) {
  const char* given = std::getenv("BOUNDS_SEED");
  return given ? std::strtoull(given, nullptr, 10) : otherwise;
}

}  // namespace

TEST_CASE("no error exceeds its bound, and no bound is much wider than need be") {
  if (const char* line = std::getenv("BOUNDS_REPLAY")) {
    for (const auto& [quantity, ratio] : measured(specimen_of(line))) {
      fmt::print("{:9} {:16} {}\n", quantity.step, quantity.name, ratio);
      CHECK(ratio <= 1);
    }
    return;
  }
  const Table table = measured_table(1, sanitized ? for_sanitizers : everyday);
  check(table);
  if (sanitized) return;  // too few cases to come near the bounds
  check_widths(table, false, exceptions);
  check_widths(table, true, exceptions_of_flat);
}

TEST_CASE("no error exceeds its bound, on twenty times as many cases of a new seed", "[long]") {
  check(measured_table(seed_or(std::random_device()()), for_long));
}
