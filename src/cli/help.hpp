#pragma once
/// The text of --help is made of the declared options.

#include <CLI/CLI.hpp>
#include <cstddef>

namespace durero::cli {

/// The most characters of a line of help.
inline constexpr std::size_t help_width = 100;

class Help : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override;
};

/// The text about an option or an argument: its description, then its words or its bounds, and its default.
std::string said_of(const CLI::Option& option);

}  // namespace durero::cli
