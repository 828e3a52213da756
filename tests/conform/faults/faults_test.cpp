// Does the suite see? Tracers with one fault each, over every family, and three right ones.
#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "conform/faults/tracer.hpp"
#include "conform/hits.hpp"
#include "conform/perturbed.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

constexpr std::uint64_t seeds = 60, seeds_of_faults = 20;  // scenes of each family
constexpr std::size_t rays_a_scene = 24;

/// How many claims were judged so: right, off and not gross, gross.
struct Tally {
  std::size_t right = 0, off = 0, gross = 0;

  void add(Verdict verdict) {
    if (verdict == Verdict::skipped) return;
    (is_gross(verdict) ? gross : verdict == Verdict::off ? off : right) += 1;
  }
};

const std::vector<SuiteCase>& cases_of(const Family& family) {
  static const std::vector<std::vector<SuiteCase>> all = [] {
    std::vector<std::vector<SuiteCase>> cases;
    for (const Family& each : families_of_few()) {
      cases.emplace_back();
      for (std::uint64_t seed = 0; seed < seeds; ++seed)
        cases.back().push_back(answered(each, generate(each, seed, rays_a_scene)));
    }
    return cases;
  }();
  return all[static_cast<std::size_t>(&family - families_of_few().data())];
}

/// What plain arithmetic can do without scaling: squares and cubes of numbers that neither overflow nor vanish.
Profile plain_profile(NumberFormat format) {
  Profile profile = wide_profile(format);
  const int places = format == NumberFormat::binary32 ? 30 : 240;
  profile.least_size = std::ldexp(1, -places);
  profile.greatest_size = profile.greatest_coordinate = std::ldexp(1, places);
  return profile;
}

/// answer(scene)(query) of every ray of so many scenes of a family, judged.
template <class Answer>
Tally judged(const Family& family, const Profile& profile, std::uint64_t scenes, Answer answer) {
  Tally tally;
  for (const SuiteCase& of : std::span(cases_of(family)).first(scenes)) {
    const auto first_hit = answer(of.the_case.scene);
    for (std::size_t i = 0; i < of.truths.size(); ++i)
      tally.add(judge(of, i, first_hit(of.the_case.rays[i]), profile).verdict);
  }
  return tally;
}

/// Where a ray starts inside a surface and no point is nearest, the origin is the limit of the points.
Claim claim_of(const scene::Hit& hit) {
  if (hit.resultado == model::Resultado::miss) return {.outcome = Claim::Outcome::miss};
  return {.outcome = Claim::Outcome::hit, .element = hit.elementos[0], .t = hit.t};
}

template <class N>
auto plain(Fault fault) {
  return [fault](const scene::Scene& scene) {
    return [tracer = Tracer<N>(scene, fault)](const scene::Query& query) { return tracer.first_hit(query.rayo); };
  };
}

/// The certified tracer.
auto exact_tracer(const scene::Scene& scene) {
  return [tables = trace::Tables(scene)](const scene::Query& query) {
    return claim_of(trace::first_hits(tables, std::span(&query, 1))[0]);
  };
}

}  // namespace

TEST_CASE("right tracers, exact and of plain arithmetic in both formats, are never called gross") {
  Tally of_exact, of_binary64, of_binary32;
  const auto check = [](Tally& all, const Tally& tally, const Family& family, const char* tracer) {
    INFO(family.name << ", " << tracer << ": " << tally.off << " off, " << tally.gross << " gross");
    CHECK(tally.gross == 0);
    all.right += tally.right, all.off += tally.off;
  };
  for (const Family& family : families_of_few()) {
    check(of_exact, judged(family, wide_profile(NumberFormat::binary64), seeds, exact_tracer), family, "exact");
    check(of_binary64, judged(family, plain_profile(NumberFormat::binary64), seeds, plain<double>(Fault::none)), family,
          "binary64");
    check(of_binary32, judged(family, plain_profile(NumberFormat::binary32), seeds, plain<float>(Fault::none)), family,
          "binary32");
  }
  fmt::print("right: exact {}, binary64 {}, binary32 {}; off: {}, {}, {}\n", of_exact.right, of_binary64.right,
             of_binary32.right, of_exact.off, of_binary64.off, of_binary32.off);
  CHECK(of_exact.off == 0);
  CHECK(of_binary64.right > 40'000);
  CHECK(of_binary32.right > 30'000);
}

TEST_CASE("each fault is caught by the families meant for it") {
  fmt::print("percent of the claims that are off: `!` some of them gross, `-` none, `.` none off\n");
  int column = 0;
  for (const Family& family : families_of_few()) {
    ++column;
    fmt::print("{:2} {}{}", column, family.name, column % 8 == 0 ? "\n" : "  ");
  }
  fmt::print("\n{:36}", "");
  for (int i = 1; i <= column; ++i) fmt::print("{:>5}", i);
  fmt::print("\n");
  const Profile profile = plain_profile(NumberFormat::binary64);
  for (const FaultRow& row : faults()) {
    fmt::print("{:36}", row.name);
    std::set<std::string_view> seen_by;
    for (const Family& family : families_of_few()) {
      const bool is_meant = std::find(row.seen_by.begin(), row.seen_by.end(), family.name) != row.seen_by.end();
      if (test::sanitized && !is_meant) continue;  // the matrix is for reading
      const std::uint64_t scenes = is_meant ? seeds : seeds_of_faults;
      const Tally tally = row.fault == Fault::binary32_arithmetic
                              ? judged(family, profile, scenes, plain<float>(row.fault))
                              : judged(family, profile, scenes, plain<double>(row.fault));
      const std::size_t wrong = tally.off + tally.gross, all = std::max<std::size_t>(wrong + tally.right, 1);
      if (wrong > 0) seen_by.insert(family.name);
      fmt::print("{:>5}", wrong == 0 ? "." : fmt::format("{}{}", 100 * wrong / all, tally.gross == 0 ? "-" : "!"));
    }
    fmt::print("\n");
    for (const std::string_view family : row.seen_by) {
      INFO(row.name << " is not seen by " << family);
      REQUIRE(find_family(family) != nullptr);
      CHECK(seen_by.count(family) == 1);
    }
  }
  CHECK(faults().size() >= 50);
}

TEST_CASE("faults of scale, place and direction are seen where a system knows triangles alone") {
  Profile profile = plain_profile(NumberFormat::binary64);
  profile.least_size = 0x1p-200;  // a plain tracer of triangles takes fourth powers of lengths
  profile.greatest_size = profile.greatest_coordinate = 0x1p200;
  const auto judged_triangles = [&](const Family& family, const auto& answer) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const auto drawn = generate(family, seed, rays_a_scene, {.tipos = {model::Tipo::soy_triangulo}});
      if (!drawn) continue;
      const SuiteCase of = answered(family, drawn->the_case);
      const auto first_hit = answer(of.the_case.scene);
      for (std::size_t i = 0; i < of.truths.size(); ++i)
        tally.add(judge(of, i, first_hit(of.the_case.rays[i]), profile).verdict);
    }
    return tally;
  };
  std::size_t right = 0;
  for (const Family& family : families_of_few()) {
    const Tally whole = judged_triangles(family, exact_tracer);
    INFO(family.name << ": " << whole.off << " off, " << whole.gross << " gross");
    CHECK(whole.off + whole.gross == 0);
    right += whole.right;
    // Products of such directions and normals overflow in plain arithmetic.
    if (family.name == "degenerate_numbers") continue;
    CHECK(judged_triangles(family, plain<double>(Fault::none)).gross == 0);
  }
  CHECK(right > 15'000);
  using enum Fault;
  const std::vector<FaultRow> seen{
      {determinant_by_epsilon, "determinant above 1e-6", {"tiny", "scale", "degenerate_numbers"}},
      {least_t_1e_3, "t at least 1e-3", {"near_origin", "tiny", "direction_scale"}},
      {greatest_t_1e_6, "t at most 1e6", {"direction_scale", "distance_limit"}},
      {negative_t, "behind the origin", {"generic", "rotation"}},
      {origin_ignored, "origin ignored", {"generic", "on_surface"}},
      {t_by_quotient_of_x, "t as (x − p.x)/v.x", {"axis_parallel"}},
      {first_in_order, "first element in order", {"generic", "huge_ratio", "grid_snapped"}},
      {triangle_one_sided, "triangle one-sided", {"generic", "far_origin", "large_offset"}},
      {triangle_widened, "triangle widened by 1e-4", {"margin"}},
  };
  for (const FaultRow& row : seen) {
    for (const std::string_view family : row.seen_by) {
      INFO(row.name << ", " << family);
      CHECK(judged_triangles(*find_family(family), plain<double>(row.fault)).gross > 0);
    }
  }
}

TEST_CASE("a tracer that lets rays through edges is seen where it claims to be watertight, and not gross otherwise") {
  Profile profile = plain_profile(NumberFormat::binary64);
  const Family& family = *find_family("vertex");
  CHECK(judged(family, profile, seeds, plain<double>(Fault::triangle_without_edges)).gross == 0);
  profile.watertight = true;
  const Tally leaky = judged(family, profile, seeds, plain<double>(Fault::triangle_without_edges));
  CHECK(leaky.gross > seeds * rays_a_scene / 4);
  const Tally whole = judged(family, profile, seeds, exact_tracer);
  CHECK(whole.gross + whole.off == 0);
  CHECK(whole.right > 1000);
}
