#include "explore_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/spec/animation_text.hpp"

namespace durero::cli {

using spec::ExploreReport;
using spec::FactCoverage;
using spec::Machine;
using spec::OperationCoverage;

std::string number_of(std::uint64_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

namespace {

std::string counts_text(const Machine& machine, const ExploreReport& report) {
  std::string said = fmt::format("{}: {}, {}, {} deep\n", machine.state(), number_of(report.states, "state"),
                                 number_of(report.transitions, "transition"), number_of(report.depth, "step"));
  for (const std::string& carrier : machine.carriers()) said += "  " + carrier + "\n";
  for (const std::string& constant : machine.taken()) said += "  " + constant + "\n";
  std::string sets;
  for (const std::string& set : report.exchanged) sets += (sets.empty() ? "" : ", ") + set;
  if (!sets.empty())
    said +=
        fmt::format("  {} of these states differ by more than an exchange of members of {}\n", report.classes, sets);
  if (report.stopped && report.planned) said += "  stopped: not all states were gone on from\n";
  for (const std::string& bound : report.bounded) said += "  bounded: " + bound + "\n";
  if (!report.planned)
    said += fmt::format("  {} while operations were planned: no state was looked for\n",
                        report.stopped ? "stopped" : "the time was over");
  return said;
}

std::string operations_text(const ExploreReport& report) {
  std::size_t width = 0;
  for (const OperationCoverage& each : report.operations) width = std::max(width, each.name.size());
  std::string said = "operations\n";
  for (const OperationCoverage& each : report.operations)
    said += fmt::format("  {:<{}}  {}{}\n", each.name, width,
                        !report.planned ? "not looked for"
                        : each.transitions == 0
                            ? "never happened"
                            : number_of(each.transitions, "transition") + ", in " + number_of(each.states, "state"),
                        each.evaluated ? " (looked for by the evaluator)" : "");
  return said;
}

/// The predicates that were one and the same wherever they were asked.
std::string facts_text(const ExploreReport& report) {
  std::string said;
  for (const OperationCoverage& each : report.operations)
    for (const FactCoverage& fact : each.facts) {
      if (fact.yes != 0 && fact.no != 0) continue;
      const char* what = fact.yes != 0 ? "never false" : fact.no != 0 ? "never true" : "never asked";
      const std::string line = fact.place.line == 0 ? "" : fmt::format("  (line {})", fact.place.line);
      said += fmt::format("  {:<11}  {}: {}{}\n", what, each.name, fact.predicate, line);
    }
  return said.empty() ? said : "predicates\n" + said;
}

std::string deadlocks_text(const Machine& machine, const ExploreReport& report) {
  if (report.deadlocks == 0) return report.is_bounded() ? "no deadlock was found\n" : "no deadlock\n";
  std::string said = fmt::format("deadlock: in {} no operation can happen; the first after this way:\n",
                                 number_of(report.deadlocks, "state"));
  return said + way_story(machine, report.deadlock_ways.front());
}

std::string claims_text(const Machine& machine, const ExploreReport& report) {
  std::string said =
      fmt::format("claims: {} tried, {} false, {} not decided\n", report.claims, report.refuted.size(), report.open);
  for (const spec::FalseClaim& each : report.refuted) {
    said += fmt::format("false  {}: {}\n", each.place, each.claim);
    if (!each.way.empty()) said += "after this way:\n" + way_story(machine, each.way);
    if (each.loop) said += fmt::format("  and so on for ever, from the state after step {}\n", *each.loop);
  }
  return said;
}

}  // namespace

std::string explore_text(const Machine& machine, const ExploreReport& report) {
  return counts_text(machine, report) + operations_text(report) + facts_text(report) + deadlocks_text(machine, report) +
         claims_text(machine, report);
}

}  // namespace durero::cli
