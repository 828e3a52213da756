#pragma once
/// Questions to a Z text: to the one that --with names, and with --by-spec to the text of spec/. The demonstration's
/// program reads no Z, and refuses them (demo_commands.cpp).

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/json/why_not.hpp"
#include "durero/io/source.hpp"
#include "durero/written/engine.hpp"

namespace durero::cli {

/// @{ Reads a scene by the text of a file, with the engine that answers rays on it. Throws io::InputError at the first
/// thing that is wrong, in the scene or in the text; of shapes also where an element is of a type that only the text
/// declares.
written::Written read_by_text(const io::Source& scene, const std::string& text);
written::Written read_shapes_by_text(const io::Source& scene, const std::string& text);
/// @}

/// Checks that a text declares the types of the algebraic surfaces of an imported scene, and what the points of each
/// are. Throws std::invalid_argument where it does not, and io::InputError where the text is wrong.
void require_surfaces(const std::string& scene, const std::string& text, const io::WrittenByName& surfaces);

/// Checks a scene by the text of a file, which must define the points of each element.
io::SceneCheck check_by_text(const io::Source& scene, const std::string& text);

/// Reads a scene by the text of a file, to be edited by it.
std::unique_ptr<io::EditedScene> edited_by_text(const io::Source& scene, const std::string& text);

/// Carries out a step of a script.
using Editor = std::function<io::EditAnswer(io::EditedScene& edited, const io::ScriptStep& step)>;
/// The editor that lets the text of spec/ decide each step too; it does not speak of groups. Throws std::logic_error
/// where the text decides otherwise: the program is wrong.
Editor editor_by_spec();

/// Finds every clause of a step that does not hold (io/json/why_not.hpp).
using ClauseFinder = std::function<io::WhyNot(const io::EditedScene& edited, const io::ScriptStep& step)>;
/// The finder that lets the text of spec/ decide the preconditions of its operations too. Throws std::logic_error where
/// the text decides otherwise: the program is wrong.
ClauseFinder clauses_by_spec();

/// The names of the elements of a set that the text of spec/ gives of a scene, ascending. Throws io::InputError.
std::vector<std::string> elements_of_set(const scene::Scene& scene, const std::string& set);

}  // namespace durero::cli
