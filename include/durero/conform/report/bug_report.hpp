#pragma once
/// A bug report describes a failure of a system to its authors, in Markdown.

#include "durero/conform/judge/variations.hpp"
#include "durero/conform/report/reproducer.hpp"

namespace durero::conform {

/// The contents of the report of one failure.
struct BugReport {
  System system{};                      ///< the system that fails
  std::string version{};                ///< the system's version, as it gives it
  std::string asker{};                  ///< the program that asked it, as "durero 0.1.0"
  std::string call{};                   ///< the call of this program that asks it again
  LeastFinding least{};                 ///< the failure, reduced to its smallest case
  std::vector<Variation> variations{};  ///< the variations of its question, with the system's answers
  std::string file{};                   ///< the name of the reproducer's file; empty where there is none
  std::string program{};                ///< the reproducer
  Reproduction reproduction{};          ///< the output of the reproducer
};

/// The title of the report, such as "Embree 3.13.5: far root".
std::string bug_title(const BugReport& bug);

/// The cause of the failure, where the system's file knows it; otherwise empty.
std::string known_cause(const BugReport& bug);

/// The sentences with which a reproducer describes itself (reproducer.hpp): title, expected, got, the exact answer.
std::string about_bug(const BugReport& bug);

/// The text of the report: title, expected, got, cause, versions, the question in decimal and hexadecimal, the exact
/// answer, data that would explain the answer, and the reproducer itself, or the name of its file where `is_beside`.
std::string bug_text(const BugReport& bug, bool is_beside);

}  // namespace durero::conform
