// durero spec explore FILE…: all states that a text's machine can reach.
#include "spec_explore.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <new>
#include <optional>
#include <tuple>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/text/whole_number.hpp"
#include "explore_text.hpp"
#include "interrupted.hpp"
#include "numbers.hpp"
#include "progress.hpp"
#include "spec.hpp"
#include "spec_machine.hpp"

namespace durero::cli {
std::pair<std::int64_t, std::int64_t> number_bounds(const std::string& typed) {
  const std::size_t dots = typed.find("..");
  const auto number = [](std::string text) -> std::optional<std::int64_t> {
    const bool negative = text.starts_with('-');
    const auto size = text::whole_number(negative ? text.substr(1) : text);
    constexpr std::uint64_t most = 1'000'000;
    if (!size || *size > most) return std::nullopt;
    return negative ? -static_cast<std::int64_t>(*size) : static_cast<std::int64_t>(*size);
  };
  const auto low = dots == typed.npos ? std::nullopt : number(typed.substr(0, dots));
  const auto high = dots == typed.npos ? std::nullopt : number(typed.substr(dots + 2));
  if (!low || !high || *low > *high)
    throw io::InputError("--numbers", {1, 1}, typed + " bounds no numbers", "expected LOW..HIGH, such as 0..3");
  return {*low, *high};
}

namespace {

/// The exploration that the options ask for. Throws io::InputError where a predicate is wrong.
std::unique_ptr<spec::StateSpace> space_of(const spec::Machine& machine, const ExploreCall& call) {
  spec::ExploreBounds bounds = call.bounds;
  std::tie(bounds.low, bounds.high) = number_bounds(call.numbers);
  bounds.symmetry = !call.plain;
  bounds.graph = !call.dot.empty() || !call.svg.empty() || (call.json && call.bounds.graph);
  for (std::size_t i = 0; i + 1 < call.leads_to.size(); i += 2)
    bounds.leads_to.emplace_back(call.leads_to[i], call.leads_to[i + 1]);
  try {
    return std::make_unique<spec::StateSpace>(machine, bounds);
  } catch (const zed::ZError& error) {
    throw io::InputError("PREDICATE", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
}

/// The first way that the report has: to a false claim, or else to a deadlock.
const std::vector<spec::Transition>* first_way(const spec::ExploreReport& report) {
  for (const spec::FalseClaim& each : report.refuted)
    if (!each.way.empty()) return &each.way;
  return report.deadlock_ways.empty() ? nullptr : &report.deadlock_ways.front();
}

void write_files(const spec::Machine& machine, const spec::StateSpace& space, const ExploreCall& call) {
  if (!call.dot.empty()) io::write_file(call.dot, graph_dot(machine, space.graph()));
  if (!call.svg.empty()) io::write_file(call.svg, graph_svg(machine, space.graph()));
  if (call.trace.empty()) return;
  spec::Animation way(machine);
  if (const auto* steps = first_way(space.report()))
    for (const spec::Transition& step : *steps) way.take(step);
  io::write_file(call.trace, way.saved());
}

bool fails(const spec::ExploreReport& report, const std::vector<std::string>& on) {
  const auto asked = [&](const char* what) { return std::find(on.begin(), on.end(), what) != on.end(); };
  const bool never = std::any_of(report.operations.begin(), report.operations.end(),
                                 [](const auto& each) { return each.transitions == 0; });
  return !report.refuted.empty() || (asked("deadlock") && report.deadlocks > 0) || (asked("never") && never) ||
         (asked("bounded") && report.is_bounded());
}

/// Explores. Throws io::InputError where the memory does not do.
const spec::ExploreReport& explored(spec::StateSpace& space) {
  try {
    return space.explore();
  } catch (const std::bad_alloc&) {
    throw io::InputError("--memory", {1, 1}, "the memory did not do", "expected fewer --states, or a greater --memory");
  }
}

int spec_explore(ExploreCall call) {
  call.bounds.begun = std::chrono::steady_clock::now();
  const auto machine = machine_of(call.files, call.given, call.setup);
  bound_memory(call.memory);
  const std::atomic<bool>& stop = interrupted();
  std::optional<Progress> progress(std::in_place, call.quiet, "spec explore", "states", call.bounds.states);
  std::uint64_t told = 0;
  call.bounds.go_on = [&](std::size_t states, std::size_t) {
    progress->add(states - told);
    told = states;
    return !stop;
  };
  const auto space = space_of(*machine, call);
  const spec::ExploreReport& report = explored(*space);
  progress.reset();
  if (report.initial == 0 && !report.stopped && !report.late)
    throw io::InputError(call.files.empty() ? "spec" : call.files.front(), {1, 1}, "no initial state is found",
                         "expected an initial schema that admits a state");
  write_files(*machine, *space, call);
  if (call.json) {
    const spec::StateGraph graph = call.bounds.graph ? space->graph() : spec::StateGraph{};
    io::print(explore_json(*machine, report, call.bounds.graph ? &graph : nullptr));
  } else {
    io::print(explore_text(*machine, report));
  }
  return fails(report, call.fail) ? 1 : 0;
}

void add_claim_options(CLI::App& command, ExploreCall& call) {
  command
      .add_option("--always", call.bounds.always,
                  "A predicate of the state's components, in Z, that every state is to satisfy")
      ->allow_extra_args(false);
  command.add_option("--eventually", call.bounds.eventually, "A predicate that some state on every way is to satisfy")
      ->allow_extra_args(false);
  command
      .add_option("--leads-to", call.leads_to, "P and Q: a state with P is to be followed by one with Q on every way")
      ->expected(2)
      ->allow_extra_args(false);
  command.add_flag("--fair", call.bounds.fair,
                   "Only ways on which an operation that stays possible is done at some time");
  command
      .add_option("--fail", call.fail,
                  "Status 1 where there is one, too: deadlock, never (an operation never happens), bounded")
      ->check(CLI::IsMember({"deadlock", "never", "bounded"}))
      ->allow_extra_args(false);
}

void add_output_options(CLI::App& command, ExploreCall& call) {
  command.add_flag("--json", call.json, "Print one JSON object");
  command.add_flag("--graph", call.bounds.graph, "With --json: the states and steps, too");
  command.add_option("--dot", call.dot, "Write the states and steps for Graphviz");
  command.add_option("--svg", call.svg, "Write a drawing of them");
  command.add_option("--trace", call.trace, "Write the first way that is reported, which spec run --replay reads");
  command.add_flag("--plain", call.plain, "Do not take members of given sets for each other");
  add_quiet(command, call.quiet);
}

}  // namespace

void add_machine_options(CLI::App& command, const MachineOptions& call) {
  command.add_option("FILES", call.files, "Z text in LaTeX or Unicode mark-up; without it, the program's own text");
  command.add_option("--state", call.setup.state, "The state schema; without it, as durero spec run chooses it");
  command.add_option("--init", call.setup.init, "The initial schema; without it, Init, or Init and the state's name");
  command.add_option("--given", call.given, "A given set's members: NAME=3, or NAME=ann,bob")->allow_extra_args(false);
  command
      .add_option("--let", call.setup.constants, "The value of a constant that the text leaves open: NAME=VALUE, in Z")
      ->allow_extra_args(false);
  command.add_option("--members", call.setup.members, "How many members other given sets have")
      ->check(whole_number(1, 20))
      ->capture_default_str();
  command.add_option("--numbers", call.numbers, "Numbers that nothing bounds are tried from LOW to HIGH: LOW..HIGH")
      ->capture_default_str();
  command.add_option("--states", call.states, "How many states are found at most")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
  command.add_option("--steps", call.setup.steps, "How many steps of evaluation one question may take")
      ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command
      .add_option("--memory", call.memory,
                  "MiB that it may take; without it 4096, or half of the machine's memory where that is less")
      ->check(whole_number(64, 1 << 30));
}

void add_spec_explore(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("explore", "Find all states that a Z text's machine can reach");
  const auto call = std::make_shared<ExploreCall>();
  add_machine_options(*command,
                      {call->files, call->given, call->setup, call->numbers, call->bounds.states, call->memory});
  command->add_option("--time", call->bounds.seconds, "Seconds that it goes on at most, reading and planning included")
      ->check(number(0.001, 1e9));
  add_claim_options(*command, *call);
  add_output_options(*command, *call);
  command->footer(
      "A state is a schema S, an operation one that has the components of S and of S ', as in spec run. States are\n"
      "found breadth first, so each way is a shortest one. Every conjecture of the text that speaks of a state or a\n"
      "step is tried in each. A bound that left something out is named; without such a line the answer is whole, for\n"
      "given sets of these sizes. When it is interrupted, or its time is over, it prints what it found, and says so\n"
      "where it was still planning.\n\n"
      "A way of --eventually and --leads-to goes on where it can; steps that leave the state as it is are no part of "
      "it.\n\n" +
      exit_status("all was done", "a claim is false in some state, or what --fail names is there",
                  "the call is bad, or a text is wrong") +
      examples({"spec explore demo/birthday_book.tex",
                "spec explore demo/birthday_book.tex --members 2 --always '# known <= 2' --json"}));
  command->callback([call, &status] { status = spec_explore(*call); });
}

}  // namespace durero::cli
