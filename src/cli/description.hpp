#pragma once
/// The description of each command is read from its declared options, arguments and footer. Help, man pages,
/// completions and the errors of a call all use it.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace durero::cli {

/// The value that an option or an argument takes.
struct OptionValue {
  enum class Kind { none, number, word, file, folder, text };
  Kind kind = Kind::none;
  std::string name;                ///< the name in help: FILE, N, ENGINE
  std::vector<std::string> words;  ///< the known words; a value of the kind word is one of them
  std::string bounds;              ///< the bounds of a number: `1 to 1024`
};

OptionValue value_of(const CLI::Option& option);

/// The words of the command, such as `conform run`; empty for the program itself.
std::string path_of(const CLI::App& command);
/// The command and all below it, each before its own subcommands.
std::vector<const CLI::App*> with_subcommands(const CLI::App& command);
std::vector<const CLI::App*> subcommands(const CLI::App& command);
/// The arguments that have a place, in order, and the options.
std::vector<const CLI::Option*> arguments(const CLI::App& command);
std::vector<const CLI::Option*> options(const CLI::App& command);
/// `-o` and `--output`, the short ones first.
std::vector<std::string> names_of(const CLI::Option& option);
/// `durero trace [OPTION]... SCENE RAYS`
std::string usage(const CLI::App& command);

/// A part of a footer: `Title:` on a line of its own and lines that two spaces indent; or, without a title, lines.
struct FooterSection {
  std::string title;
  std::vector<std::string> lines;
};
std::vector<FooterSection> sections(const CLI::App& command);

/// The sections that end a footer, in this order: the meaning of the exit statuses of the command, and calls of it.
std::string exit_status(const std::string& zero, const std::string& one, const std::string& two);
std::string exit_status(const std::string& zero, const std::string& two);
std::string examples(const std::vector<std::string>& calls);

}  // namespace durero::cli
