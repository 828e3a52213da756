#pragma once
/// A seeded stream of random numbers, the same on every platform: std::mt19937_64 and operations that IEEE 754 fixes.
/// The compiler may choose the order of two draws in one expression, so code that draws twice names the first.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>

namespace durero::conform {

/// The stream. Each call takes the bits it needs, and so the order of calls matters.
class Random {
 public:
  /// A stream from its beginning: the same seed gives the same stream.
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// The next 64 bits, each 0 or 1 as often.
  std::uint64_t bits() { return engine_(); }
  /// A number in 0 … n − 1, each about as often: bits() mod n. Precondition: n > 0.
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  /// A number in least … greatest.
  int integer(int least, int greatest) {
    return least + static_cast<int>(below(static_cast<std::uint64_t>(greatest - least) + 1));
  }
  /// True in n of m cases.
  bool chance(std::uint64_t n, std::uint64_t m) { return below(m) < n; }
  /// An entry of a list, each as often. Precondition: the list is not empty.
  template <class List>
  const auto& any_of(const List& list) {
    return list[below(list.size())];
  }
  /// 1 or −1, each as often.
  double sign() { return chance(1, 2) ? 1 : -1; }
  /// ±2^k with k in least … greatest.
  double signed_power(int least, int greatest) {
    const double one = sign();
    return std::ldexp(one, integer(least, greatest));
  }
  /// ±m·2^k with m in [1, 2) and k in least … greatest.
  double number(int least, int greatest) {
    const double power = signed_power(least, greatest);
    return power * uniform(1, 2);
  }
  /// A number uniform in [low, high), up to rounding.
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// A point with each coordinate uniform in [−half, half).
  glm::dvec3 in_cube(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half), z = uniform(-half, half);
    return {x, y, z};
  }
  /// A vector of integer coordinates in −half … half, not all 0.
  glm::dvec3 lattice_vector(int half) {
    for (;;) {
      const int x = integer(-half, half), y = integer(-half, half), z = integer(-half, half);
      if (x != 0 || y != 0 || z != 0) return {x, y, z};
    }
  }
  /// A direction uniform on the sphere, of length 1 up to rounding.
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = in_cube(1);
      const double square = v.x * v.x + v.y * v.y + v.z * v.z;
      if (square > 0.01 && square <= 1) return v / std::sqrt(square);
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace durero::conform
