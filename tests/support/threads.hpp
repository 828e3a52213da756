#pragma once
/// What a call answers on a given number of threads.

#include <oneapi/tbb/task_arena.h>

namespace durero::test {

template <class Call>
auto on_threads(int threads, Call call) {
  oneapi::tbb::task_arena arena(threads);
  return arena.execute(call);
}

}  // namespace durero::test
