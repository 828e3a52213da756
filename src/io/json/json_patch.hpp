#pragma once
/// JSON Patch (RFC 6902): operations on a JSON value, one behind the other.

#include <string_view>
#include <vector>

#include "json_value.hpp"

namespace durero::io::json {

/// The value that a JSON pointer leads to; null where there is none, or where it is no pointer.
JsonValue* find(JsonValue& root, std::string_view pointer);

/// Carries out a patch, which is all of the source, and tells where each of its operations begins. A replaced value
/// keeps its offset in the text that it was read from. Throws InputError, at the place of what is wrong in the patch,
/// where it is none, where a pointer leads nowhere, or where a test fails; what has become of the value then is of no
/// use.
std::vector<std::size_t> apply_patch(const Source& patch, JsonValue& value);

}  // namespace durero::io::json
