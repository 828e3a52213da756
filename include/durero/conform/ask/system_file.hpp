#pragma once
/// A system's file describes it: systems/FOLDER/NAME.json, beside the program that asks the system.
///
///   {"format":"durero-system","version":1,"system":"embree","title":"Embree 3",
///    "install":{"debian":["libembree-dev"]},
///    "build":["c++","-O2","-o","{out}","{here}/ask.cpp","-lembree3"],
///    "ask":["{out}"],
///    "profile":{"format":"binary32","tipos":["esfera"],"caps":"open","measure":"parameter","directions":"any",
///               "inside":"exit_point","names_elements":true,"greatest_coordinate":1e18},
///    "sources":[{"claim":"directions","sentence":"…","place":"rtcore_ray.h"}],
///    "reproduce":{"program":"reproduce.cpp.in","words":{"flags":"0"},
///                 "run":[["c++","-o","{built}","{program}","-lembree3"],["{built}"]]},
///    "known":[{"verdicts":["misplaced"],"types":["tronco"],"families":["generic"],"cause":"…"}]}
///
/// {here} is the folder of the file; {setup} the folder that `durero conform setup` fills; {out} is {setup}/ask;
/// {python} is {setup}/venv/bin/python, or python3 where nothing is installed from PyPI; {durero} is this program. In a
/// reproducer's commands (reproducer.hpp), {program} is the program and {built} the place for its build.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// A program and its arguments, word by word: no shell reads them.
using Command = std::vector<std::string>;

/// The plan by which a reproducer is made and run.
struct ReproducerPlan {
  std::string program{};                       ///< its template, NAME.in; empty: there is none
  std::map<std::string, std::string> words{};  ///< further names of the template, with their texts
  std::vector<Command> run{};  ///< the commands, one after the other; {program} and {built} are not filled in
};

/// A failure that is known, and its cause.
struct KnownCause {
  std::vector<std::string> verdicts;    ///< the names of the verdicts that it causes
  std::vector<std::string> tipos{};     ///< the types of which an element must be; none: any
  std::vector<std::string> families{};  ///< none: any
  std::string cause;                    ///< in sentences, as bug reports say it
};

/// A system, and how it is installed, built and asked. Commands have their places filled in.
struct System {
  std::string name;                                            ///< the name of its file, as commands and reports use it
  std::string title;                                           ///< its title for people, such as "Embree 3"
  std::map<std::string, std::vector<std::string>> packages{};  ///< by their source: debian, pypi, crates, npm
  Command build{};                  ///< the command that builds its asker; empty where nothing is built
  Command ask;                      ///< the command that answers questions at its standard input (question.hpp)
  Profile profile;                  ///< its claims, with the places in its documentation
  std::string folder;               ///< the folder of the file, {here}
  std::string setup;                ///< the folder that `durero conform setup` fills, {setup}
  ReproducerPlan reproducer{};      ///< without a template where the file has none
  std::vector<KnownCause> known{};  ///< the first that fits a failure is its cause (known_cause)
};

/// The command with each {NAME} of `places` replaced by its text.
Command filled_in(Command command, const std::map<std::string, std::string>& places);

/// The sources of packages, in the order in which they are installed.
inline constexpr std::string_view package_sources[] = {"debian", "pypi", "crates", "npm"};

/// Reads a system's file; its name is that of the file. `setups` is the folder of all setups. Throws io::InputError.
System read_system(const io::Source& source, const std::string& setups);

/// Every system of a folder, by name. Throws std::runtime_error where it is no folder, and where two files have a name.
std::map<std::string, std::string> system_files(const std::string& systems);

/// The folder of systems: the one that the variable DURERO_SYSTEMS names; otherwise the one installed with the running
/// program; otherwise the one of its sources, which the folder of its build links to as `systems`. Where there is none,
/// the place where the installed one would be.
std::string default_systems();
/// The folder of setups: $XDG_CACHE_HOME/durero/systems, by default in ~/.cache.
std::string default_setups();

/// The system of that name. Throws std::runtime_error where the folder has none of it.
System find_system(std::string_view name, const std::string& systems, const std::string& setups);

/// The profile of a system of the folder, or of a file: a system's, or a profile alone,
/// {"format":"durero-profile","version":1,"system":NAME,"profile":{…},"sources":[…]}.
Profile read_profile(const std::string& name_or_file, const std::string& systems);
/// Checks that the profile claims the question. Throws std::runtime_error.
void require_claimed(const Profile& profile, QuestionKind question);
/// The profile of such a file. Throws io::InputError.
Profile read_profile(const io::Source& source);

}  // namespace durero::conform
