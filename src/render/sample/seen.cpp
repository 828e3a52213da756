#include "durero/render/sample/seen.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "by_rows.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/trace/search.hpp"
#include "view.hpp"

namespace durero::render {
namespace {

/// The number of each element.
using Numbers = std::map<scene::ElementRef, std::uint32_t>;

Numbers numbers_of(const scene::Scene& scene) {
  Numbers numbers;
  std::uint32_t number = 0;
  for (const scene::ElementRef element : scene::elements_by_name(scene)) numbers.emplace(element, ++number);
  return numbers;
}

std::uint32_t level_of(const scene::Scene& scene, const model::Rayo& ray, const scene::ElementSet& elements) {
  trace::Counts counts;
  const trace::Search search(scene, ray, {}, counts);
  trace::Step last = trace::Step::triage;
  for (const scene::ElementRef element : elements) last = std::max(last, search.meeting(element, trace::no_limit).step);
  return static_cast<std::uint32_t>(last) + 1;
}

PrimaryHit seen_by(const View& view, const Numbers& numbers, const model::Rayo& ray, const scene::Hit& hit) {
  if (hit.resultado != model::Resultado::hit) return {};
  const auto front = std::ranges::min_element(hit.elementos, {}, [&](auto element) { return numbers.at(element); });
  const glm::dvec3 n = view.engine.normal(view.scene, *front, hit.punto), v = ray.v().xyz();
  return {.depth = hit.t * glm::length(v),
          .normal = glm::dot(n, v) > 0 ? -n : n,
          .element = numbers.at(*front),
          .level = level_of(view.scene, ray, hit.elementos)};
}

}  // namespace

std::vector<PrimaryHit> seen(const scene::Scene& scene, const engine::Engine& engine, const RenderSettings& frame) {
  const View view(scene, engine, frame);
  const Numbers numbers = numbers_of(scene);
  const std::uint32_t width = view.crop.size.width;
  std::vector<PrimaryHit> all(std::size_t(width) * view.crop.size.height);
  by_rows(view.crop.size.height, {}, [&](std::uint32_t y) {
    std::vector<scene::Query> queries;
    for (std::uint32_t x = 0; x < width; ++x) queries.push_back({view.rays.ray(view.crop.x + x, view.crop.y + y)});
    const std::vector<scene::Hit> hits = engine::first_hits(engine, queries);
    for (std::uint32_t x = 0; x < width; ++x)
      all[std::size_t(y) * width + x] = seen_by(view, numbers, queries[x].rayo, hits[x]);
  });
  return all;
}

std::vector<std::string> numbered(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const scene::ElementRef element : scene::elements_by_name(scene)) names.emplace_back(scene.name(element).name());
  return names;
}

}  // namespace durero::render
