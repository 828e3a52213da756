#pragma once
/// A comparison puts several systems side by side on the same rays, from their reports.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/conform/judge/verdict.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// The number of rays of each verdict, by Verdict.
using VerdictCounts = std::array<std::uint64_t, verdict_count>;

/// The numbers of one system in its report (report.json).
struct Summary {
  /// The verdicts on the rays of one family.
  struct OfFamily {
    std::string family;      ///< as Family::name
    VerdictCounts counts{};  ///< of its rays
  };

  std::string system, title, version;               ///< name, title, and version as it says it, which may be empty
  std::uint64_t suite_version = 1;                  ///< of the suite, 1 where the report says none
  std::uint64_t seed = 0, rays = 0;                 ///< of the suite: reports that agree in these have the same rays
  std::string numbers;                              ///< the format of the suite, binary32 or binary64
  std::uint64_t faces = usual_faces;                ///< about so many faces have its meshes
  std::string question{word(QuestionKind::first)};  ///< the word of the question about the rays
  VerdictCounts counts{};                           ///< of the rays of all families
  std::vector<OfFamily> families;                   ///< in the order of the report: those that fail first
};

/// Reads a report. Throws io::InputError.
Summary read_summary(const io::Source& source);

/// The comparison as a table with a row for each system, most gross failures first, and the families in which each
/// fails. Throws std::invalid_argument where two reports are not of the same rays.
std::string comparison_text(std::vector<Summary> systems);
/// The comparison as a table of Markdown. Throws what comparison_text() throws.
std::string comparison_markdown(std::vector<Summary> systems);

/// The history of a system as a table with a row for each report, in their order, such as that of its versions; then,
/// of each report and the one before, the families in which the share of gross failures among the judged rays became
/// less or more. Throws what comparison_text() throws.
std::string history_text(const std::vector<Summary>& versions);

}  // namespace durero::conform
