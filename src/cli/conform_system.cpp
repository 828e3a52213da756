#include "conform_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "completion.hpp"
#include "conform.hpp"
#include "durero/conform/ask/setup.hpp"
#include "durero/conform/campaign/campaign.hpp"
#include "durero/io/file_name.hpp"

namespace durero::cli {

using namespace conform;

namespace {

/// The name of a command in files: its words, each from its last slash on, with - for each character that is not plain
/// in a file's name: "python3 ./mine.py" is python3-mine.py.
std::string name_of_command(const std::string& command) {
  constexpr std::size_t most = 64;
  std::istringstream words(command);
  std::string name;
  for (std::string word; words >> word;) {
    word.erase(0, word.rfind('/') + 1);
    std::ranges::replace_if(
        word, [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '_'; }, '-');
    word.erase(0, std::min(word.find_first_not_of("-."), word.size()));
    if (!word.empty()) name += (name.empty() ? "" : "-") + word;
  }
  return name.empty() ? "command" : name.substr(0, most);
}

}  // namespace

System system_of(const std::string& name, const std::string& profile, const std::string& systems) {
  if (!name.starts_with(of_command)) {
    const bool is_file = io::ends_in(name, ".json") || name.find('/') != name.npos;
    return is_file ? read_system(io::read_source(name), default_setups())
                   : find_system(name, systems, default_setups());
  }
  if (profile.empty())
    throw std::runtime_error("command: without --profile; expected a system's name or a file that says what it claims");
  System system;
  system.ask = {"sh", "-c", name.substr(of_command.size())};
  system.title = system.ask.back();
  system.name = name_of_command(system.title);
  system.profile = read_profile(profile, systems);
  return system;
}

void require_use_of_profile(std::span<const std::string> names, const std::string& profile) {
  if (!profile.empty() && std::ranges::none_of(names, [](const auto& name) { return name.starts_with(of_command); }))
    throw std::runtime_error(
        "--profile without command:PROGRAM; expected no profile: a system's own file says what it claims");
}

System system_of(const SystemCall& call) {
  require_use_of_profile({&call.system, 1}, call.profile);
  return system_of(call.system, call.profile, call.systems);
}

void add_system(CLI::App& command, SystemCall& call) {
  command.add_option("SYSTEM", call.system, "The name of a system, its file, or command:PROGRAM")->required();
  command.add_option("--profile", call.profile, profile_help);
  add_systems(command, call.systems);
}

std::string words_of_system(const std::string& name, const std::string& profile) {
  static constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:-";
  const auto word = [](const std::string& text) {
    return text.find_first_not_of(plain) == text.npos ? text : shell_word(text);
  };
  return name.starts_with(of_command) ? fmt::format("{} --profile {}", word(name), word(profile)) : word(name);
}

void require_present(const System& system) {
  if (const std::string why = why_absent(system); !why.empty())
    throw std::runtime_error(
        fmt::format("{} is absent: {}; expected durero conform setup {}", system.name, why, system.name));
}

Ask counted(Ask ask, Progress& progress) {
  return [ask = std::move(ask), &progress](const SuiteCase& of) {
    progress.add();
    return ask(of);
  };
}

}  // namespace durero::cli
