#pragma once
/// The subcommands of `durero spec`. Each returns the exit status.

#include <cstdint>
#include <string>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/spec/constants.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "solver_program.hpp"

namespace durero::cli {

/// The call of `durero spec check`: texts, the number of states for their conjectures, and the strictness.
struct CheckCall {
  std::vector<std::string> files;  ///< without one, the program's own text
  std::vector<std::string> let;    ///< values of constants, NAME=VALUE
  std::vector<std::string> scope;  ///< members of given sets, SET=MEMBERS, or values of constants
  std::string numbers;             ///< the numbers to try, LOW..HIGH; empty: small ones
  std::size_t states = 8;
  bool strict = false;     ///< opinions are errors
  bool all_tried = false;  ///< a conjecture that is not tried is an error
  SolverOptions solver;
  bool quiet = false;
};

/// The call of `durero spec eval`: an expression, and the limits of its evaluation.
struct EvalCall {
  std::string expression, scene;
  std::vector<std::string> files;  ///< texts; none: the program's own
  std::vector<std::string> let;    ///< values of constants, NAME=VALUE
  std::vector<std::string> scope;  ///< members of given sets, SET=MEMBERS, or values of constants
  std::uint64_t steps = 100'000'000;
  std::uint64_t memory = 0;  ///< MiB; 0: as default_memory() says
  SolverOptions solver;
  bool explain = false, quiet = false;
};
/// The default for the memory of an evaluation in MiB: 4096, or half of the machine's memory where that is less.
std::uint64_t default_memory();
/// Bounds the memory from here on: an allocation beyond so many MiB more throws std::bad_alloc (0: as default_memory()
/// says). A number may take a 128th of it.
void bound_memory(std::uint64_t mebibytes);

/// Reads the texts of these files, or the program's own where there are none: the one way by which every command does.
/// Throws io::InputError at the first error of reading or of types, io::FileError where a file cannot be read.
zed::Specification specification_of(const std::vector<std::string>& files);

/// Throws io::InputError at the first defect that reading found in these files, or where one of them holds no Z.
void refuse_unread(const std::vector<std::string>& files, const zed::Specification& read);

/// Names on stderr each constant for which a value was taken, with the value.
void note_taken(const std::vector<std::string>& lines);
/// Runs, and throws io::InputError where a value that --let gives is refused, or what --scope gives.
template <class Run>
auto with_constants(Run&& run) {
  try {
    return run();
  } catch (const spec::ScopeError& error) {
    throw io::InputError("--scope", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  } catch (const spec::ConstantError& error) {
    throw io::InputError("--let", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
}

int spec_check(const CheckCall& call);
int spec_eval(const EvalCall& call);
int spec_show(const std::string& name, const std::vector<std::string>& files);
int spec_confirm(const std::string& scene, const std::string& rays, const std::string& hits, bool quiet);

}  // namespace durero::cli
