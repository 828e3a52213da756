// durero completion SHELL: what completes calls of durero in a shell.
#include "completion.hpp"

#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/io/standard_output.hpp"

namespace durero::cli {
namespace {

struct CompletionShell {
  const char* name;
  std::string (*script)(const CLI::App&);
};
constexpr CompletionShell shells[] = {{"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

std::vector<std::string> shell_names() {
  std::vector<std::string> names;
  for (const CompletionShell& shell : shells) names.emplace_back(shell.name);
  return names;
}

}  // namespace

OptionValue completed(const CLI::Option& option) {
  OptionValue value = value_of(option);
  const std::string folder = conform::default_systems();
  const bool names_system = option.get_name() == "SYSTEM" || option.get_name() == "--profile";
  if (!names_system || !std::filesystem::is_directory(folder)) return value;
  for (const auto& [name, file] : conform::system_files(folder)) value.words.push_back(name);
  return value;
}

std::string shell_word(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

void add_completion(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("completion", "Print what completes calls of durero in a shell");
  const auto name = std::make_shared<std::string>();
  command->add_option("SHELL", *name, "Which shell")->required()->check(one_of("shell", shell_names()));
  command->footer("An installed durero is completed by itself. Else, for this shell alone:\n\n" +
                  exit_status("it is printed", "the call is bad") +
                  examples({"completion bash >durero.bash && . ./durero.bash", "completion zsh >~/.zfunc/_durero",
                            "completion fish | source"}));
  command->callback([&app, name, &status] {
    for (const CompletionShell& shell : shells)
      if (*name == shell.name) io::print(shell.script(app));
    status = 0;
  });
}

}  // namespace durero::cli
