#pragma once
/// Whole numbers in a binary file, by the order of their bytes.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace durero::io {

/// The number of some bytes, the least first. Precondition: there are 8 at most.
inline std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// The number of some bytes, the greatest first. Precondition: there are 8 at most.
inline std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

/// Appends the low bytes of a number, the least first. Precondition: there are 8 at most.
inline void append_little_endian(std::string& out, std::uint64_t number, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) out += static_cast<char>(number >> 8 * i & 0xffU);
}

}  // namespace durero::io
