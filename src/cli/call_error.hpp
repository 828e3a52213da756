#pragma once
/// What is wrong with a call, in the house's form.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace durero::cli {

/// The command that was called, as deep as the call got: the program itself where it names none.
const CLI::App& called(const CLI::App& app);

/// One line without an end: the command, what in the call is wrong first, then what is expected. An option that the
/// command does not have is told before anything else, as the rest of the call may be wrong by it.
std::string call_error(const CLI::App& app, const CLI::ParseError& error);

/// The command that the words name, each below the one before it; without a word, the program itself. The command that
/// asks is named where a word names none.
/// @throws std::runtime_error, whose text is one line as that of call_error
const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& words, std::string_view asking);

}  // namespace durero::cli
