#pragma once
/// The systems that a call names.

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "progress.hpp"

namespace durero::cli {

/// A system by its name, by its file (a word that ends in .json or has a slash), or by command:PROGRAM, whose profile
/// is that of a system or a file. Throws std::runtime_error where there is no such system.
conform::System system_of(const std::string& name, const std::string& profile, const std::string& systems);

/// One system, as the arguments of a command give it.
struct SystemCall {
  std::string system, profile;
  std::string systems = conform::default_systems();
};

/// Adds the argument SYSTEM and the options --profile and --systems.
void add_system(CLI::App& command, SystemCall& call);
/// The description of the option --profile.
inline constexpr const char* profile_help = "What command:PROGRAM claims: a system's name, or a file";
/// The system of the call. Throws as the other does.
conform::System system_of(const SystemCall& call);
/// Checks that a profile, where one is given, is of use: one of the names is command:PROGRAM, which alone needs one.
/// Throws std::runtime_error.
void require_use_of_profile(std::span<const std::string> names, const std::string& profile);
/// The words that name the same system in another call, as a shell reads them: SYSTEM, and --profile where it is
/// needed.
std::string words_of_system(const std::string& name, const std::string& profile);

/// Checks that the system can be asked. Throws std::runtime_error with the call that sets it up.
void require_present(const conform::System& system);

/// A function that asks as `ask` does, and counts the questions.
conform::Ask counted(conform::Ask ask, Progress& progress);

}  // namespace durero::cli
