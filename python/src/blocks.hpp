#pragma once
/// Many rays in blocks, on every processor, without Python's lock; between rounds of them Python may interrupt.

#include <pybind11/pybind11.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace durero::python {

/// How many rays one task answers: enough to fill the lanes, few enough to stay in the cache, so that no array of
/// queries or answers is as long as the caller's.
inline constexpr std::size_t rays_of_a_block = 256;

/// answer(begin, end) for blocks that make up `size`. Throws what Python raises at an interrupt.
template <class Answer>
void for_each_block(std::size_t size, Answer answer) {
  constexpr std::size_t round = std::size_t{1} << 20;
  for (std::size_t first = 0; first < size; first += round) {
    const std::size_t last = std::min(first + round, size);
    {
      const pybind11::gil_scoped_release released;
      const std::size_t blocks = (last - first + rays_of_a_block - 1) / rays_of_a_block;
      tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        const std::size_t begin = first + block * rays_of_a_block;
        answer(begin, std::min(begin + rays_of_a_block, last));
      });
    }
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }
}

}  // namespace durero::python
