#include "conform/families/digest.hpp"

#include <fmt/format.h>

#include <array>

namespace durero::conform {
namespace {

/// The table of CRC-64: the summand for each byte that leaves the register. The polynomial is that of ECMA-182, its
/// bits reversed.
constexpr auto of_byte = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t byte = 0; byte < table.size(); ++byte) {
    table[byte] = byte;
    for (int bit = 0; bit < 8; ++bit)
      table[byte] = (table[byte] >> 1U) ^ ((table[byte] & 1U) != 0 ? 0xc96c5795d7870f42 : 0);
  }
  return table;
}();

}  // namespace

std::uint64_t digest(std::string_view bytes, std::uint64_t before) {
  std::uint64_t remainder = ~before;
  for (const char c : bytes)
    remainder = of_byte[(remainder ^ static_cast<unsigned char>(c)) & 0xffU] ^ (remainder >> 8U);
  return ~remainder;
}

std::string digest_text(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

}  // namespace durero::conform
