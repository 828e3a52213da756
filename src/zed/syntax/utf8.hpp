#pragma once
/// The UTF-8 that reading Z needs beyond what places and messages need.

#include <string>

#include "durero/text/utf8.hpp"

namespace durero::zed::utf8 {

using text::continues;
using text::first;

/// A number that is a character: no surrogate, and at most U+10FFFF.
inline bool is_scalar(unsigned code) { return code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF); }

/// The bytes of a character.
inline std::string encode(unsigned code) {
  const auto byte = [](unsigned value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | (code >> 6)), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000) return {byte(0xE0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3F)), byte(0x80 | (code & 0x3F))};
  return {byte(0xF0 | (code >> 18)), byte(0x80 | ((code >> 12) & 0x3F)), byte(0x80 | ((code >> 6) & 0x3F)),
          byte(0x80 | (code & 0x3F))};
}

}  // namespace durero::zed::utf8
