#include "durero/engine/bounds.hpp"

#include <algorithm>
#include <ctime>
#include <glm/geometric.hpp>

#include "durero/accel/structure.hpp"
#include "durero/accel/volume/choice.hpp"
#include "durero/accel/volumes.hpp"
#include "durero/trace/search.hpp"

namespace durero::engine {
namespace {

using accel::VolumeKind;
using accel::Volumes;
using scene::Query;
using Queries = std::span<const Query>;

/// The number of directions, spread over the rays, for which void areas are computed; their polyhedra are slow.
constexpr std::size_t directions_asked = 16;

std::vector<glm::dvec3> some_directions(Queries queries) {
  std::vector<glm::dvec3> some;
  const std::size_t count = std::min(directions_asked, queries.size());
  for (std::size_t i = 0; i < count; ++i) {
    const trace::Ray ray(queries[i * queries.size() / count].rayo);
    if (ray.ordinary) some.push_back(ray.v / ray.length());
  }
  return some;
}

/// The CPU time of a call in nanoseconds: the least of several goes, each long enough for the clock's resolution.
template <class Do>
double nanoseconds_of(Do what) {
  constexpr int goes = 5;
  constexpr std::clock_t long_enough = CLOCKS_PER_SEC / 100;
  double least = 0;
  for (int go = 0; go < goes; ++go) {
    std::size_t calls = 0;
    const std::clock_t start = std::clock();
    std::clock_t taken = 0;
    for (; taken < long_enough; taken = std::clock() - start, ++calls) what();
    const double one = 1e9 * double(taken) / CLOCKS_PER_SEC / double(calls);
    if (go == 0 || one < least) least = one;
  }
  return least;
}

/// Tests every ray against all volumes, without a limit and without the elements.
void test_volumes(const Volumes& volumes, Queries queries, accel::Work& work) {
  for (const Query& query : queries) {
    const trace::Ray ray(query.rayo);
    if (!ray.ordinary) continue;
    volumes.any(
        ray, [] { return trace::no_limit; }, [](scene::ElementRef) { return false; }, work);
  }
}

template <class Source>
void answer(const Source& source, Queries queries) {
  trace::Counts unseen;
  for (const Query& query : queries) trace::first_hit_among(source, query.rayo, query.en, unseen);
}

Fit fit_of(const accel::Simple& volume, const accel::Outline& outline, std::span<const glm::dvec3> directions) {
  double sum = 0;
  for (const glm::dvec3& v : directions) sum += void_area(volume, outline, v);
  return {mean_fit(volume, outline), directions.empty() ? 0 : sum / double(directions.size())};
}

void add(Fit& sum, const Fit& fit) {
  sum.mean_fit += fit.mean_fit;
  sum.void_area = sum.void_area && fit.void_area ? std::optional(*sum.void_area + *fit.void_area) : std::nullopt;
}

std::uint64_t count_met(const accel::Volume& volume, Queries queries) {
  std::uint64_t met = 0;
  accel::Work unseen;
  for (const Query& query : queries) {
    const trace::Ray ray(query.rayo);
    if (!ray.ordinary) continue;
    const accel::PrecomputedRay asked(ray, accel::most_slabs);
    met += verdict(volume, asked, trace::no_limit, unseen) == accel::VolumeTest::met;
  }
  return met;
}

class Bounding {
 public:
  Bounding(const scene::Scene& scene, Queries queries)
      : scene_(scene), queries_(queries), directions_(some_directions(queries)), region_(Volumes::region(scene)) {}

  BoundedElement bounded(scene::ElementRef e) const {
    return scene_.visit(e, [&](const auto& shape) {
      const scene::ShapeView element(shape);
      const accel::Outline outline = accel::outline(element);
      BoundedElement found{e, chosen(element, outline), {}};
      for (const VolumeKind& kind : accel::kinds()) {
        const accel::Simple volume = kind.around(element, outline);
        const double share = std::min(1.0, surface_of(volume) / region_);
        found.kinds.push_back({std::string(kind.name), fit_of(volume, outline, directions_),
                               count_met({{volume}}, queries_), kind.B + share * accel::I});
      }
      return found;
    });
  }

 private:
  Bound chosen(scene::ShapeView element, const accel::Outline& outline) const {
    const accel::VolumeCost choice = accel::choose(element, region_);
    Fit fit{(choice.m * region_ - outline.surface()) / 4};
    if (choice.volume.parts.size() == 1) fit = fit_of(choice.volume.parts[0], outline, directions_);
    return {described(choice.volume), fit, count_met(choice.volume, queries_), choice.T};
  }

  const scene::Scene& scene_;
  Queries queries_;
  std::vector<glm::dvec3> directions_;
  double region_;
};

/// Counts n and m in other runs than the timed ones.
void measure(WayOfBounding& way, const Volumes& volumes, Queries queries, bool with_clock) {
  accel::Work answered;
  answer(accel::Counted(volumes, answered), queries);
  way.n = answered.volumes;
  way.m = answered.candidates;
  if (!with_clock || way.n == 0) return;
  accel::Work tested, unseen;
  test_volumes(volumes, queries, tested);
  const double testing = nanoseconds_of([&] { test_volumes(volumes, queries, unseen); });
  way.B = testing / double(std::max<std::uint64_t>(1, tested.volumes));
  way.measured = nanoseconds_of([&] { answer(accel::CandidateSource(volumes), queries); }) / double(queries.size());
}

/// The mean B of the kinds that were chosen for the elements, by the table.
double B_of_the_table(const Volumes& volumes) {
  double sum = 0;
  std::size_t parts = 0;
  for (const auto& [element, volume] : volumes.bounded())
    for (const accel::Simple& part : volume.parts) sum += kind_of(part).B, ++parts;
  return parts == 0 ? 0 : sum / double(parts);
}

WayOfBounding way_of(std::string name, const Volumes& volumes, Queries queries, bool with_clock) {
  WayOfBounding way{std::move(name), {0, 0.0}};
  measure(way, volumes, queries, with_clock);
  if (!with_clock) way.B = B_of_the_table(volumes);
  return way;
}

std::vector<scene::ElementRef> elements_of(const Volumes& volumes) {
  std::vector<scene::ElementRef> elements;
  for (const Volumes::Bounded& one : volumes.bounded()) elements.push_back(one.element);
  std::ranges::sort(elements);
  return elements;
}

void sum_fits(BoundsFigures& found) {
  for (const BoundedElement& element : found.elements) {
    for (std::size_t i = 0; i < element.kinds.size(); ++i) add(found.ways[i].fit, element.kinds[i].fit);
    add(found.ways.back().fit, element.chosen.fit);
  }
}

}  // namespace

BoundsFigures bounds_figures(const scene::Scene& scene, Queries queries, bool with_clock) {
  BoundsFigures found{accel::I, queries.size(), {}, {}};
  for (const VolumeKind& kind : accel::kinds())
    found.ways.push_back(way_of(std::string(kind.name), Volumes(scene, kind), queries, with_clock));
  const Volumes chosen(scene);
  found.ways.push_back(way_of("chosen", chosen, queries, with_clock));
  const Bounding bounding(scene, queries);
  for (const scene::ElementRef e : elements_of(chosen)) found.elements.push_back(bounding.bounded(e));
  sum_fits(found);
  const double rays = double(std::max<std::uint64_t>(1, found.rays));
  const WayOfBounding& balls = found.ways.front();
  if (with_clock) found.I = balls.m == 0 ? 0 : (balls.measured * rays - double(balls.n) * balls.B) / double(balls.m);
  for (WayOfBounding& way : found.ways) way.T = (double(way.n) * way.B + double(way.m) * found.I) / rays;
  return found;
}

}  // namespace durero::engine
