#pragma once
/// SHA-256 digests. They chain the events of a store, and seal what stands beside them.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace durero::store {

/// The 32 bytes of a SHA-256 digest.
using Digest = std::array<char, 32>;

/// The bytes of a digest, as a text.
inline std::string_view bytes_of(const Digest& digest) noexcept { return {digest.data(), digest.size()}; }

/// A digest in 64 hexadecimal digits.
std::string hexadecimal(const Digest& digest);

/// Digests fields one behind the other. Each goes in behind its length, so that no two lists of fields are the same
/// bytes: `5:hello,0:,`.
class FieldDigest {
 public:
  /// Adds a field of any bytes.
  FieldDigest& add(std::string_view field);
  /// The digest of all fields so far.
  Digest digest() const;

 private:
  std::string fields_;
};

/// The digest of some bytes. Throws std::bad_alloc where the library has no memory.
Digest digest_of(std::string_view bytes);

}  // namespace durero::store
