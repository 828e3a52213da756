// A store: a scene that is kept with its whole history.
#include "durero/store/store.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <mutex>
#include <optional>
#include <stdexcept>

#include "bindings.hpp"
#include "durero/model/historia.hpp"
#include "durero/store/event_log.hpp"
#include "durero/store/provenance.hpp"
#include "durero/store/store_path.hpp"
#include "durero/store/store_reading.hpp"
#include "errors.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

/// An open store, which one thread uses at a time. Who waits for another, or for the disk, does so without Python's
/// lock.
class OpenStore {
 public:
  OpenStore(const std::string& path, bool write) : is_written_(write) {
    const py::gil_scoped_release released;
    open_ = std::make_unique<store::Store>(path, write ? store::StoreAccess::write : store::StoreAccess::read);
  }

  /// What the task answers, of the store as it is while the task runs.
  template <class Task>
  auto read(Task task) {
    return use([&](store::Store& of) {
      const store::StoreReading reading(of);
      return task(of);
    });
  }
  /// What the task answers, which changes the store.
  template <class Task>
  auto write(Task task) {
    if (!is_written_) throw std::invalid_argument("the store is open for reading; expected one with write=True");
    return use(task);
  }
  void close() {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(using_);
    open_.reset();
  }

 private:
  template <class Task>
  auto use(Task task) {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(using_);
    if (!open_) throw std::invalid_argument("the store is closed; expected an open one");
    return task(*open_);
  }

  std::mutex using_;
  std::unique_ptr<store::Store> open_;
  bool is_written_;
};

/// Author, time and comment. Without an author the environment names one, and without a time it is now.
using GivenProvenance = std::tuple<std::optional<std::string>, std::optional<std::string>, std::string>;

store::Provenance provenance(const GivenProvenance& given) {
  const auto& [author, time, comment] = given;
  store::Provenance by{author ? *author : store::author_of_environment(), time ? *time : store::time_now(), comment};
  store::require_provenance(by);
  return by;
}

/// The state of a scene to be kept: Python may edit the scene meanwhile. Null stands for the empty scene.
std::shared_ptr<const State> state_to_keep(const Scene* scene) {
  if (scene == nullptr) return nullptr;
  if (scene->whole().text() != nullptr)
    throw std::invalid_argument(
        fmt::format("the scene was read by {}; expected one without surfaces: a store holds the program's own shapes",
                    scene->whole().text()->file()));
  return scene->state();
}

scene::GroupedScene copied(const std::shared_ptr<const State>& state) {
  return state ? state->grouped() : scene::GroupedScene();
}

void create_store(const std::string& path, const Scene* scene, const std::string& from, const GivenProvenance& given) {
  const store::Provenance by = provenance(given);
  const auto state = state_to_keep(scene);
  const py::gil_scoped_release released;
  store::Store::create(path, copied(state), from, by);
}

store::EventNumber import_into(OpenStore& of, const Scene& scene, const std::string& from,
                               const GivenProvenance& given) {
  const store::Provenance by = provenance(given);
  const auto state = state_to_keep(&scene);
  return of.write([&](store::Store& opened) { return opened.import(copied(state), from, by); });
}

/// The answers, a JSON line for each operation.
std::string edit(OpenStore& of, const std::string& text, const GivenProvenance& given, bool all_or_nothing,
                 std::optional<store::EventNumber> expected_head) {
  if (expected_head && *expected_head <= store::no_event)
    throw std::invalid_argument(
        fmt::format("expected_head is {}; expected the number of an event, as head.event has it", *expected_head));
  const io::Source script("operations", text);
  const store::EditCall call{
      script, 0, provenance(given), all_or_nothing, store::carry_out, expected_head.value_or(store::no_event)};
  const store::EditAttempt attempt = of.write([&](store::Store& opened) {
    return std::move(opened.edit_together({&call, 1}).front());
  });
  if (attempt.error) std::rethrow_exception(attempt.error);
  if (attempt.is_stale) raise("StaleHead", attempt.head, call.expected_head);
  return attempt.result.answers;
}

store::EventNumber undo_in(OpenStore& of) {
  const auto event = of.write([](store::Store& opened) { return opened.undo(); });
  if (!event) raise_refused(model::Deshacer_pre_1, model::Respuesta::nada_que_deshacer, "Deshacer");
  return *event;
}

store::EventNumber redo_in(OpenStore& of) {
  const auto event = of.write([](store::Store& opened) { return opened.redo(); });
  if (!event) raise_refused(model::Rehacer_pre_1, model::Respuesta::nada_que_rehacer, "Rehacer");
  return *event;
}

std::pair<store::EventNumber, std::optional<std::string>> head_of(OpenStore& of) {
  const store::StoreHead head = of.read([](store::Store& opened) { return opened.head(); });
  return {head.event, head.branch.empty() ? std::nullopt : std::optional(head.branch)};
}

/// Each event as a line of JSON.
std::vector<std::string> log_of(OpenStore& of, const std::string& revision, std::uint64_t limit, bool all) {
  return of.read([&](store::Store& opened) {
    std::vector<std::string> lines;
    store::tell_log(opened, {revision, limit, all},
                    [&](const store::HistoryEvent& event, const std::vector<std::string>& names) {
                      lines.push_back(store::event_json(event, names));
                    });
    return lines;
  });
}

Scene scene_at(OpenStore& of, const std::string& revision) {
  return Scene(of.read([&](store::Store& opened) { return scene::GroupedScene(opened.state(opened.find(revision))); }));
}

std::map<std::string, store::EventNumber> by_name(const std::vector<store::StoredName>& names) {
  std::map<std::string, store::EventNumber> events;
  for (const store::StoredName& stored : names) events[stored.name] = stored.event;
  return events;
}

}  // namespace

void add_store(py::module_& module) {
  py::class_<OpenStore>(module, "Store")
      .def(py::init<const std::string&, bool>())
      .def("close", &OpenStore::close)
      .def("edit", edit)
      .def("import_scene", import_into)
      .def("undo", undo_in)
      .def("redo", redo_in)
      .def("head", head_of)
      .def("log", log_of)
      .def("scene", scene_at)
      .def("branches",
           [](OpenStore& of) { return by_name(of.read([](store::Store& opened) { return opened.branches(); })); })
      .def("tags", [](OpenStore& of) { return by_name(of.read([](store::Store& opened) { return opened.tags(); })); })
      .def("go_to",
           [](OpenStore& of, const std::string& revision) {
             of.write([&](store::Store& opened) { opened.go_to(revision); });
           })
      .def("add_branch",
           [](OpenStore& of, const std::string& name, const std::string& revision) {
             of.write([&](store::Store& opened) { opened.add_branch(name, revision); });
           })
      .def("add_tag", [](OpenStore& of, const std::string& name, const std::string& revision) {
        of.write([&](store::Store& opened) { opened.add_tag(name, revision); });
      });
  module.def("create_store", create_store);
  module.def("shown_path", store::shown_path);
  module.def("picture_place", store::picture_place);
}

}  // namespace durero::python
