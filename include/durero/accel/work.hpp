#pragma once
/// The work of a structure for rays, and its size. Counts compare structures better than the clock does: the same scene
/// and rays give the same numbers, on any machine and any number of threads.

#include <cstddef>
#include <cstdint>

namespace durero::accel {

/// The work for some rays. Every thread has its own counts, which are added at the end.
struct Work {
  std::uint64_t rays = 0;         ///< rays answered
  std::uint64_t volumes = 0;      ///< n: tests of a ray against a bounding volume, or a plane that halves space
  std::uint64_t nodes = 0;        ///< inner nodes visited
  std::uint64_t cells = 0;        ///< leaves, voxels or lists visited
  std::uint64_t by_miss = 0;      ///< volumes that the ray missed
  std::uint64_t by_distance = 0;  ///< volumes or cells pruned beyond the nearest hit so far
  std::uint64_t candidates = 0;   ///< m: elements handed to the certified search
  std::uint64_t repeated = 0;     ///< elements found in a further cell, and not handed over again
  std::uint64_t untested = 0;     ///< rays without a candidate

  /// Adds each number.
  Work& operator+=(const Work& other);
  bool operator==(const Work&) const = default;
};

/// The size of a structure.
struct Size {
  std::size_t elements = 0;    ///< elements in its nodes or cells
  std::size_t apart = 0;       ///< elements that every ray is tested against, which are not ordinary or have no bound
  std::size_t nodes = 0;       ///< inner nodes
  std::size_t cells = 0;       ///< leaves, voxels or lists, also the empty ones
  std::size_t references = 0;  ///< references to elements, over all cells
  std::size_t depth = 0;       ///< the longest path from the root to a leaf; 0 without a root
  std::size_t bytes = 0;       ///< memory in bytes

  bool operator==(const Size&) const = default;
};

}  // namespace durero::accel
