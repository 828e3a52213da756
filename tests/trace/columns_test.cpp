// Rays in columns keep their numbers, the nearest of their hits, and what is open.
#include "durero/trace/columns.hpp"

#include <cstdint>
#include <vector>

#include "support/catch.hpp"

using namespace durero;
using scene::ElementRef;

namespace {

/// The findings of one hit in every place.
trace::ColumnFindings findings_of(double t, double error) {
  trace::ColumnFindings findings{};
  for (trace::Findings& eight : findings) {
    eight.hit = 0xff;
    eight.t.fill(t), eight.error.fill(error), eight.A.fill(t);
  }
  return findings;
}

}  // namespace

TEST_CASE("rays are complete with their speeds, and those out of the ordinary become zeros") {
  trace::RayColumns rays;
  const std::vector<model::Rayo> all{{{1, 2, 3}, {-3, 0, 4}},
                                     {{0, 0, 0x1p101}, {1, 0, 0}},
                                     {{0, 0, 0}, {0, 0x1p-101, 1}},
                                     {{0, -0x1p100, 0}, {0, 0x1p-100, 0}}};
  for (std::size_t i = 0; i < all.size(); ++i) rays.set(i, trace::Ray(all[i]));
  rays.speed.fill(-1);
  CHECK(trace::complete(rays, all.size()) == 0b1001);
  CHECK(rays.speed[0] == 7);
  CHECK(rays.speed[3] == 0x1p-100);
  CHECK(rays.p[1][3] == -0x1p100);
  CHECK(rays.p[2][1] == 0);
  CHECK(rays.v[1][2] == 0);
  CHECK(trace::complete(rays, 1) == 1);
  for (std::size_t i = 0; i < trace::RayColumns::size; ++i) rays.set(i, trace::Ray(all[0]));
  CHECK(trace::complete(rays, trace::RayColumns::size) == ~std::uint64_t{});
}

TEST_CASE("a finding is kept where it is nearer, and left open where two overlap") {
  const ElementRef one{model::Tipo::soy_esfera, 3}, other{model::Tipo::soy_disco, 5};
  constexpr std::uint64_t which = 0x8000000000000205, all = ~std::uint64_t{};
  trace::NearestColumns nearest;
  nearest.clear();
  const auto keep = [&](double t, double error, std::uint64_t of, ElementRef own) {
    return trace::keep_nearer(findings_of(t, error), of, own, nearest);
  };
  const auto [nearer, open] = keep(4, 0.5, which, one);
  CHECK(nearer == which);
  CHECK(open == 0);
  CHECK(nearest.t[0] == 4);
  CHECK(nearest.t[1] == trace::no_limit);
  CHECK(trace::RayColumns::element(nearest.own[63]) == one);
  CHECK(nearest[9].hi == 4);
  CHECK(nearest[9].slope.A == 4);

  CHECK(keep(5.5, 0.5, 1, other).nearer == 0);
  CHECK(keep(5.5, 0.5, 1, other).open == 0);
  CHECK(trace::RayColumns::element(nearest.own[0]) == one);
  CHECK(keep(3, 0.25, 1, other).nearer == 1);
  CHECK(trace::RayColumns::element(nearest.own[0]) == other);
  CHECK(nearest.error[0] == 0.25);
  CHECK(keep(3.25, 0.25, 1, one).open == 1);  // the bounds touch
  CHECK(keep(4.75, 0.25, 4, one).open == 4);
  CHECK(keep(3.25, 0.25, 512, one).open == 512);

  trace::ColumnFindings doubt{};
  doubt[1].undecided = 1;
  CHECK(trace::keep_nearer(doubt, all, one, nearest).open == 256);
  CHECK(trace::keep_nearer(doubt, all, one, nearest).nearer == 0);
  CHECK(trace::keep_nearer(doubt, all ^ 256, one, nearest).open == 0);
}

TEST_CASE("a point before 1 blocks, a point behind 1 does not, and one about 1 is left open") {
  constexpr std::uint64_t which = 0x8000000000000003;
  const auto found = [&](double t, double error) { return trace::blocked_by(findings_of(t, error), which); };
  CHECK(found(0.5, 0.25).blocked == which);
  CHECK(found(0.5, 0.25).open == 0);
  CHECK(found(0.75, 0.25).blocked == 0);
  CHECK(found(0.75, 0.25).open == which);
  CHECK(found(1.25, 0.25).open == which);
  CHECK(found(1.5, 0.25).open == 0);
  CHECK(found(1.5, 0.25).blocked == 0);
  trace::ColumnFindings doubt{};
  doubt[7].undecided = 0x80;
  CHECK(trace::blocked_by(doubt, which).open == std::uint64_t{1} << 63);
  CHECK(trace::blocked_by(doubt, 1).open == 0);
}
