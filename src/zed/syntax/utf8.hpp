#pragma once
/// The little of UTF-8 that reading Z needs.

#include <string>
#include <string_view>

namespace durero::zed::utf8 {

inline bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

inline bool is_scalar(unsigned code) { return code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF); }

/// The first character of `text` (not empty), whole: a lead byte and the bytes that continue it, at most 4 together.
inline std::string_view first(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && length < 4 && continues(text[length])) ++length;
  return text.substr(0, length);
}

inline std::string encode(unsigned code) {
  const auto byte = [](unsigned value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | (code >> 6)), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000) return {byte(0xE0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3F)), byte(0x80 | (code & 0x3F))};
  return {byte(0xF0 | (code >> 18)), byte(0x80 | ((code >> 12) & 0x3F)), byte(0x80 | ((code >> 6) & 0x3F)),
          byte(0x80 | (code & 0x3F))};
}

}  // namespace durero::zed::utf8
