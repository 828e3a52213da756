// Does the suite see faults of triangles and of trees? Tracers with one fault each, over the rays of a default run in
// the families of meshes, and right tracers in three styles.
#include <fmt/core.h>

#include <map>
#include <string>

#include "conform/faults/tree_tracer.hpp"
#include "conform/judged.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/conform/judge/judge.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

/// The cases of a default run, answered.
const std::vector<SuiteCase>& mesh_cases() {
  static const std::vector<SuiteCase> all = [] {
    std::vector<SuiteCase> made;
    const SuiteOptions options{.tipos = {model::Tipo::soy_triangulo}};
    for (const Family& family : families_of_meshes()) {
      for (std::uint64_t number = 0; number < cases(options, family); ++number)
        answer(made.emplace_back(suite_case(options, family, number)));
    }
    return made;
  }();
  return all;
}

Profile triangle_profile(NumberFormat format, bool is_watertight = false) {
  return {.format = format, .tipos = {model::Tipo::soy_triangulo}, .watertight = is_watertight};
}

struct VerdictTally {
  std::size_t gross = 0, off = 0, all = 0;
  std::string first{};
};

/// answer(query) of every ray of the case, judged.
template <class Answer>
VerdictTally judged_case(const SuiteCase& of, const Profile& profile, Answer answer) {
  Claims claims;
  for (const scene::Query& ray : of.the_case.rays) claims.push_back(answer(ray));
  VerdictTally tally;
  const std::vector<ClaimJudgement> judgements = CaseJudge(of, profile).judge(claims);
  for (std::size_t ray = 0; ray < judgements.size(); ++ray) {
    const Verdict verdict = judgements[ray].verdict;
    tally.gross += is_gross(verdict), tally.off += verdict == Verdict::off, tally.all += verdict != Verdict::skipped;
    if ((is_gross(verdict) || verdict == Verdict::off) && tally.first.empty())
      tally.first = fmt::format("{} ray {} {}", of.name(), ray, name(verdict));
  }
  return tally;
}

/// Checks that a right tracer is never accused of any ray, or of the rays of each family's first meshes.
void check_right(TriangleStyle style, TriangleNumbers numbers, const Profile& profile, std::uint64_t meshes) {
  const bool is_narrow = profile.format == NumberFormat::binary32;
  std::size_t right = 0;
  for (const SuiteCase& of : mesh_cases()) {
    if (of.number >= meshes) continue;
    TreeTracer tracer(of.the_case.scene, style, numbers);
    const VerdictTally tally = judged_case(of, profile, [&](const scene::Query& query) {
      Claim claim = tracer.first_hit(query.rayo);
      if (claim.t && is_narrow) claim.t = static_cast<double>(static_cast<float>(*claim.t));
      return claim;
    });
    INFO(tally.first << ": " << tally.gross << " gross, " << tally.off << " off");
    CHECK(tally.gross + tally.off == 0);
    right += tally.all;
  }
  CHECK(right == families_of_meshes().size() * meshes * rays_of_a_mesh);
}

/// Every style in both numbers, those of binary64 in a profile of binary32, where their roundings are small.
void check_all_right(std::uint64_t meshes) {
  for (const TriangleStyle style : {TriangleStyle::moller_trumbore, TriangleStyle::woop, TriangleStyle::pluecker}) {
    check_right(style, TriangleNumbers::exact, triangle_profile(NumberFormat::binary64), meshes);
    check_right(style, TriangleNumbers::exact, triangle_profile(NumberFormat::binary64, true), meshes);
    check_right(style, TriangleNumbers::binary64, triangle_profile(NumberFormat::binary32), meshes);
  }
  check_right(TriangleStyle::woop, TriangleNumbers::binary64, triangle_profile(NumberFormat::binary32, true), meshes);
}

/// Asks tracers with each fault the rays of the families that `is_asked` names, and prints what is seen.
template <class IsAsked>
void check_faults(IsAsked is_asked) {
  for (const TreeFaultRow& row : tree_faults()) {
    const Profile profile = triangle_profile(NumberFormat::binary64, row.is_of_watertight);
    std::map<std::string_view, VerdictTally> by_family;
    VerdictTally all;
    for (const SuiteCase& of : mesh_cases()) {
      if (!is_asked(row, of)) continue;
      TreeTracer tracer(of.the_case.scene, row.fault);
      const VerdictTally tally =
          judged_case(of, profile, [&](const scene::Query& query) { return tracer.first_hit(query.rayo); });
      for (VerdictTally* sum : {&all, &by_family[of.family->name]})
        sum->gross += tally.gross, sum->off += tally.off, sum->all += tally.all;
    }
    std::string seen;
    for (const auto& [family, tally] : by_family) {
      if (tally.gross + tally.off > 0) seen += fmt::format(" {} {}", family, tally.gross + tally.off);
    }
    fmt::print("{:52} {:5} gross {:5} off:{}\n", row.name, all.gross, all.off, seen);
    INFO(row.name << " is not seen by " << row.seen_by);
    const VerdictTally& meant = by_family[row.seen_by];
    CHECK(meant.gross + meant.off >= 5);
  }
}

}  // namespace

TEST_CASE("right tracers of triangles by trees are not accused, in three styles, and watertight ones that claim it") {
  check_all_right(1);
}

TEST_CASE("the same of every mesh of a default run", "[long]") { check_all_right(4); }

TEST_CASE("the certified tracer is exact on every mesh") {
  for (const SuiteCase& of : mesh_cases()) {
    const accel::WideBvh tree(of.the_case.scene);
    trace::Counts counts;
    const VerdictTally tally =
        judged_case(of, triangle_profile(NumberFormat::binary64), [&](const scene::Query& query) {
          const scene::Hit hit = trace::first_hit_among(tree, query.rayo, {}, counts);
          return right_claim({.hit = hit});
        });
    INFO(tally.first);
    CHECK(tally.gross + tally.off == 0);
  }
}

TEST_CASE("each fault of triangles and of trees is caught in a default run by the family meant for it") {
  check_faults([](const TreeFaultRow& row, const SuiteCase& of) { return of.family->name == row.seen_by; });
  CHECK(tree_faults().size() >= 60);
}

TEST_CASE("the families that see each fault of triangles and of trees", "[long]") {
  check_faults([](const TreeFaultRow&, const SuiteCase&) { return true; });
}
