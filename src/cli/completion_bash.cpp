#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion.hpp"

namespace durero::cli {
namespace {

constexpr const char* head_in_bash = R"(# Completes calls of durero in bash.

# What may stand next: words that begin so, files or folders.
_durero_words() { mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$2"); }
_durero_files() { compopt -o filenames; mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$1"); }
_durero_folders() { compopt -o filenames; mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$1"); }

_durero() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} path='' word
  COMPREPLY=()
  # --option=value comes as three words.
  if [[ $current == = ]]; then current=''; elif [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi
  for word in "${COMP_WORDS[@]:1:COMP_CWORD - 1}"; do
    case " $path/$word " in
)";

constexpr const char* middle = R"(    esac
  done
  case "$path/$before" in
)";

constexpr const char* rest = R"(  esac
  case "$path" in
)";

constexpr const char* tail = R"(  esac
}
complete -F _durero durero
)";

/// The command that completes a value, or nothing.
std::string completing_in_bash(const OptionValue& value) {
  std::string call;
  if (!value.words.empty())
    call += fmt::format("_durero_words {} \"$current\"", shell_word(fmt::format("{}", fmt::join(value.words, " "))));
  if (!call.empty() && value.kind == OptionValue::Kind::file) call += "; ";
  if (value.kind == OptionValue::Kind::file) call += "_durero_files \"$current\"";
  if (value.kind == OptionValue::Kind::folder) call += "_durero_folders \"$current\"";
  return call.empty() ? ":" : call;
}

std::string option_row_in_bash(const std::string& path, const CLI::Option& option) {
  const OptionValue value = completed(option);
  if (value.kind == OptionValue::Kind::none) return "";
  std::vector<std::string> patterns;
  for (const std::string& name : names_of(option)) patterns.push_back(shell_word(path + "/" + name));
  return fmt::format("    {}) {}; return ;;\n", fmt::join(patterns, " | "), completing_in_bash(value));
}

std::string command_row(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::App* below : subcommands(command)) words.push_back(below->get_name());
  std::string text = fmt::format("    {})\n", shell_word(path_of(command)));
  for (const CLI::Option* option : options(command))
    for (const std::string& name : names_of(*option)) words.push_back(name);
  text += fmt::format("      _durero_words {} \"$current\"\n", shell_word(fmt::format("{}", fmt::join(words, " "))));
  for (const CLI::Option* argument : arguments(command)) {
    const std::string call = completing_in_bash(completed(*argument));
    if (call != ":" && text.find(call) == text.npos)
      text += fmt::format("      [[ $current == -* ]] || {{ {}; }}\n", call);
  }
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string text = head_in_bash;
  for (const CLI::App* command : with_subcommands(app)) {
    if (command->get_parent() == nullptr) continue;
    const std::string above = path_of(*command->get_parent());
    text += fmt::format("      {}) path={} ;;\n", shell_word(fmt::format(" {}/{} ", above, command->get_name())),
                        shell_word(path_of(*command)));
  }
  text += middle;
  for (const CLI::App* command : with_subcommands(app))
    for (const CLI::Option* option : options(*command)) text += option_row_in_bash(path_of(*command), *option);
  text += rest;
  for (const CLI::App* command : with_subcommands(app)) text += command_row(*command);
  return text + tail;
}

}  // namespace durero::cli
