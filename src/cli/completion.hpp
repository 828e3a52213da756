#pragma once
/// Completion scripts, which shells read to complete calls of durero, are made of the declared options.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "description.hpp"

namespace durero::cli {

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

/// The value that the option or argument takes, with the names of the systems that come with the program where it may
/// be one.
OptionValue completed(const CLI::Option& option);

/// The text as one word of a shell: between single quotes.
std::string shell_word(std::string_view text);

}  // namespace durero::cli
