#pragma once
/// The subcommands of `durero spec`. Each returns the exit status.

#include <cstdint>
#include <string>
#include <vector>

namespace durero::cli {

/// An expression, and how far its evaluation may go.
struct EvalCall {
  std::string expression, scene;
  std::uint64_t steps = 100'000'000;
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
  bool quiet = false;
};
/// MiB that an evaluation may take where nothing is said: 4096, or half of the machine's memory where that is less.
std::uint64_t default_memory();

int spec_check(const std::vector<std::string>& files, bool strict, bool quiet);
int spec_eval(const EvalCall& call);
int spec_show(const std::string& name);
int spec_confirm(const std::string& scene, const std::string& rays, const std::string& hits, bool quiet);

}  // namespace durero::cli
