#pragma once
/// Operations as text, and their answers as JSON lines.
///
///   Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1        one a line; the ? is optional; # starts a comment
///   {"op":"Agregar_Esfera","e":"s1","centro":[0,0,5],"radio":1}
///
///   Cambiar_Radio_Esfera e?=s1 radio?=2                  an attribute of a sphere, or of any element: Cambiar_Radio
///   Cambiar_Material e?=s1 material?=red                 and Quitar_Material e?=s1
///   Cambiar_Grupo e?=s1 g?=pair                          and Quitar_Grupo e?=s1
///
///   group g?=pair elementos?=s1,s2 groups?=others        an edit of the groups
///   ungroup g?=pair
///
///   close e?=c1 base?=b1 top?=t1                         discs close an element; without names c1:base and c1:top
///
///   Agregar_Instancia e?=pebble de?=ball centro?=(0,0,5) x?=(2,0,0) y?=(0,1,0) z?=(0,0,1)   where the map of an
///   instance Eliminar_Instancia e?=pebble                          puts the origin, and what it makes of the axes
///
///   Agregar_Malla m?=tent puntos?=((0,0,0),(1,0,0),(0,1,0)) caras?=((0,1,2))   and Reemplazar_Malla likewise
///   Eliminar_Malla m?=tent
///   Mover_Vertice m?=tent n?=2 punto?=(0,2,0)
///
///   Agregar_Toro e?=ring centro?=(0,0,0) mayor?=2 menor?=1   of a type that a Z text declares: its word with a capital
///   Eliminar_Toro e?=ring
///
/// The additions also take `material`, a name among the scene's materials, which the new element gets. Numbers are
/// decimal or, as text, C's hexadecimal. What an operation refuses (radius 0, a name that is taken) is no error of the
/// text: it is answered. An error is what no operation could be made of.

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/io/json/written_elements.hpp"
#include "durero/io/source.hpp"
#include "durero/model/cambio.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/closing.hpp"
#include "durero/scene/copying.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/joining.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

/// One line of a script: the edit that it asks for.
struct ScriptStep {
  std::size_t line;  ///< from 1
  /// A material is a place in the stage that the script was read with.
  std::variant<scene::Edit, scene::GroupEdit, scene::Closing, WrittenEdit, scene::Copying, scene::CopyRemoval,
               scene::Joining, scene::SolidRemoval, scene::MeshEdit, model::AttributeChange, model::LookChange>
      edit;
};

/// What an edit answers. Of a type that a Z text declares, what does not hold is a predicate of that text.
struct EditAnswer {
  std::string r;            ///< r!, or a word
  std::string violated{};   ///< the label of what does not hold; empty where the edit is done
  std::string predicate{};  ///< that
  /// Of a removal, the group that the element left; of an addition, the one that an element of its name left before,
  /// and that the new one is not in. Empty where there is none.
  std::string left_group{};
  /// Whether the edit is done.
  bool ok() const noexcept { return violated.empty(); }
};
/// @{ What those answers say.
EditAnswer edit_answer(const model::Answer& answer);
EditAnswer edit_answer(const scene::Outcome& answer);
/// @}

/// An operation by its name, and its inputs by theirs, without `?`; those that it needs come first.
struct OperationWords {
  std::string name;                 ///< such as `Agregar_Esfera`
  std::vector<std::string> inputs;  ///< such as `e`, `centro`, `radio`, `material`
  std::size_t required;             ///< how many of these it needs
};
/// Every operation of a script, those of the types that a Z text declares too.
std::vector<OperationWords> operation_words(std::span<const WrittenType> types = {});

/// Reads a whole script, so that a malformed line stops it before anything is done. Throws InputError. Of a WrittenEdit
/// there is none where there are no types.
std::vector<ScriptStep> read_script(const Source& source, const scene::Stage& stage,
                                    std::span<const WrittenType> types = {});

/// `{"line":1,"ok":true,"r":"esfera_agregada"}`, perhaps with a left_group, or with what was violated; without line
/// end. `for_each` is the element that an operation is repeated for, where it is.
std::string answer_text(std::size_t line, const EditAnswer& answer, std::string_view for_each = {});

}  // namespace durero::io
