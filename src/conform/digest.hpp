#pragma once
/// Digests of texts: CRC-64 as xz computes it. A digest tells what happens to files by accident: a text with any bits
/// within 64 neighbouring ones flipped has another digest, and of other texts one in 2⁶⁴ has the same. It is no defence
/// against who wants to deceive.

#include <cstdint>
#include <string>
#include <string_view>

namespace durero::conform {

/// Of the bytes behind those of which `before` is the digest.
std::uint64_t digest(std::string_view bytes, std::uint64_t before = 0);

/// Sixteen hexadecimal digits.
std::string digest_text(std::uint64_t digest);

}  // namespace durero::conform
