#pragma once
/// Whole numbers in a binary file, by the order of their bytes.

#include <cstddef>
#include <cstdint>
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

}  // namespace durero::io
