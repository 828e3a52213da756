// durero store init, import, undo and redo: another scene, and steps through the history.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "description.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/standard_output.hpp"
#include "store.hpp"

namespace durero::cli {
namespace {

struct StoreImport {
  std::string store, scene;
  store::Provenance by;
};

/// Another scene, to be kept; without a file the empty one.
scene::GroupedScene scene_to_keep(const std::string& file) {
  if (file.empty()) return {};
  return io::read_grouped_scene(io::read_source(file), io::Bodies::read);
}

int init_store(const StoreImport& call) {
  store::Store::create(call.store, scene_to_keep(call.scene), call.scene, provenance_of(call.by));
  store::Store made(call.store, store::StoreAccess::read);
  io::print(where_text(made) + "\n");
  return 0;
}

int import_scene(const StoreImport& call) {
  store::Store into(call.store, store::StoreAccess::write);
  into.import(scene_to_keep(call.scene), call.scene, provenance_of(call.by));
  io::print(where_text(into) + "\n");
  return 0;
}

/// Undo or redo, which answer 1 where there is nothing to do.
int step_in_history(const std::string& path, std::optional<store::EventNumber> (store::Store::*how)(),
                    const char* nothing) {
  store::Store of(path, store::StoreAccess::write);
  const bool is_done = (of.*how)().has_value();
  io::print(where_text(of) + (is_done ? "\n" : fmt::format(": {}\n", nothing)));
  return is_done ? 0 : 1;
}

void add_store_init(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("init", "Make a new store");
  const auto call = std::make_shared<StoreImport>();
  command->add_option("STORE", call->store, "The file that it is to be, or postgresql://… of a server")->required();
  command->add_option("--from", call->scene, "Scene file (JSON) that it begins with; without it the empty scene");
  add_provenance(*command, call->by);
  command->footer("The store appears whole or not at all, and takes no file's place. Its first branch is main.\n\n" +
                  exit_status("it is made", "the call or a file is bad, or there is a file of that path") +
                  examples({"store init room.store --from demo/still-life.json", "store init empty.store"}));
  command->callback([call, &status] { status = init_store(*call); });
}

void add_store_import(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("import", "Put the scene of a file in the place of HEAD's");
  const auto call = std::make_shared<StoreImport>();
  add_store_path(*command, call->store);
  command->add_option("SCENE", call->scene, "Scene file (JSON)")->required();
  add_provenance(*command, call->by);
  command->footer(
      "An import is one event, and one step of undo. What operations cannot change, such as materials and\n"
      "the camera, is changed so.\n\n" +
      exit_status("it is kept", "the call or a file is bad, and nothing is kept") +
      examples({"store import room.store demo/still-life.json --comment \"from the designer\""}));
  command->callback([call, &status] { status = import_scene(*call); });
}

void add_step(CLI::App& store, int& status, const char* name, const char* about, const char* footer,
              std::optional<store::EventNumber> (store::Store::*how)(), const char* nothing) {
  auto* command = store.add_subcommand(name, about);
  const auto path = std::make_shared<std::string>();
  add_store_path(*command, *path);
  command->footer(footer + exit_status("it is done", nothing, "the call or the store is bad") +
                  examples({fmt::format("store {} room.store", name)}));
  command->callback([path, how, nothing, &status] { status = step_in_history(*path, how, nothing); });
}

}  // namespace

void add_store_write(CLI::App& store, int& status) {
  add_store_init(store, status);
  add_store_import(store, status);
  add_step(store, status, "undo", "Go back before the last transaction",
           "The branch where HEAD is then stands on the event before. Nothing is deleted: redo goes on again.\n\n",
           &store::Store::undo, "no transaction is before it");
  add_step(store, status, "redo", "Go on to where undo has left from last",
           "It is kept durably, and for each event. After another edit there is nothing to do again.\n\n",
           &store::Store::redo, "no undo has left behind it");
}

}  // namespace durero::cli
