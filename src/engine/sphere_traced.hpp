#pragma once
/// Sphere tracing as an engine.

#include <memory>

#include "durero/engine/engine.hpp"

namespace durero::engine {

/// An engine that walks along each ray by distances. A ray that it gives up is a miss.
std::unique_ptr<const Engine> sphere_traced(const scene::Scene& scene);

}  // namespace durero::engine
