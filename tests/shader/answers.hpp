#pragma once
/// What a shader answers of a scene, held against the exact first hits of the same rays.

#include <cstddef>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"
#include "shader/offscreen.hpp"

namespace durero::test {

/// The exact first hits of all pixels, row by row.
inline std::vector<scene::Hit> exact_hits(const engine::Engine& engine, const scene::PrimaryRays& rays) {
  std::vector<scene::Query> queries;
  for (std::uint32_t y = 0; y < rays.resolution().height; ++y)
    for (std::uint32_t x = 0; x < rays.resolution().width; ++x) queries.push_back({rays.ray(x, y)});
  return engine::first_hits(engine, queries);
}

/// All elements, in the order of a shader's numbers.
inline std::vector<scene::ElementRef> numbered_elements(const scene::Scene& scene) {
  std::vector<scene::ElementRef> all;
  scene.for_each([&](scene::ElementRef element, const auto&) { all.push_back(element); });
  return all;
}

/// Whether the answer is the exact one: the one element of the first point, or none.
inline bool is_exact(const scene::Hit& hit, std::uint32_t answer, std::span<const scene::ElementRef> elements) {
  if (answer == 0) return hit.resultado == model::Resultado::miss;
  return hit.resultado == model::Resultado::hit && hit.elementos.size() == 1 &&
         hit.elementos[0] == elements[answer - 1];
}

/// Pixels, those in doubt, and the wrong ones among the others.
struct AnswerCounts {
  std::size_t pixels = 0, doubtful = 0, wrong = 0, met = 0, missed = 0;

  AnswerCounts& operator+=(const AnswerCounts& more) {
    pixels += more.pixels, doubtful += more.doubtful, wrong += more.wrong, met += more.met, missed += more.missed;
    return *this;
  }
};

#ifdef DURERO_EGL

/// Draws a picture of answers, and counts them.
inline AnswerCounts counted_answers(DrawnShader& shader, const scene::Scene& scene, const engine::Engine& engine,
                                    const scene::PrimaryRays& rays) {
  shader.draw(rays);
  const auto answers = shader.answers();
  const std::vector<scene::Hit> hits = exact_hits(engine, rays);
  const std::vector<scene::ElementRef> elements = numbered_elements(scene);
  AnswerCounts counts{.pixels = answers.size()};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i][1] != 0)
      ++counts.doubtful;
    else if (!is_exact(hits[i], answers[i][0], elements))
      ++counts.wrong;
    else
      ++(answers[i][0] != 0 ? counts.met : counts.missed);
  }
  return counts;
}

#endif

}  // namespace durero::test
