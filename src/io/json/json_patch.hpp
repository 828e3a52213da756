#pragma once
/// JSON Patch (RFC 6902): operations on a JSON value, one behind the other.

#include "json_value.hpp"

namespace durero::io::json {

/// Carries out a patch, which is all of the source. Throws InputError, at the place of what is wrong in the patch,
/// where it is none, where a pointer leads nowhere, or where a test fails; what has become of the value then is of no
/// use.
void apply_patch(const Source& patch, JsonValue& value);

}  // namespace durero::io::json
