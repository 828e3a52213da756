#pragma once
/// The edits of solids: an element is added that is the union, the intersection or the difference of some that are
/// there (spec/solidos.tex). It stays as it is made, whatever becomes of its parts.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// The addition of a solid: Agregar_Union, Agregar_Interseccion or Agregar_Diferencia.
struct Joining {
  Compound::Operation operation;            ///< which of them
  std::string e;                            ///< what it is to be called
  std::vector<std::string> de;              ///< its parts, elements, in their order; two or more
  std::optional<std::uint32_t> material{};  ///< as an index into the stage's materials
};

/// The removal of a solid, Eliminar_Solido. Eliminar_Elemento removes one too.
struct SolidRemoval {
  std::string e;  ///< which
};

/// @{ What they ask.
inline constexpr contract::clause Agregar_Solido_pre_1{"Agregar_Solido.pre.1", "e? ∉ elementos"};
inline constexpr contract::clause Agregar_Solido_pre_2{"Agregar_Solido.pre.2", "ran de? ⊆ elementos"};
inline constexpr contract::clause Agregar_Solido_pre_3{"Agregar_Solido.pre.3", "ran de? ∩ (discos ∪ triangulos) = ∅"};
inline constexpr contract::clause Eliminar_Solido_pre_1{"Eliminar_Solido.pre.1", "e? ∈ elementos"};
inline constexpr contract::clause Eliminar_Solido_pre_2{"Eliminar_Solido.pre.2", "e? ∈ solidos"};
/// @}

/// @{ The total edits: where a precondition does not hold they change nothing and answer so, the first in the order of
/// their labels. Precondition: the names are names, and a solid has parts. Throws std::out_of_range, and changes
/// nothing, where the material is none of the stage's.
Outcome apply_total(Scene& scene, const Joining& in);
Outcome apply_total(Scene& scene, const SolidRemoval& in);
/// @}

}  // namespace durero::scene
