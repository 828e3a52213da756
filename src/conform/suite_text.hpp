#pragma once
/// The files of a suite as texts.

#include <string>
#include <vector>

#include "durero/conform/suite.hpp"
#include "durero/conform/suite_file.hpp"

namespace durero::conform {

/// The ends of the names of a case's files: those that hold it, then those that follow from it.
inline constexpr std::string_view scene_ending = ".scene.json";
inline constexpr std::string_view rays_ending = ".rays.txt";
inline constexpr std::string_view sidecar_ending = ".case.json";

struct File {
  std::string_view ending;
  std::string text;
};

/// Every file of an answered case; `counted` are its rays.
std::vector<File> case_files(const SuiteCase& of, const Count& counted);

/// suite.json
std::string suite_text(const SuiteOptions& options, const std::vector<FamilySummary>& families);

/// What a case adds to the summary of its family. Precondition: the case was answered.
FamilySummary summary(const SuiteCase& of);

}  // namespace durero::conform
