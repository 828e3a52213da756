#pragma once
/// Makes an engine for a scene whose groups may serve as its hierarchy.

#include <memory>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::engine {

/// @{ The hierarchy of an engine: its own, or the scene's groups.
inline constexpr std::string_view automatic = "automatic", by_hand = "hand";
/// @}

/// Makes the engine of a row for a scene, which must outlive it unedited, with the hierarchy `automatic` or `by_hand`.
/// Throws std::invalid_argument with the expected names, where the hierarchy is neither, and where the engine follows
/// no groups.
std::unique_ptr<const Engine> prepared(const EngineRow& row, std::string_view hierarchy,
                                       const scene::GroupedScene& input);

}  // namespace durero::engine
