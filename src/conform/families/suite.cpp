#include "durero/conform/families/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "conform/families/asked_points.hpp"
#include "conform/families/asked_radii.hpp"
#include "conform/families/asked_ranges.hpp"
#include "conform/families/scattered.hpp"
#include "durero/conform/judge/cast_truth.hpp"

namespace durero::conform {
namespace {

/// The seed of a case; generate() derives a stream for each family from it.
std::uint64_t seed_of_case(std::uint64_t seed, std::uint64_t number) { return scattered(scattered(seed) + number); }

CaseOptions of_cases(const SuiteOptions& options) {
  return {.numbers = options.numbers,
          .tipos = options.tipos,
          .bodies = options.bodies,
          // The distance, and what a ball touches, are known of the types alone.
          .has_bodies = options.question != QuestionKind::closest && options.question != QuestionKind::cast,
          .caps = options.caps,
          .faces = options.faces};
}

}  // namespace

std::string SuiteCase::name() const { return fmt::format("{}/{:04}", family->name, number); }

std::size_t rays_of(const Family& family) { return is_of_meshes(family) ? rays_of_a_mesh : rays_of_a_case; }

std::vector<const Family*> chosen_families(const SuiteOptions& options) {
  std::vector<const Family*> chosen;
  for (const Family& family : families()) {
    const auto& asked = options.families;
    if (asked.empty() || std::find(asked.begin(), asked.end(), &family) != asked.end()) chosen.push_back(&family);
  }
  return chosen;
}

std::size_t cases(const SuiteOptions& options, const Family& family) {
  const bool has_any = has_scenes(family, seed_of_case(options.seed, 0), of_cases(options));
  return has_any ? (options.rays + rays_of(family) - 1) / rays_of(family) : 0;
}

SuiteCase suite_case(const SuiteOptions& options, const Family& family, std::uint64_t number) {
  const std::size_t rays = std::min(rays_of(family), options.rays - number * rays_of(family));
  DrawnCase drawn = generate(family, seed_of_case(options.seed, number), rays, of_cases(options)).value();
  for (scene::Query& ray : drawn.the_case.rays) ray.en.clear();
  SuiteCase of{
      &family, number, drawn.parameter, std::move(drawn.the_case), std::move(drawn.solids), std::move(drawn.bodies)};
  of.is_grid = is_of_meshes(family) && asks_grids(options.tipos, options.bodies);
  return of;
}

const Family own_family{"own", "rays that a user brings", "a scene and rays of one's own", {"none", 0, 0}};

SuiteCase own_case(scene::Scene scene, std::vector<scene::Query> rays) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!rays[i].en.empty())
      throw std::invalid_argument(
          fmt::format("ray {} names elements that it starts on, as no system is told of them; expected none", i));
  }
  return {.family = &own_family, .the_case = {std::move(scene), std::move(rays)}};
}

void ask_question(SuiteCase& of, const SuiteOptions& options) {
  of.question = options.question;
  of.ranges.clear();
  Random random(scattered(seed_of_case(options.seed, of.number)));
  switch (options.question) {
    case QuestionKind::first:
      return;
    case QuestionKind::shadow:
      of.ranges = shadow_ranges(of, options.numbers, random);
      return;
    case QuestionKind::range:
      of.ranges = ranges_near_crossings(of, options.numbers, random);
      return answer(of);
    case QuestionKind::all:
    case QuestionKind::count:
      return answer(of);
    case QuestionKind::cast:
      of.ranges = radii_of_balls(of, options.numbers, random);
      return answer(of);
    case QuestionKind::closest:
      put_points_near(of, options.numbers, random);
      answer(of);
      return turn_to_nearest(of);
  }
}

void answer(SuiteCase& of) {
  const auto& [scene, rays] = of.the_case;
  if (of.question == QuestionKind::range)
    of.truths = truths_within(scene, rays, of.ranges, of.others());
  else if (of.question == QuestionKind::cast)
    of.truths = truths_of_casts(scene, rays, of.ranges);
  else if (of.question == QuestionKind::closest)
    of.truths = truths_of_nearest(scene, rays);
  else
    of.truths =
        is_about_all(of.question) ? truths_with_all(scene, rays, of.others()) : truths(scene, rays, of.others());
}

}  // namespace durero::conform
