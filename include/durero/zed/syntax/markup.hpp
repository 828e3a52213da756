#pragma once
/// A Z text may itself name commands, for characters and words beyond the toolkit's.

#include <functional>
#include <map>
#include <string>

namespace durero::zed {

/// The mark-up holds the `%%Zchar` and `%%Zword` directives in scope: it leads from a command, without its backslash,
/// to its Unicode text.
using Markup = std::map<std::string, std::string, std::less<>>;

}  // namespace durero::zed
