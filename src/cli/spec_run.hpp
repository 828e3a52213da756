#pragma once
/// The call of `durero spec run`.

#include <string>
#include <vector>

#include "durero/spec/animation.hpp"

namespace durero::cli {

/// A call of `durero spec run`.
struct RunCall {
  std::vector<std::string> files, given;
  spec::Setup setup;
  std::size_t choices = 20;   ///< so many ways to go on are listed
  std::size_t states = 1000;  ///< an exploration has so many at most
  std::string replay;
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
};
int spec_run(RunCall call);

}  // namespace durero::cli
