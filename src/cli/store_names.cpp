// durero store goto, branch and tag: names of events.
#include <fmt/format.h>

#include <memory>

#include "description.hpp"
#include "durero/io/standard_output.hpp"
#include "store.hpp"

namespace durero::cli {
namespace {

struct StoreNaming {
  std::string store, name, revision = "HEAD";
  bool removes = false;
};

/// The members of a store for one kind of names.
struct NamingMembers {
  std::vector<store::StoredName> (store::Store::*list)();
  void (store::Store::*add)(const std::string& name, std::string_view revision);
  void (store::Store::*remove)(const std::string& name);
};

int name_event(const StoreNaming& call, const NamingMembers& members) {
  const bool only_lists = call.name.empty();
  store::Store of(call.store, only_lists ? store::StoreAccess::read : store::StoreAccess::write);
  if (only_lists) {
    std::string text;
    for (const store::StoredName& named : (of.*members.list)())
      text += fmt::format("{}  {}\n", named.name, named.event);
    io::print(text);
  } else if (call.removes) {
    (of.*members.remove)(call.name);
  } else {
    (of.*members.add)(call.name, call.revision);
  }
  return 0;
}

void add_naming(CLI::App& store, int& status, const char* name, const char* about, const char* footer,
                const NamingMembers& members) {
  auto* command = store.add_subcommand(name, about);
  const auto call = std::make_shared<StoreNaming>();
  add_store_path(*command, call->store);
  auto* const named = command->add_option("NAME", call->name, "The new name; without it all are listed");
  add_revision(*command, call->revision);
  command->add_flag("--delete", call->removes, "Take the name away; its events stay")->needs(named);
  command->footer(
      footer + exit_status("it is done", "the call or the store is bad, or the name is") +
      examples({fmt::format("store {} room.store", name), fmt::format("store {} room.store night HEAD~1", name),
                fmt::format("store {} room.store night --delete", name)}));
  command->callback([call, members, &status] { status = name_event(*call, members); });
}

int go_to_revision(const StoreNaming& call) {
  store::Store of(call.store, store::StoreAccess::write);
  of.go_to(call.revision);
  io::print(where_text(of) + "\n");
  return 0;
}

}  // namespace

void add_store_names(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("goto", "Put HEAD, where the next edit goes, on a branch or an event");
  const auto call = std::make_shared<StoreNaming>();
  add_store_path(*command, call->store);
  command->add_option("REV", call->revision, "A branch, a tag, the number of an event, or HEAD~N")->required();
  command->footer(
      "A branch goes on with the edits behind it. On no branch HEAD itself goes on, and only the numbers of\n"
      "its events tell of them.\n\n" +
      exit_status("HEAD is there", "the call or the store is bad, or there is no such revision") +
      examples({"store goto room.store night", "store goto room.store 17"}));
  command->callback([call, &status] { status = go_to_revision(*call); });
  add_naming(store, status, "branch", "List, make or delete branches",
             "A branch is a line of work, which goes on with each edit that is made on it.\n\n",
             {&store::Store::branches, &store::Store::add_branch, &store::Store::remove_branch});
  add_naming(store, status, "tag", "List, make or delete tags", "A tag stays on its event.\n\n",
             {&store::Store::tags, &store::Store::add_tag, &store::Store::remove_tag});
}

}  // namespace durero::cli
