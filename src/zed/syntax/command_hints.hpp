#pragma once
/// The command of Z that is meant by one of LaTeX that Z has not.

#include <string>
#include <string_view>

#include "durero/zed/syntax/markup.hpp"

namespace durero::zed {

/// The expectation of a message where a command has no meaning: the command of Z for what LaTeX or another style writes
/// so, or one that it is a slip of, or any. `markup` has the commands of the text's directives.
std::string expected_command(std::string_view command, const Markup& markup);

}  // namespace durero::zed
