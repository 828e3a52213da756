#pragma once
/// Writes JSON text: commas, quotes, escapes and numbers stand where they must, whoever writes.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace durero::io::json {

/// Appends to a text, which must outlive it. Precondition: the calls are those of a JSON value, in its order: a key
/// before each member, an end for each beginning.
class Writer {
 public:
  /// Writes behind what the text holds already.
  explicit Writer(std::string& out) : out_(&out) {}

  /// @{ A bracket of an object or array, which is itself a value: of a member or an item, or the whole.
  Writer& begin_object() { return begin('{'); }
  Writer& end_object() { return end('}'); }
  Writer& begin_array() { return begin('['); }
  Writer& end_array() { return end(']'); }
  /// @}
  /// A key of an object, escaped. Its value must follow. Precondition: it is UTF-8.
  Writer& key(std::string_view name);
  /// What follows next, a member, an item or an end, stands on a new line.
  Writer& new_line();

  /// A string, escaped. Precondition: it is UTF-8.
  Writer& value(std::string_view text);
  /// The same of a text up to its NUL. Precondition: it is not null.
  Writer& value(const char* text) { return value(std::string_view(text)); }
  /// true or false; for bool alone, so that nothing is converted to it.
  Writer& value(std::same_as<bool> auto truth) { return raw(truth ? "true" : "false"); }
  /// All digits, also of what no binary64 holds.
  Writer& value(std::uint64_t number);
  /// All digits of a size, where its type is another.
  Writer& value(std::same_as<std::size_t> auto size)
    requires(!std::same_as<std::size_t, std::uint64_t>)
  {
    return value(std::uint64_t{size});
  }
  /// The shortest decimal that reads back; what JSON has no number for is the string "inf", "-inf" or "nan".
  Writer& value(double number);
  /// `[x,y,z]`
  Writer& value(const glm::dvec3& triple);
  /// `[[x,y,z],[x,y,z],[x,y,z]]`
  Writer& value(const std::array<glm::dvec3, 3>& triples);

  /// A member of an object.
  template <class Value>
  Writer& member(std::string_view name, const Value& its_value) {
    return key(name).value(its_value);
  }

 private:
  Writer& begin(char bracket);
  Writer& end(char bracket);
  Writer& raw(std::string_view text);
  void separate();

  std::string* out_;
  bool comma_ = false;  // a member or an item stands before what follows
  bool line_ = false;   // a line ends before what follows
};

}  // namespace durero::io::json
