#include "durero/io/json/scene_script.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "body_steps.hpp"
#include "change_steps.hpp"
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operation_text.hpp"
#include "durero/io/json/scene_changes.hpp"
#include "durero/io/json/scene_parts.hpp"
#include "durero/io/lines.hpp"
#include "durero/number/rational.hpp"
#include "regrouping.hpp"

namespace durero::io {
namespace {

using scene::ElementRef;

bool is_of_stage(PartKind kind) { return kind < PartKind::groups; }

bool is_binary64(const model::ExactVector& v) {
  const auto holds = [](const number::Rational& x) {
    const double rounded = number::round_to_binary64(x);
    return std::isfinite(rounded) && number::exact(rounded) == x;
  };
  return holds(v.x) && holds(v.y) && holds(v.z);
}

/// @{ Whether operations have the numbers of all maps in a body.
bool is_mapped_by_binary64(const scene::Body& body);
bool is_mapped_by_binary64(const scene::Instance& in) {
  return is_binary64(in.mapa.centro) && is_binary64(in.mapa.x) && is_binary64(in.mapa.y) && is_binary64(in.mapa.z);
}
bool is_mapped_by_binary64(const scene::Compound& in) {
  return std::ranges::all_of(in.parts, [](const scene::Body& part) { return is_mapped_by_binary64(part); });
}
bool is_mapped_by_binary64(const scene::Body& body) {
  return std::visit([](const auto& form) { return is_mapped_by_binary64(form); }, body.form);
}
/// @}

/// The only point that two meshes do not share; nothing where they differ in more.
std::optional<model::Ordinal> moved_point(const scene::Mesh& a, const scene::Mesh& b) {
  if (a.puntos.size() != b.puntos.size() || a.caras != b.caras || a.material != b.material) return std::nullopt;
  if (a.normals != b.normals || a.uv != b.uv) return std::nullopt;
  std::optional<model::Ordinal> moved;
  for (model::Ordinal n = 0; n < a.puntos.size(); ++n) {
    if (is_written_alike(a.puntos[n], b.puntos[n])) continue;
    if (moved) return std::nullopt;
    moved = n;
  }
  return moved;
}

/// Makes the script, and follows it on a scene of its own.
class ScriptMaker {
 public:
  ScriptMaker(const scene::GroupedScene& from, const scene::GroupedScene& to) : from_(from), to_(to), working_(from) {}

  SceneScript script() {
    compare();
    if (script_.beyond.empty()) make_steps();
    if (script_.beyond.empty()) note_what_is_left();
    if (!script_.beyond.empty()) script_.steps.clear();
    return std::move(script_);
  }

 private:
  /// Lists the elements and the meshes that differ, and the parts that no line of a script says.
  void compare() {
    for (const PartChange& change : part_changes(from_, to_)) {
      if (is_of_stage(change.part.kind)) script_.beyond.push_back(change.part.pointer());
      if (change.part.kind == PartKind::elementos) note_element(change);
      if (change.part.kind == PartKind::mallas) note_mesh(change);
    }
  }

  void note_mesh(const PartChange& change) {
    (!change.from ? added_meshes_ : change.to ? changed_meshes_ : removed_meshes_).push_back(change.part.name);
  }

  void note_element(const PartChange& change) {
    const std::string& name = change.part.name;
    if (change.from && change.to && can_be_changed(name)) return changed_.push_back(name);
    if (change.from) removed_.push_back(name);
    if (!change.to) return;
    const ElementRef element = to_.scene.find(name).value();
    const scene::Body* const body = to_.scene.body(element);
    if (body != nullptr && !is_mapped_by_binary64(*body)) script_.beyond.push_back(change.part.pointer());
    (body == nullptr ? added_ : added_bodies_).push_back(name);
  }

  /// What still differs is beyond operations: an element moves, or a triangle has normals of its own.
  void note_what_is_left() {
    if (working_.scene_text() == scene_text(to_.scene, to_.groups)) return;
    for (const PartChange& change : part_changes(working_.of(), to_)) script_.beyond.push_back(change.part.pointer());
  }

  /// Whether changes make an element what it is to be, in no more steps than to remove it, to add it, and to put it
  /// into its group again; or in any number, where it has what no operation gives.
  bool can_be_changed(const std::string& name) const {
    const ElementRef old = from_.scene.find(name).value(), made = to_.scene.find(name).value();
    if (old.tipo != made.tipo || !has_same_rest(from_.scene, to_.scene, name)) return false;
    if (to_.scene.motion(made) != nullptr || to_.scene.wrap(made) || to_.scene.vertex_normals(made)) return true;
    const std::size_t anew = from_.groups.of_element(name).empty() ? 2 : 3;
    return changes_between(from_.scene, to_.scene, name).size() <= anew;
  }

  /// Names go before others come, so that none is ever in use twice. The face of a mesh has the name of no other's.
  void make_steps() {
    for (const std::string& name : removed_) add(removal_step(from_.scene, name));
    for (const std::string& name : changed_)
      for (AnyStep& step : changes_between(from_.scene, to_.scene, name)) add(std::move(step));
    for (const std::string& m : removed_meshes_) add(scene::MeshEdit(scene::MeshRemoval{model::Elemento(m)}));
    for (const std::string& m : changed_meshes_) change_mesh(m);
    for (const std::string& m : added_meshes_) add_whole_mesh<scene::MeshAddition>(m);
    for (const std::string& name : added_) {
      const ElementRef element = to_.scene.find(name).value();
      to_.scene.visit(element,
                      [&](const auto& shape) { add(addition_step(name, shape, to_.scene.material(element))); });
    }
    add_bodies();
    make_groups();
  }

  /// Elements go from group to group one by one where that takes fewer steps than to make the groups anew.
  void make_groups() {
    std::vector<scene::GroupEdit> edits = regrouping(working_.of().groups, to_.groups);
    scene::Groups moved = working_.of().groups;
    std::vector<AnyStep> moves = element_moves(moved, to_.groups);
    std::vector<scene::GroupEdit> rest = regrouping(moved, to_.groups);
    if (moves.size() + rest.size() < edits.size()) {
      for (AnyStep& move : moves) add(std::move(move));
      edits = std::move(rest);
    }
    for (scene::GroupEdit& edit : edits) {
      const std::string g = std::visit([](const auto& in) { return in.g; }, edit);
      add_long(std::move(edit), {PartKind::groups, g});
    }
  }

  void add_bodies() {
    if (added_bodies_.empty()) return;
    BodySteps steps(working_.of().scene, from_.scene, to_.scene, [&](AnyStep edit) { add(std::move(edit)); });
    for (const std::string& name : added_bodies_) {
      const ElementRef element = to_.scene.find(name).value();
      steps.add_body(name, *to_.scene.body(element), to_.scene.material(element));
    }
    steps.remove_parts();
  }

  void change_mesh(const std::string& m) {
    const scene::Mesh& mesh = mesh_of(to_.scene, m);
    if (const auto n = moved_point(mesh_of(from_.scene, m), mesh))
      add(scene::MeshEdit(scene::VertexMove{mesh.m, *n, model::Punto(mesh.puntos[*n])}));
    else
      add_whole_mesh<scene::MeshReplacement>(m);
  }

  template <class WholeMesh>
  void add_whole_mesh(const std::string& m) {
    const PartKey name{PartKind::mallas, m};
    const scene::Mesh& mesh = mesh_of(to_.scene, m);
    if (mesh.normals.empty() && mesh.uv.empty())
      add_long(scene::MeshEdit(WholeMesh{mesh}), name);
    else
      script_.beyond.push_back(name.pointer());
  }

  static const scene::Mesh& mesh_of(const scene::Scene& scene, const std::string& m) {
    return scene.meshes()[scene.meshes().find(m).value()];
  }

  /// Adds a step whose line may be longer than a script's is.
  void add_long(AnyStep edit, const PartKey& name) {
    const ScriptStep step{script_.steps.size() + 1, std::move(edit)};
    if (operation_text(step, to_.scene.stage()).size() > longest_line)
      script_.beyond.push_back(name.pointer());
    else
      add(step.edit);
  }

  void add(AnyStep edit) {
    const ScriptStep& step = script_.steps.emplace_back(script_.steps.size() + 1, std::move(edit));
    if (!working_.apply_total(step).ok())
      throw std::logic_error("a script between two scenes was refused: " + operation_text(step, to_.scene.stage()));
  }

  const scene::GroupedScene& from_;
  const scene::GroupedScene& to_;
  EditedScene working_;
  SceneScript script_{};
  std::vector<std::string> removed_{}, changed_{}, added_{}, added_bodies_{};
  std::vector<std::string> removed_meshes_{}, changed_meshes_{}, added_meshes_{};
};

}  // namespace

SceneScript script_between(const scene::GroupedScene& from, const scene::GroupedScene& to) {
  return ScriptMaker(from, to).script();
}

std::string script_text(const SceneScript& script, const scene::Stage& stage) {
  std::string text;
  for (const ScriptStep& step : script.steps) text.append(operation_text(step, stage)).append("\n");
  return text;
}

}  // namespace durero::io
