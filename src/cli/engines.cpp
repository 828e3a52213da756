#include "engines.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "durero/oracle/exact.hpp"
#include "durero/oracle/sampled.hpp"
#include "durero/trace/analytic.hpp"

namespace durero::cli {
namespace {

// The sampled engine covers the scene anew for each ray: it is there to be looked at, not to be fast.
scene::Hit sampled_first_hit(const scene::Scene& scene, const model::Rayo& rayo, std::span<const scene::ElementRef>) {
  return oracle::sampled::Oracle(scene).first_hit(rayo);
}
bool sampled_occluded_segment(const scene::Scene& scene, const model::Rayo& rayo,
                              std::span<const scene::ElementRef> en) {
  const scene::Hit hit = sampled_first_hit(scene, rayo, en);
  return hit.resultado == model::Resultado::hit && hit.t < 1;
}

constexpr std::array<Engine, 3> all = {{
    {"sampled", sampled_first_hit, sampled_occluded_segment},
    {"exact", oracle::exact::first_hit, oracle::exact::occluded_segment},
    {"analytic", trace::first_hit, trace::occluded_segment},
}};

}  // namespace

std::span<const Engine> engines() { return all; }

const Engine* find_engine(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Engine::name);
  return found == all.end() ? nullptr : found;
}

std::string engine_names() {
  std::vector<std::string_view> names;
  for (const Engine& engine : all) names.push_back(engine.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string is_engine(const std::string& name) {
  return find_engine(name) == nullptr ? fmt::format("no engine {}, but {}", name, engine_names()) : "";
}

}  // namespace durero::cli
