#pragma once
/// An engine made ready for a scene with groups, which may be its hierarchy.

#include <memory>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::engine {

/// @{ How an engine groups elements: by itself, or as the groups of the scene do.
inline constexpr std::string_view automatic = "automatic", by_hand = "hand";
/// @}

/// The engine, ready for the scene, which must outlive it unedited, with its hierarchy made so: `automatic` or
/// `by_hand`. Throws std::invalid_argument, which says what was expected, where it is neither, and where the engine
/// follows no groups.
std::unique_ptr<const Engine> prepared(const Row& row, std::string_view hierarchy, const scene::GroupedScene& input);

}  // namespace durero::engine
