#pragma once
/// The bytes that a buffer of a glTF file names.

#include <cstddef>
#include <string>
#include <string_view>

#include "durero/io/source.hpp"

namespace durero::io {

/// The bytes that a URI stands for, `most` of them at most: those in base64 that a `data:` URI holds, or those of a
/// file in the folder of the source or in one beneath it, whose name the URI is. Throws InputError at `at`, where the
/// URI stands.
std::string buffer_bytes(const Source& source, std::string_view uri, std::size_t at, std::size_t most);

/// The digits of bytes in base64.
std::string base64_text(std::string_view bytes);

}  // namespace durero::io
