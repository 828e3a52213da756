#pragma once
/// The call of `durero spec tests`, and the tests that it prints.

#include "durero/spec/partition.hpp"

namespace CLI {
class App;
}

namespace durero::cli {

/// A call of `durero spec tests`.
struct CasesCall {
  std::vector<std::string> files, given;
  spec::Setup setup{};
  std::string numbers = "0..3", output = "-";
  spec::ExploreBounds bounds{};
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
  bool json = false, cpp = false, python = false, quiet = false;
};

void add_spec_cases(CLI::App& spec, int& status);

/// @{ The cases of each operation with their examples: for people, as one JSON object (docs/formats/explore.md), and as
/// a program in Python or in C++, in which calls of the system that is tested are to be filled in.
std::string cases_text(const spec::Machine& machine, const spec::OperationCases& cases);
std::string cases_json(const spec::Machine& machine, const spec::OperationCases& cases);
std::string cases_python(const spec::Machine& machine, const spec::OperationCases& cases);
std::string cases_cpp(const spec::Machine& machine, const spec::OperationCases& cases);
/// @}

}  // namespace durero::cli
