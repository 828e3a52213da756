#pragma once
/// The edits of instances: an element is added that is the copy of one that is there, by an affine map (spec/
/// instancias.tex). The copy stays as it is made, whatever becomes of its original.

#include <cstdint>
#include <optional>
#include <string>

#include "durero/contract/contract.hpp"
#include "durero/model/instancias.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// The addition of an instance, Agregar_Instancia.
struct Copying {
  std::string e;                            ///< what it is to be called
  std::string de;                           ///< its original, an element or an instance
  model::Mapa mapa;                         ///< where the points of the original are put
  std::optional<std::uint32_t> material{};  ///< as an index into the stage's materials
};

/// The removal of an instance, Eliminar_Instancia. Eliminar_Elemento removes one too.
struct CopyRemoval {
  std::string e;  ///< which
};

/// @{ What they ask.
inline constexpr contract::clause Agregar_Instancia_pre_1{"Agregar_Instancia.pre.1", "e? ∉ elementos"};
inline constexpr contract::clause Agregar_Instancia_pre_2{"Agregar_Instancia.pre.2", "de? ∈ elementos"};
inline constexpr contract::clause Eliminar_Instancia_pre_1{"Eliminar_Instancia.pre.1", "e? ∈ elementos"};
inline constexpr contract::clause Eliminar_Instancia_pre_2{"Eliminar_Instancia.pre.2", "e? ∈ instancias"};
/// @}

/// @{ The total edits: where a precondition does not hold they change nothing and answer so, the first in the order of
/// their labels. The map's own is Mapa.inv.1, after those of the addition. Precondition: the names are names. Throws
/// std::out_of_range, and changes nothing, where the material is none of the stage's.
Outcome apply_total(Scene& scene, const Copying& in);
Outcome apply_total(Scene& scene, const CopyRemoval& in);
/// @}

}  // namespace durero::scene
