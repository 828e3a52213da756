// The search orders elements by the errors that the steps state, and leaves what lies within them to the next step.
// Over steps by tables it is held against its model, proofs/Search.v: here by recorded answers, in
// tests/proofs/search.sh by new ones.
#include "durero/trace/search.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>

#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "support/tree.hpp"
#include "trace/drawn_step_table.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

using namespace durero;
using namespace durero::test;

TEST_CASE("parameters closer than the sum of their errors are ordered exactly") {
  // Two unit spheres, the second off the ray by y, so that it is met y²/2 later.
  const model::Rayo along_x = ray({0, 0, 0}, {1, 0, 0});
  const scene::Sphere first{{2, 0, 0}, 1};
  const double error = stable(first, trace::Ray(along_x), false).error;
  const auto ordered_by = [&](double apart) {
    scene::Scene scene;
    add(scene, first);
    add(scene, scene::Sphere{{2, std::sqrt(2 * apart), 0}, 1});
    trace::Counts counts;
    first_hit(trace::Tables(scene), along_x, {}, &counts);
    return counts.order;
  };
  CHECK(ordered_by(2 * error * 0.99)[2] == 1);
  CHECK(ordered_by(2 * error * 0.6)[2] == 1);
  CHECK(ordered_by(2 * error * 4)[2] == 0);
}

TEST_CASE("elements that floating point finds alike are no tie unless they are equal") {
  scene::Scene scene;
  const scene::ElementRef first = add(scene, scene::Sphere{{2, 0, 0}, 1});
  add(scene, scene::Sphere{{2, 0x1p-30, 0}, 1});  // met 2⁻⁶¹ later
  const model::Rayo along_x = ray({0, 0, 0}, {1, 0, 0});
  CHECK(first_hit(trace::Tables(scene), along_x, {}, nullptr).elementos == scene::ElementSet{first});
  const scene::ElementRef again = add(scene, scene::Sphere{{2, 0, 0}, 1});
  CHECK(first_hit(trace::Tables(scene), along_x, {}, nullptr).elementos == scene::ElementSet{first, again});
}

TEST_CASE("elements with the same bits of a finding are no tie unless their numbers are equal") {
  scene::Scene scene;
  add(scene, scene::Sphere{{0x1p20, 0, 0}, 1});
  const scene::ElementRef nearest = add(scene, scene::Sphere{{0x1p20, 0, 0}, 1 + 0x1p-50});  // by less than t can tell
  add(scene, scene::Sphere{{0x1p20, 0, 0}, 1 + 0x1p-52});
  const model::Rayo along_x = ray({0, 0, 0}, {1, 0, 0});
  CHECK(first_hit(trace::Tables(scene), along_x, {}, nullptr).elementos == scene::ElementSet{nearest});
}

TEST_CASE("what no step in floating point is certain of is rounded from the exact parameter") {
  // A sphere met at 1 + 2⁻⁵³ and at 1 + 3·2⁻⁵³, each halfway between two binary64: the even one is told. Both are met
  // at 1 along the axis, which is rounded of p + t·v and not of p and the rounded t.
  const auto first = [](double centre, double p) {
    scene::Scene scene;
    add(scene, scene::Sphere{{centre, 0, 0}, 1});
    trace::Counts counts;
    const scene::Hit hit = first_hit(trace::Tables(scene), ray({p, 0, 0}, {1, 0, 0}), {}, &counts);
    CHECK(counts.rounding[2] == 1);
    return hit;
  };
  CHECK(first(2, -0x1p-53).t == 1);
  CHECK(first(2, -0x1p-53).punto == glm::dvec3(1, 0, 0));
  CHECK(first(2, -0x1.8p-52).t == 1 + 0x1p-51);
  CHECK(first(2, -0x1.8p-52).punto == glm::dvec3(1, 0, 0));
}

namespace {

bool same(const trace::RootEstimate& a, const trace::RootEstimate& b) {
  return a.hi == b.hi && a.lo == b.lo && a.error == b.error;
}
bool same(const trace::RoundedPoint& a, const trace::RoundedPoint& b) { return a.t == b.t && a.punto == b.punto; }

/// What the search says of one element is what these steps say, in their order.
template <class Shape>
void check_steps(const trace::Search& search, scene::ElementRef e, const Shape& shape, const model::Rayo& rayo, bool on,
                 double limit) {
  const trace::Ray& ray = search.ray();
  const trace::Meeting met = search.meeting(e, limit);
  const bool in_range = ray.ordinary && trace::ordinary(shape);
  const auto first = in_range ? trace::triage(shape, ray, on, limit) : trace::RootEstimate{trace::Decision::undecided};
  const auto second = in_range ? trace::stable(shape, ray, on, limit) : first;
  const bool by_triage = first.verdict != trace::Decision::undecided;
  const auto& said = by_triage ? first : second;
  if (said.verdict == trace::Decision::undecided) {
    REQUIRE(met.step == trace::Step::exact);
    const auto reach = surface::exact::reach(shape, rayo, on);
    REQUIRE((met.kind == trace::Meeting::Kind::none) == reach.empty());
    REQUIRE((met.kind == trace::Meeting::Kind::no_minimum) == reach.no_minimum());
    if (met.kind != trace::Meeting::Kind::point) return;
    REQUIRE(*met.t == reach.first());
    const double nearest = number::round_to_binary64(reach.first());
    REQUIRE((met.low < nearest && nearest < met.high));
    const scene::Hit hit = surface::exact::rounded_hit(rayo, reach.first(), {});
    REQUIRE(same(search.rounded_hit(e, met), {true, hit.t, hit.punto}));
    return;
  }
  REQUIRE(met.step == (by_triage ? trace::Step::triage : trace::Step::stable));
  REQUIRE((met.kind == trace::Meeting::Kind::point) == (said.verdict == trace::Decision::hit));
  if (met.kind != trace::Meeting::Kind::point) return;
  REQUIRE(same(met.finding, said));
  const auto [low, high] = by_triage ? trace::ends_of(said.hi, said.error) : trace::ends_of_pair(said.hi, said.error);
  REQUIRE((met.low == low && met.high == high));
  const auto best = by_triage ? trace::improved(shape, ray, on, said) : said;
  const auto once = best.verdict == trace::Decision::hit ? trace::rounded(shape, ray, best) : trace::RoundedPoint{};
  if (once.certain) REQUIRE(same(search.rounded_hit(e, met), once));
}

}  // namespace

TEST_CASE("the steps of the search are the decisions that are proved, and exact numbers") {
  Random random(1);
  trace::Counts counts;
  for (int i = 0; i < 400; ++i) {
    scene::Scene scene = random_scene(random, 8);
    add(scene, scene::Sphere{{0, 0, 5}, 1});
    model::Rayo rayo = random_ray(random);
    if (i % 8 == 0) rayo = {model::Punto(rayo.p().xyz()), model::Vector(rayo.v().xyz() * 0x1p101)};  // out of range
    if (i % 8 == 1) rayo = ray({0, 0, 0}, {0, 0, 1});
    if (i % 8 == 2) rayo = ray({1 - std::ldexp(1, -40 - i % 100 / 8), 0, 0}, {0, 0, 1});  // which grazes the sphere
    scene::ElementRef own{};
    scene.for_each([&](scene::ElementRef e, const auto&) { own = e; });
    const trace::Search search(scene, rayo, own, counts);
    scene.for_each([&](scene::ElementRef e, const auto& shape) {
      for (const double limit : {trace::no_limit, 1.0}) check_steps(search, e, shape, rayo, e == own, limit);
    });
  }
  for (const std::uint64_t decided : counts.element) CHECK(decided > 20);
}

TEST_CASE("over the steps of a table the search answers as the model extracted from its proofs") {
  std::ifstream recorded(source_dir() + "/tests/trace/search_answers.txt");
  std::string line;
  std::uint64_t number = 0;
  for (; std::getline(recorded, line); ++number) {
    INFO("table " << number << " of seed 1");
    REQUIRE(answer(DrawnStepTable(1, number).table()) == line);
  }
  CHECK(number == 1000);
}

TEST_CASE("elements of equal numbers that different steps found are told apart, as the model does") {
  CHECK(answer(DrawnStepTable(7, 1682).table()) == "3; 0t 3s;; hit 3 0; 1111; 0100");
}

namespace {

/// What is met first, by the exact step alone.
std::string first_by_exact(const StepTable& table) {
  const auto parameter = [&](const TableElement& e) {
    return TableSteps::parameter(table.parameters[static_cast<std::size_t>(e.reach)]);
  };
  std::string begun, first;
  const TableElement* least = nullptr;
  for (std::size_t i = 0; i < table.elements.size(); ++i) {
    const TableElement& e = table.elements[i];
    if (e.reach == no_minimum) begun += ' ' + std::to_string(i);
    if (e.reach < 0) continue;
    const auto side = least ? surface::exact::order(parameter(e), parameter(*least)) : std::strong_ordering::less;
    if (side < 0) least = &e, first.clear();
    if (side <= 0) first += ' ' + std::to_string(i);
  }
  if (!begun.empty()) return "none" + begun;
  if (!least) return "miss";
  return "hit " + std::to_string(table.parameters[static_cast<std::size_t>(least->reach)].rounded) + first;
}

}  // namespace

TEST_CASE("over steps that say nothing false the search publishes what is first by exact numbers") {
  const char* given = std::getenv("SEARCH_SEED");
  const std::uint64_t seed = given ? std::strtoull(given, nullptr, 10) : std::random_device{}();
  INFO("replay with SEARCH_SEED=" << seed);
  for (std::uint64_t number = 0; number < 4000; ++number) {
    INFO("table " << number);
    const DrawnStepTable drawn(seed, number);
    if (!drawn.right()) continue;
    const std::string line = answer(drawn.table()), first = first_by_exact(drawn.table());
    REQUIRE(line.find("; " + first + "; ") != std::string::npos);
  }
}

namespace {

/// The steps of a table, counted.
struct CountedSteps : TableSteps {
  explicit CountedSteps(const StepTable& table) : TableSteps{table} {}
  mutable std::size_t stables = 0, reaches = 0, exact_orders = 0, orders = 0;

  trace::RootEstimate stable(const Element& e, bool on, double limit) const {
    return ++stables, TableSteps::stable(e, on, limit);
  }
  surface::exact::Reach reach(const Element& e, bool on) const { return ++reaches, TableSteps::reach(e, on); }
  std::strong_ordering order(const Parameter& a, const Parameter& b) const {
    return ++exact_orders, TableSteps::order(a, b);
  }
  std::strong_ordering order_of_numbers(scene::ElementRef a, scene::ElementRef b) const {
    return ++orders, TableSteps::order_of_numbers(a, b);
  }
};

/// n elements of equal numbers, in two kinds that take turns, all met at 1.
StepTable ties(std::size_t n) {
  StepTable table;
  table.parameters = some_parameters();
  constexpr int one = 5;
  table.parameters[one].low = limit_of(0.5), table.parameters[one].high = limit_of(1.5);
  const Limit low = limit_of(0.5), high = limit_of(1.5);
  table.findings = {{low, high, low, high, 0, {false}}};
  TableElement e{};
  e.in_range = true, e.improved = {0}, e.rounded = {uncertain}, e.reach = one;
  e.triage.fill(0), e.stable.fill(0);
  for (std::size_t i = 0; i < n; ++i) table.elements.push_back(e), table.elements.back().on = i % 2 == 1;
  return table;
}

}  // namespace

TEST_CASE("ties of equal elements are told by as many steps as one of each kind needs") {
  const auto counted = [](std::size_t n) {
    const StepTable table = ties(n);
    const CountedSteps steps(table);
    trace::Counts counts;
    trace::SearchState found;
    for (std::size_t i = 0; i < n; ++i) take(steps, found, element_at(i), trace::Search::Range::unknown, counts);
    CHECK(published(steps, found, counts).elementos.size() == n);
    CHECK(counts.order[2] == 1);
    return std::array{steps.stables, steps.reaches, steps.exact_orders, steps.orders};
  };
  const auto few = counted(100), many = counted(10'000);
  for (const std::size_t step : {0, 1, 2}) CHECK(many[step] == few[step]);
  CHECK(few[1] == 2);
  CHECK(many[3] < 250 * few[3]);  // n log n: a hundredfold and twice the logarithm; n² would be 10000-fold
}
