#pragma once
/// The rows of a picture, shared among threads.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <mutex>

#include "durero/render/render.hpp"

namespace durero::render {

/// Calls draw(y) for each row, on as many threads as may be used, and the progress after each of them.
template <class Draw>
void by_rows(std::uint32_t height, const Progress& progress, Draw&& draw) {
  std::mutex mutex;
  std::uint32_t done = 0;
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, height), [&](const auto& rows) {
    for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
      draw(y);
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(double(done) / height);
    }
  });
}

}  // namespace durero::render
