#pragma once
/// A body as files have it where it is a part of a solid.

#include <string>

#include "durero/scene/body.hpp"

namespace durero::io {

/// One line: the body without a name and a material. The same body gives the same bytes.
std::string part_text(const scene::Body& part);

}  // namespace durero::io
