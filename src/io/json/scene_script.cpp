#include "durero/io/json/scene_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/operation_text.hpp"
#include "durero/io/json/scene_changes.hpp"
#include "durero/io/json/scene_parts.hpp"
#include "durero/io/lines.hpp"
#include "durero/model/cambio.hpp"
#include "durero/model/vista.hpp"
#include "durero/number/rational.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/solids.hpp"
#include "part_text.hpp"
#include "regrouping.hpp"

namespace durero::io {
namespace {

using AnyStep = decltype(ScriptStep::edit);
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

/// Whether an operation adds the element as it is.
bool can_be_added(const scene::Scene& scene, ElementRef element) {
  if (scene.motion(element) != nullptr || scene.wrap(element) || scene.vertex_normals(element)) return false;
  const scene::Body* const body = scene.body(element);
  return body == nullptr || is_mapped_by_binary64(*body);
}

/// @{ The removal of an element by its own operation.
AnyStep body_removal(const scene::Instance&, const std::string& name) { return scene::CopyRemoval{name}; }
AnyStep body_removal(const scene::Compound&, const std::string& name) { return scene::SolidRemoval{name}; }
AnyStep removal_step(const scene::Scene& scene, const std::string& name) {
  const ElementRef element = scene.find(name).value();
  if (const scene::Body* const body = scene.body(element))
    return std::visit([&](const auto& form) { return body_removal(form, name); }, body->form);
  return scene.visit(element, [&]<class Shape>(const Shape&) -> AnyStep {
    return scene::Edit{typename Shape::Removal{model::Elemento(name)}, {}};
  });
}
/// @}

template <class Shape>
AnyStep addition_step(const std::string& name, const Shape& shape, std::optional<std::uint32_t> material) {
  return scene::Edit{scene::addition(model::Elemento(name), shape), material};
}

/// @{ Whether two values of an attribute have the same text.
bool is_written_alike(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }
bool is_written_alike(const glm::dvec3& a, const glm::dvec3& b) {
  return is_written_alike(a.x, b.x) && is_written_alike(a.y, b.y) && is_written_alike(a.z, b.z);
}
bool is_written_alike(const scene::Corners& a, const scene::Corners& b) {
  return std::ranges::equal(a, b, [](const glm::dvec3& p, const glm::dvec3& q) { return is_written_alike(p, q); });
}
/// @}

/// Whether two elements have the same of what no operation gives.
bool has_same_rest(const scene::Scene& a, ElementRef x, const scene::Scene& b, ElementRef y) {
  const auto same = [](const auto* one, const auto* other) {
    return one == nullptr || other == nullptr ? one == other : *one == *other;
  };
  return same(a.motion(x), b.motion(y)) && a.wrap(x) == b.wrap(y) && a.vertex_normals(x) == b.vertex_normals(y);
}

/// The change of an attribute to the value that a shape has, by the name of its type.
template <class Shape, class Attribute>
AnyStep change_to(const std::string& name, const Shape& shape, const Attribute& attribute) {
  std::optional<AnyStep> step;
  const auto consider = [&]<class Change>(std::type_identity<Change>) {
    const auto& of = model::attribute_of<Change::component>();
    if (of.word != attribute.word) return;
    using Input = std::remove_cvref_t<decltype(of.input(std::declval<Change&>()))>;
    using Stored = std::remove_cvref_t<decltype(scene::stored(std::declval<const Input&>()))>;
    if constexpr (std::is_same_v<Stored, std::remove_cvref_t<decltype(shape.*attribute.field)>>)
      step = model::AttributeChange(
          Change{model::Elemento(name), scene::input_of<Input>(shape.*attribute.field), Shape::tipo});
  };
  [&]<class... Change>(std::type_identity<std::variant<Change...>>) {
    (consider(std::type_identity<Change>()), ...);
  }(std::type_identity<model::AttributeChange>());
  return step.value();
}

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
    if (!script_.beyond.empty()) script_.steps.clear();
    return std::move(script_);
  }

 private:
  /// Lists the elements and the meshes that differ, and what no operation makes so.
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
    if (!can_be_added(to_.scene, element)) script_.beyond.push_back(change.part.pointer());
    (to_.scene.body(element) == nullptr ? added_ : added_bodies_).push_back(name);
  }

  /// Whether changes of attributes and of the material make an element what it is to be, in fewer steps than to remove
  /// it, to add it, and to put it into its group again; or in any number, where it has what no operation gives.
  bool can_be_changed(const std::string& name) const {
    const ElementRef x = from_.scene.find(name).value(), y = to_.scene.find(name).value();
    if (x.tipo != y.tipo || from_.scene.body(x) != nullptr || to_.scene.body(y) != nullptr) return false;
    if (!has_same_rest(from_.scene, x, to_.scene, y)) return false;
    if (!can_be_added(to_.scene, y)) return true;
    return changes_of(name).size() <= (from_.groups.of_element(name).empty() ? 2 : 3);
  }

  /// The steps that change an element.
  std::vector<AnyStep> changes_of(const std::string& name) const {
    const ElementRef x = from_.scene.find(name).value(), y = to_.scene.find(name).value();
    std::vector<AnyStep> steps;
    from_.scene.visit(x, [&]<class Shape>(const Shape& old) {
      const Shape& made = to_.scene.shapes<Shape>()[y.index];
      scene::for_each_attribute<Shape>([&](const auto& attribute) {
        if (!is_written_alike(old.*attribute.field, made.*attribute.field))
          steps.push_back(change_to(name, made, attribute));
      });
    });
    const auto material = to_.scene.material(y);
    if (material == from_.scene.material(x)) return steps;
    const model::Elemento e(name);
    steps.push_back(material
                        ? model::LookChange(model::Cambiar_Material{e, to_.scene.stage().materials[*material].name})
                        : model::LookChange(model::Quitar_Material{e}));
    return steps;
  }

  /// Names go before others come, so that none is ever in use twice. The face of a mesh has the name of no other's.
  void make_steps() {
    for (const std::string& name : removed_) add(removal_step(from_.scene, name));
    for (const std::string& name : changed_)
      for (AnyStep& step : changes_of(name)) add(std::move(step));
    for (const std::string& m : removed_meshes_) add(scene::MeshEdit(scene::MeshRemoval{model::Elemento(m)}));
    for (const std::string& m : changed_meshes_) change_mesh(m);
    for (const std::string& m : added_meshes_) add_whole_mesh<scene::MeshAddition>(m);
    for (const std::string& name : added_) {
      const ElementRef element = to_.scene.find(name).value();
      to_.scene.visit(element,
                      [&](const auto& shape) { add(addition_step(name, shape, to_.scene.material(element))); });
    }
    for (const std::string& name : added_bodies_) {
      const ElementRef element = to_.scene.find(name).value();
      add_body(name, *to_.scene.body(element), to_.scene.material(element));
    }
    make_groups();
  }

  /// Elements go from group to group one by one where that takes fewer steps than to make the groups anew.
  void make_groups() {
    const scene::Groups& now = working_.of().groups;
    std::vector<scene::GroupEdit> edits = regrouping(now, to_.groups);
    scene::Groups moved = now;
    std::vector<AnyStep> moves = element_moves(moved);
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

  /// The moves of elements between groups that both scenes have; `groups` becomes what they make of it.
  std::vector<AnyStep> element_moves(scene::Groups& groups) const {
    const auto is_kept = [&](std::string_view g) {
      return g.empty() || (groups.table().contains(g) && to_.groups.table().contains(g));
    };
    std::vector<std::string> names;
    for (const scene::Groups* const of : {&working_.of().groups, &to_.groups})
      for (const auto& [g, group] : of->table())
        names.insert(names.end(), group.elementos.begin(), group.elementos.end());
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    std::vector<AnyStep> moves;
    for (const std::string& name : names) {
      const std::string from(groups.of_element(name)), to(to_.groups.of_element(name));
      if (from == to || !is_kept(from) || !is_kept(to)) continue;
      if (to.empty()) {
        moves.emplace_back(model::LookChange(model::Quitar_Grupo{model::Elemento(name)}));
        groups.take_out(name);
      } else {
        moves.emplace_back(model::LookChange(model::Cambiar_Grupo{model::Elemento(name), to}));
        groups.put(name, to);
      }
    }
    return moves;
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

  /// Adds an element with a body, and removes the elements that were made for its parts.
  void add_body(const std::string& name, const scene::Body& body, std::optional<std::uint32_t> material) {
    if (by_geometry_.empty()) index_geometry();
    make(name, body, material);
    for (; !made_parts_.empty(); made_parts_.pop_back()) {
      const auto& [geometry, part] = *made_parts_.back();
      add(removal_step(working_.of().scene, part));
      by_geometry_.erase(made_parts_.back());
    }
    by_geometry_.emplace(part_text(body), name);
  }

  void make(const std::string& name, const scene::Body& body, std::optional<std::uint32_t> material) {
    if (const auto* const copy = std::get_if<scene::Instance>(&body.form)) {
      const std::string original = part_element(scene::unmoved(copy->shape), {});
      return add(scene::Copying{name, original, copy->mapa, material});
    }
    const auto& solid = std::get<scene::Compound>(body.form);
    std::vector<std::string> de;
    for (const scene::Body& part : solid.parts) {
      std::string element = part_element(part, de);
      de.push_back(std::move(element));
    }
    add(scene::Joining{solid.operation, name, std::move(de), material});
  }

  /// An element of that geometry, not of those names: one that is there, or a new one.
  std::string part_element(const scene::Body& part, const std::vector<std::string>& not_of) {
    std::string geometry = part_text(part);
    const auto [first, last] = by_geometry_.equal_range(geometry);
    for (auto known = first; known != last; ++known)
      if (std::ranges::find(not_of, known->second) == not_of.end()) return known->second;
    std::string name = free_name();
    const auto* const copy = std::get_if<scene::Instance>(&part.form);
    if (copy != nullptr && model::identidad(copy->mapa))
      std::visit([&](const auto& shape) { add(addition_step(name, shape, {})); }, copy->shape);
    else
      make(name, part, {});
    made_parts_.push_back(by_geometry_.emplace(std::move(geometry), name));
    return name;
  }

  void index_geometry() {
    const scene::Scene& scene = working_.of().scene;
    for (const ElementRef element : scene::singles_by_name(scene)) {
      const scene::Body* const body = scene.body(element);
      const std::string& name = scene.name(element).name();
      if (body != nullptr)
        by_geometry_.emplace(part_text(*body), name);
      else
        scene.visit(element, [&](const auto& shape) { by_geometry_.emplace(part_text(scene::unmoved(shape)), name); });
    }
  }

  /// A name of nothing, neither now nor then.
  std::string free_name() {
    for (;;) {
      std::string name = fmt::format("part:{}", ++last_part_);
      if (!working_.of().scene.find(name) && !to_.scene.find(name)) return name;
    }
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

  using Geometry = std::multimap<std::string, std::string>;  // from a body's text to the names of elements

  const scene::GroupedScene& from_;
  const scene::GroupedScene& to_;
  EditedScene working_;
  SceneScript script_{};
  std::vector<std::string> removed_{}, changed_{}, added_{}, added_bodies_{};
  std::vector<std::string> removed_meshes_{}, changed_meshes_{}, added_meshes_{};
  Geometry by_geometry_{};
  std::vector<Geometry::iterator> made_parts_{};
  std::size_t last_part_ = 0;
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
