#include "durero/conform/ask/system_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "conform/ask/profile_reader.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/file_name.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

namespace fs = std::filesystem;
using io::json::Reader;

enum SystemKey : std::size_t {
  format,
  version,
  system,
  title,
  ask,
  profile,
  install,
  build,
  sources,
  reproduce,
  known
};
constexpr std::string_view keys[] = {"format",  "version", "system",  "title",     "ask",  "profile",
                                     "install", "build",   "sources", "reproduce", "known"};
constexpr std::size_t required = 6;

std::vector<std::string> read_strings(Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  std::vector<std::string> strings;
  in.array(what, [&] { strings.emplace_back(in.string(what)); });
  if (strings.empty()) in.fail(at, fmt::format("{} is empty", what), "expected one string at least");
  return strings;
}

void read_packages(Reader& in, System& read) {
  in.object("install", package_sources, 0, [&](std::size_t key) {
    const std::string_view from = package_sources[key];
    read.packages.emplace(from, read_strings(in, from));
  });
}

void read_name(Reader& in, System& read) { read_exactly(in, "system", read.name); }

/// Reads the plan of a reproducer; the place of its template is filled in after.
void read_reproduction(Reader& in, ReproducerPlan& read) {
  constexpr std::string_view parts[] = {"program", "run", "words"};
  in.object("reproduce", parts, 2, [&](std::size_t key) {
    if (key == 0) read.program = in.string("program");
    if (key == 1) in.array("run", [&] { read.run.push_back(read_strings(in, "a command")); });
    if (key == 2)
      in.members("words", [&](const io::json::Key& word) {
        const std::string name(word.name);
        read.words[name] = in.string(name);
      });
  });
}

KnownCause read_known_cause(Reader& in) {
  constexpr std::string_view parts[] = {"verdicts", "cause", "types", "families"};
  KnownCause read;
  in.object("what is known", parts, 2, [&](std::size_t key) {
    if (key == 0) read.verdicts = read_strings(in, "verdicts");
    if (key == 1) read.cause = in.string("cause");
    if (key == 2) read.tipos = read_strings(in, "types");
    if (key == 3) read.families = read_strings(in, "families");
  });
  return read;
}

void read_part(Reader& in, SystemKey key, System& read) {
  switch (key) {
    case format:
    case version:  // read before all others
      return in.skip();
    case system:
      return read_name(in, read);
    case title:
      read.title = in.string(keys[key]);
      return;
    case ask:
      read.ask = read_strings(in, keys[key]);
      return;
    case profile:
      return read_profile_members(in, read.profile);
    case install:
      return read_packages(in, read);
    case build:
      read.build = read_strings(in, keys[key]);
      return;
    case sources:
      read.profile.sources = read_sources(in);
      return;
    case reproduce:
      return read_reproduction(in, read.reproducer);
    case known:
      in.array(keys[key], [&] { read.known.push_back(read_known_cause(in)); });
  }
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += with.size())
    text.replace(at, what.size(), with);
}

void fill_in_places(System& of) {
  const std::string python = of.packages.contains("pypi") ? of.setup + "/venv/bin/python" : "python3";
  const std::map<std::string, std::string> places = {{"python", python},
                                                     {"out", of.setup + "/ask"},
                                                     {"durero", fs::canonical("/proc/self/exe").string()},
                                                     {"here", of.folder},
                                                     {"setup", of.setup}};
  of.build = filled_in(std::move(of.build), places);
  of.ask = filled_in(std::move(of.ask), places);
  for (Command& command : of.reproducer.run) command = filled_in(std::move(command), places);
  if (!of.reproducer.program.empty()) of.reproducer.program = of.folder + "/" + of.reproducer.program;
}

/// Whether the file is of a system; the folder may hold other JSON files, such as npm's.
bool is_of_system(const io::Source& source) { return source.text().find("\"durero-system\"") != source.text().npos; }
bool is_system_file(const fs::path& path) {
  return path.extension() == ".json" && fs::is_regular_file(path) && is_of_system(io::read_source(path));
}

Profile read_profile_file(const io::Source& source) {
  constexpr std::string_view profile_keys[] = {"format", "version", "system", "profile", "sources"};
  const io::json::Document document(source);
  Reader in(document);
  require_version(in, profile_format);
  Profile read;
  in.object("a profile file", profile_keys, 4, [&](std::size_t key) {
    if (key < 2) in.skip();  // format and version
    if (key == 2) read.system = in.string("system");
    if (key == 3) read_profile_members(in, read);
    if (key == 4) read.sources = read_sources(in);
  });
  return read;
}

}  // namespace

System read_system(const io::Source& source, const std::string& setups) {
  const fs::path path = fs::absolute(source.name()).lexically_normal();
  System read;
  read.name = path.stem();
  read.folder = path.parent_path();
  read.setup = fs::path(setups) / read.name;
  read.profile.system = read.name;
  const io::json::Document document(source);
  Reader in(document);
  require_version(in, system_format);
  in.object("a system", keys, required, [&](std::size_t key) { read_part(in, static_cast<SystemKey>(key), read); });
  fill_in_places(read);
  return read;
}

Command filled_in(Command command, const std::map<std::string, std::string>& places) {
  for (std::string& word : command) {
    for (const auto& [name, place] : places) replace_all(word, "{" + name + "}", place);
  }
  return command;
}

std::map<std::string, std::string> system_files(const std::string& systems) {
  if (!fs::is_directory(systems))
    throw std::runtime_error(fmt::format("{}: no folder; expected one with systems in it", systems));
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& folder : fs::directory_iterator(systems)) {
    if (!folder.is_directory()) continue;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
      if (!is_system_file(file.path())) continue;
      const auto [other, is_new] = files.emplace(file.path().stem(), file.path());
      if (!is_new)
        throw std::runtime_error(fmt::format("{}: its name is also that of {}; expected a name of its own",
                                             file.path().string(), other->second));
    }
  }
  return files;
}

std::string default_systems() {
  if (const char* const named = std::getenv("DURERO_SYSTEMS"); named != nullptr && *named != '\0') return named;
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
  const fs::path installed = (program.parent_path() / DURERO_INSTALLED_SYSTEMS).lexically_normal();
  const fs::path linked = fs::canonical(program / "systems", none);  // empty where there is no link
  return !fs::is_directory(installed, none) && fs::is_directory(linked, none) ? linked : installed;
}

std::string default_setups() {
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && *cache == '/')
    return std::string(cache) + "/durero/systems";  // a relative one is to be ignored
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0')
    throw std::runtime_error("neither XDG_CACHE_HOME nor HOME is set; expected a folder for systems");
  return std::string(home) + "/.cache/durero/systems";
}

System find_system(std::string_view name, const std::string& systems, const std::string& setups) {
  const std::map<std::string, std::string> files = system_files(systems);
  const auto file = files.find(std::string(name));
  if (file != files.end()) return read_system(io::read_source(file->second), setups);
  std::vector<std::string> known;
  for (const auto& [known_name, path] : files) known.push_back(known_name);
  throw std::runtime_error(fmt::format("no system {}; expected {}", text::shown(name), text::expected_of(name, known)));
}

Profile read_profile(const std::string& name_or_file, const std::string& systems) {
  if (name_or_file.find('/') == name_or_file.npos && !io::ends_in(name_or_file, ".json"))
    return find_system(name_or_file, systems, "").profile;
  return read_profile(io::read_source(name_or_file));
}

void require_claimed(const Profile& profile, QuestionKind question) {
  if (std::ranges::find(profile.questions, question) != profile.questions.end()) return;
  throw std::runtime_error(fmt::format("{} does not claim the question {}; expected one of its profile's questions",
                                       profile.system, word(question)));
}

Profile read_profile(const io::Source& source) {
  return is_of_system(source) ? read_system(source, "").profile : read_profile_file(source);
}

}  // namespace durero::conform
