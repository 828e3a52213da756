#pragma once
/// Random edits of every kind that a script has, of few names, so that they meet; and scenes that such edits make.

#include <rapidcheck.h>

#include <string>
#include <utility>
#include <vector>

#include "durero/io/json/edited_scene.hpp"
#include "durero/model/cambio.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/vertex_normals.hpp"
#include "durero/scene/wrap.hpp"
#include "io/random_scene.hpp"

namespace durero::test {

using AnyEdit = decltype(io::ScriptStep::edit);

/// A whole number from 0 below another, at every size of a test.
inline int below(int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); }

inline bool flip() { return *rc::gen::arbitrary<bool>(); }

/// A name of an element; some are those of faces, and one is that of a part which a script makes.
inline std::string any_name() {
  return *rc::gen::element<std::string>("a", "b", "c", "d", "e", "f", "m:0", "m:1", "w:0", "part:1");
}
inline std::string any_group_name() { return *rc::gen::element<std::string>("a", "g", "h", "i", "j"); }

/// A material, or none. Of a copy it has no textures.
inline std::optional<std::uint32_t> any_material(const scene::Stage& stage, bool of_copy = false) {
  if (stage.materials.empty() || flip()) return std::nullopt;
  const auto place = static_cast<std::size_t>(below(static_cast<int>(stage.materials.size())));
  const scene::Material& material = stage.materials[place];
  if (of_copy && (material.textures.any() || material.bump)) return std::nullopt;
  return static_cast<std::uint32_t>(place);
}

inline glm::dvec3 any_small_triple() {
  const auto x = [] { return (below(9) - 4) / 2.0; };
  return {x(), x(), x()};
}

/// A map of binary64, mostly of an inverse.
inline model::Mapa any_map() {
  const auto column = [](const glm::dvec3& v) { return model::ExactVector(model::Vector(v)); };
  return {column(flip() ? any_triple() : any_small_triple()), column(any_small_triple()), column(any_small_triple()),
          column(any_small_triple())};
}

inline std::vector<std::string> distinct_names(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    std::string name = any_name();
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

/// The general addition, with inputs that its type does not have.
inline model::Operation any_general_addition(const std::string& name) {
  model::Agregar_Elemento general{model::Elemento(name), model::Tipo::soy_disco, model::Punto(any_triple()),
                                  any_positive(), model::Vector(any_axis())};
  if (flip()) general.altura = *anyFinite();
  if (flip()) general.vertices = model::Terna{{0, 0, 0}, {1, -0.0, 0}, {0, 1, 0x1p-1074}};
  return general;
}

inline AnyEdit any_element_edit(const scene::Stage& stage) {
  const std::string name = any_name();
  switch (below(8)) {
    case 0:
      return io::removal_of(name);
    case 1:
      return scene::Edit{model::Eliminar_Esfera{model::Elemento(name)}, {}};
    case 2:
      return scene::Edit{model::Eliminar_Triangulo{model::Elemento(name)}, {}};
    case 3:
      return scene::Edit{any_general_addition(name), any_material(stage)};
    default:
      return scene::Edit{any_addition(model::Elemento(name)), any_material(stage)};
  }
}

inline AnyEdit any_body_edit(const scene::Stage& stage) {
  switch (below(6)) {
    case 0:
      return scene::CopyRemoval{any_name()};
    case 1:
      return scene::SolidRemoval{any_name()};
    case 2:
    case 3:
      return scene::Copying{any_name(), any_name(), any_map(), any_material(stage, true)};
    default: {
      std::vector<std::string> de = distinct_names(4);
      while (de.size() < 2) de = distinct_names(4);
      const auto operation = static_cast<scene::Compound::Operation>(below(3));
      return scene::Joining{operation, any_name(), std::move(de), any_material(stage, true)};
    }
  }
}

/// Five points of a small grid, and a fan about the first, of which some face may lie on a line.
inline scene::Mesh any_whole_mesh(const scene::Stage& stage) {
  scene::Mesh mesh{*rc::gen::element(model::Elemento("m"), model::Elemento("w"))};
  for (int n = 0; n < 5; ++n) mesh.puntos.push_back(any_small_triple() * (flip() ? 1.0 : -1.0));
  for (model::Ordinal n = 1; n < 4; ++n)
    if (flip()) mesh.caras.push_back({0, n, n + 1});
  mesh.material = any_material(stage).value_or(scene::no_material);
  return mesh;
}

inline AnyEdit any_mesh_edit(const scene::Stage& stage) {
  const scene::Mesh mesh = any_whole_mesh(stage);
  switch (below(5)) {
    case 0:
      return scene::MeshEdit(scene::MeshRemoval{mesh.m});
    case 1:
      return scene::MeshEdit(scene::MeshReplacement{mesh});
    case 2:
      return scene::MeshEdit(
          scene::VertexMove{mesh.m, static_cast<model::Ordinal>(below(5)), model::Punto(any_small_triple())});
    default:
      return scene::MeshEdit(scene::MeshAddition{mesh});
  }
}

inline AnyEdit any_change(const scene::Stage& stage) {
  const model::Elemento e(any_name());
  const auto of_type = [] {
    return flip() ? std::nullopt : std::optional(static_cast<model::Tipo>(below(static_cast<int>(model::tipo_count))));
  };
  const auto of_type_with = [&](const auto& attribute) {
    auto t = of_type();
    while (t && !attribute.types.contains(*t)) t = of_type();
    return t;
  };
  const auto real = [] { return flip() ? any_positive() : *anyFinite(); };
  const auto type_of = [&]<auto component> { return of_type_with(model::attribute_of<component>()); };
  switch (below(10)) {
    case 0:
      return model::AttributeChange(model::Cambiar_Centro{e, model::Punto(any_triple()),
                                                          type_of.template operator()<&model::Escena::mi_centro>()});
    case 1:
      return model::AttributeChange(
          model::Cambiar_Radio{e, real(), type_of.template operator()<&model::Escena::mi_radio>()});
    case 2:
      return model::AttributeChange(model::Cambiar_Vector{e, model::Vector(flip() ? any_axis() : any_triple()),
                                                          type_of.template operator()<&model::Escena::mi_vector>()});
    case 3:
      return model::AttributeChange(
          model::Cambiar_Altura{e, real(), type_of.template operator()<&model::Escena::mi_altura>()});
    case 4:
      return model::AttributeChange(
          model::Cambiar_Proporcion{e, real(), type_of.template operator()<&model::Escena::mi_proporcion>()});
    case 5:
      return model::AttributeChange(model::Cambiar_Vertices{
          e, model::Terna{model::Punto(any_triple()), {1, -0.0, 0}, model::Punto(any_small_triple())},
          type_of.template operator()<&model::Escena::mi_vertices>()});
    case 6: {
      const auto material = any_material(stage, true);
      if (!material) return model::LookChange(model::Quitar_Material{e});
      return model::LookChange(model::Cambiar_Material{e, stage.materials[*material].name});
    }
    case 7:
    case 8:
      return model::LookChange(model::Cambiar_Grupo{e, any_group_name()});
    default:
      return model::LookChange(model::Quitar_Grupo{e});
  }
}

inline AnyEdit any_group_edit() {
  if (below(3) == 0) return scene::GroupEdit(scene::Ungrouping{any_group_name()});
  scene::Grouping made{any_group_name(), {}};
  for (const std::string& name : distinct_names(below(3))) made.of.elementos.insert(name);
  for (int n = below(3); n > 0; --n) made.of.groups.insert(any_group_name());
  return scene::GroupEdit(made);
}

/// Of every kind but those of a Z text.
inline AnyEdit any_edit(const scene::Stage& stage) {
  switch (below(15)) {
    case 12:
    case 13:
    case 14:
      return any_change(stage);
    case 0:
      return scene::Closing{any_name(), any_name(), any_name()};
    case 1:
    case 2:
    case 3:
      return any_body_edit(stage);
    case 4:
    case 5:
      return any_mesh_edit(stage);
    case 6:
    case 7:
    case 8:
      return any_group_edit();
    default:
      return any_element_edit(stage);
  }
}

/// Edits of that scene that are done or refused.
inline void edit_at_random(scene::GroupedScene& scene, int most) {
  io::EditedScene edited(std::move(scene));
  for (int n = below(most + 1); n > 0; --n) edited.apply_total({1, any_edit(edited.stage())});
  scene = edited.of();
}

inline scene::GroupedScene any_grouped_scene(int most = 30) {
  scene::GroupedScene scene;
  set_any_stage(scene.scene.stage());
  edit_at_random(scene, most);
  return scene;
}

/// Gives an element something that no operation does.
inline void look_at_random(scene::Scene& scene) {
  for (const scene::ElementRef element : scene::singles_by_name(scene)) {
    if (below(8) != 0 || scene.body(element) != nullptr) continue;
    if (element.tipo == model::Tipo::soy_triangulo)
      scene.set_vertex_normals(element, {{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}});
    else
      scene.set_motion(element, any_small_triple());
  }
}

}  // namespace durero::test
