#pragma once
/// The tracer under one instruction set at a time. Highway compiles it for several ("targets", from the baseline of the
/// machine's kind to its widest vectors) and takes the best that the machine has, unless it is told otherwise.

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace durero::test {

/// Those that this machine can run, the best first.
inline std::vector<std::int64_t> machine_targets() { return hwy::SupportedAndGeneratedTargets(); }

/// While it lives the program runs under that target alone. Precondition: no ray is being traced when it
/// begins or ends.
class Only_Target {
 public:
  explicit Only_Target(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
  ~Only_Target() { hwy::SetSupportedTargetsForTest(0); }
  Only_Target(const Only_Target&) = delete;
  Only_Target& operator=(const Only_Target&) = delete;
};

}  // namespace durero::test
