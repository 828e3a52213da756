#pragma once
/// The JSON Patch between two JSON values.

#include <string>

#include "json_value.hpp"

namespace durero::io::json {

/// The patch that makes one value of the other, an operation a line. Items of the arrays `elementos` and `mallas` of
/// the whole are told apart by `id`, by which they ascend; before such an item is changed or removed a test asks its
/// id. An array or an object is replaced where that is shorter than what its parts take.
std::string patch_between(const JsonValue& from, const JsonValue& to);

}  // namespace durero::io::json
