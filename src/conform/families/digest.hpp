#pragma once
/// A digest of a text is its CRC-64 as xz computes it. It detects accidents to files: a text with any bits within 64
/// neighbouring ones flipped has another digest, and one in 2⁶⁴ of all other texts has the same. It is no defence
/// against deceit.

#include <cstdint>
#include <string>
#include <string_view>

namespace durero::conform {

/// The digest of a text that ends in `bytes`; `before` is the digest of the part before them.
std::uint64_t digest(std::string_view bytes, std::uint64_t before = 0);

/// The digest as sixteen hexadecimal digits.
std::string digest_text(std::uint64_t digest);

}  // namespace durero::conform
