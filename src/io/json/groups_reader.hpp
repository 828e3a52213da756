#pragma once
/// The groups of a scene file, read from JSON: first as they stand, since a group may name one that stands below it.

#include <cstddef>
#include <string>
#include <vector>

#include "durero/io/json/json.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// A name, and where it stands.
struct NamePlace {
  std::string name;
  std::size_t offset;
};

/// A group as it stands in a file.
struct WrittenGroup {
  NamePlace name;
  std::vector<NamePlace> elementos, groups;
};

/// Throws InputError where what stands here is no groups.
std::vector<WrittenGroup> read_written_groups(json::Reader& in);

/// The groups that they make of the scene's elements. Throws InputError at the first name that breaks a clause.
scene::Groups make_groups(const json::Reader& in, const std::vector<WrittenGroup>& written, const scene::Scene& scene);

}  // namespace durero::io
