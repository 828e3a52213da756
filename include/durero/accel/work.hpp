#pragma once
/// What a structure does to answer rays, and what it holds: counted, so that structures can be compared by more than
/// the clock. The same scene and rays give the same numbers, on any machine and any number of threads.

#include <cstddef>
#include <cstdint>

namespace durero::accel {

/// What was done for some rays. A plain value: every thread counts in its own, and adds.
struct Work {
  std::uint64_t rays = 0;         ///< that were asked
  std::uint64_t volumes = 0;      ///< tests of a ray against a bounding volume or a plane that halves a space: n
  std::uint64_t nodes = 0;        ///< inner nodes whose children were looked at
  std::uint64_t cells = 0;        ///< leaves, voxels or lists that were looked through
  std::uint64_t by_miss = 0;      ///< volumes passed over because the ray misses them
  std::uint64_t by_distance = 0;  ///< volumes or cells passed over because they lie beyond the nearest hit so far
  std::uint64_t candidates = 0;   ///< elements handed to the certified search: m
  std::uint64_t repeated = 0;     ///< elements found again in a further cell, and not handed over again
  std::uint64_t untested = 0;     ///< rays for which no element was handed over

  /// Adds number by number.
  Work& operator+=(const Work& other);
  bool operator==(const Work&) const = default;
};

/// What a structure holds.
struct Size {
  std::size_t elements = 0;    ///< in its nodes or cells
  std::size_t apart = 0;       ///< that every ray is tested against: what is not ordinary, and what has no bound
  std::size_t nodes = 0;       ///< inner nodes
  std::size_t cells = 0;       ///< leaves, voxels or lists, the empty ones with them
  std::size_t references = 0;  ///< to elements, from all cells
  std::size_t depth = 0;       ///< the longest way from the root to a leaf; 0 where there is no root
  std::size_t bytes = 0;       ///< of memory, all told

  bool operator==(const Size&) const = default;
};

}  // namespace durero::accel
