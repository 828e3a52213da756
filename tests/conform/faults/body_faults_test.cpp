// Does the suite see faults in boxes, capsules, ellipsoids and copies of them?
#include <fmt/core.h>

#include <array>
#include <map>
#include <string_view>

#include "conform/faults/body_tracer.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/report/tally.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

/// A fault, by the families that must see it.
struct BodyFaultRow {
  BodyFault fault;
  std::string_view name;
  std::vector<std::string_view> seen_by{"bodies"};
};

const std::vector<BodyFaultRow>& body_faults() {
  using enum BodyFault;
  static const std::vector<BodyFaultRow> rows{
      {binary32_arithmetic, "binary32 arithmetic"},
      {zero_times_infinity, "0·∞ ends the test", {"bodies_axis"}},
      {slab_parallel_by_epsilon, "parallel to a slab by 1e-2"},
      {slab_grown, "slab grown by 1e-4", {"bodies", "bodies_margin"}},
      {slab_shrunk, "slab shrunk by 1e-4", {"bodies", "bodies_margin"}},
      {slab_one_pair_left_out, "a pair of sides left out"},
      {far_side_first, "far side first"},
      {behind_the_origin, "behind the origin", {"bodies", "bodies_inside"}},
      {inside_missed, "from inside nothing", {"bodies_inside"}},
      {inside_at_the_origin, "from inside the origin", {"bodies_inside"}},
      {first_in_order, "first in order"},
      {last_in_order, "last in order"},
      {local_length, "t of the body's own space"},
      {local_direction_unit, "v a unit vector there"},
      {least_t_1e_3, "t at least 1e-3", {"bodies_surface"}},
      {least_t_1e_6, "t at least 1e-6", {"bodies_surface"}},
      {greatest_t_1e_6, "t at most 1e6", {"bodies_far"}},
      {transposed_map, "map transposed"},
      {map_without_shear, "map without its directions"},
      {axes_of_coordinates, "box along the axes of coordinates"},
      {determinant_by_epsilon, "determinant above 1e-6", {"bodies_thin", "bodies_scale"}},
      {mirrored_missed, "no points of a mirrored copy"},
      {least_axis_for_all, "ellipsoid as a ball"},
      {discriminant_by_epsilon, "discriminant above 1e-6", {"bodies_margin"}},
      {discriminant_clamped, "discriminant at least 0"},
      {far_root_first, "far root first"},
      {capsule_without_top, "capsule without its top"},
      {capsule_without_ends, "capsule without ends"},
      {capsule_flat_ends, "capsule with flat ends"},
      {capsule_inner_balls, "capsule with whole balls", {"bodies_inside"}},
      {capsule_twice_as_long, "capsule twice as long"},
      {capsule_along_z, "capsule along z"},
      {capsule_side_unbounded, "capsule without bounds"},
      {rounded_sharp, "rounded box with sharp edges", {"bodies", "bodies_edge"}},
      {rounded_not_longer, "rounded box without a radius"},
      {rounded_without_corners, "rounded box without corners", {"bodies_edge"}},
      {rounded_without_edges, "rounded box without edges", {"bodies_edge"}},
      {rounded_inner_edges, "rounded box with whole edges", {"bodies_inside"}},
      {torus_two_roots, "torus with two crossings", {"bodies_inside"}},
      {torus_without_hole, "torus without a hole", {"bodies_inside"}},
      {torus_apple, "torus as an apple"},
      {torus_newton, "torus by three halves"},
  };
  return rows;
}

Profile profile_of_bodies(NumberFormat format) {
  Profile profile{.format = format};
  for (std::size_t i = 0; i < body_count; ++i) profile.bodies.push_back(static_cast<BodyKind>(i));
  return profile;
}

struct SeenCounts {
  std::size_t rays = 0, off = 0, gross = 0;
};

/// The cases of a family, answered once for all faults.
const std::vector<SuiteCase>& answered_cases(const Family& family, NumberFormat numbers) {
  static std::map<std::pair<const Family*, NumberFormat>, std::vector<SuiteCase>> known;
  std::vector<SuiteCase>& all = known[{&family, numbers}];
  const SuiteOptions options{.rays = 512, .numbers = numbers};
  for (std::uint64_t number = all.size(); number < cases(options, family); ++number) {
    all.push_back(suite_case(options, family, number));
    answer(all.back());
  }
  return all;
}

SeenCounts judged(const Family& family, NumberFormat numbers, BodyFault fault) {
  const Profile profile = profile_of_bodies(NumberFormat::binary64);
  SeenCounts counts;
  for (const SuiteCase& of : answered_cases(family, numbers)) {
    const BodyTracer tracer(of.bodies, fault);
    for (std::size_t ray = 0; ray < of.truths.size(); ++ray) {
      const Verdict is = judge(of, ray, tracer.first_hit(of.the_case.rays[ray].rayo), profile).verdict;
      ++counts.rays, counts.off += is == Verdict::off, counts.gross += is_gross(is);
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("a plain tracer of bodies is not gross where plain arithmetic is enough") {
  SeenCounts all;
  for (const char* name : {"bodies", "bodies_scale", "bodies_inside", "bodies_axis"}) {
    for (const NumberFormat numbers : {NumberFormat::binary32, NumberFormat::binary64}) {
      const SeenCounts counts = judged(*find_family(name), numbers, BodyFault::none);
      INFO(name << ": " << counts.off << " off, " << counts.gross << " gross of " << counts.rays);
      CHECK(counts.gross == 0);
      all.rays += counts.rays, all.off += counts.off;
    }
  }
  CHECK(all.rays == 8 * 512);
  CHECK(all.off < all.rays / 10);
}

TEST_CASE("each fault of a tracer of bodies is seen by the families meant for it") {
  for (const BodyFaultRow& row : body_faults()) {
    for (const std::string_view name : row.seen_by) {
      const SeenCounts counts = judged(*find_family(name), NumberFormat::binary32, row.fault);
      fmt::print("{:36} {:16} {:4} off, {:4} gross\n", row.name, name, counts.off, counts.gross);
      INFO(row.name << ", " << name << ": " << counts.off << " off, " << counts.gross << " gross of " << counts.rays);
      if (row.fault == BodyFault::binary32_arithmetic)
        CHECK(counts.off > 20);
      else
        CHECK(counts.gross >= 3);
    }
  }
  CHECK(body_faults().size() >= 30);
}
