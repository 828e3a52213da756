#pragma once
/// The binary part of a glTF file that is written: numbers of binary32 and of 32 bits, and where they stand.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "durero/io/json/json_writer.hpp"

namespace durero::io {

class GltfBuffer {
 public:
  /// @{ Appends an accessor, and answers its number: vectors of two or three numbers, of which those of points have
  /// bounds; indices. Precondition: it is not empty.
  std::size_t add_vectors(std::span<const float> numbers, std::size_t per_vector, bool with_bounds);
  std::size_t add_indices(std::span<const std::uint32_t> indices);
  /// @}
  const std::string& bytes() const { return bytes_; }
  /// Writes the members `accessors` and `bufferViews`, if there are any.
  void write(json::Writer& out) const;

 private:
  struct Accessor {
    std::size_t begin, bytes, count;
    bool is_of_indices;
    std::size_t per_vector;
    std::vector<double> least{}, greatest{};
  };
  std::string bytes_;
  std::vector<Accessor> accessors_;
};

}  // namespace durero::io
