// How many operations an intersection takes (A §1.1): of each shape on a miss and on a hit, by a number type that
// counts what the tracer's own templates ask of it. docs/acceleration-reference.md has the table.
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "durero/surface/surfaces.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "support/tree.hpp"
#include "trace/closed_form-inl.hpp"

namespace {

struct Operations {
  unsigned sums = 0, products = 0, quotients = 0, roots = 0;

  unsigned all() const { return sums + products + quotients + roots; }
  std::string text() const {
    return all() == 0 ? "–" : fmt::format("{} + {} + {} + {}", sums, products, quotients, roots);
  }
};

Operations done;

/// A binary64 whose operations are counted; to change a sign, to compare and to choose is none.
struct Tally {
  double value = 0;

  Tally() = default;
  Tally(double of) : value(of) {}

  friend Tally operator+(Tally a, Tally b) { return ++done.sums, a.value + b.value; }
  friend Tally operator-(Tally a, Tally b) { return ++done.sums, a.value - b.value; }
  friend Tally operator*(Tally a, Tally b) { return ++done.products, a.value * b.value; }
  friend Tally operator/(Tally a, Tally b) { return ++done.quotients, a.value / b.value; }
  friend Tally operator-(Tally a) { return -a.value; }
  friend Tally abs(Tally a) { return std::abs(a.value); }
  friend Tally sqrt(Tally a) { return ++done.roots, std::sqrt(a.value); }
  friend auto operator<=>(Tally a, Tally b) { return a.value <=> b.value; }
  friend bool operator==(Tally a, Tally b) { return a.value == b.value; }
  friend Tally choose(bool condition, Tally yes, Tally no) { return condition ? yes : no; }
};

}  // namespace

namespace durero::trace::HWY_NAMESPACE {

template <>
struct Numbers<Tally> : Binary64<Tally> {};

}  // namespace durero::trace::HWY_NAMESPACE

using namespace durero;
using namespace durero::test;
namespace steps = trace::HWY_NAMESPACE;
using trace::Decision;

namespace {

template <class Do>
Operations counted(Do what) {
  done = {};
  what();
  return done;
}

/// The formula of a textbook: the coefficients, the discriminant, both roots, and where these are along the axis. It
/// stops where the discriminant is negative.
template <class Shape>
void textbook(const Shape& shape, const model::Rayo& rayo) {
  const auto w = surface::along<Tally>(rayo);
  const auto f = surface::potencia(shape, w);
  if constexpr (requires { f.A; }) {
    const Tally D = f.B * f.B - f.A * f.C;
    if (D < Tally(0)) return;
    const Tally root = sqrt(D), near = (-f.B - root) / f.A, far = (-f.B + root) / f.A;
    if constexpr (surface::Axial<Shape>) {
      const auto s = surface::avance(shape, w);
      for (const Tally t : {near, far}) (void)(s.at_zero + t * s.slope);
    }
  }
}

/// A shape with a ray that meets it and one whose line does not, or whose first point lies behind.
template <class Shape>
struct Row {
  Shape shape;
  glm::dvec3 misses{1, 0.1, 0.2}, meets{0.02, 0.1, 1};
};

struct Counts {
  Operations textbook_miss, textbook_hit, miss, hit, lanes;
};

template <class Shape>
Counts counts(const Row<Shape>& row) {
  const auto early = [&](const glm::dvec3& v, Decision expected) {
    return counted([&] {
      const trace::Ray of(ray({0, 0, 0}, v));
      CHECK(steps::closed_form<Tally>(row.shape, of, false, trace::no_limit).verdict == expected);
    });
  };
  Counts all;
  all.miss = early(row.misses, Decision::miss);
  all.hit = early(row.meets, Decision::hit);
  all.lanes = counted([&] {
    const trace::Ray of(ray({0, 0, 0}, row.misses));
    const auto found = steps::found_in_lanes<Shape::tipo>(steps::quadratic<Tally>(row.shape, of));
    CHECK_FALSE(found.hit);
    CHECK_FALSE(found.undecided);
  });
  if (!steps::is_linear(Shape::tipo)) {
    all.textbook_miss = counted([&] { textbook(row.shape, ray({0, 0, 0}, row.misses)); });
    all.textbook_hit = counted([&] { textbook(row.shape, ray({0, 0, 0}, row.meets)); });
  }
  return all;
}

}  // namespace

TEST_CASE("a miss takes fewer operations than a hit, and than where nothing ends early: the table of the manual") {
  std::ifstream file(source_dir() + "/docs/acceleration-reference.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string manual = text.str();
  const auto check = [&]<class Shape>(const Row<Shape>& row) {
    const Counts of = counts(row);
    const std::string line = fmt::format("| `{}` | {} | {} | {} | {} | {} |", Shape::word, of.textbook_miss.text(),
                                         of.textbook_hit.text(), of.miss.text(), of.hit.text(), of.lanes.text());
    INFO("expected in docs/acceleration-reference.md: " << line);
    CHECK(manual.find(line) != std::string::npos);
    CHECK(of.miss.all() <= of.hit.all());
    if (!steps::is_linear(Shape::tipo)) {
      CHECK(of.miss.all() < of.hit.all());
      CHECK(of.miss.all() < of.lanes.all());
      CHECK(of.miss.quotients == 0);
      CHECK(of.textbook_miss.all() < of.textbook_hit.all());
    }
  };
  const glm::dvec3 up(0, 1, 0), forwards(0, 0, 1), at(0, 0, 5);
  check(Row<scene::Sphere>{{at, 1}});
  check(Row<scene::Cylinder>{{at, 1, up, 1}});
  check(Row<scene::Cone>{{at, 0.5, up, 2}});
  check(Row<scene::TruncatedCone>{{at, 1, 0.5, up, 2}});
  check(Row<scene::Plane>{{at, forwards}, {1, 0.1, -0.2}});
  check(Row<scene::Disc>{{at, 1, forwards}});
  check(Row<scene::Triangle>{{{{{-1, -1, 5}, {2, -1, 5}, {-1, 2, 5}}}}});
}
