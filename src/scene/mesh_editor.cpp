// How an operation edits the meshes of a scene. The edit is made where no precondition is broken; where a postcondition
// is, it is undone, which cannot fail.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "durero/contract/contract.hpp"
#include "durero/model/malla_clauses.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::scene {
namespace {

using contract::clause;
using contract::cost;
using model::Respuesta;

bool has_line(const Mesh& mesh, std::uint32_t face) {
  return !model::Vertices::contains(input_of<model::Terna>(mesh.triangle(face).vertices));
}

/// red? ∈ Completa
bool is_complete(const Mesh& mesh) {
  const std::size_t points = mesh.puntos.size();
  return std::ranges::all_of(mesh.caras,
                             [&](const model::Cara& c) { return c.i < points && c.j < points && c.k < points; });
}

/// red? ∈ Malla. Precondition: is_complete(mesh).
bool has_triangles(const Mesh& mesh) {
  for (std::uint32_t face = 0; face < mesh.caras.size(); ++face)
    if (has_line(mesh, face)) return false;
  return true;
}

/// (m?, red?) ∈ dom familia: the last face has the longest name. Precondition: has_triangles(mesh).
bool has_names(const Mesh& mesh) {
  return mesh.caras.empty() ||
         model::nombre_cara(mesh.m, static_cast<model::Ordinal>(mesh.caras.size() - 1)).has_value();
}

/// Throws where the looks are none of the points', or the material none of the stage's.
void require_looks(const Mesh& mesh, const Stage& stage) {
  const auto fits = [&](const auto& column) { return column.empty() || column.size() == mesh.puntos.size(); };
  if (!fits(mesh.normals) || !fits(mesh.uv)) throw std::domain_error("a mesh has looks at all of its points, or none");
  const auto is_direction = [](const glm::dvec3& n) { return have_directions({n, n, n}); };
  if (!std::ranges::all_of(mesh.normals, is_direction)) throw std::domain_error("a normal has no direction");
  if (mesh.material != no_material && mesh.material >= stage.materials.size())
    throw std::out_of_range("no such material");
}

/// @{ The same edit of the text.
model::MeshOperation operation_of(const MeshAddition& in) { return model::Agregar_Malla{in.mesh.m, red_of(in.mesh)}; }
model::MeshOperation operation_of(const MeshRemoval& in) { return model::Eliminar_Malla{in.m}; }
model::MeshOperation operation_of(const MeshReplacement& in) {
  return model::Reemplazar_Malla{in.mesh.m, red_of(in.mesh)};
}
model::MeshOperation operation_of(const VertexMove& in) { return model::Mover_Vertice{in.m, in.n, in.punto}; }
/// @}

}  // namespace

class MeshEditor {
 public:
  explicit MeshEditor(Scene& scene) : scene_(scene) {}

  model::Answer apply_total(MeshAddition& in) {
    require_looks(in.mesh, std::as_const(scene_).stage());
    if (place(in.mesh.m)) return {Respuesta::malla_ya_existe, &model::Agregar_Malla_pre_1};
    if (const auto refused = refusal(in.mesh, {&model::Agregar_Malla_pre_2, &model::Agregar_Malla_pre_3,
                                               &model::Agregar_Malla_pre_4, &model::Agregar_Malla_pre_5}))
      return *refused;
    const model::Elemento m = in.mesh.m;
    const std::size_t size_before = scene_.size(), added = in.mesh.caras.size();
    return with_meshes(
        in, Respuesta::malla_agregada, [&] { meshes().put(std::move(in.mesh)); },
        [&](auto&& check) {
          check(model::Agregar_Malla_post_1, [&] { return scene_.size() == size_before + added; });
          check(model::Agregar_Malla_post_4, [&] { return place(m).has_value(); });
        });
  }

  model::Answer apply_total(MeshRemoval& in) {
    const auto at = place(in.m);
    if (!at) return {Respuesta::malla_no_existe, &model::Eliminar_Malla_pre_1};
    const std::size_t size_before = scene_.size(), removed = meshes()[*at].caras.size();
    return with_meshes(
        in, Respuesta::malla_eliminada, [&] { meshes().remove(*at); },
        [&](auto&& check) {
          check(model::Eliminar_Malla_post_1, [&] { return scene_.size() + removed == size_before; });
          check(model::Eliminar_Malla_post_4, [&] { return !place(in.m); });
        });
  }

  model::Answer apply_total(MeshReplacement& in) {
    require_looks(in.mesh, std::as_const(scene_).stage());
    const auto at = place(in.mesh.m);
    if (!at) return {Respuesta::malla_no_existe, &model::Reemplazar_Malla_pre_1};
    if (const auto refused = refusal(in.mesh, {&model::Reemplazar_Malla_pre_2, &model::Reemplazar_Malla_pre_3,
                                               &model::Reemplazar_Malla_pre_4, &model::Reemplazar_Malla_pre_5}))
      return *refused;
    const std::size_t size_before = scene_.size(), removed = meshes()[*at].caras.size(), added = in.mesh.caras.size();
    return with_meshes(
        in, Respuesta::malla_reemplazada, [&] { meshes().put(std::move(in.mesh)); },
        [&](auto&& check) {
          check(model::Reemplazar_Malla_post_1, [&] { return scene_.size() + removed == size_before + added; });
          check(model::Reemplazar_Malla_post_4, [&] { return meshes()[*at].caras.size() == added; });
        });
  }

  model::Answer apply_total(VertexMove& in) {
    const auto at = place(in.m);
    if (!at) return {Respuesta::malla_no_existe, &model::Mover_Vertice_pre_1};
    if (in.n >= meshes()[*at].puntos.size()) return {Respuesta::vertice_no_existe, &model::Mover_Vertice_pre_2};
    if (!can_move(meshes()[*at], in)) return {Respuesta::vertices_alineados, &model::Mover_Vertice_pre_3};
    const std::size_t size_before = scene_.size();
    MeshPoints& points = meshes().edited(*at).puntos;
    const glm::dvec3 before = points[in.n];
    return edited(
        in, Respuesta::vertice_movido, [&] { points.set(in.n, in.punto.xyz()); }, [&] { points.set(in.n, before); },
        [&](auto&& check) {
          check(model::Mover_Vertice_post_1, [&] { return scene_.size() == size_before; });
          check(model::Mover_Vertice_post_4, [&] { return meshes()[*at].puntos[in.n] == in.punto.xyz(); });
        });
  }

 private:
  Meshes& meshes() { return scene_.meshes_; }
  std::optional<std::size_t> place(const model::Elemento& m) const { return scene_.meshes_.find(m.name()); }

  /// The first of what Agregar_Malla and Reemplazar_Malla ask of a mesh that does not hold.
  std::optional<model::Answer> refusal(const Mesh& mesh, const std::array<const clause*, 4>& what) const {
    for (const glm::dvec3 p : mesh.puntos) static_cast<void>(model::Punto(p));  // throws where it is none
    if (!is_complete(mesh)) return model::Answer{Respuesta::cara_incompleta, what[0]};
    if (!has_triangles(mesh)) return model::Answer{Respuesta::vertices_alineados, what[1]};
    if (!has_names(mesh)) return model::Answer{Respuesta::cara_sin_nombre, what[2]};
    if (takes_a_name(mesh)) return model::Answer{Respuesta::elemento_ya_existe, what[3]};
    if (mesh.caras.size() > NameIndex::last_index - scene_.shapes<Triangle>().size())
      throw std::length_error("a scene holds no more triangles");
    return std::nullopt;
  }

  /// Whether a face would have the name of an element by itself. The faces of another mesh have other names
  /// (suyos.conj.1).
  bool takes_a_name(const Mesh& mesh) const {
    const NameIndex& index = scene_.index_;
    if (mesh.caras.size() < index.size()) {
      for (std::uint32_t face = 0; face < mesh.caras.size(); ++face) {
        const std::string name = model::nombre_cara(mesh.m, face).value().name();
        const auto is_it = [&](ElementRef e) { return scene_.label(e).name.name() == name; };
        if (index.find(NameIndex::hash(name), is_it)) return true;
      }
      return false;
    }
    bool taken = false;
    scene_.for_each_single([&](ElementRef e, const auto&) {
      const auto face = face_number(mesh.m.name(), std::as_const(scene_).label(e).name.name());
      taken = taken || (face && *face < mesh.caras.size());
    });
    return taken;
  }

  /// movida(mallas(m?), n?, punto?) ∈ Malla
  static bool can_move(const Mesh& mesh, const VertexMove& in) {
    const auto moved = [&](model::Ordinal n) { return n == in.n ? in.punto : model::Punto(mesh.puntos[n]); };
    return std::ranges::all_of(mesh.caras, [&](const model::Cara& c) {
      if (c.i != in.n && c.j != in.n && c.k != in.n) return true;
      return model::Vertices::contains({moved(c.i), moved(c.j), moved(c.k)});
    });
  }

  /// Edits what meshes there are; where a postcondition is broken, those before stand again.
  template <class In, class Make, class Checks>
  model::Answer with_meshes(const In& in, Respuesta r, Make&& make, Checks&& checks) {
    Meshes before = meshes();
    return edited(
        in, r, make, [&] { meshes() = std::move(before); }, checks);
  }

  /// Makes the edit, between the old value and the whole Z predicates where audit clauses are evaluated.
  /// checks(check) evaluates postconditions: check(clause, holds). undo() does not throw.
  template <class In, class Make, class Undo, class Checks>
  model::Answer edited(const In& in, Respuesta r, Make&& make, Undo&& undo, Checks&& checks) {
    std::optional<OldValue> before;
    if (!scene_.audits_are_put_off_)
      before = contract::old_value([&] { return OldValue{retrieve_mallas(scene_), operation_of(in)}; });
    make();
    try {
      if (const auto now = contract::semantic(cost::normal); now != contract::evaluation_semantic::ignore)
        checks([&](const clause& what, auto&& holds) { contract::check_under(now, what, holds); });
      audit(before, r);
    } catch (...) {
      undo();
      throw;
    }
    return {r};
  }

  /// The edit, and the state before it.
  struct OldValue {
    model::Mallas mallas;
    model::MeshOperation operation;
  };

  void audit(const std::optional<OldValue>& before, Respuesta r) {
    if (!before) return scene_.audited_.reset();
    model::Mallas after = retrieve_mallas(scene_);
    model::check(model::post(before->mallas, before->operation, after, r), cost::audit);
    model::check(model::inv(after), cost::audit);
    scene_.audited_ = std::make_shared<const model::Escena>(std::move(after.escena));
  }

  Scene& scene_;
};

model::Answer Scene::apply_total(MeshEdit edit) {
  return std::visit([&](auto& in) { return MeshEditor(*this).apply_total(in); }, edit);
}

}  // namespace durero::scene
