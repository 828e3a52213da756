#pragma once
/// What the fuzzers share.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "durero/io/source.hpp"

namespace durero::test {

inline io::Source as_source(const std::uint8_t* data, std::size_t size) {
  return {"f", std::string(reinterpret_cast<const char*>(data), size)};
}

/// Runs what reads a source; its own error is an answer, every other exception is a crash.
template <class Run>
int fuzz(Run&& run) {
  try {
    run();
  } catch (const io::InputError&) {  // the answer to malformed input
  }
  return 0;
}

/// What must hold whatever the input.
inline void must(bool holds) {
  if (!holds) std::abort();
}

}  // namespace durero::test
