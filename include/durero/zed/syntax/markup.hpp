#pragma once
/// The commands that a Z text itself names.

#include <functional>
#include <map>
#include <string>

namespace durero::zed {

/// What the `%%Zchar` and `%%Zword` directives in scope say: a command, without its backslash, and its Unicode text.
using Markup = std::map<std::string, std::string, std::less<>>;

}  // namespace durero::zed
