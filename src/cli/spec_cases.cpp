// durero spec tests FILE…: tests of a system, made from a text.
#include "spec_cases.hpp"

#include <limits>
#include <optional>

#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "interrupted.hpp"
#include "numbers.hpp"
#include "progress.hpp"
#include "spec.hpp"
#include "spec_explore.hpp"
#include "spec_machine.hpp"

namespace durero::cli {
namespace {

int spec_cases(CasesCall call) {
  const auto machine = machine_of(call.files, call.given, call.setup);
  bound_memory(call.memory);
  const std::atomic<bool>& stop = interrupted();
  std::tie(call.bounds.low, call.bounds.high) = number_bounds(call.numbers);
  io::OutputFile out(call.output);
  std::optional<Progress> progress(std::in_place, call.quiet, "spec tests");
  call.bounds.go_on = [&](std::size_t, std::size_t) { return !stop; };
  const spec::OperationCases cases = spec::operation_cases(*machine, call.bounds);
  progress.reset();
  out.write(call.json     ? cases_json(*machine, cases)
            : call.cpp    ? cases_cpp(*machine, cases)
            : call.python ? cases_python(*machine, cases)
                          : cases_text(*machine, cases));
  out.commit();
  return 0;
}

}  // namespace

void add_spec_cases(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("tests", "Make tests of a system from a Z text");
  const auto call = std::make_shared<CasesCall>();
  add_machine_options(*command,
                      {call->files, call->given, call->setup, call->numbers, call->bounds.states, call->memory});
  auto* json = command->add_flag("--json", call->json, "As one JSON object");
  auto* cpp =
      command->add_flag("--cpp", call->cpp, "As a program in C++, in which the system's calls are to be filled in");
  auto* python = command->add_flag("--python", call->python, "The same in Python");
  json->excludes(cpp)->excludes(python);
  cpp->excludes(python);
  command->add_option("-o,--output", call->output, "File to write; without it, the standard output");
  add_quiet(*command, call->quiet);
  command->footer(
      "An operation's predicate is taken apart into the conjunctions of its sides, and each is a case. A case has an\n"
      "example in a state that can be reached: the state before, the inputs, and every answer that the text admits.\n"
      "A case of which none is found is named as infeasible, as far as the bounds go.\n\n" +
      exit_status("they are written", "the call is bad, or a text is wrong") +
      examples({"spec tests demo/birthday_book.tex", "spec tests demo/birthday_book.tex --python -o book_test.py"}));
  command->callback([call, &status] { status = spec_cases(*call); });
}

}  // namespace durero::cli
