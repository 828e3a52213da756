#pragma once
/// In the place of oneTBB: there is one thread.
#include "tbb/namespace.h"

namespace tbb::this_task_arena {

inline int max_concurrency() { return 1; }

}  // namespace tbb::this_task_arena
