#pragma once
/// The materials of a scene as Radiance has them.

#include <string_view>
#include <vector>

#include "durero/scene/stage.hpp"

namespace durero::io {

/// A type of material, and its numbers.
struct RadWrittenLook {
  std::string_view type;
  std::vector<double> numbers;
};

/// The nearest material that Radiance has: one that RadLooks reads to the same, where there is such.
RadWrittenLook rad_written_look(const scene::Material& look);

/// What RadLooks makes of a material, without a name.
scene::Material rad_read_look(const RadWrittenLook& written);

}  // namespace durero::io
