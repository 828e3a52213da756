#pragma once
/// The numbers of vectors that stand once in a mesh.

#include <cstddef>
#include <cstring>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace durero::io {

/// Numbers vectors in the order in which they come, each once by its bits. `Vector` is an array of doubles.
template <class Vector>
class Numbering {
 public:
  /// The number of a vector, from 0, and whether it is new.
  std::pair<std::size_t, bool> number(const Vector& vector) {
    const auto [place, is_new] = numbers_.try_emplace(vector, numbers_.size());
    return {place->second, is_new};
  }

 private:
  struct Hash {
    std::size_t operator()(const Vector& vector) const {
      return std::hash<std::string_view>()(
          {reinterpret_cast<const char*>(vector.data()), vector.size() * sizeof(double)});
    }
  };
  struct SameBits {
    bool operator()(const Vector& a, const Vector& b) const {
      return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
    }
  };
  std::unordered_map<Vector, std::size_t, Hash, SameBits> numbers_;
};

}  // namespace durero::io
