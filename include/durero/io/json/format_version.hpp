#pragma once
/// Which format a JSON file is of, and in which version. Each format has versions of its own, apart from the program's.

#include <cstdint>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::io::json {

/// What the keys `format` and `version` say in a file of the format.
struct FormatVersion {
  std::string_view format;  ///< such as "durero-scene"; the text must outlive this
  std::uint64_t version;    ///< the one that is read and written
};

/// Looks at the keys `format` and `version` of the object that stands here, wherever they stand in it, and passes
/// nothing. Asked before anything else is read, it refuses a file that a newer durero wrote as that, and not for the
/// first key that is new. Throws InputError where one of them says something else; whether they are there, it does not
/// ask.
void require_version(const Reader& in, const FormatVersion& expected);

/// Writes both keys: the first members of an object.
void write_version(Writer& out, const FormatVersion& of);

}  // namespace durero::io::json
