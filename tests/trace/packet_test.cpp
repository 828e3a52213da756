// Steps in lanes against the same steps one by one, bit for bit, under every instruction set of the machine.
#include "durero/trace/packet.hpp"

#include <bit>
#include <span>
#include <vector>

#include "durero/trace/tables.hpp"
#include "plain/plain.hpp"
#include "support/catch.hpp"
#include "support/elements.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"
#include "support/shapes.hpp"
#include "support/targets.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

using namespace durero;
using namespace durero::test;
using scene::ElementRef;
using trace::Decision;
using trace::Packet;
using trace::RootEstimate;

namespace {

/// Every ordinary number: 0, or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
Reals ordinary_range() {
  return rc::gen::map(rc::gen::pair(moderate(), rc::gen::inRange(-92, 93)),
                      [](const std::pair<double, int>& x) { return std::ldexp(x.first, x.second); });
}

struct Tally {
  int decided = 0, hits = 0, certain = 0, all = 0;
};

template <class Element>
struct Lanes {
  static constexpr model::Tipo tipo = Element::tipo;
  std::vector<Element> elements;
  std::vector<model::Rayo> rays;
  std::vector<trace::Ray> traced;
  Packet packet;

  /// Less than twice radio, or proporcion, away from the centre in each axis; of a triangle in its plane.
  static glm::dvec3 place_near(const Element& element) {
    double breadth = 0;
    if constexpr (requires { element.radio; }) {
      breadth = element.radio;
    } else if constexpr (requires { element.proporcion; }) {
      breadth = element.proporcion;
    }
    const glm::dvec3 off = *vec(rc::gen::map(rc::gen::inRange(-8, 9), [](int x) { return x / 4.0; }));
    if constexpr (requires { element.centro; }) {
      return element.centro + breadth * off;
    } else {
      const auto& [a, b, c] = element.vertices;
      return a + off.x / 2 * (b - a) + off.y / 2 * (c - a);
    }
  }

  /// Any ray, or as often one towards a place near the element.
  static model::Rayo ray(const Element& element, const Reals& numbers) {
    const model::Rayo ray = *test::rays(numbers);
    const glm::dvec3 v = place_near(element) - ray.p().xyz();
    if (*rc::gen::arbitrary<bool>() || v == glm::dvec3(0)) return ray;
    const model::Rayo aimed(ray.p(), model::Vector(v));
    return trace::Ray(aimed).ordinary ? aimed : ray;
  }

  Lanes(const rc::Gen<Element>& any, const Reals& numbers) {
    for (std::size_t lane = 0; lane < Packet::size; ++lane) {
      elements.push_back(*any);
      rays.push_back(ray(elements.back(), numbers));
      traced.emplace_back(rays.back());
      packet.set(lane, traced[lane], elements[lane]);
    }
  }
};

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

void same_finding(const RootEstimate& a, const RootEstimate& b) {
  RC_ASSERT(a.verdict == b.verdict);
  if (a.verdict != Decision::hit) return;
  RC_ASSERT(same(a.hi, b.hi) && a.lo == 0 && same(a.error, b.error));
  RC_ASSERT(same(a.slope.at_root, b.slope.at_root) && same(a.slope.at_root_error, b.slope.at_root_error));
  RC_ASSERT(same(a.slope.A, b.slope.A) && same(a.slope.A_error, b.slope.A_error));
}

/// A lane may be undecided where the triage of one ray decides, not otherwise.
template <class Element>
void check_triage(const Lanes<Element>& lanes, trace::Findings& findings, Tally& tally) {
  trace::triage(lanes.packet, lanes.tipo, findings);
  for (std::size_t lane = 0; lane < Packet::size; ++lane) {
    ++tally.all;
    if (findings[lane].verdict == Decision::undecided) continue;
    ++tally.decided;
    tally.hits += findings[lane].verdict == Decision::hit;
    same_finding(findings[lane], trace::triage(lanes.elements[lane], lanes.traced[lane], false));
  }
}

/// The same of rays that start on the element, of which the lanes need not be.
template <class Element>
void check_triage_from(const Lanes<Element>& lanes) {
  trace::Findings findings;
  trace::triage_from(lanes.packet, lanes.tipo, findings);
  for (std::size_t lane = 0; lane < Packet::size; ++lane)
    same_finding(findings[lane], trace::triage(lanes.elements[lane], lanes.traced[lane], true));
}

/// Of the same rays in columns, those that have a bit get of one element what it finds alone; eights without any stay
/// as they are. Each eight has the rays in an order of its own.
template <class Element>
void check_columns(const Lanes<Element>& lanes) {
  trace::RayColumns rays;
  std::uint64_t which = 0;
  for (const std::size_t eight : {std::size_t{0}, std::size_t{3}, std::size_t{7}})
    for (std::size_t lane = 0; lane < Packet::size; ++lane) {
      rays.set(8 * eight + lane, lanes.traced[(eight + lane) % Packet::size]);
      if (lane != eight) which |= std::uint64_t{1} << (8 * eight + lane);
    }
  for (const Element& element : lanes.elements) {
    trace::ColumnFindings findings;
    findings[4].hit = 0x5a;
    trace::triage(rays, which, element, findings);
    RC_ASSERT(findings[4].hit == 0x5a);
    for (std::size_t place = 0; place < trace::RayColumns::size; ++place) {
      if ((which >> place & 1) == 0) continue;
      const RootEstimate found = findings[place / 8][place % 8];
      if (found.verdict != Decision::undecided)
        same_finding(found, trace::triage(element, lanes.traced[(place / 8 + place) % Packet::size], false));
    }
    Packet one;
    for (std::size_t lane = 0; lane < Packet::size; ++lane)
      one.set(lane, lanes.traced[(3 + lane) % Packet::size], element);
    trace::Findings of_packet;
    trace::triage(one, lanes.tipo, of_packet);
    const auto used = static_cast<unsigned>(which >> 24 & 0xff);
    RC_ASSERT((findings[3].hit & used) == (of_packet.hit & used));
    RC_ASSERT((findings[3].undecided & used) == (of_packet.undecided & used));
  }
}

template <class Element>
void check_rounding(const Lanes<Element>& lanes, const trace::Findings& findings, Tally& tally) {
  trace::RoundedPacket rounded;
  trace::improve_and_round(lanes.packet, lanes.tipo, findings, rounded);
  for (std::size_t lane = 0; lane < Packet::size; ++lane) {
    const RootEstimate found = findings[lane];
    if (found.verdict != Decision::hit) continue;
    const RootEstimate better = trace::improved(lanes.elements[lane], lanes.traced[lane], false, found);
    const trace::RoundedPoint one = better.verdict == Decision::hit
                                        ? trace::rounded(lanes.elements[lane], lanes.traced[lane], better)
                                        : trace::RoundedPoint{};
    const bool certain = (rounded.certain >> lane & 1) != 0;
    RC_ASSERT(certain == one.certain);
    tally.certain += certain;
    if (!certain) continue;
    RC_ASSERT(same(rounded.t[lane], one.t) && same(rounded.x[lane], one.punto.x));
    RC_ASSERT(same(rounded.y[lane], one.punto.y) && same(rounded.z[lane], one.punto.z));
  }
}

template <class Element>
void check_plain(const Lanes<Element>& lanes) {
  trace::plain::Firsts firsts;
  trace::plain::first(lanes.packet, lanes.tipo, firsts);
  for (std::size_t lane = 0; lane < Packet::size; ++lane) {
    const auto one = trace::plain::first(trace::plain::quadratic(lanes.elements[lane], lanes.rays[lane], false));
    if ((firsts.undecided >> lane & 1) != 0) continue;
    const bool hit = (firsts.hit >> lane & 1) != 0;
    RC_ASSERT(hit == (one.resultado == model::Resultado::hit));
    if (hit) RC_ASSERT(firsts.t[lane] == one.t);
  }
}

template <class Element>
void check(const rc::Gen<Element>& elements, const Reals& numbers, Tally& tally) {
  const Lanes<Element> lanes(elements, numbers);
  for (const std::int64_t target : machine_targets()) {
    const Only_Target only(target);
    trace::Findings findings;
    check_triage(lanes, findings, tally);
    check_triage_from(lanes);
    check_columns(lanes);
    check_rounding(lanes, findings, tally);
    check_plain(lanes);
  }
}

Tally check_all(const Reals& numbers) {
  Tally tally;
  property("elements of every shape", [&] {
    check(spheres(numbers), numbers, tally);
    check(cylinders(numbers), numbers, tally);
    check(cones(numbers), numbers, tally);
    check(planes(numbers), numbers, tally);
    check(discs(numbers), numbers, tally);
    check(triangles(numbers), numbers, tally);
    check(truncated_cones(numbers), numbers, tally);
  });
  return tally;
}

}  // namespace

TEST_CASE("steps in lanes are the steps one by one, on ordinary scenes") {
  const Tally tally = check_all(moderate());
  if (sanitized) return;  // too few for shares
  CHECK(tally.decided > tally.all * 9 / 10);
  CHECK(tally.hits > tally.all / 10);
  CHECK(tally.certain > tally.hits * 9 / 10);
}

TEST_CASE("steps in lanes are the steps one by one, on grids") {
  const Tally tally = check_all(dyadicGrid());
  if (sanitized) return;  // too few for shares
  CHECK(tally.hits > tally.all / 10);
}

TEST_CASE("steps in lanes are the steps one by one, over the whole ordinary range") {
  const Tally tally = check_all(ordinary_range());
  if (sanitized) return;  // too few for shares
  CHECK(tally.decided > tally.all / 2);
  CHECK(tally.hits > tally.all / 50);
}

TEST_CASE("rays in columns start on an element where type and row are those that they were told") {
  const ElementRef sphere{model::Tipo::soy_esfera, 7}, cone{model::Tipo::soy_cono, 7}, other{model::Tipo::soy_cono, 8};
  trace::RayColumns rays;
  std::uint64_t on_cone = 0;
  for (std::size_t place = 0; place < trace::RayColumns::size; ++place) {
    trace::Ray told(ray({0, 0, 0}, {0, 0, 1}));
    if (place % 4 != 0) told.start_on(place % 4 == 1 ? sphere : place % 4 == 2 ? cone : other);
    rays.set(place, told);
    rays.set_start(place, told.start());
    if (place % 4 == 2) on_cone |= std::uint64_t{1} << place;
  }
  for (const std::int64_t target : machine_targets()) {
    const Only_Target only(target);
    CHECK(trace::starting_on(rays, ~std::uint64_t{}, cone) == on_cone);
    CHECK(trace::starting_on(rays, std::uint64_t{0xf0f} << 40, cone) == (on_cone & std::uint64_t{0xf0f} << 40));
    CHECK(trace::starting_on(rays, ~std::uint64_t{}, {model::Tipo::soy_disco, 7}) == 0);
  }
}

TEST_CASE("of rays in columns, the eights that have a bit are found by their first places") {
  CHECK(trace::eights_of(0) == 0);
  for (std::size_t place = 0; place < trace::RayColumns::size; ++place) {
    const std::uint64_t one = std::uint64_t{1} << place, first = std::uint64_t{1} << place / 8 * 8;
    CHECK(trace::eights_of(one) == first);
    CHECK(trace::eights_of(one | 0x8001) == (first | 0x0101));
  }
}

TEST_CASE("rays that follow each other come into a queue with one element while there is room") {
  scene::Scene scene;
  const ElementRef first = add(scene, scene::Sphere{{0, 0, 5}, 1}), second = add(scene, scene::Sphere{{0, 0, 6}, 2});
  std::vector<trace::Ray> rays;
  for (int i = 0; i < 9; ++i) rays.emplace_back(ray({0, 0, 0.25 * i}, {0, 0, 1}));
  const trace::Tables tables(scene);
  trace::Queue queue;
  CHECK(queue.push(tables, 40, std::span(rays).first(3), first) == 3);
  CHECK_FALSE(queue.full());
  CHECK(queue.push(tables, 43, std::span(rays).subspan(3), second) == 5);
  CHECK(queue.full());
  for (std::size_t lane = 0; lane < Packet::size; ++lane) {
    CHECK(queue.numbers[lane] == 40 + lane);
    CHECK(queue.elements[lane] == (lane < 3 ? first : second));
    CHECK(queue.packet.p[2][lane] == 0.25 * static_cast<double>(lane));
    CHECK(queue.packet.centro[2][lane] == (lane < 3 ? 5 : 6));
    CHECK(queue.packet.radio[lane] == (lane < 3 ? 1 : 2));
  }
}

TEST_CASE("what touches is undecided in its lane alone") {
  const trace::Ray tangent(ray({1, 0, 0}, {0, 0, 1})), met(ray({0, 0, 0}, {0, 0, 1})),
      missed(ray({2, 0, 0}, {0, 0, 1}));
  for (const std::int64_t target : machine_targets()) {
    const Only_Target only(target);
    Packet packet;
    for (std::size_t lane = 0; lane < Packet::size; ++lane) {
      packet.set(lane, lane == 5 ? tangent : lane % 2 == 0 ? met : missed, scene::Sphere{{0, 0, 5}, 1});
    }
    trace::Findings findings;
    trace::triage(packet, model::Tipo::soy_esfera, findings);
    CHECK(findings.undecided == 0b00100000);
    CHECK(findings.hit == 0b01010101);
    trace::RoundedPacket rounded;
    trace::improve_and_round(packet, model::Tipo::soy_esfera, findings, rounded);
    CHECK((rounded.certain & findings.hit) == findings.hit);
    CHECK(rounded.t[2] == 4);
    CHECK(rounded.z[2] == 4);
  }
}
