#pragma once
/// The error of a call names the fault in the house's form.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace durero::cli {

/// The command that was called, as deep as the call got: the program itself where it names none.
const CLI::App& called(const CLI::App& app);

/// The message of an error, one line without an end: the command, the first fault of the call, then the expectation. An
/// option that the command does not have comes before any other fault, which may follow from it.
std::string call_error(const CLI::App& app, const CLI::ParseError& error);

/// The command that the words name, each below the one before it; without a word, the program itself. Where a word
/// names none the message names `asking`, the command that asks.
const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& words, std::string_view asking);

}  // namespace durero::cli
