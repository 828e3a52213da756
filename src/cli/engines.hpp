#pragma once
/// The engines that `durero trace --engine` and `durero render --engine` know: a name and a tracer.

#include <span>
#include <string>
#include <string_view>

#include "durero/render/render.hpp"
#include "durero/scene/scene.hpp"

namespace durero::cli {

/// A name, and what makes it ready to answer the rays of one scene, which must outlive the tracer unedited.
struct Engine {
  std::string_view name;
  render::Tracer (*prepare)(const scene::Scene& scene);
};

/// In the order of the ladder.
std::span<const Engine> engines();

/// The tracer of the engine of that name for this scene. Precondition: is_engine(name) is empty.
render::Tracer prepare(std::string_view name, const scene::Scene& scene);

/// Their names, separated by commas.
std::string engine_names();

/// What is wrong with the name of an engine, for CLI11's check(); empty where nothing is.
std::string is_engine(const std::string& name);

inline constexpr std::string_view default_engine = "analytic";

}  // namespace durero::cli
