// A population of right tracers against the judge: whatever they claim of themselves, however their data are moved
// within what is allowed and wherever their limits lie, none of their answers is off. None of these answers, a little
// beside its place, is gross.
#include "right_tracers.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <functional>

#include "drawn_profile.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/report/report.hpp"
#include "durero/conform/report/tally.hpp"
#include "hits.hpp"
#include "right_trace.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::conform;
using namespace durero::test;

namespace {

RightTracer drawn_tracer(Random& random, const SuiteCase& of) {
  RightTracer tracer{.profile = drawn_profile(random, of)};
  tracer.data = static_cast<Data>(random.below(data_words.size()));
  if (random.chance(1, 3)) tracer.data = Data::moved;
  tracer.draw = static_cast<Draw>(random.below(3));
  tracer.makes_unit = tracer.profile.directions != Directions::any || random.chance(1, 2);
  tracer.counts_origin = random.chance(1, 4);
  tracer.sees_beyond_least = random.chance(1, 4);
  tracer.sees_beyond_greatest = random.chance(1, 4);
  tracer.excludes_limits = random.chance(1, 2);
  tracer.answers_element = random.chance(1, 8);
  tracer.culls_backs = random.chance(3, 4);
  if (random.chance(1, 2))
    tracer.profile.questions = {QuestionKind::first, QuestionKind::shadow, QuestionKind::range, QuestionKind::all,
                                QuestionKind::count};
  return tracer;
}

/// Limits at something that is met by the tracer, or by the data given, or beside it, or anywhere.
void draw_limits(Random& random, RightTracer& tracer, const std::vector<Met>& all, const ExactAnswer& truth) {
  std::vector<double> numbers{std::abs(random.number(-30, 30))};
  for (const Met& met : all) numbers.push_back(distance(tracer, met));
  if (truth.hit.resultado == model::Resultado::hit) numbers.push_back(truth.hit.t);
  for (const scene::Hit& hit : truth.permissible) numbers.push_back(hit.t);
  const auto limit = [&] { return std::abs(near_number(random, random.any_of(numbers))); };
  if (random.chance(1, 3)) tracer.profile.least_t = limit();
  if (random.chance(1, 2)) tracer.profile.greatest_t = limit();
  if (tracer.profile.least_t > tracer.profile.greatest_t) std::swap(tracer.profile.least_t, tracer.profile.greatest_t);
}

std::string shown(const RightTracer& tracer, const Claim& claim) {
  std::string text =
      fmt::format("{} data, unit {}, origin {}, sees least {}, greatest {}, excludes {}",
                  data_words[static_cast<std::size_t>(tracer.data)], tracer.makes_unit, tracer.counts_origin,
                  tracer.sees_beyond_least, tracer.sees_beyond_greatest, tracer.excludes_limits);
  for (const auto& [clause, value] : clauses(tracer.profile)) text += fmt::format(", {} {}", clause, value);
  text += fmt::format("\nleast_t {:a}, greatest_t {:a}, thickness {:a}\n", tracer.profile.least_t,
                      tracer.profile.greatest_t, tracer.profile.thickness);
  text += claim.outcome == Claim::Outcome::hit ? "hit" : "miss";
  if (claim.element) text += fmt::format(" {}#{}", model::name(claim.element->tipo), claim.element->index);
  if (claim.t) text += fmt::format(" t={:a}", *claim.t);
  if (claim.normal)
    text += fmt::format(" normal ({:a}, {:a}, {:a})", claim.normal->x, claim.normal->y, claim.normal->z);
  if (claim.is_front) text += *claim.is_front ? " front" : " back";
  if (claim.uv) text += fmt::format(" uv ({:a}, {:a})", claim.uv->x, claim.uv->y);
  if (claim.punto) text += fmt::format(" ({:a}, {:a}, {:a})", claim.punto->x, claim.punto->y, claim.punto->z);
  return text;
}

/// What was judged: how many rays, of each clause and value, and of each kind of data.
struct Judged {
  std::size_t rays = 0, failures = 0, beyond = 0;
  std::size_t doubtful_shadows = 0, ranges = 0, doubtful_ranges = 0;
  std::size_t lists = 0, doubtful_lists = 0, doubtful_counts = 0;
  std::size_t nudged = 0, off = 0;  ///< answers a little beside their place, and how many of these are off
  std::map<std::string, std::map<std::string, std::size_t>> clauses{};
  std::map<Data, std::size_t> data{};
};

/// A lower bound of the size of an element, beside which the judge calls an error small.
double size_of(const SuiteCase& of, scene::ElementRef element, double way) {
  if (const AskedBody* const body = find_body(of.bodies, element)) return length_of(body->sides[0]);
  return of.the_case.scene.visit(element, [&]<class Shape>(const Shape& shape) {
    if constexpr (requires { shape.altura; })
      return shape.altura;
    else if constexpr (requires { shape.radio; })
      return shape.radio;
    else if constexpr (requires { shape.vertices; })
      return longest(shape.vertices[0] - shape.vertices[1]);
    else
      return way;
  });
}

/// Whether the element is a solid to the tracer, and so may be answered at the origin.
bool is_answered_at_origin(const RightTracer& tracer, const SuiteCase& of, scene::ElementRef element) {
  const bool is_solid = element.tipo == model::Tipo::soy_esfera || is_closed(tracer, of, element) ||
                        (element.tipo == model::Tipo::soy_plano && tracer.profile.half_spaces);
  return tracer.profile.inside == Inside::origin && is_solid;
}

/// A right answer, beside its place by a small part of what is met: near the exact first hit, or the origin inside a
/// solid; nothing where the answer has no number, or is no such.
std::optional<Claim> nudged(Random& random, const RightTracer& tracer, const SuiteCase& of, std::size_t ray,
                            Claim claim) {
  if (!claim.t || !claim.element) return std::nullopt;
  const scene::Hit& truth = of.truths[ray].hit;
  const double length = length_of(1, of.the_case.rays[ray].rayo.v().xyz());
  const double unit = tracer.profile.measure == Measure::length ? 1 : 1 / length, way = truth.t * length;
  double size = size_of(of, *claim.element, way);
  const bool is_plane = claim.element->tipo == model::Tipo::soy_plano;
  if (*claim.t == 0 && is_plane) return std::nullopt;  // it has no size there
  if (*claim.t != 0 || !is_answered_at_origin(tracer, of, *claim.element)) {
    if (truth.resultado != model::Resultado::hit) return std::nullopt;
    for (const scene::ElementRef element : truth.elementos) size = std::min(size, size_of(of, element, way));
    if (!(std::abs(*claim.t / unit - way) < std::ldexp(size, -12))) return std::nullopt;
  }
  claim.normal.reset(), claim.is_front.reset(), claim.uv.reset();  // they are of the place itself
  *claim.t += random.sign() * std::ldexp(size, -random.integer(12, 44)) * unit;
  const bool is_possible = std::isfinite(size / unit) && *claim.t > 0 && std::isfinite(*claim.t);
  return is_possible ? std::optional(claim) : std::nullopt;
}

/// The end of a shadow ray at or beside a t, or anywhere, as the tracer is asked about it.
double drawn_end(Random& random, double t) {
  const double end = random.chance(1, 8) ? std::abs(random.number(-30, 30)) : std::abs(near_number(random, t));
  return end > 0 && std::isfinite(end) ? end : 1;
}

/// An end of a range as the tracer compares it with its numbers.
double own_end(const RightTracer& tracer, double end, double length) {
  const double own = tracer.profile.measure == Measure::length ? end * length : end;
  return narrowed(own, tracer.profile.format);
}

/// The tracer's answer to a shadow ray, in its own number and format, from its answer to the first hit; nothing where
/// that has no number.
std::optional<Claim> shadow_claim(const RightTracer& tracer, const Claim& first, double length, double end) {
  if (first.outcome == Claim::Outcome::miss) return first;
  if (!first.t) return std::nullopt;
  const bool is_hit = *first.t <= own_end(tracer, end, length);
  return Claim{.outcome = is_hit ? Claim::Outcome::hit : Claim::Outcome::miss};
}

/// A range with its ends beside what the tracer meets, or anywhere; perhaps empty.
AskedRange drawn_range(Random& random, const std::vector<Met>& all) {
  const auto end = [&] {
    const bool is_beside = !all.empty() && random.chance(7, 8);
    const double t = is_beside ? near_number(random, random.any_of(all).parameter()) : random.number(-30, 30);
    return std::isfinite(t) ? std::abs(t) : 1;
  };
  const double begin = random.chance(1, 4) ? 0 : end();
  return {begin, end()};
}

/// The case of the ray alone with a range.
SuiteCase within_range(const SuiteCase& of, std::size_t ray, const AskedRange& range) {
  SuiteCase asked = with_ray_alone(of, ray);
  asked.question = QuestionKind::range;
  asked.ranges = {range};
  answer(asked);
  return asked;
}

/// The tracer's answer to the first hit within a range, whose ends may or may not belong to it.
std::optional<Claim> range_claim(const RightTracer& tracer, std::vector<Met> all, const AskedRange& range,
                                 double length) {
  const double begin = own_end(tracer, range.begin, length), end = own_end(tracer, range.end, length);
  std::erase_if(all, [&](const Met& met) {
    const double x = distance(tracer, met);
    return x < begin || x > end || (tracer.excludes_limits && (x == end || (x == begin && begin > 0)));
  });
  return claim_of(tracer, all);
}

/// The case of the ray alone, asked for all hits or their number.
SuiteCase about_all(const SuiteCase& of, std::size_t ray, QuestionKind question) {
  SuiteCase asked = with_ray_alone(of, ray);
  asked.question = question;
  answer(asked);
  return asked;
}

/// The list and the number of all hits of a ray.
void judge_all(Judged& judged, const SuiteCase& of, std::size_t ray, const RightTracer& tracer,
               const std::vector<Met>& all, const std::function<void(Verdict, const Claim&)>& fail) {
  const std::optional<Claim> list = list_claim(tracer, all);
  if (!list) return;
  const Verdict of_list = judge(about_all(of, ray, QuestionKind::all), 0, *list, tracer.profile).verdict;
  const Claim count = count_claim(tracer, all);
  const Verdict of_count = judge(about_all(of, ray, QuestionKind::count), 0, count, tracer.profile).verdict;
  ++judged.lists;
  judged.doubtful_lists += of_list == Verdict::right;
  judged.doubtful_counts += of_count == Verdict::right;
  UNSCOPED_INFO(all.size() << " are met, listed " << claim_words(*list, of.the_case.scene));
  if (is_failure(of_list)) fail(of_list, *list);
  if (is_failure(of_count)) fail(of_count, *list);
}

/// One ray for one tracer of that seed. `beyond` are rays that end otherwise by their limits.
void judge_one(Judged& judged, const SuiteCase& of, std::size_t ray, std::uint64_t seed) {
  Random random(seed);
  RightTracer tracer = drawn_tracer(random, of);
  const auto all = RightTrace(tracer, of, ray, random).all_met();
  if (!all) return;
  const std::optional<Claim> unlimited = claim_of(tracer, *all);
  draw_limits(random, tracer, *all, of.truths[ray]);
  const std::optional<Claim> claim = claim_of(tracer, *all);
  if (!claim) return;
  const Verdict verdict = judge(of, ray, *claim, tracer.profile).verdict;
  if (verdict == Verdict::skipped) return;
  ++judged.rays;
  ++judged.data[tracer.data];
  judged.beyond += unlimited != claim;
  for (const auto& [clause, value] : clauses(tracer.profile)) ++judged.clauses[clause][value];
  const auto fail = [&](Verdict is, const Claim& with) {
    if (judged.failures > 20) return;
    ++judged.failures;
    FAIL_CHECK(of.name() << " ray " << ray << ", tracer " << seed << ": " << name(is) << "\n"
                         << text(of.the_case.rays[ray]) << "\ntruth " << text(of.truths[ray].hit) << "\n"
                         << shown(tracer, with));
  };
  if (verdict != Verdict::exact && verdict != Verdict::right) fail(verdict, *claim);
  if (tracer.profile.questions.size() > 1) {
    const double length = length_of(1, of.the_case.rays[ray].rayo.v().xyz());
    const double unit = tracer.profile.measure == Measure::length ? length : 1;
    const double t = claim->t ? *claim->t / unit : of.truths[ray].hit.t;
    SuiteCase asked = with_ray_alone(of, ray);
    asked.question = QuestionKind::shadow;
    asked.ranges = {{0, drawn_end(random, t)}};
    const std::optional<Claim> says = shadow_claim(tracer, *claim, length, asked.ranges[0].end);
    const Verdict of_shadow = says ? judge(asked, 0, *says, tracer.profile).verdict : Verdict::exact;
    judged.doubtful_shadows += of_shadow == Verdict::right;
    if (is_failure(of_shadow)) {
      UNSCOPED_INFO("a shadow ray up to " << asked.ranges[0].end << ": " << (says->outcome == Claim::Outcome::hit));
      fail(of_shadow, *claim);
    }
    const AskedRange range = drawn_range(random, *all);
    const std::optional<Claim> within = range_claim(tracer, *all, range, length);
    const Verdict of_range =
        within ? judge(within_range(of, ray, range), 0, *within, tracer.profile).verdict : Verdict::exact;
    ++judged.ranges;
    judged.doubtful_ranges += of_range == Verdict::right;
    if (is_failure(of_range)) {
      UNSCOPED_INFO(fmt::format("within {:a} … {:a}", range.begin, range.end));
      fail(of_range, *within);
    }
    judge_all(judged, of, ray, tracer, *all, fail);
  }
  const std::optional<Claim> beside = random.chance(1, 4) ? nudged(random, tracer, of, ray, *claim) : std::nullopt;
  if (!beside) return;
  ++judged.nudged;
  const Verdict of_beside = judge(of, ray, *beside, tracer.profile).verdict;
  judged.off += of_beside == Verdict::off;
  if (is_gross(of_beside)) fail(of_beside, *beside);
}

/// Of each family some cases of either format, open and with solids; of each ray some tracers.
Judged judge_population(std::uint64_t suite_seed, std::uint64_t cases_of_each, std::size_t tracers) {
  Judged judged;
  std::uint64_t seed = suite_seed << 32U;
  for (const NumberFormat numbers : {NumberFormat::binary32, NumberFormat::binary64}) {
    for (const Caps caps : {Caps::open, Caps::solid}) {
      const SuiteOptions options{
          .seed = suite_seed, .rays = cases_of_each * rays_of_a_case, .caps = caps, .numbers = numbers};
      for (const Family& family : families()) {
        if (is_of_meshes(family) || (is_of_bodies(family) && caps == Caps::solid)) continue;
        for (std::uint64_t number = 0; number < cases(options, family); ++number) {
          INFO("suite seed " << suite_seed << ", " << word(numbers) << ", " << word(caps));
          SuiteCase of = suite_case(options, family, number);
          answer(of);
          for (std::size_t ray = 0; ray < of.truths.size(); ++ray)
            for (std::size_t i = 0; i < tracers; ++i) judge_one(judged, of, ray, ++seed);
        }
      }
    }
  }
  return judged;
}

/// Every clause was claimed, in each of its values, by tracers whose answers were judged.
void check_members(const Judged& judged, std::size_t least) {
  for (const auto& [clause, values] : judged.clauses) {
    for (const auto& [value, rays] : values) {
      INFO(clause << " " << value << ": " << rays);
      CHECK(rays > least);
    }
    CHECK(values.size() >= 2);
  }
  const auto count = [&](const char* clause) { return judged.clauses.at(clause).size(); };
  CHECK(count("measure") == measure_words.size());
  CHECK(count("directions") == directions_words.size());
  CHECK(count("inside") == inside_words.size());
  CHECK(judged.data.size() == data_words.size());
  CHECK(judged.beyond > judged.rays / 50);
  CHECK(judged.doubtful_shadows > judged.rays / 50);
  CHECK(judged.doubtful_ranges > judged.ranges / 50);
  CHECK(judged.doubtful_lists > judged.lists / 50);
  CHECK(judged.doubtful_counts > judged.lists / 50);
  CHECK(judged.nudged > judged.rays / 50);
  CHECK(judged.off > judged.nudged / 4);
  CHECK(judged.failures == 0);
}

}  // namespace

TEST_CASE(
    "no answer of a right tracer is off, nor gross a little beside, whatever it claims and wherever its limits lie") {
  const Judged judged = judge_population(1, 4, fewer_when_sanitized(5));
  INFO(judged.rays << " rays, " << judged.beyond << " end otherwise by their limits");
  CHECK(judged.rays > fewer_when_sanitized(20'000));
  check_members(judged, fewer_when_sanitized(100));
}

TEST_CASE("nor of ten million rays", "[long]") {
  // RIGHT_TRACERS_SUITES: how many of the suites, each of some 117,000 rays.
  const char* asked = std::getenv("RIGHT_TRACERS_SUITES");
  const std::uint64_t suites = asked == nullptr ? 90 : std::strtoull(asked, nullptr, 10);
  std::size_t rays = 0;
  for (std::uint64_t suite = 2; suite < 2 + suites; ++suite) {
    const Judged judged = judge_population(suite, 8, 12);
    rays += judged.rays;
    CHECK(judged.failures == 0);
  }
  fmt::print("{} rays of right tracers were judged\n", rays);
  CHECK(rays > suites * 111'112);
}
