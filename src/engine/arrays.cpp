#include "durero/engine/arrays.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace durero::engine {
namespace {

constexpr std::size_t at_a_time = 1 << 16;

void require_equal(std::size_t size, std::initializer_list<std::size_t> others) {
  if (std::ranges::any_of(others, [&](std::size_t other) { return other != size; }))
    throw std::invalid_argument("the arrays of rays are not equally long; expected a number of every ray in each");
}

void require_whole(const RayArrays& rays, std::size_t answers) {
  const std::size_t size = rays.size();
  require_equal(size, {rays.p[1].size(), rays.p[2].size(), rays.v[0].size(), rays.v[1].size(), rays.v[2].size()});
  require_equal(size, {rays.start.empty() ? size : rays.start.size(), answers});
}

scene::Query query(const RayArrays& rays, std::size_t i) {
  scene::Query query{{model::Punto(rays.p[0][i], rays.p[1][i], rays.p[2][i]),
                      model::Vector(rays.v[0][i], rays.v[1][i], rays.v[2][i])}};
  if (!rays.start.empty() && rays.start[i]) query.en.push_back(*rays.start[i]);
  return query;
}

/// Calls answer(begin, queries) for consecutive rays, of which `begin` is the first.
template <class Answer>
void answer_some_at_a_time(const RayArrays& rays, Answer answer) {
  std::vector<scene::Query> queries;
  queries.reserve(std::min(rays.size(), at_a_time));
  for (std::size_t begin = 0; begin < rays.size(); begin += at_a_time) {
    queries.clear();
    for (std::size_t i = begin; i < std::min(begin + at_a_time, rays.size()); ++i) queries.push_back(query(rays, i));
    answer(begin, std::span<const scene::Query>(queries));
  }
}

}  // namespace

void first_hits(const Engine& engine, const RayArrays& rays, std::span<trace::FirstElement> elements,
                const PointArrays& points) {
  require_whole(rays, elements.size());
  require_equal(rays.size(), {points.t.size(), points.point[0].size(), points.point[1].size(), points.point[2].size()});
  std::vector<scene::Hit> hits(std::min(rays.size(), at_a_time));
  answer_some_at_a_time(rays, [&](std::size_t begin, std::span<const scene::Query> queries) {
    engine.first_hits(queries, std::span(hits).first(queries.size()));
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const scene::Hit& hit = hits[i];
      elements[begin + i] = trace::first_element(hit);
      points.t[begin + i] = hit.t;
      for (int axis = 0; axis < 3; ++axis) points.point[static_cast<std::size_t>(axis)][begin + i] = hit.punto[axis];
    }
  });
}

void first_elements(const Engine& engine, const RayArrays& rays, std::span<trace::FirstElement> elements) {
  require_whole(rays, elements.size());
  answer_some_at_a_time(rays, [&](std::size_t begin, std::span<const scene::Query> queries) {
    engine.first_elements(queries, elements.subspan(begin, queries.size()));
  });
}

void occluded_segments(const Engine& engine, const RayArrays& rays, std::span<bool> occluded) {
  require_whole(rays, occluded.size());
  answer_some_at_a_time(rays, [&](std::size_t begin, std::span<const scene::Query> queries) {
    engine.occluded_segments(queries, occluded.subspan(begin, queries.size()));
  });
}

}  // namespace durero::engine
