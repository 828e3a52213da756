// Stores for C.
#include "durero/store/store.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "c/handles.hpp"
#include "durero/c/durero.h"
#include "durero/model/historia.hpp"
#include "durero/store/provenance.hpp"
#include "durero/store/store_path.hpp"
#include "durero/store/store_reading.hpp"

using namespace durero;
using c::guarded;
using c::last_error;

struct durero_store {
  store::Store value;
  std::string answers{};  // of the last edit
};

namespace {

/// What the caller says, or the environment and the clock.
store::Provenance provenance_of(const durero_provenance* said) {
  const durero_provenance given = said == nullptr ? durero_provenance{nullptr, nullptr, nullptr} : *said;
  store::Provenance by{given.author == nullptr ? store::author_of_environment() : given.author,
                       given.time == nullptr ? store::time_now() : given.time,
                       given.comment == nullptr ? "" : given.comment};
  store::require_provenance(by);
  return by;
}

/// The file that a scene is from. One that is of none stands beside the store, so that its pictures keep their names.
std::string file_of(const durero_scene* scene, const char* store) {
  if (scene == nullptr) return "";
  return scene->file.empty() ? (std::filesystem::path(store::picture_place(store)).parent_path() / "<scene>").string()
                             : scene->file;
}

scene::GroupedScene scene_to_keep(const durero_scene* scene) {
  if (scene == nullptr) return {};
  if (scene->value.text() != nullptr)
    throw std::invalid_argument(
        fmt::format("the scene was read by {}; expected one that was not: a store holds the program's own shapes",
                    scene->value.text()->file()));
  return scene->value.of();
}

durero_answer edited(durero_store& of, const char* script, const durero_store_call& call) {
  of.answers.clear();
  if (call.expected_head < 0)
    throw std::invalid_argument(
        fmt::format("expected_head is {}; expected the number of an event, or 0", call.expected_head));
  std::string first_refusal;
  const auto carry_out = [&](io::EditedScene& scene, const io::ScriptStep& step) {
    io::EditAnswer answer = store::carry_out(scene, step);
    if (!answer.ok() && first_refusal.empty()) first_refusal = answer.violated + ": " + answer.predicate;
    return answer;
  };
  const io::Source source("operations", script);
  store::EditResult result =
      of.value.edit({source, 0, provenance_of(&call.by), call.all_or_nothing != 0, carry_out, call.expected_head});
  of.answers = std::move(result.answers);
  if (!result.is_refused) return DURERO_DONE;
  last_error = first_refusal;
  return DURERO_REFUSED;
}

/// The answer of undo or redo, which says what is missing.
durero_answer stepped(bool is_done, const contract::clause& precondition) {
  if (is_done) return DURERO_DONE;
  last_error = fmt::format("{}: {}", precondition.label, precondition.predicate);
  return DURERO_REFUSED;
}

}  // namespace

durero_answer durero_store_create(const char* path, const durero_scene* scene, const durero_provenance* by) {
  return guarded(DURERO_FAILED, [&] {
    store::Store::create(path, scene_to_keep(scene), file_of(scene, path), provenance_of(by));
    return DURERO_DONE;
  });
}

durero_store* durero_store_open(const char* path) {
  return guarded<durero_store*>(nullptr, [&] { return new durero_store{{path, store::StoreAccess::write}}; });
}

void durero_store_close(durero_store* store) { delete store; }

durero_answer durero_store_edit(durero_store* store, const char* script, const durero_store_call* call) {
  const durero_store_call plain{};
  return guarded(DURERO_FAILED, [&] { return edited(*store, script, call == nullptr ? plain : *call); });
}

const char* durero_store_answers(const durero_store* store) { return store->answers.c_str(); }

durero_answer durero_store_undo(durero_store* store) {
  return guarded(DURERO_FAILED, [&] { return stepped(store->value.undo().has_value(), model::Deshacer_pre_1); });
}

durero_answer durero_store_redo(durero_store* store) {
  return guarded(DURERO_FAILED, [&] { return stepped(store->value.redo().has_value(), model::Rehacer_pre_1); });
}

durero_scene* durero_store_scene(durero_store* store, const char* revision) {
  return guarded<durero_scene*>(nullptr, [&] {
    const store::StoreReading reading(store->value);
    const store::EventNumber event = store->value.find(revision == nullptr ? "HEAD" : revision);
    return new durero_scene{written::Edited(scene::GroupedScene(store->value.state(event))),
                            c::from_root(store::picture_place(store->value.path()).c_str())};
  });
}

int64_t durero_store_head(durero_store* store) {
  return guarded<int64_t>(-1, [&] {
    const store::StoreReading reading(store->value);
    return store->value.head().event;
  });
}
