#pragma once
/// The engine for a scene where a Z text defines some elements, and the program's formulas all others.

#include <memory>
#include <vector>

#include "durero/engine/engine.hpp"
#include "surface_search.hpp"

namespace durero::written {

/// The engine for a scene whose elements at those places have these points, ascending by place; in the tables they
/// stand as spheres. Others are asked as composed::prepared asks them, bodies too. It does not refer to the scene.
std::unique_ptr<const engine::Engine> mixed_engine(const scene::Scene& scene, std::vector<SurfaceElement> surfaces);

}  // namespace durero::written
