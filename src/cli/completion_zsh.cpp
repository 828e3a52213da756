#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "completion.hpp"

namespace durero::cli {
namespace {

std::string function_of(const CLI::App& command) {
  std::string name = path_of(command).empty() ? "_durero" : "_durero_" + path_of(command);
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

/// The text between brackets or before a colon of a specification of _arguments.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += std::string_view("[]:\\").find(c) != std::string_view::npos ? std::string("\\") + c : std::string(1, c);
  return out;
}

/// `:message:action` of a value.
std::string action(const OptionValue& value) {
  std::string action;
  if (value.kind == OptionValue::Kind::file) action = "_files";
  if (value.kind == OptionValue::Kind::file && !value.words.empty())
    action = fmt::format(" _alternative 'names: :({})' 'files: :_files'", fmt::join(value.words, " "));
  if (value.kind == OptionValue::Kind::folder) action = "_files -/";
  if (value.kind == OptionValue::Kind::word) action = fmt::format("({})", fmt::join(value.words, " "));
  return fmt::format(":{}:{}", escaped(value.name), action);
}

std::string option_rows(const CLI::Option& option) {
  const OptionValue value = completed(option);
  const auto names = names_of(option);
  std::string text;
  for (const std::string& name : names) {
    const std::string others = names.size() > 1 ? fmt::format("({})", fmt::join(names, " ")) : "";
    const bool is_list = option.get_items_expected_max() > 1;
    const std::string may_be_with_equals = name.starts_with("--") && value.kind != OptionValue::Kind::none ? "=" : "";
    text += " \\\n    " + shell_word(fmt::format("{}{}{}[{}]{}", is_list ? "*" : others, name, may_be_with_equals,
                                                 escaped(option.get_description()),
                                                 value.kind == OptionValue::Kind::none ? "" : action(value)));
  }
  return text;
}

std::string argument_rows(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* argument : arguments(command)) {
    const bool is_list = argument->get_items_expected_max() > 1;
    text += " \\\n    " + shell_word((is_list ? "*" : "") + action(completed(*argument)));
  }
  return text;
}

std::string leaf(const CLI::App& command) {
  std::string text = function_of(command) + "() {\n  _arguments -s";
  for (const CLI::Option* option : options(command)) text += option_rows(*option);
  return text + argument_rows(command) + "\n}\n\n";
}

/// A command that has subcommands goes on to the one that is called.
std::string branch(const CLI::App& command) {
  std::string text = function_of(command) + "() {\n  local -a commands line\n  local state\n  _arguments -C";
  for (const CLI::Option* option : options(command)) text += option_rows(*option);
  text += " \\\n    '1: :->command' '*:: :->rest'\n  case $state in\n    command)\n      commands=(";
  for (const CLI::App* below : subcommands(command))
    text += "\n        " + shell_word(below->get_name() + ":" + escaped(below->get_description()));
  text += ")\n      _describe command commands ;;\n    rest)\n      case $line[1] in\n";
  for (const CLI::App* below : subcommands(command))
    text += fmt::format("        {}) {} ;;\n", below->get_name(), function_of(*below));
  return text + "      esac ;;\n  esac\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string text = "#compdef durero\n# Completes calls of durero in zsh.\n\n";
  for (const CLI::App* command : with_subcommands(app))
    text += subcommands(*command).empty() ? leaf(*command) : branch(*command);
  return text + "if [ \"$funcstack[1]\" = _durero ]; then _durero \"$@\"; else compdef _durero durero; fi\n";
}

}  // namespace durero::cli
