// durero store verify: whether a store is whole, and what is left of one that is not.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "by_text.hpp"
#include "description.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/store/store_path.hpp"
#include "durero/store/verification.hpp"
#include "progress.hpp"
#include "store.hpp"

namespace durero::cli {
namespace {

struct StoreVerification {
  std::string store, salvage;
  bool audit = false, by_spec = false, quiet = false;
};

std::string store_summary(const store::StoreReport& report) {
  const auto count = [&](store::EventStanding standing) { return std::ranges::count(report.standings, standing); };
  std::string text =
      fmt::format("events {}, snapshots {}, names {}: ", report.standings.size(), report.snapshots, report.names);
  if (report.is_whole()) return text + "whole\n";
  const auto follow = count(store::EventStanding::rebased) + count(store::EventStanding::follows);
  return text + fmt::format("{} events are whole, {} follow from a snapshot alone, {} are lost\n",
                            count(store::EventStanding::whole), follow, count(store::EventStanding::lost));
}

int verify_store(const StoreVerification& call) {
  if (call.audit) contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  store::Store of(call.store, store::StoreAccess::read);
  const store::CarryOut carry_out = call.by_spec ? editor_by_spec() : store::CarryOut(store::carry_out);
  store::StoreReport report;
  {
    Progress progress(call.quiet, "store verify", "events");
    report = store::verify(of, carry_out, [&](std::size_t more) { progress.add(more); });
  }
  std::string text;
  for (const std::string& defect : report.defects) text += fmt::format("{}: {}\n", of.path(), defect);
  text += store_summary(report);
  if (!call.salvage.empty())
    for (const std::string& said : store::salvage(of, report, call.salvage))
      text += fmt::format("{}: {}\n", store::shown_path(call.salvage), said);
  io::print(text);
  return report.is_whole() ? 0 : 1;
}

}  // namespace

void add_store_verify(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("verify", "Carry the whole history out again, and check all that is kept");
  const auto call = std::make_shared<StoreVerification>();
  add_store_path(*command, call->store);
  command->add_option("--salvage", call->salvage, "Write a new store, of this name, with what is left");
  command->add_flag("--audit", call->audit, "Check whole predicates, with a copy of the old state");
  command->add_flag("--by-spec", call->by_spec, "Let the Z text decide each step too; a difference is a defect");
  add_quiet(*command, call->quiet);
  command->footer(
      "Each event must be chained to the one before by its hash, be accepted by the contracts again with the same\n"
      "answer, and lead to the scene of its snapshot, byte for byte. Names must stand for the events that they were "
      "given\n"
      "to. Each defect is a line on stdout.\n\n"
      "What --salvage writes is whole: an event with a snapshot of its own becomes an import where what was before it "
      "is\n"
      "lost.\n\n" +
      exit_status("the store is whole", "it is not", "the call is bad, or the store cannot be read at all") +
      examples({"store verify room.store", "store verify room.store --salvage left.store"}));
  command->callback([call, &status] { status = verify_store(*call); });
}

}  // namespace durero::cli
