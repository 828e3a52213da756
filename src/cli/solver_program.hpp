#pragma once
/// The program that `--solver` names is a solver of SMT-LIB, run as a process.

#include <cstdint>
#include <string>

#include "durero/zed/smt/smt.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace durero::cli {

/// The options for a solver.
struct SolverOptions {
  std::string program{};       ///< the program and its arguments, with blanks between; empty: none is asked
  std::uint64_t seconds = 10;  ///< the time for each question
};

/// Adds --solver and --solver-time to a command.
void add_solver(CLI::App& command, SolverOptions& to);

/// Returns the program, which is started for each question. It is named by its file. z3 and cvc5 have the arguments
/// with which they read scripts; any other has those that are typed. To ask throws io::InputError where there is no
/// such program.
zed::SmtProgram solver_program(const SolverOptions& options);

}  // namespace durero::cli
