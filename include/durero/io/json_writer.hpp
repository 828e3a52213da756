#pragma once
/// Writes JSON text: commas, quotes, escapes and numbers stand where they must, whoever writes.

#include <array>
#include <concepts>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace durero::io::json {

/// Appends to a text, which must outlive it. Precondition: the calls are those of a JSON value, in its order: a key
/// before each member, an end for each beginning.
class Writer {
 public:
  explicit Writer(std::string& out) : out_(&out) {}

  Writer& begin_object() { return begin('{'); }
  Writer& end_object() { return end('}'); }
  Writer& begin_array() { return begin('['); }
  Writer& end_array() { return end(']'); }
  Writer& key(std::string_view name);
  /// What follows next, a member, an item or an end, stands on a new line.
  Writer& new_line();

  Writer& value(std::string_view text);
  Writer& value(const char* text) { return value(std::string_view(text)); }
  Writer& value(std::same_as<bool> auto truth) { return raw(truth ? "true" : "false"); }
  Writer& value(std::uint64_t number);
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
