#pragma once
/// The subcommands of `durero spec`. Each returns the exit status.

#include <cstdint>
#include <string>
#include <vector>

#include "durero/zed/syntax/reader.hpp"

namespace durero::cli {

/// An expression, and how far its evaluation may go.
struct EvalCall {
  std::string expression, scene;
  std::vector<std::string> files;  ///< texts; none: the program's own
  std::uint64_t steps = 100'000'000;
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
  bool explain = false, quiet = false;
};
/// MiB that an evaluation may take where nothing is said: 4096, or half of the machine's memory where that is less.
std::uint64_t default_memory();
/// From here on what takes so many MiB more throws std::bad_alloc (0: as default_memory() says). A number may take a
/// 128th of it.
void bound_memory(std::uint64_t mebibytes);

/// Reads the texts of these files, or the program's own where there are none: the one way by which every command does.
/// Throws io::InputError at the first error of reading or of types, io::FileError where a file cannot be read.
zed::Specification specification_of(const std::vector<std::string>& files);

int spec_check(const std::vector<std::string>& files, bool quiet);
int spec_eval(const EvalCall& call);
int spec_show(const std::string& name, const std::vector<std::string>& files);
int spec_confirm(const std::string& scene, const std::string& rays, const std::string& hits, bool quiet);

}  // namespace durero::cli
