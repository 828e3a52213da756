#pragma once
/// JSON Patch (RFC 6902): operations on a JSON value, one behind the other.

#include <string>

#include "json_value.hpp"

namespace durero::io::json {

/// Carries out a patch, which is all of the source. Throws InputError, at the place of what is wrong in the patch,
/// where it is none, where a pointer leads nowhere, or where a test fails; what has become of the value then is of no
/// use.
void apply_patch(const Source& patch, JsonValue& value);

/// The patch that makes one value of the other, an operation a line. Items of the arrays `elementos` and `mallas` of
/// the whole are told apart by `id`, by which they ascend; before such an item is changed or removed a test asks its
/// id. An array or an object is replaced where that is shorter than what its parts take.
std::string patch_between(const JsonValue& from, const JsonValue& to);

}  // namespace durero::io::json
