#pragma once
/// Operations that are repeated for each element of a set: places in braces stand for what differs.

#include <string>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::cli {

/// An operation as it is written for one of the elements.
struct RepeatedOperation {
  std::string element;  ///< its name
  std::string text;     ///< without places
};

/// Each operation for each element, in the order of the elements: `{}` becomes the name, and `{radio}`, or another
/// attribute's word, the value as a line of a script has it. Precondition: the elements are of the scene. Throws
/// io::InputError at a place whose word is none of an attribute that the element has.
std::vector<RepeatedOperation> repeated(const std::vector<std::string>& operations, const scene::Scene& scene,
                                        const std::vector<std::string>& elements);

}  // namespace durero::cli
