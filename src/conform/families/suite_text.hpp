#pragma once
/// The texts of a suite's files.

#include <string>
#include <vector>

#include "durero/conform/families/suite.hpp"
#include "durero/conform/families/suite_file.hpp"

namespace durero::conform {

/// The endings of the names of a case's files: the files that hold it, then the files that follow from these.
inline constexpr std::string_view scene_ending = ".scene.json";
inline constexpr std::string_view rays_ending = ".rays.txt";
inline constexpr std::string_view sidecar_ending = ".case.json";
inline constexpr std::string_view ranges_ending = ".ranges.txt";

struct File {
  std::string_view ending;
  std::string text;
};

/// Every file of an answered case; `counted` are the counts of its rays.
std::vector<File> case_files(const SuiteCase& of, const Count& counted);

/// The text of suite.json.
std::string suite_text(const SuiteOptions& options, const std::vector<FamilySummary>& families);

/// The summary of one case, to be added to that of its family. Precondition: the case was answered.
FamilySummary summary(const SuiteCase& of);

}  // namespace durero::conform
