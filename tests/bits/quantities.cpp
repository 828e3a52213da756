// Prints a digest of the bits of what the closed forms compute of random rays, for each shape: the quadratic with its
// errors, the root of the discriminant, the stable sum and both quotients. Those in lanes, under every instruction set
// of the machine, must be those of one number at a time; else the status is 1. levels.sh compares such programs.
#define HWY_TARGET_INCLUDE "bits/quantities.cpp"  // as seen from tests/
#include "lanes/for_each_target.hpp"
//
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "trace/closed_form-inl.hpp"
#include "trace/packet_lanes-inl.hpp"

#ifndef DURERO_BITS_QUANTITIES
#define DURERO_BITS_QUANTITIES
namespace durero::test {

/// A quantity in every lane.
struct alignas(64) Row {
  trace::Packet::Column lane{};
};
using Rows = std::vector<Row>;

/// Eight rays, each against an element of the shape.
template <class Shape>
struct Cases {
  std::vector<Shape> elements;
  std::vector<trace::Ray> rays;
  trace::Packet packet;
};

}  // namespace durero::test
#endif

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

/// Writes one quantity after the other, from a lane on.
struct Writer {
  test::Rows& rows;
  std::size_t lane, row = 0;

  double* next() {
    if (row == rows.size()) rows.emplace_back();
    return &rows[row++].lane[lane];
  }
  void operator()(double x) { *next() = x; }
  void operator()(const DoubleDouble& x) {
    *next() = x.hi;
    *next() = x.lo;
  }
  HWY_ATTR void operator()(Lanes x) { x.store(next()); }
};

template <class T>
HWY_ATTR void write_quantities(const BoundedQuadratic<T>& f, Writer put) {
  put(f.A), put(f.B), put(f.C), put(f.F), put(f.H);
  put(f.A_error), put(f.B_error), put(f.C_error);
  put(f.s0), put(f.s1), put(f.margin), put(f.margin_error);
  const Approximation<T> S = root_of_discriminant(f);
  const Stable<T> sum = stable_sum(f, S);
  put(S.value), put(S.error), put(sum.q.value), put(sum.q.error);
  const Root<T> of_A = quotient(sum.q.value, sum.q.error, f.A, f.A_error);
  const Root<T> of_C = quotient(f.C, f.C_error, sum.q.value, sum.q.error);
  put(of_A.t), put(of_A.error), put(of_C.t), put(of_C.error);
}

void rows_in_lanes(const Packet& packet, model::Tipo tipo, test::Rows& rows) {
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>) HWY_ATTR {
    for (std::size_t at = 0; at < Packet::size; at += lanes())
      write_quantities(quadratic<Lanes>(element<Shape::tipo>(packet, at), rays(packet, at)), Writer{rows, at});
  });
}

template <class T, class Shape>
void rows_one_by_one(const test::Cases<Shape>& cases, test::Rows& rows) {
  for (std::size_t lane = 0; lane < Packet::size; ++lane)
    write_quantities(quadratic<T>(cases.elements[lane], cases.rays[lane]), Writer{rows, lane});
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <fmt/core.h>

#include "durero/conform/random.hpp"
#include "durero/model/operaciones.hpp"
#include "support/shapes.hpp"
#include "support/targets.hpp"

namespace durero::trace {
namespace {
HWY_EXPORT(rows_in_lanes);
}  // namespace
}  // namespace durero::trace

namespace {

using namespace durero;
namespace steps = trace::HWY_NAMESPACE;
using test::Cases;
using test::Row;
using test::Rows;
using trace::Packet;

constexpr std::uint64_t seed = 20;

/// Some of the numbers of moderate size, some from all over the ordinary range.
struct Draw {
  conform::Random random{seed};

  double number() { return random.chance(1, 4) ? random.number(-90, 90) : random.number(-6, 6); }
  double positive() { return std::abs(number()); }
  glm::dvec3 triple() { return {number(), number(), number()}; }

  template <class Shape>
  Shape shape() {
    Shape drawn{};
    if constexpr (requires { drawn.centro; }) drawn.centro = triple();
    if constexpr (requires { drawn.radio; }) drawn.radio = positive();
    if constexpr (requires { drawn.proporcion; }) drawn.proporcion = positive();
    if constexpr (requires { drawn.vector; }) drawn.vector = random.direction();
    if constexpr (requires { drawn.altura; }) drawn.altura = positive();
    if constexpr (requires { drawn.vertices; }) drawn.vertices = {triple(), triple(), triple()};
    return drawn;
  }

  template <class Shape>
  Cases<Shape> cases() {
    Cases<Shape> drawn;
    for (std::size_t lane = 0; lane < Packet::size; ++lane) {
      drawn.elements.push_back(shape<Shape>());
      drawn.rays.emplace_back(test::ray(triple(), triple()));
      drawn.packet.set(lane, drawn.rays[lane], drawn.elements[lane]);
    }
    return drawn;
  }
};

/// The bits; of a number that is none the sign and the payload are nobody's.
std::uint64_t bits(double x) { return std::isnan(x) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(x); }

bool same(const Rows& a, const Rows& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t row = 0; row < a.size(); ++row)
    for (std::size_t lane = 0; lane < Packet::size; ++lane)
      if (bits(a[row].lane[lane]) != bits(b[row].lane[lane])) return false;
  return true;
}

/// FNV-1a, a number at a time.
void fold(std::uint64_t& digest, const Rows& rows) {
  for (const Row& row : rows)
    for (const double x : row.lane) digest = (digest ^ bits(x)) * 0x100000001b3;
}

template <class Shape>
bool print_digest() {
  constexpr int packets = 2000;
  Draw draw;
  std::uint64_t digest = 0xcbf29ce484222325;
  for (int i = 0; i < packets; ++i) {
    const Cases<Shape> cases = draw.cases<Shape>();
    Rows one, twofold;
    steps::rows_one_by_one<double>(cases, one);
    steps::rows_one_by_one<steps::DoubleDouble>(cases, twofold);
    for (const std::int64_t target : test::machine_targets()) {
      const test::Only_Target only(target);
      Rows lanes;
      HWY_DYNAMIC_DISPATCH(trace::rows_in_lanes)(cases.packet, Shape::tipo, lanes);
      if (same(lanes, one)) continue;
      fmt::print("{}: other bits in lanes of {}, seed {}, packet {}\n", Shape::Addition::schema,
                 hwy::TargetName(target), seed, i);
      return false;
    }
    fold(digest, one);
    fold(digest, twofold);
  }
  fmt::print("{:18} {:016x}\n", Shape::Addition::schema, digest);
  return true;
}

}  // namespace

int main() {
  bool all = true;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { all = print_digest<Shape>() && all; });
  return all ? 0 : 1;
}
#endif
