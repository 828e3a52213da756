#pragma once
/// JSON values that are taken apart and put together. Numbers stand as they are written: none is rounded.

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/io/json/json.hpp"

namespace durero::io::json {

struct JsonValue;
struct JsonMember;

/// A number, true, false or null, by its text.
struct JsonWord {
  std::string text;
  bool operator==(const JsonWord&) const = default;
};

using JsonItems = std::vector<JsonValue>;
using JsonMembers = std::vector<JsonMember>;

/// A string stands without quotes and escapes.
struct JsonValue {
  std::variant<JsonWord, std::string, JsonItems, JsonMembers> of;
  std::size_t offset = 0;  ///< where it stands in the text that it was read from; of a made value 0
  /// The value of the first member of that key; null where there is none, or where it is no object.
  JsonValue* member(std::string_view key);
  const JsonValue* member(std::string_view key) const;
  /// Written alike: members in the same order, and numbers with the same digits.
  bool operator==(const JsonValue& other) const;
};

struct JsonMember {
  std::string key;
  JsonValue value;
  bool operator==(const JsonMember&) const = default;
};

/// The size of a value.
struct ValueExtent {
  std::size_t depth;   ///< how deep its brackets stand in each other; 0 of a word or a string
  std::size_t values;  ///< how many values it has with all below it
};
ValueExtent extent_of(const JsonValue& value);

/// How deep brackets may stand in brackets. At most 500 bodies of a scene file lie in each other (most_within of
/// body_reader.cpp), and each of them brings two brackets, that of its object and that of `de`: 1000. The other
/// brackets are those of a scene and of a map, 5 at most.
inline constexpr std::size_t deepest_brackets = 1024;

/// Takes the value that stands here. Throws InputError where brackets are deeper than that.
JsonValue read_value(const Source& source, Reader& in);
/// The value that is the whole of a source. Throws InputError as read_value does, and where the source is no JSON.
JsonValue read_whole(const Source& source);

/// Appends the text of a value, without blanks.
void append_value(std::string& out, const JsonValue& value);
/// Appends the text of a file: each part of the value, and each part of such a part, stands on a line of its own.
void append_lines(std::string& out, const JsonValue& value);

/// Whether they are equal as RFC 6902 says it in section 4.6: numbers in their values, which are binary64 here, and
/// members in any order.
bool are_equal(const JsonValue& a, const JsonValue& b);

}  // namespace durero::io::json
