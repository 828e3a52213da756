#include "engines.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "durero/oracle/exact.hpp"
#include "durero/oracle/sampled.hpp"
#include "durero/trace/analytic.hpp"

namespace durero::cli {
namespace {

using render::Tracer;
using Origin = Tracer::Origin;

Tracer sampled(const scene::Scene& scene) {
  const auto oracle = std::make_shared<const oracle::sampled::Oracle>(scene);
  return {[oracle](const model::Rayo& ray, Origin) { return oracle->first_hit(ray); },
          [oracle](const model::Rayo& ray, Origin) {
            const scene::Hit hit = oracle->first_hit(ray);
            return hit.resultado == model::Resultado::hit && hit.t < 1;
          }};
}

Tracer exact(const scene::Scene& scene) {
  return {[&](const model::Rayo& ray, Origin en) { return oracle::exact::first_hit(scene, ray, en); },
          [&](const model::Rayo& ray, Origin en) { return oracle::exact::occluded_segment(scene, ray, en); }};
}

Tracer analytic(const scene::Scene& scene) {
  const auto tables = std::make_shared<const trace::Tables>(scene);
  return {[tables](const model::Rayo& ray, Origin en) { return trace::first_hit(*tables, ray, en); },
          [tables](const model::Rayo& ray, Origin en) { return trace::occluded_segment(*tables, ray, en); },
          [tables](std::span<const scene::Query> rays, unsigned threads) {
            return trace::first_hits(*tables, rays, threads);
          }};
}

constexpr std::array<Engine, 3> all = {{{"sampled", sampled}, {"exact", exact}, {"analytic", analytic}}};

const Engine* find(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Engine::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Engine> engines() { return all; }

render::Tracer prepare(std::string_view name, const scene::Scene& scene) { return find(name)->prepare(scene); }

std::string engine_names() {
  std::vector<std::string_view> names;
  names.reserve(std::size(all));
  for (const Engine& engine : all) names.push_back(engine.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string is_engine(const std::string& name) {
  return find(name) == nullptr ? fmt::format("no engine {}, but {}", name, engine_names()) : "";
}

}  // namespace durero::cli
