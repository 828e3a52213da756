#pragma once
/// The call of `durero spec explore`.

#include "durero/spec/explore.hpp"

namespace CLI {
class App;
}

namespace durero::cli {

/// A call of `durero spec explore`.
struct ExploreCall {
  std::vector<std::string> files, given;
  spec::Setup setup{};
  std::string numbers = "0..3", trace, dot, svg;
  std::vector<std::string> leads_to, fail;
  spec::ExploreBounds bounds{};
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
  bool json = false, quiet = false, plain = false;
};

/// The options of a machine that is explored, where a call keeps them.
struct MachineOptions {
  std::vector<std::string>&files, &given;
  spec::Setup& setup;
  std::string& numbers;
  std::size_t& states;
  std::uint64_t& memory;
};
void add_machine_options(CLI::App& command, const MachineOptions& options);
/// The bounds LOW..HIGH of numbers. Throws io::InputError.
std::pair<std::int64_t, std::int64_t> number_bounds(const std::string& typed);

void add_spec_explore(CLI::App& spec, int& status);

}  // namespace durero::cli
