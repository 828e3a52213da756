#pragma once
/// The names that may stand at a place of a text, for one who writes there.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "durero/zed/names/cross_reference.hpp"

namespace durero::zed {

/// A name that may stand at a place.
struct VisibleName {
  Name name;                                     ///< with its strokes
  Referent::Form form = Referent::Form::global;  ///< by what it is declared
  std::optional<Type> type;                      ///< none where it is not known
};

/// Returns the names that are in scope where these bytes of a file stand, or behind a point the components of the
/// binding before it. The bytes are the beginning of a name, or none. If the paragraph cannot be read with a name
/// there, the names are those of its section, with the names that stand in the paragraph before a colon. Outside of
/// paragraphs there is no scope, and nothing is returned.
std::optional<std::vector<VisibleName>> names_in_scope(const std::map<std::string, std::string>& texts,
                                                       const std::string& file, std::size_t from, std::size_t to);

/// Returns the names of the toolkit that are written the same in both mark-ups, such as `first`.
std::vector<std::string> plain_toolkit_names();

/// Returns the commands of LaTeX, without the backslash, that the language, its toolkit and a section's directives
/// know, each with its Unicode text.
std::vector<std::pair<std::string, std::string>> latex_commands(const Specification& read, const std::string& section);

}  // namespace durero::zed
