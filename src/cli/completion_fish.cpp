#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion.hpp"

namespace durero::cli {
namespace {

constexpr const char* head_in_fish = R"(# Completes calls of durero in fish.

# The words of the command that is called, such as `conform run`.
function __durero_path
  set -l path
  for word in (commandline -opc)[2..]
    if contains -- (string join -- ' ' $path $word) $__durero_paths
      set path $path $word
    end
  end
  string join -- ' ' $path
end
function __durero_at
  test (__durero_path | string collect --allow-empty) = "$argv[1]"
end
complete -c durero -f
)";

/// The arguments of `complete` that complete a value.
std::string completing_in_fish(const OptionValue& value) {
  std::string call;
  if (!value.words.empty()) call = " -a " + shell_word(fmt::format("{}", fmt::join(value.words, " ")));
  if (value.kind == OptionValue::Kind::file) return call + " -F";
  if (value.kind == OptionValue::Kind::folder) return call + " -a '(__fish_complete_directories)'";
  return call;
}

std::string option_row_in_fish(const std::string& at, const CLI::Option& option) {
  std::string row = at;
  for (const std::string& letter : option.get_snames()) row += " -s " + letter;
  for (const std::string& word : option.get_lnames()) row += " -l " + word;
  const OptionValue value = completed(option);
  if (value.kind != OptionValue::Kind::none) row += value.kind == OptionValue::Kind::file ? " -r" : " -x";
  return fmt::format("{} -d {}{}\n", row, shell_word(option.get_description()), completing_in_fish(value));
}

std::string command_rows(const CLI::App& command) {
  const std::string at =
      fmt::format("complete -c durero -n {}", shell_word(fmt::format("__durero_at {}", shell_word(path_of(command)))));
  std::string text;
  for (const CLI::App* below : subcommands(command))
    text += fmt::format("{} -a {} -d {}\n", at, shell_word(below->get_name()), shell_word(below->get_description()));
  for (const CLI::Option* option : options(command)) text += option_row_in_fish(at, *option);
  for (const CLI::Option* argument : arguments(command)) {
    const std::string call = completing_in_fish(completed(*argument));
    if (!call.empty()) text += at + call + "\n";
  }
  return text;
}

}  // namespace

std::string fish_completion(const CLI::App& app) {
  std::vector<std::string> paths;
  std::string text;
  for (const CLI::App* command : with_subcommands(app)) {
    if (command->get_parent() != nullptr) paths.push_back(shell_word(path_of(*command)));
    text += command_rows(*command);
  }
  return fmt::format("{}set -g __durero_paths {}\n{}", head_in_fish, fmt::join(paths, " "), text);
}

}  // namespace durero::cli
