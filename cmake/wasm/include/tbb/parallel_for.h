#pragma once
/// In the place of oneTBB: what it would do on one thread.
#include "tbb/blocked_range.h"
#include "tbb/partitioner.h"

namespace tbb {

template <class Index, class Body, class... Partitioner>
void parallel_for(Index first, Index last, const Body& body, const Partitioner&...) {
  for (Index i = first; i < last; ++i) body(i);
}

template <class Range, class Body, class... Partitioner>
void parallel_for(const Range& range, const Body& body, const Partitioner&...) {
  if (!range.empty()) body(range);
}

}  // namespace tbb
