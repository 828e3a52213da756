#pragma once
/// The term that a token makes: the reference of a name, the application of an operator, the set of a brace.

#include <set>
#include <vector>

#include "zed/names/name_walk.hpp"

namespace durero::zed {

/// Says whether a term is what this token makes. Where terms inside one another are, the innermost is meant.
bool is_made_by(const Token& token, const Node& node);

/// Says whether a term mentions no name of these scopes but those that it binds itself. A schema that is not included
/// counts as a mention of its components.
bool is_closed(const Term& term, const Typing& typing, const std::vector<NameScope>& scopes);

}  // namespace durero::zed
