#pragma once
/// Operations as text, and their answers as JSON lines.
///
///   Agregar_Esfera e?=s1 centro?=(0,0,5) radio?=1        one a line; the ? is optional; # starts a comment
///   {"op":"Agregar_Esfera","e":"s1","centro":[0,0,5],"radio":1}
///
///   group g?=pair elementos?=s1,s2 groups?=others        an edit of the groups
///   ungroup g?=pair
///
/// The additions also take `material`, a name among the scene's materials, which the new element gets. Numbers are
/// decimal or, as text, C's hexadecimal. What an operation refuses (radius 0, a name that is taken) is no error of the
/// text: it is answered. An error is what no operation could be made of.

#include <string>
#include <variant>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// One line of a script: the edit that it asks for.
struct Step {
  std::size_t line;  ///< from 1
  /// A material is a place in the stage that the script was read with.
  std::variant<scene::Edit, scene::GroupEdit> edit;
};

/// Reads a whole script, so that a malformed line stops it before anything is done. Throws InputError.
std::vector<Step> read_script(const Source& source, const scene::Stage& stage);

/// @{ `{"line":1,"ok":true,"r":"esfera_agregada"}`, or with what was violated; without line end.
std::string answer_text(std::size_t line, const model::Answer& answer);
std::string answer_text(std::size_t line, const scene::Outcome& answer);
/// @}

}  // namespace durero::io
