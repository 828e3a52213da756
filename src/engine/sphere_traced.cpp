#include "sphere_traced.hpp"

#include <tbb/parallel_for.h>

#include <vector>

#include "durero/distance/sphere_tracing.hpp"
#include "durero/engine/sphere_tracing_figures.hpp"

namespace durero::engine {
namespace {

using distance::SphereTracer;
using distance::Walk;
using distance::WalkEnd;

void put(scene::Hit& hit, const model::Rayo& rayo, const Walk& walk) {
  const bool is_near = walk.end == WalkEnd::near;
  hit.resultado = is_near ? model::Resultado::hit : model::Resultado::miss;
  hit.t = is_near ? walk.t : 0;
  hit.punto = is_near ? rayo.p().xyz() + walk.t * rayo.v().xyz() : glm::dvec3(0);
  hit.elementos.clear();
  if (is_near) hit.elementos.push_back(walk.element);
}

class SphereTraced final : public Engine {
 public:
  explicit SphereTraced(const scene::Scene& scene) : tracer_(scene) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(),
                      [&](std::size_t i) { put(hits[i], queries[i].rayo, tracer_.walk(queries[i])); });
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      const Walk walk = tracer_.walk(queries[i]);
      occluded[i] = walk.end == WalkEnd::near && walk.t < 1;
    });
  }

 private:
  SphereTracer tracer_;
};

void count(SphereTracingFigures& figures, const Walk& walk, const scene::Hit& exact) {
  constexpr double rounding = 1 + 0x1p-40;  // of the two parameters
  const bool is_near = walk.end == WalkEnd::near, is_hit = exact.resultado == model::Resultado::hit;
  figures.steps += walk.steps;
  ++figures.rays;
  if (is_hit && (walk.t > exact.t * rounding || walk.end == WalkEnd::outside)) {
    ++figures.passed;
  } else if (walk.end == WalkEnd::tired) {
    ++figures.tired;
  } else if (is_near && exact.resultado == model::Resultado::miss) {
    ++figures.grazed;
  } else if (is_near && std::ranges::find(exact.elementos, walk.element) == exact.elementos.end()) {
    ++figures.other;
  } else {
    ++figures.right;
  }
}

}  // namespace

std::unique_ptr<const Engine> sphere_traced(const scene::Scene& scene) {
  return std::make_unique<const SphereTraced>(scene);
}

SphereTracingFigures sphere_tracing_figures(const scene::Scene& scene, std::span<const scene::Query> queries,
                                            double epsilon) {
  const SphereTracer tracer(scene, epsilon);
  const std::vector<scene::Hit> exact = first_hits(*find(default_engine)->prepare(scene), queries);
  std::vector<Walk> walks(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) { walks[i] = tracer.walk(queries[i]); });
  SphereTracingFigures figures{.epsilon = tracer.epsilon()};
  for (std::size_t i = 0; i < queries.size(); ++i) count(figures, walks[i], exact[i]);
  return figures;
}

}  // namespace durero::engine
