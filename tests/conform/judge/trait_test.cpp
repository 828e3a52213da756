#include "durero/conform/judge/trait.hpp"

#include <bit>
#include <glm/geometric.hpp>
#include <set>

#include "conform/drafted.hpp"
#include "conform/faults/tracer.hpp"
#include "conform/judged.hpp"
#include "durero/conform/judge/minimise.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
using test::drafted;
using test::sphere_case;

namespace {

const Profile all = test::profile_of_all();

/// A system that misses where the condition holds of a question, and is right elsewhere.
template <class IsMissed>
Ask missing_where(IsMissed is_missed) {
  return [is_missed](const SuiteCase& of) { return is_missed(of) ? test::miss() : test::right_claims(of)[0]; };
}

Trait cause(const SuiteCase& of, const Ask& ask, const Profile& profile = all) {
  return cause_of(test::finding_of(of, ask(of), profile), profile, ask);
}

glm::dvec3 origin_of(const SuiteCase& of) { return of.the_case.rays[0].rayo.p().xyz(); }
glm::dvec3 direction_of(const SuiteCase& of) { return of.the_case.rays[0].rayo.v().xyz(); }

double radius_of(const SuiteCase& of) { return of.the_case.scene.shapes<scene::Sphere>()[0].radio; }
double distance_from_zero(const SuiteCase& of) {
  return glm::length(of.the_case.scene.shapes<scene::Sphere>()[0].centro);
}

SuiteCase ball_at(const glm::dvec3& centre, double radius, const glm::dvec3& p, const glm::dvec3& v) {
  return drafted({{"e0", scene::Sphere{centre, radius}}}, p, v);
}

/// The cause of the first failures of a tracer with a fault, with the number of failures that have it.
Trait commonest_cause(test::Fault fault, const char* family, const SuiteOptions& options = {}) {
  const Ask ask = [&](const SuiteCase& of) {
    return test::Tracer<double>(of.the_case.scene, fault).first_hit(of.the_case.rays[0].rayo);
  };
  std::map<Trait, int> count;
  int failures = 0;
  for (std::uint64_t number = 0; number < 8; ++number) {
    const SuiteCase of = test::answered_case(family, number, options);
    for (std::size_t ray = 0; ray < of.truths.size() && failures < 12; ++ray) {
      const Finding finding = test::finding_of(with_ray_alone(of, ray), ask(with_ray_alone(of, ray)), all);
      if (!is_failure(finding.judgement.verdict)) continue;
      ++failures;
      ++count[cause_of(finding, all, ask)];
    }
  }
  REQUIRE(failures > 0);
  return std::ranges::max_element(count, {}, [](const auto& each) { return each.second; })->first;
}

}  // namespace

TEST_CASE("a failure is caused by the trait without which it is gone") {
  const SuiteCase askew = sphere_case({0.25, 0.125, 0}, {0.03125, 0.0625, 1.5});
  CHECK(cause(askew, missing_where([](const SuiteCase& of) { return glm::length(direction_of(of)) > 1.25; })) ==
        Trait::not_unit);
  CHECK(cause(ball_at({0, 0, 0x1p-8}, 0x1p-10, {0x1p-13, 0, 0}, {0, 0, 1}),
              missing_where([](const SuiteCase& of) { return radius_of(of) < 0.01; })) == Trait::small);
  CHECK(cause(ball_at({0, 0, 0x1p12}, 0x1p10, {0x1p3, 0, 0}, {0, 0, 1}),
              missing_where([](const SuiteCase& of) { return radius_of(of) > 100; })) == Trait::large);
  CHECK(cause(ball_at({0x1p10, 0x1p9, 4}, 1, {0x1p10, 0x1p9, 0}, {0, 0, 1}),
              missing_where([](const SuiteCase& of) { return distance_from_zero(of) > 100; })) == Trait::far_from_zero);
  CHECK(cause(ball_at({0, 0, 0}, 1, {0, 0, -0x1p10}, {0, 0, 1}), missing_where([](const SuiteCase& of) {
                return glm::length(origin_of(of)) > 100;
              })) == Trait::far_origin);
  CHECK(cause(sphere_case({0, 0.25, 4}, {0, 0, 1}), missing_where([](const SuiteCase& of) {
                return of.the_case.scene.shapes<scene::Sphere>()[0].radio >
                       glm::length(of.the_case.scene.shapes<scene::Sphere>()[0].centro - origin_of(of));
              })) == Trait::inside);
  CHECK(cause(sphere_case({0, 0, 2.984375}, {0, 0, 1}),
              missing_where([](const SuiteCase& of) { return of.truths[0].hit.t < 0.125; })) == Trait::near_surface);
  CHECK(cause(sphere_case({0, 0, 0}, {-0.0, 0, 1}), missing_where([](const SuiteCase& of) {
                const double x = direction_of(of).x;
                return x == 0 && std::signbit(x);
              })) == Trait::minus_zero);
  CHECK(cause(askew, missing_where([](const SuiteCase&) { return true; })) == Trait::none);
}

TEST_CASE("what hangs on several elements, on a side, on an axis or on where the ray goes is told apart") {
  const SuiteCase two =
      drafted({{"e0", scene::Sphere{glm::dvec3(0, 0, 4), 1}}, {"e1", scene::Sphere{glm::dvec3(0.25, 0, 8), 1}}},
              {0.125, 0, 0}, {0, 0, 1});
  const Ask last = [](const SuiteCase& of) {
    Claim claim = test::right_claims(of)[0];
    if (of.the_case.scene.size() > 1) claim.t = *claim.t + 4, claim.element = *of.the_case.scene.find("e1");
    return claim;
  };
  CHECK(cause(two, last) == Trait::several);
  const SuiteCase face =
      drafted({{"e0", scene::Triangle{{glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 0.5), glm::dvec3(0.5, 2, 0)}}}},
              {0.5, 0.375, -4}, {0.0625, 0.125, 1});
  CHECK(cause(face, missing_where([](const SuiteCase& of) {
                const auto& [a, b, c] = of.the_case.scene.shapes<scene::Triangle>()[0].vertices;
                return glm::dot(glm::cross(b - a, c - a), direction_of(of)) > 0;
              })) == Trait::one_sided);
  CHECK(cause(sphere_case({0, 0, 0}, {0, 0, 1}),
              missing_where([](const SuiteCase& of) { return direction_of(of).x == 0; })) == Trait::parallel);
  CHECK(cause(sphere_case({0.25, 0.125, 0}, {0.0625, 0.125, 1}), missing_where([](const SuiteCase& of) {
                const glm::dvec3 v = direction_of(of);
                return v.z > std::max(v.x, v.y);
              })) == Trait::one_axis);
  CHECK(cause(sphere_case({0.9375, 0.125, 0}, {0.0078125, 0.015625, 1}), missing_where([](const SuiteCase& of) {
                const glm::dvec3 to = of.the_case.scene.shapes<scene::Sphere>()[0].centro - origin_of(of);
                const glm::dvec3 v = glm::normalize(direction_of(of));
                return glm::length(to - glm::dot(to, v) * v) > 0.75;
              })) == Trait::grazing);
  const SuiteCase tangent = sphere_case({1, 0, 0}, {0, 0, 1});
  REQUIRE(tangent.truths[0].ambiguity == Ambiguity::tangent);
  CHECK(cause(tangent, [](const SuiteCase& of) {
          return of.truths[0].ambiguity == Ambiguity::none ? test::right_claims(of)[0] : test::hit_at(1);
        }) == Trait::coincidence);
}

TEST_CASE("a remedy that rounds v heals no failure that any rounding heals") {
  // A system that is wrong for this v alone: with v/|v| it is right, and so it is with v of the old length.
  const SuiteCase askew = sphere_case({0.25, 0.125, 0}, {0.03125, 0.0625, 1.5});
  const glm::dvec3 v = direction_of(askew);
  const Ask of_this_v = missing_where([v](const SuiteCase& of) {
    const glm::dvec3 w = direction_of(of);
    return w.x == v.x && w.y == v.y;
  });
  CHECK(cause(askew, of_this_v) != Trait::not_unit);
}

TEST_CASE("what is right or wrong by chance has no cause") {
  // A system that is right about the questions, three in eight, whose numbers have some bits.
  std::size_t failures = 0, none = 0;
  const Ask by_chance = [](const SuiteCase& of) {
    std::uint64_t bits = 0;
    for (const glm::dvec3& w : {direction_of(of), origin_of(of)})
      for (int i = 0; i < 3; ++i) bits = (bits ^ std::bit_cast<std::uint64_t>(w[i])) * 0x9E3779B97F4A7C15U;
    return bits >> 61U >= 3 ? test::miss() : test::right_claims(of)[0];
  };
  for (int i = 1; i <= 64; ++i) {
    const SuiteCase of = sphere_case({0.25 + i / 256.0, 0.125, 0}, {i / 1000.0, i / 3000.0, 1.5});
    if (of.truths[0].hit.resultado != model::Resultado::hit || by_chance(of).outcome != Claim::Outcome::miss) continue;
    ++failures;
    none += cause(of, by_chance) == Trait::none;
  }
  CHECK(failures >= 20);
  CHECK(none * 10 >= failures * 9);
}

TEST_CASE("what the profile does not cover is not asked, and what hangs is not asked again") {
  Profile small = all;
  small.greatest_size = 0.01;
  std::size_t outside_asked = 0;
  const Ask blind = [&](const SuiteCase& of) {
    outside_asked += !outside(of, 0, small).empty();
    return radius_of(of) < 0.5 ? test::miss() : test::right_claims(of)[0];
  };
  CHECK(cause(ball_at({0, 0, 0x1p-8}, 0x1p-10, {0x1p-13, 0, 0}, {0, 0, 1}), blind, small) == Trait::none);
  CHECK(outside_asked == 0);
  Finding hung = test::finding_of(sphere_case({0, 0, 0}, {0, 0, 1}), test::miss(), all);
  hung.judgement.verdict = Verdict::hung;
  CHECK(cause_of(hung, all, [](const SuiteCase&) -> Claim { throw std::logic_error("asked"); }) == Trait::none);
}

TEST_CASE("planted faults of a tracer are traced to what their author did") {
  using enum test::Fault;
  CHECK(commonest_cause(unit_v_assumed, "generic") == Trait::not_unit);
  CHECK(commonest_cause(v_normalised_alone, "generic") == Trait::not_unit);
  CHECK(commonest_cause(inside_is_a_miss, "inside") == Trait::inside);
  CHECK(commonest_cause(first_in_order, "generic") == Trait::several);
  CHECK(commonest_cause(t_by_quotient_of_x, "axis_parallel") == Trait::parallel);
  CHECK(commonest_cause(small_numbers_vanish, "tiny") == Trait::small);
  CHECK(commonest_cause(discriminant_by_epsilon, "tiny") == Trait::small);
  CHECK(commonest_cause(least_t_1e_3, "near_origin") == Trait::near_surface);
  CHECK(commonest_cause(triangle_one_sided, "generic", {.tipos = {model::Tipo::soy_triangulo}}) == Trait::one_sided);
  CHECK(commonest_cause(unstable_quadratic, "far_origin") == Trait::far_origin);
  CHECK(commonest_cause(limb_cut, "margin") == Trait::grazing);
}

TEST_CASE("without a system the question tells what may be the cause") {
  const auto likely = [](const SuiteCase& of) { return likely_cause(test::finding_of(of, test::miss(), all), all); };
  CHECK(likely(sphere_case({0.25, 0.125, 0}, {0.03125, 0.0625, 1.5})) == Trait::not_unit);
  CHECK(likely(sphere_case({1, 0, 0}, {0, 0, 1})) == Trait::coincidence);
  CHECK(likely(sphere_case({0, 0.25, 4}, {0.25, 0.5, 1})) == Trait::inside);
  CHECK(likely(sphere_case({0, 0, 2.984375}, {0.001, 0.001, 1})) == Trait::near_surface);
  CHECK(likely(ball_at({0, 0, 0}, 1, {0.25, 0.125, -0x1p10}, {0x1p-14, 0x1p-14, 1})) == Trait::far_origin);
  CHECK(likely(ball_at({0x1p10, 0x1p9, 4}, 1, {0x1p10, 0x1p9, 0}, {0.01, 0.02, 1})) == Trait::far_from_zero);
}

TEST_CASE("each trait has a name and a title of its own") {
  std::set<std::string_view> names, titles;
  for (std::size_t i = 0; i < trait_count; ++i) {
    const Trait trait = static_cast<Trait>(i);
    names.insert(name(trait));
    titles.insert(title(trait));
    CHECK(remedy(trait).empty() == (trait == Trait::none));
  }
  CHECK(names.size() == trait_count);
  CHECK(titles.size() == trait_count);
}

TEST_CASE("a tidied failure is the same failure, of a size and a direction near 1, with its other numbers") {
  const SuiteCase of = ball_at({0x1p20, 0, 0x1p20}, 0x1.234p10, {0x1p20, 3, 0}, {0, 0x1.357p-32, 0x1p-20});
  const Ask misses = missing_where([](const SuiteCase&) { return true; });
  const Finding tidy = tidied(test::finding_of(of, test::miss(), all), all, misses);
  CHECK(tidy.judgement.verdict == Verdict::missed);
  CHECK(radius_of(tidy.of) == 0x1.234p0);
  CHECK(distance_from_zero(tidy.of) == 0);
  CHECK(direction_of(tidy.of) == glm::dvec3(0, 0x1.357p-12, 1));
  CHECK(origin_of(tidy.of) == glm::dvec3(0, 0x1.8p-9, -0x1p10));
}
