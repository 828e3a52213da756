#pragma once
/// What a line of an editing session may go on with.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/edited_scene.hpp"

namespace durero::cli {

/// A command of a session that is no operation.
struct SessionCommand {
  std::string_view name;   ///< its first word
  std::string_view value;  ///< what follows it, or nothing
  std::string_view help;   ///< what it does
};

/// All of them.
const std::vector<SessionCommand>& session_commands();

/// The words that may stand where a line ends.
struct TypedCompletion {
  std::size_t begin;               ///< the byte of the line where each of them begins
  std::vector<std::string> words;  ///< ascending; each starts as the line goes on from there
};

/// The commands and the operations; then the inputs of an operation that are not given yet; then, of an input, the
/// names of elements, groups, meshes, materials or types, whichever it takes.
TypedCompletion completion_of(std::string_view line, const io::EditedScene& scene);

}  // namespace durero::cli
