#include "help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "description.hpp"

namespace durero::cli {
namespace {

constexpr std::size_t column = 28;

std::string row(const std::string& left, const std::string& said) {
  std::string text = fmt::format("  {:{}}", left, column - 2);
  if (left.size() + 4 > column) text += fmt::format("\n{:{}}", "", column);
  std::size_t at = column;
  for (std::size_t begin = 0; begin < said.size();) {
    const std::size_t end = std::min(said.find(' ', begin), said.size());
    if (at > column && at + 1 + end - begin > help_width) {
      text += fmt::format("\n{:{}}", "", column);
      at = column;
    }
    if (at > column) text += ' ', ++at;
    text += said.substr(begin, end - begin);
    at += end - begin;
    begin = end + 1;
  }
  return text + '\n';
}

std::string option_row(const CLI::Option& option) {
  const auto names = names_of(option);
  const std::string indent = names.front().starts_with("--") ? "    " : "";
  const OptionValue value = value_of(option);
  return row(indent + fmt::format("{}", fmt::join(names, ", ")) + (value.name.empty() ? "" : " " + value.name),
             said_of(option));
}

std::string arguments_text(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* argument : arguments(command)) text += row(argument->get_name(), said_of(*argument));
  return text.empty() ? "" : "\nArguments:\n" + text;
}

std::string options_text(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : options(command)) text += option_row(*option);
  return "\nOptions:\n" + text;
}

/// The subcommands, group after group.
std::string commands_text(const CLI::App& command) {
  std::string text, group;
  for (const CLI::App* below : subcommands(command)) {
    if (below->get_group() != group) {
      group = below->get_group();
      text += fmt::format("\n{}:\n", group == "Subcommands" ? "Commands" : group);
    }
    text += row(below->get_name(), below->get_description());
  }
  return text;
}

}  // namespace

std::string said_of(const CLI::Option& option) {
  const OptionValue value = value_of(option);
  std::vector<std::string> more;
  if (value.kind == OptionValue::Kind::word) more.push_back(fmt::format("{}", fmt::join(value.words, ", ")));
  if (!value.bounds.empty()) more.push_back(value.bounds);
  if (!option.get_default_str().empty()) more.push_back("by default " + option.get_default_str());
  return option.get_description() + (more.empty() ? "" : fmt::format(" ({})", fmt::join(more, "; ")));
}

std::string Help::make_help(const CLI::App* command, std::string, CLI::AppFormatMode) const {
  std::string text = fmt::format("{}\n\nUsage: {}\n", command->get_description(), usage(*command));
  text += commands_text(*command) + arguments_text(*command) + options_text(*command);
  const std::string footer = command->get_footer();
  return text + (footer.empty() ? "" : "\n" + footer + "\n");
}

}  // namespace durero::cli
