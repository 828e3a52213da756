#pragma once
/// The parts that two scenes differ in.

#include <optional>
#include <string>
#include <vector>

#include "durero/io/json/scene_parts.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::io {

/// A part that two scenes do not share.
struct PartChange {
  PartKey part;                             ///< which
  std::optional<std::string> from{}, to{};  ///< its values, as scene_parts() has them; nothing where there is none
};

/// The parts that differ, in their order; none where scene_text() gives the same bytes for both.
std::vector<PartChange> part_changes(const scene::GroupedScene& from, const scene::GroupedScene& to);

/// `{"part":"/elementos/ball","change":"changed","from":{…},"to":{…}}`, `added` without from, `removed` without to;
/// without line end.
std::string change_text(const PartChange& change);

/// How many parts of each kind were added, removed and changed, a line each: `elementos: 1 added, 0 removed, 2
/// changed`.
std::string changes_summary(const std::vector<PartChange>& changes);

/// A value of a part, which may have several lines, as one line of JSON.
std::string on_one_line(std::string value);

}  // namespace durero::io
