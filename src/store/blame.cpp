#include "durero/store/blame.hpp"

#include <algorithm>
#include <map>

#include "durero/scene/by_name.hpp"
#include "journal.hpp"

namespace durero::store {
namespace {

/// Elements and meshes have names of their own, which may be the same.
struct Setters {
  std::map<std::string, EventNumber> elements, meshes;
};

/// @{ What an edit that was carried out sets. What it removes is no more in the scene, where names are looked up.
void set(Setters& to, const scene::Edit& edit, EventNumber by) {
  to.elements[scene::name_of(edit.operation).name()] = by;
}
void set(Setters& to, const scene::Closing& edit, EventNumber by) {
  to.elements[edit.base] = by;
  to.elements[edit.top] = by;
}
void set(Setters& to, const scene::Copying& edit, EventNumber by) { to.elements[edit.e] = by; }
void set(Setters& to, const scene::CopyRemoval& edit, EventNumber by) { to.elements[edit.e] = by; }
void set(Setters& to, const scene::Joining& edit, EventNumber by) { to.elements[edit.e] = by; }
void set(Setters& to, const scene::SolidRemoval& edit, EventNumber by) { to.elements[edit.e] = by; }
void set(Setters& to, const scene::MeshAddition& edit, EventNumber by) { to.meshes[edit.mesh.m.name()] = by; }
void set(Setters& to, const scene::MeshReplacement& edit, EventNumber by) { to.meshes[edit.mesh.m.name()] = by; }
void set(Setters& to, const scene::MeshRemoval& edit, EventNumber by) { to.meshes[edit.m.name()] = by; }
void set(Setters& to, const scene::VertexMove& edit, EventNumber by) { to.meshes[edit.m.name()] = by; }
void set(Setters& to, const scene::MeshEdit& edit, EventNumber by) {
  std::visit([&](const auto& in) { set(to, in, by); }, edit);
}
void set(Setters& to, const model::AttributeChange& edit, EventNumber by) {
  to.elements[model::name_of(edit).name()] = by;
}
void set(Setters& to, const model::Cambiar_Material& edit, EventNumber by) { to.elements[edit.e.name()] = by; }
void set(Setters& to, const model::Quitar_Material& edit, EventNumber by) { to.elements[edit.e.name()] = by; }
void set(Setters&, const model::Cambiar_Grupo&, EventNumber) {}  // as every edit of groups
void set(Setters&, const model::Quitar_Grupo&, EventNumber) {}
void set(Setters& to, const model::LookChange& edit, EventNumber by) {
  std::visit([&](const auto& in) { set(to, in, by); }, edit);
}
void set(Setters&, const scene::GroupEdit&, EventNumber) {}
void set(Setters&, const io::WrittenEdit&, EventNumber) {}  // a store has none
/// @}

/// The edits from the import before an event up to it, in their order; the import first.
std::vector<EventNumber> way_from_import(Records& records, EventNumber to) {
  std::vector<EventNumber> way{to};
  for (EventOrigin origin = records.origin(to); origin.kind != EventKind::import; origin = records.origin(way.back()))
    way.push_back(origin.parent);
  std::ranges::reverse(way);
  return way;
}

std::vector<BlamedElement> blamed(const scene::GroupedScene& of, const Setters& setters, EventNumber import) {
  std::vector<BlamedElement> all;
  const auto add = [&](const std::map<std::string, EventNumber>& from, const std::string& name) {
    const auto found = from.find(name);
    all.push_back({name, found == from.end() ? import : found->second});
  };
  for (const scene::ElementRef element : scene::singles_by_name(of.scene))
    add(setters.elements, of.scene.name(element).name());
  for (std::size_t i = 0; i < of.scene.meshes().size(); ++i) add(setters.meshes, of.scene.meshes()[i].m.name());
  return all;
}

}  // namespace

std::vector<BlamedElement> blame(Store& store, EventNumber of) {
  const scene::GroupedScene& scene = store.state(of);
  const std::vector<EventNumber> way = way_from_import(store.journal().records, of);
  Setters setters;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const HistoryEvent event = store.event(way[i]);
    const io::Source line(store.path(), event.operation);
    for (const io::ScriptStep& step : io::read_script(line, scene.scene.stage()))
      std::visit([&](const auto& edit) { set(setters, edit, event.number); }, step.edit);
  }
  return blamed(scene, setters, way.front());
}

}  // namespace durero::store
