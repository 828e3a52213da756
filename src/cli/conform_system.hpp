#pragma once
/// The systems that a call names.

#include <string>

#include "durero/conform/runner.hpp"
#include "durero/conform/system_file.hpp"
#include "progress.hpp"

namespace durero::cli {

/// A system by its name, by its file (what ends in .json or has a slash), or command:PROGRAM, whose profile is that of
/// a system or a file. Throws std::runtime_error where there is none such.
conform::System system_of(const std::string& name, const std::string& profile, const std::string& systems);
/// Throws std::runtime_error, with the call that sets it up, where the system cannot be asked.
void require_present(const conform::System& system);

/// Asks as the other does, and counts the questions.
conform::Ask counted(conform::Ask ask, Progress& progress);

}  // namespace durero::cli
