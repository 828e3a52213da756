#pragma once
/// The parts of an answer beside its place: the outward normal, the side that the ray comes from, u and v.

#include "durero/conform/ask/claim.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::cli {

/// Adds them to a hit with an element and a point.
void add_besides(conform::Claim& claim, const scene::Scene& scene, const scene::Query& ray);

}  // namespace durero::cli
