#pragma once
/// In the place of oneTBB: one thread has nothing to divide.
#include "tbb/namespace.h"

namespace tbb {

struct simple_partitioner {};
struct auto_partitioner {};
struct static_partitioner {};

}  // namespace tbb
