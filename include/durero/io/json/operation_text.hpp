#pragma once
/// Edits as lines of a script, which read_script() reads back as the same edits.

#include <span>
#include <string>

#include "durero/io/json/operations_file.hpp"
#include "durero/io/json/written_elements.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

/// The canonical line of the step of a script, without line end: the inputs in the order of the operation's table,
/// numbers in the shortest form. It is text, or JSON where the material has a name that is no word of text. A material
/// is a place in that stage, a type in those. Precondition: a script can ask for the edit, whose numbers are finite; a
/// mesh has neither normals nor uv, and a map has entries that are binary64.
std::string operation_text(const ScriptStep& step, const scene::Stage& stage, std::span<const WrittenType> types = {});

}  // namespace durero::io
