// durero store log, show, export and blame: what a store holds.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <vector>

#include "description.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "durero/store/blame.hpp"
#include "durero/store/event_log.hpp"
#include "durero/store/store_path.hpp"
#include "numbers.hpp"
#include "store.hpp"

namespace durero::cli {
namespace {

struct StoreQuestion {
  std::string store, revision = "HEAD", out = "-";
  std::uint64_t limit = 0;
  bool json = false, all = false;
};

/// A long log is printed by parts of so many bytes.
constexpr std::size_t printed_at_once = std::size_t{1} << 20U;

std::string event_operation(const store::HistoryEvent& event) {
  return event.kind == store::EventKind::import ? "import " + event.operation : event.operation;
}

/// `3  2026-01-31T12:00:00Z  ann  Eliminar_Cono e?=hat  # the reason  [HEAD main]`
std::string event_line(const store::HistoryEvent& event, const std::vector<std::string>& names) {
  std::string text = fmt::format("{}  {}  {}  {}", event.number, event.by.time,
                                 event.by.author.empty() ? "-" : event.by.author, event_operation(event));
  if (!event.by.comment.empty()) text += "  # " + event.by.comment;
  if (!names.empty()) text += fmt::format("  [{}]", fmt::join(names, " "));
  return text + "\n";
}

int print_log(const StoreQuestion& question) {
  store::Store of(question.store, store::StoreAccess::read);
  std::string text;
  const auto tell = [&](const store::HistoryEvent& event, const std::vector<std::string>& names) {
    text += question.json ? store::event_json(event, names) : event_line(event, names);
    if (text.size() < printed_at_once) return;
    io::print(text);
    text.clear();
  };
  store::tell_log(of, {question.revision, question.limit, question.all}, tell);
  io::print(text);
  return 0;
}

int print_event(const StoreQuestion& question) {
  store::Store of(question.store, store::StoreAccess::read);
  const store::HistoryEvent event = of.event(of.find(question.revision));
  const store::EventNames names = store::event_names_of(of);
  const auto found = names.find(event.number);
  const std::vector<std::string> own = found == names.end() ? std::vector<std::string>() : found->second;
  if (question.json) {
    io::print(store::event_json(event, own));
    return 0;
  }
  std::string text = fmt::format("event      {}\n", event.number);
  if (event.parent != store::no_event) text += fmt::format("parent     {}\n", event.parent);
  text += fmt::format(
      "author     {}\ntime       {}\ncomment    {}\noperation  {}\nanswer     {}\nhash       {}\nnames      {}\n",
      event.by.author, event.by.time, event.by.comment, event_operation(event), event.answer,
      store::hexadecimal(event.hash), fmt::join(own, " "));
  text += fmt::format("elementos  {}\n", of.state(event.number).scene.size());
  io::print(text);
  return 0;
}

int export_scene(const StoreQuestion& question) {
  io::require_ending(question.out, io::json_endings, "a scene");
  io::OutputFile out(question.out);
  store::Store of(question.store, store::StoreAccess::read);
  scene::GroupedScene scene = of.state(of.find(question.revision));
  io::rename_pictures(scene.scene.stage(), store::picture_place(question.store), question.out);
  out.write(io::scene_text(scene.scene, scene.groups));
  out.commit();
  return 0;
}

int blame_elements(const StoreQuestion& question) {
  store::Store of(question.store, store::StoreAccess::read);
  std::string text;
  for (const store::BlamedElement& blamed : store::blame(of, of.find(question.revision))) {
    const store::HistoryEvent event = of.event(blamed.event);
    if (question.json) {
      io::json::Writer out(text);
      out.begin_object().member("e", blamed.name).member("event", static_cast<std::uint64_t>(event.number));
      out.member("author", event.by.author).member("time", event.by.time).end_object();
      text += "\n";
    } else {
      text += fmt::format("{}  {}  {}  {}\n", blamed.name, event.number, event.by.time,
                          event.by.author.empty() ? "-" : event.by.author);
    }
  }
  io::print(text);
  return 0;
}

/// A command that asks a store about a revision.
CLI::App* add_question(CLI::App& store, int& status, const char* name, const char* about,
                       const std::shared_ptr<StoreQuestion>& question, int (*answer)(const StoreQuestion&)) {
  auto* command = store.add_subcommand(name, about);
  add_store_path(*command, question->store);
  add_revision(*command, question->revision);
  command->callback([question, answer, &status] { status = answer(*question); });
  return command;
}

const std::string store_was_asked =
    exit_status("it is printed", "the call or the store is bad, or there is no such revision");

void add_store_log(CLI::App& store, int& status) {
  const auto question = std::make_shared<StoreQuestion>();
  auto* command =
      add_question(store, status, "log", "The events up to a revision, the last one first", question, print_log);
  command->add_option("-n", question->limit, "How many at most")->check(whole_number(1, 1'000'000'000'000));
  command->add_flag("--all", question->all, "Every event of the store, also those that undo has left");
  command->add_flag("--json", question->json, "A JSON object a line");
  command->footer(
      "A line has the event's number, its time, author and operation, its comment behind #, and its names\n"
      "between brackets. The keys of the JSON object: event, parent, begins (whether it is the first of its\n"
      "transaction), author, time, comment, operation or import, answer, hash and names.\n\n" +
      store_was_asked + examples({"store log room.store", "store log room.store main~3 --json"}));
}

void add_store_show(CLI::App& store, int& status) {
  const auto question = std::make_shared<StoreQuestion>();
  auto* command = add_question(store, status, "show", "One event, and how large its scene is", question, print_event);
  command->add_flag("--json", question->json, "The event as a JSON object, as log has it");
  command->footer(store_was_asked + examples({"store show room.store", "store show room.store 17"}));
}

void add_store_export(CLI::App& store, int& status) {
  const auto question = std::make_shared<StoreQuestion>();
  auto* command = add_question(store, status, "export", "Write the scene of a revision", question, export_scene);
  command->add_option("-o,--output", question->out, "Where it goes, NAME.json; without it to the standard output");
  command->footer("The file is the one that durero edit would have written by the same operations.\n\n" +
                  exit_status("it is written", "the call or the store is bad, or there is no such revision") +
                  examples({"store export room.store -o room.json", "store export room.store HEAD~1 -o before.json"}));
}

void add_store_blame(CLI::App& store, int& status) {
  const auto question = std::make_shared<StoreQuestion>();
  auto* command =
      add_question(store, status, "blame", "Which event has set each element last", question, blame_elements);
  command->add_flag("--json", question->json, "A JSON object a line, with the keys e, event, author and time");
  command->footer(
      "A line has the name of an element, the number of the event, its time and its author. An element that no\n"
      "edit has set is the import's. Behind the elements stand the meshes, each as a whole.\n\n" +
      store_was_asked + examples({"store blame room.store"}));
}

}  // namespace

void add_store_read(CLI::App& store, int& status) {
  add_store_log(store, status);
  add_store_show(store, status);
  add_store_export(store, status);
  add_store_blame(store, status);
}

}  // namespace durero::cli
