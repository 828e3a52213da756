#pragma once
/// What --help prints, made of what is declared.

#include <CLI/CLI.hpp>

namespace durero::cli {

class Help : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override;
};

/// What an option or an argument says of itself: its description, then its words or its bounds, and its default.
std::string said_of(const CLI::Option& option);

}  // namespace durero::cli
