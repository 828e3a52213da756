#include "durero/conform/ask/setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "conform/ask/child.hpp"
#include "durero/io/output_file.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

namespace fs = std::filesystem;

constexpr Seconds time_of_a_line{3600};
constexpr std::size_t kept_lines = 8;

struct EndedCommand {
  bool well = false;
  std::string lines{};  // the last of its standard output
  std::string words{};  // the last of its standard error
};

EndedCommand run(const Command& command, const std::atomic<bool>& stop) {
  Child child(command, {}, stop);
  child.close_input();
  std::vector<std::string> lines;
  std::string line;
  while (child.next_line(time_of_a_line, line) == Child::Event::line) {
    lines.push_back(line);
    if (lines.size() > kept_lines) lines.erase(lines.begin());
  }
  const std::string how = child.end();
  return {how == "exit status 0", fmt::format("{}", fmt::join(lines, "\n")), child.last_words()};
}

void require(const Command& command, const Say& say, const std::atomic<bool>& stop) {
  say(fmt::format("  {}", fmt::join(command, " ")));
  const EndedCommand ended = run(command, stop);
  if (stop) throw std::runtime_error("interrupted; expected to go on");
  if (!ended.well)
    throw std::runtime_error(fmt::format("{} failed: {}; expected it to end well", command.front(),
                                         text::escaped(ended.words.empty() ? ended.lines : ended.words)));
}

bool has_debian_package(const std::string& package, const std::atomic<bool>& stop) {
  const EndedCommand ended = run({"dpkg-query", "-W", "-f=${Status}\n", package}, stop);
  return ended.well && ended.lines == "install ok installed";
}

void install_from_debian(const std::vector<std::string>& packages, const Say& say, const std::atomic<bool>& stop) {
  std::vector<std::string> missing;
  std::ranges::copy_if(packages, std::back_inserter(missing),
                       [&](const std::string& package) { return !has_debian_package(package, stop); });
  if (missing.empty()) return;
  if (::geteuid() != 0)
    throw std::runtime_error(fmt::format(
        "missing packages {0}; expected root to have installed them: apt-get install {0}", fmt::join(missing, " ")));
  require({"apt-get", "-qq", "update"}, say, stop);
  Command install = {"apt-get", "-qq", "install", "-y", "--no-install-recommends"};
  install.insert(install.end(), missing.begin(), missing.end());
  require(install, say, stop);
}

void install_from_pypi(const System& system, const std::vector<std::string>& packages, const Say& say,
                       const std::atomic<bool>& stop) {
  const std::string venv = system.setup + "/venv";
  require({"python3", "-m", "venv", venv}, say, stop);
  Command install = {venv + "/bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"};
  install.insert(install.end(), packages.begin(), packages.end());
  require(install, say, stop);
}

void install_from_npm(const System& system, const std::vector<std::string>& packages, const Say& say,
                      const std::atomic<bool>& stop) {
  Command install = {"npm", "install", "--no-audit", "--no-fund", "--prefix", system.setup};
  install.insert(install.end(), packages.begin(), packages.end());
  require(install, say, stop);
}

/// Installs the packages and runs the build, which fetches the crates itself.
void install(const System& system, const Say& say, const std::atomic<bool>& stop) {
  for (const auto& [from, packages] : system.packages) {
    if (from == "debian") install_from_debian(packages, say, stop);
    if (from == "pypi") install_from_pypi(system, packages, say, stop);
    if (from == "npm") install_from_npm(system, packages, say, stop);
  }
  if (!system.build.empty()) require(system.build, say, stop);
}

/// The mark of a complete setup. The last step makes it, and where it is the folder is whole.
std::string mark_of(const System& system) { return system.setup + "/complete"; }

bool is_on_path(const std::string& program) {
  if (program.find('/') != program.npos) return ::access(program.c_str(), X_OK) == 0;
  const char* const path = std::getenv("PATH");
  for (std::string_view rest = path == nullptr ? "" : path; !rest.empty();) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (::access(fmt::format("{}/{}", folder, program).c_str(), X_OK) == 0) return true;
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
  }
  return false;
}

}  // namespace

std::string why_absent(const System& system) {
  const bool needs_setup = !system.packages.empty() || !system.build.empty();
  if (needs_setup && !fs::exists(mark_of(system))) return "it is not set up";
  return is_on_path(system.ask.front()) ? "" : fmt::format("there is no program {}", system.ask.front());
}

void set_up(const System& system, const Say& say, const std::atomic<bool>& stop) {
  fs::remove_all(system.setup);
  fs::create_directories(system.setup);
  try {
    install(system, say, stop);
    io::write_file(mark_of(system), system.title + "\n");
  } catch (...) {
    fs::remove_all(system.setup);
    throw;
  }
}

}  // namespace durero::conform
