#pragma once
/// JSON pointers (RFC 6901), which say of a value in a file which it is: `/elementos/3/radio`.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/json.hpp"

namespace durero::io::json {

/// A key as it stands between the slashes of a pointer.
std::string pointer_token(std::string_view key);

/// For each byte of the document's source the pointer to the value that stands there, or whose key does; of a bracket,
/// to what it opens or closes. Precondition: the offsets ascend. One walk over the document answers them all.
std::vector<std::string> pointers(const Document& document, std::span<const std::size_t> offsets);

/// Puts the errors of a text into its order, and tells the pointer of each. Throws InputError where the text is no
/// JSON; the errors are in order then, too.
std::vector<std::string> pointers_in_order(const Source& text, std::vector<InputError>& errors);

}  // namespace durero::io::json
