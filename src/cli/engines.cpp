#include "engines.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

namespace durero::cli {
namespace {

constexpr std::array<Engine, 0> all = {};

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
