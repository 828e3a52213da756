#pragma once
/// How an element looks, and which group it is in (spec/historia.tex): no answer depends on either.

#include <map>
#include <set>
#include <string>
#include <variant>

#include "durero/model/cambio.hpp"

namespace durero::model {

inline constexpr clause Vista_inv_1{"Vista.inv.1", "dom mi_grupo ⊆ elementos"};
inline constexpr clause Vista_inv_2{"Vista.inv.2", "ran mi_grupo ⊆ grupos"};
inline constexpr clause Vista_inv_3{"Vista.inv.3", "dom mi_material ⊆ elementos"};
inline constexpr clause Vista_inv_4{"Vista.inv.4", "ran mi_material ⊆ materiales"};
inline constexpr clause Mismo_Aspecto_post_1{"Mismo_Aspecto.post.1", "grupos' = grupos"};
inline constexpr clause Mismo_Aspecto_post_2{"Mismo_Aspecto.post.2", "materiales' = materiales"};
inline constexpr clause Mismo_Aspecto_post_3{"Mismo_Aspecto.post.3", "mi_grupo' = elementos' ◁ mi_grupo"};
inline constexpr clause Mismo_Aspecto_post_4{"Mismo_Aspecto.post.4", "mi_material' = elementos' ◁ mi_material"};
inline constexpr clause Cambiar_Material_pre_1{"Cambiar_Material.pre.1", "e? ∈ elementos"};
inline constexpr clause Cambiar_Material_pre_2{"Cambiar_Material.pre.2", "material? ∈ materiales"};
inline constexpr clause Cambiar_Material_post_1{"Cambiar_Material.post.1", "grupos' = grupos"};
inline constexpr clause Cambiar_Material_post_2{"Cambiar_Material.post.2", "materiales' = materiales"};
inline constexpr clause Cambiar_Material_post_3{"Cambiar_Material.post.3", "mi_grupo' = mi_grupo"};
inline constexpr clause Cambiar_Material_post_4{"Cambiar_Material.post.4",
                                                "mi_material' = mi_material ⊕ { e? ↦ material? }"};
inline constexpr clause Cambiar_Material_post_5{"Cambiar_Material.post.5", "r! = elemento_cambiado"};
inline constexpr clause Quitar_Material_pre_1{"Quitar_Material.pre.1", "e? ∈ elementos"};
inline constexpr clause Quitar_Material_post_1{"Quitar_Material.post.1", "grupos' = grupos"};
inline constexpr clause Quitar_Material_post_2{"Quitar_Material.post.2", "materiales' = materiales"};
inline constexpr clause Quitar_Material_post_3{"Quitar_Material.post.3", "mi_grupo' = mi_grupo"};
inline constexpr clause Quitar_Material_post_4{"Quitar_Material.post.4", "mi_material' = { e? } ⩤ mi_material"};
inline constexpr clause Quitar_Material_post_5{"Quitar_Material.post.5", "r! = elemento_cambiado"};
inline constexpr clause Cambiar_Grupo_pre_1{"Cambiar_Grupo.pre.1", "e? ∈ elementos"};
inline constexpr clause Cambiar_Grupo_pre_2{"Cambiar_Grupo.pre.2", "g? ∈ grupos"};
inline constexpr clause Cambiar_Grupo_post_1{"Cambiar_Grupo.post.1", "grupos' = grupos"};
inline constexpr clause Cambiar_Grupo_post_2{"Cambiar_Grupo.post.2", "materiales' = materiales"};
inline constexpr clause Cambiar_Grupo_post_3{"Cambiar_Grupo.post.3", "mi_grupo' = mi_grupo ⊕ { e? ↦ g? }"};
inline constexpr clause Cambiar_Grupo_post_4{"Cambiar_Grupo.post.4", "mi_material' = mi_material"};
inline constexpr clause Cambiar_Grupo_post_5{"Cambiar_Grupo.post.5", "r! = elemento_cambiado"};
inline constexpr clause Quitar_Grupo_pre_1{"Quitar_Grupo.pre.1", "e? ∈ elementos"};
inline constexpr clause Quitar_Grupo_post_1{"Quitar_Grupo.post.1", "grupos' = grupos"};
inline constexpr clause Quitar_Grupo_post_2{"Quitar_Grupo.post.2", "materiales' = materiales"};
inline constexpr clause Quitar_Grupo_post_3{"Quitar_Grupo.post.3", "mi_grupo' = { e? } ⩤ mi_grupo"};
inline constexpr clause Quitar_Grupo_post_4{"Quitar_Grupo.post.4", "mi_material' = mi_material"};
inline constexpr clause Quitar_Grupo_post_5{"Quitar_Grupo.post.5", "r! = elemento_cambiado"};
inline constexpr clause Nadie_Se_Llama_pre_1{"Nadie_Se_Llama.pre.1", "e? ∉ elementos"};
inline constexpr clause Nadie_Se_Llama_post_1{"Nadie_Se_Llama.post.1", "r! = elemento_no_existe"};
inline constexpr clause Material_No_Existe_pre_1{"Material_No_Existe.pre.1", "material? ∉ materiales"};
inline constexpr clause Material_No_Existe_post_1{"Material_No_Existe.post.1", "r! = material_no_existe"};
inline constexpr clause Grupo_No_Existe_pre_1{"Grupo_No_Existe.pre.1", "g? ∉ grupos"};
inline constexpr clause Grupo_No_Existe_post_1{"Grupo_No_Existe.post.1", "r! = grupo_no_existe"};

// How an element looks, and which group it is in.

/// The name of a material or of a group (Nombre).
using Nombre = std::string;

/// A scene with the looks of its elements (Vista). A plain value: its invariants are evaluated by what is declared
/// below.
struct Vista {
  Escena escena;  ///< the components of Escena
  /// @{ The component of that name in the text.
  std::set<Nombre> grupos;
  std::set<Nombre> materiales;
  std::map<Elemento, Nombre> mi_grupo;
  std::map<Elemento, Nombre> mi_material;
  /// @}

  bool operator==(const Vista&) const = default;
};

/// The invariants of Escena, and Vista.inv.1 to Vista.inv.4: the whole predicates. O(n log n).
Judgements inv(const Vista& s);

/// Gives an element a material (Cambiar_Material).
struct Cambiar_Material {
  Elemento e;
  Nombre material;

  static constexpr std::string_view schema = "Cambiar_Material";
  static constexpr std::string_view total = "Cambiar_Material_Total";  ///< Cambiar_Material_Total.def.1
};

/// Takes the material of an element away (Quitar_Material).
struct Quitar_Material {
  Elemento e;

  static constexpr std::string_view schema = "Quitar_Material";
  static constexpr std::string_view total = "Quitar_Material_Total";  ///< Quitar_Material_Total.def.1
};

/// Puts an element into a group, and takes it out of the one that it was in (Cambiar_Grupo).
struct Cambiar_Grupo {
  Elemento e;
  Nombre g;

  static constexpr std::string_view schema = "Cambiar_Grupo";
  static constexpr std::string_view total = "Cambiar_Grupo_Total";  ///< Cambiar_Grupo_Total.def.1
};

/// Takes an element out of its group (Quitar_Grupo).
struct Quitar_Grupo {
  Elemento e;

  static constexpr std::string_view schema = "Quitar_Grupo";
  static constexpr std::string_view total = "Quitar_Grupo_Total";  ///< Quitar_Grupo_Total.def.1
};

/// e?
const Elemento& name_of(const LookChange& change);
/// @{ The clauses over the before-state and the inputs, and over both states, the inputs and r!, judged.
Judgements pre(const Vista& before, const LookChange& change);
Judgements post(const Vista& before, const LookChange& change, const Vista& after, Respuesta r);
/// @}
/// The partial operation. Throws contract_violation where a clause does not hold; the state is then as it was.
Respuesta apply(Vista& s, const LookChange& change);
/// The total operation (…_Total): where a precondition does not hold it changes nothing and answers the error, the
/// first in the order of the text.
Answer apply_total(Vista& s, const LookChange& change);

/// The total operation of elements in a scene with looks. Elements that stay keep theirs: Agregar_Elemento_Vista.def.1,
/// Eliminar_Elemento_Vista.def.1 and Cambio_Vista.def.1.
Answer apply_total(Vista& s, const ElementOperation& operation);

}  // namespace durero::model
