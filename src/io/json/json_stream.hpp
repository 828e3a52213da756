#pragma once
/// What RapidJSON reads a text through: a stream that keeps the numbers to itself.

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace durero::io::json {

/// A byte of a number's text, in JSON.
inline bool is_number_byte(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

/// Passes one digit or more; false where there is none.
inline bool take_digits(std::string_view& rest) {
  const std::size_t count = std::min(rest.find_first_not_of("0123456789"), rest.size());
  rest.remove_prefix(count);
  return count > 0;
}

inline bool take_any(std::string_view& rest, std::string_view bytes) {
  if (rest.empty() || bytes.find(rest.front()) == bytes.npos) return false;
  rest.remove_prefix(1);
  return true;
}

/// JSON's grammar of a number (RFC 8259, section 6).
inline bool is_number(std::string_view text) {
  take_any(text, "-");
  if (!take_any(text, "0") && !take_digits(text)) return false;
  if (take_any(text, ".") && !take_digits(text)) return false;
  if (take_any(text, "eE")) {
    take_any(text, "+-");
    if (!take_digits(text)) return false;
  }
  return text.empty();
}

/// RapidJSON's stream over a part of a text: '\0' stands for its end, so a NUL inside it is looked for afterwards. In
/// the place of each number, whose grammar is checked here, the parser sees one 0. What is no number by that grammar it
/// sees as it is, and refuses.
struct Stream {
  using Ch = char;
  const char* begin;
  const char* next;
  const char* end;
  bool in_string = false;
  bool escaped = false;              // the last byte of the string was a backslash that escapes the next
  mutable const char* looked = end;  // the last place at which a number was looked for,
  mutable const char* behind = end;  // and what stands behind it; `looked` itself where there is none

  Ch Peek() const {
    if (next == end) return '\0';
    return number_end() == next ? *next : '0';
  }
  Ch Take() {
    if (next == end) return '\0';
    if (const char* const after = number_end(); after != next) {
      next = after;
      return '0';
    }
    follow_string(*next);
    return *next++;
  }
  std::size_t Tell() const { return static_cast<std::size_t>(next - begin); }
  // Only parsing in place writes.
  Ch* PutBegin() { return nullptr; }
  void Put(Ch) {}
  std::size_t PutEnd(Ch*) { return 0; }

 private:
  // Behind the number that starts here; `next` where none does. A number is the whole of a run of its bytes.
  const char* number_end() const {
    if (in_string || !is_number_byte(*next) || (next != begin && is_number_byte(next[-1]))) return next;
    if (looked != next) {
      looked = next;
      const char* const run_end = std::find_if_not(next, end, is_number_byte);
      behind = is_number(std::string_view(next, run_end)) ? run_end : next;
    }
    return behind;
  }

  void follow_string(char c) {
    if (c == '"' && !escaped) in_string = !in_string;
    escaped = in_string && c == '\\' && !escaped;
  }
};

}  // namespace durero::io::json
