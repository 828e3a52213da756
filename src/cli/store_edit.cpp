// durero store edit: runs operations on the scene of a store, and keeps those that are accepted.
#include <memory>
#include <vector>

#include "by_text.hpp"
#include "description.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/standard_output.hpp"
#include "numbers.hpp"
#include "progress.hpp"
#include "store.hpp"

namespace durero::cli {
namespace {

struct StoreEdit {
  std::string store, script;
  std::vector<std::string> operations;
  store::Provenance by;
  std::size_t group = 0;
  bool all_or_nothing = false, audit = false, by_spec = false, quiet = false;
};

/// The operations of a call: the script's lines, then those of --op.
struct StoreScript {
  io::Source source;
  std::vector<io::TextLine> operations;  ///< the lines that hold one, in order
};

/// Every line is read before anything is done, so that a malformed one stops all.
StoreScript read_whole(store::Store& of, const StoreEdit& call) {
  std::string text, joined, name = "--op";
  for (const std::string& operation : call.operations) joined.append(operation).append("\n");
  std::vector<io::ScriptStep> steps;
  if (!call.script.empty() || call.operations.empty()) {
    const io::Source script = io::read_lines(call.script.empty() ? "-" : call.script);
    steps = of.read(script);
    name = script.name();
    text = script.text();
    if (!text.empty() && !io::ends_line(text, text.size() - 1)) text += '\n';
  }
  const std::size_t lines = io::count_lines(text);
  for (io::ScriptStep& step : of.read(io::Source("--op", joined))) {
    step.line += lines;
    steps.push_back(std::move(step));
  }
  StoreScript whole{io::Source(name, text + joined), {}};
  io::Lines walk(whole.source.text());
  for (const io::ScriptStep& step : steps)
    for (auto line = walk.next(); line; line = walk.next())
      if (line->number == step.line) {
        whole.operations.push_back(*line);
        break;
      }
  return whole;
}

/// The operations from first on, `count` of them, as a script of their own.
io::Source part_of(const StoreScript& whole, std::size_t first, std::size_t count) {
  const std::size_t begin = whole.operations[first].begin, end = whole.operations[first + count - 1].end;
  return {whole.source.name(), std::string(whole.source.text().substr(begin, end - begin)),
          whole.operations[first].number - 1};
}

int edit_store(const StoreEdit& call) {
  if (call.audit) contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  store::Store of(call.store, store::StoreAccess::write);
  const StoreScript whole = read_whole(of, call);
  const std::size_t all = whole.operations.size(), group = call.group == 0 ? all : call.group;
  const store::CarryOut carry_out = call.by_spec ? editor_by_spec() : store::CarryOut(store::carry_out);
  const store::Provenance by = provenance_of(call.by);
  Progress progress(call.quiet, "store edit", "operations", all);
  bool is_refused = false;
  for (std::size_t done = 0; done < all; done += group) {
    const std::size_t count = std::min(group, all - done);
    const io::Source part = part_of(whole, done, count);
    const store::EditResult result =
        of.edit({part, whole.operations[done].number - 1, by, call.all_or_nothing, carry_out});
    io::print(result.answers);
    is_refused = is_refused || result.is_refused;
    progress.add(count);
  }
  return is_refused ? 1 : 0;
}

}  // namespace

void add_store_edit(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("edit", "Run operations where HEAD is, each checked, and keep those accepted");
  const auto call = std::make_shared<StoreEdit>();
  add_store_path(*command, call->store);
  command->add_option("--script", call->script, "File of operations, one a line; - is the standard input");
  command->add_option("--op", call->operations, "An operation; may be given again")->allow_extra_args(false);
  auto* const group = command->add_option("--group", call->group,
                                          "How many operations are a transaction; without it all of the call are one");
  group->check(whole_number(1, 1'000'000'000));
  command->add_flag("--all-or-nothing", call->all_or_nothing, "Keep nothing where one is refused, which ends the call")
      ->excludes(group);
  add_provenance(*command, call->by);
  command->add_flag("--audit", call->audit, "Check whole predicates, with a copy of the old state");
  command->add_flag("--by-spec", call->by_spec, "Let the Z text decide each step too; a difference is a defect");
  add_quiet(*command, call->quiet);
  command->footer(
      "Operations and answers are those of durero edit; without --script and --op, operations are read from the\n"
      "standard input. A transaction is one step of undo. Its answers are printed when it is on disk: whatever "
      "happens\n"
      "to program or machine, an operation that was answered with ok is kept. One that is refused is answered, and is "
      "no\n"
      "event.\n\n"
      "Programs that edit one store wait for each other, a transaction at a time.\n\n" +
      exit_status("every operation was carried out", "one was refused",
                  "the call or a file is bad, and nothing is kept but what was answered") +
      examples({"store edit room.store --op \"Eliminar_Elemento e?=apple\" --comment eaten",
                "store edit room.store --script edits.txt --group 100"}));
  command->callback([call, &status] { status = edit_store(*call); });
}

}  // namespace durero::cli
