#pragma once
/// A bijection that scatters its numbers: the finalizer of SplitMix64.

#include <cstdint>

namespace durero::conform {

constexpr std::uint64_t scattered(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace durero::conform
