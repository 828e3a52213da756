#include "call_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "description.hpp"
#include "durero/text/nearest.hpp"

namespace durero::cli {
namespace {

std::string all_of(const std::vector<std::string>& words) {
  return words.size() == 1 ? words.front() : fmt::format("one of {}", fmt::join(words, ", "));
}

/// `check — did you mean it?` where a word is near, or else all of them.
std::string expected_of(const std::string& word, const std::vector<std::string>& known) {
  const auto meant = text::nearest(word, known);
  return meant ? *meant + " — did you mean it?" : all_of(known);
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options(command)) {
    const auto of_option = names_of(*option);
    names.insert(names.end(), of_option.begin(), of_option.end());
  }
  return names;
}

const CLI::App& program(const CLI::App& command) {
  return command.get_parent() == nullptr ? command : program(*command.get_parent());
}

/// The commands that have the option.
std::vector<std::string> that_have(const CLI::App& app, const std::string& name) {
  std::vector<std::string> paths;
  for (const CLI::App* command : with_subcommands(app)) {
    const auto names = option_names(*command);
    if (std::ranges::count(names, name) != 0) paths.push_back("durero " + path_of(*command));
  }
  return paths;
}

/// `--enginee=exact` and `-x5` are named `--enginee` and `-x`.
std::string name_in(const std::string& argument) {
  return argument.starts_with("--") ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
}

std::string no_such_option(const CLI::App& command, const std::string& argument) {
  const std::string name = name_in(argument);
  const auto known = option_names(command);
  const auto others = that_have(program(command), name);
  if (text::nearest(name, known) || others.empty())
    return fmt::format("{}: no such option; expected {}", name, expected_of(name, known));
  return fmt::format("{}: no option of this command; expected it with {}", name, all_of(others));
}

std::string no_such_command(const CLI::App& command, const std::string& word) {
  std::vector<std::string> known, deeper;
  for (const CLI::App* below : subcommands(command)) known.push_back(below->get_name());
  for (const CLI::App* other : with_subcommands(program(command)))
    if (other->get_name() == word) deeper.push_back("durero " + path_of(*other));
  if (!text::nearest(word, known) && !deeper.empty())
    return fmt::format("{}: no such command here; expected {}", word, all_of(deeper));
  return fmt::format("{}: no such command; expected {}", word, expected_of(word, known));
}

/// The arguments that no command and no option took. Behind `--` nothing is an option.
struct Surplus {
  const CLI::App* command;
  std::string argument;
  bool is_option;
};

std::optional<Surplus> surplus(const CLI::App& app) {
  std::optional<Surplus> first;
  for (const CLI::App* command = &app;;) {
    bool may_be_option = true;
    for (const std::string& argument : command->remaining(false)) {
      if (argument == "--") {
        may_be_option = false;
        continue;
      }
      const bool is_option = may_be_option && argument.size() > 1 && argument.front() == '-';
      if (is_option) return Surplus{command, argument, true};
      if (!first) first = {command, argument, false};
    }
    const auto below = command->get_subcommands();
    if (below.empty()) return first;
    command = below.front();
  }
}

std::string what_of(const Surplus& of) {
  if (of.is_option) return no_such_option(*of.command, of.argument);
  if (!subcommands(*of.command).empty()) return no_such_command(*of.command, of.argument);
  return fmt::format("{}: an argument too many; expected {}", of.argument, usage(*of.command));
}

/// The message about a required argument or command that was not given.
std::string missing(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    return fmt::format("{}: it is missing; expected {}", option->get_name(), usage(command));
  }
  std::vector<std::string> known;
  for (const CLI::App* below : subcommands(command)) known.push_back(below->get_name());
  return fmt::format("no command; expected {}", all_of(known));
}

/// The message about an option with too many values, or too few.
std::string mismatched(const CLI::App& command, const std::string& said) {
  std::string name = said.substr(0, said.find_first_of(": "));
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr) option = command.get_option_no_throw("--" + name);  // a flag's name comes without
  if (option == nullptr) return said;
  name = option->get_name();
  const OptionValue value = value_of(*option);
  if (value.kind == OptionValue::Kind::none) return fmt::format("{}: it takes no value; expected {} alone", name, name);
  if (option->count() > 1) return fmt::format("{}: it is given {} times; expected once", name, option->count());
  return fmt::format("{}: its value is missing; expected {} {}", name, name, value.name);
}

/// The message about an option that needs another, which is missing.
std::string alone(const CLI::App& command, const std::string& said) {
  for (const CLI::Option* option : options(command)) {
    for (const CLI::Option* needed : option->get_needs())
      if (option->count() > 0 && needed->count() == 0)
        return fmt::format("{}: it says nothing alone; expected {} with it", option->get_name(), needed->get_name());
  }
  return said;
}

/// The message of a check. It begins with the value; CLI11 puts the option's name and a colon before it, which go.
std::string checked(std::string said) {
  const std::size_t colon = said.find(": ");
  if (colon != said.npos && said.find(": ", colon + 2) != said.npos) said.erase(colon, 1);
  return said;
}

std::string what_of(const CLI::App& command, const CLI::ParseError& error) {
  const std::string said = error.what();
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing(command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return mismatched(command, said);
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) return alone(command, said);
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) return checked(said);
  return said;
}

}  // namespace

const CLI::App& called(const CLI::App& app) {
  const auto below = app.get_subcommands();
  return below.empty() ? app : called(*below.front());
}

std::string call_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto extra = surplus(app);
  const bool is_extra = extra && (extra->is_option || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                                  !subcommands(*extra->command).empty());
  const CLI::App& command = is_extra ? *extra->command : called(app);
  const std::string path = path_of(command);
  std::string what = is_extra ? what_of(*extra) : what_of(command, error);
  if (what.find("; expected ") == what.npos)
    what += fmt::format("; expected what durero {}--help shows", path.empty() ? "" : path + " ");
  return path.empty() ? what : path + ": " + what;
}

const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& words, std::string_view asking) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    std::vector<std::string> known;
    const CLI::App* next = nullptr;
    for (const CLI::App* below : subcommands(*command)) {
      known.push_back(below->get_name());
      if (below->get_name() == word) next = below;
    }
    if (next == nullptr)
      throw std::runtime_error(
          fmt::format("{}: {}: no such command; expected {}", asking, word,
                      known.empty() ? "none below " + path_of(*command) : expected_of(word, known)));
    command = next;
  }
  return *command;
}

}  // namespace durero::cli
