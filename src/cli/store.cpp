// durero store …: scenes kept with their whole history.
#include "store.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "description.hpp"
#include "durero/store/provenance.hpp"
#include "durero/text/shown.hpp"

namespace durero::cli {
namespace {

/// A check for a text that stands on one line.
std::string check_one_line(const std::string& said) {
  if (text::escaped(said) == said) return "";
  return fmt::format("{}: no line of text; expected characters that a line shows, in UTF-8", text::shown(said));
}

std::string check_time(const std::string& said) {
  if (store::is_time(said)) return "";
  return fmt::format("{}: no time; expected one of UTC, as 2026-01-31T12:00:00Z", said);
}

}  // namespace

void add_store_path(CLI::App& command, std::string& path) {
  command.add_option("STORE", path, "A file that store init has made, or the URI of a PostgreSQL server")->required();
}

void add_revision(CLI::App& command, std::string& revision) {
  command.add_option(
      "REV", revision,
      "A branch, a tag, the number of an event, or HEAD; with ~N the N-th transaction before; without it "
      "HEAD");
}

void add_provenance(CLI::App& command, store::Provenance& by) {
  command
      .add_option("--author", by.author, "Who does it; without it DURERO_AUTHOR, LOGNAME or USER of the environment")
      ->check(check_one_line);
  command.add_option("--time", by.time, "When, as 2026-01-31T12:00:00Z; without it now")->check(check_time);
  command.add_option("--comment", by.comment, "Why")->check(check_one_line);
}

store::Provenance provenance_of(store::Provenance by) {
  if (by.author.empty()) by.author = store::author_of_environment();
  if (by.time.empty()) by.time = store::time_now();
  return by;
}

std::string where_text(store::Store& of) {
  const store::StoreHead head = of.head();
  return head.branch.empty() ? fmt::format("event {}, no branch", head.event)
                             : fmt::format("event {}, branch {}", head.event, head.branch);
}

void add_store(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("store", "Keep a scene with its whole history, durably");
  command->require_subcommand(1);
  command->footer(examples({"store init room.store --from demo/still-life.json",
                            "store edit room.store --op \"Eliminar_Elemento e?=apple\"", "store undo room.store",
                            "store log room.store"}));
  add_store_write(*command, status);
  add_store_edit(*command, status);
  add_store_read(*command, status);
  add_store_names(*command, status);
  add_store_compare(*command, status);
  add_store_verify(*command, status);
}

}  // namespace durero::cli
