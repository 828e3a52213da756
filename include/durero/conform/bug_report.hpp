#pragma once
/// A failure of a system as one would file it with its authors, in Markdown.

#include "durero/conform/reproducer.hpp"
#include "durero/conform/variations.hpp"

namespace durero::conform {

/// What the report of one failure is made of.
struct BugReport {
  System system{};                      ///< the one that fails
  std::string version{};                ///< as the system says it
  std::string asker{};                  ///< the program that asked it, as "durero 0.1.0"
  std::string call{};                   ///< the call of this program that asks it again
  LeastFinding least{};                 ///< the failure, made as small as it stays one
  std::vector<Variation> variations{};  ///< of its question, with what the system answers to them
  std::string file{};                   ///< the name of the reproducer's file; empty: there is none
  std::string program{};                ///< the reproducer
  Reproduction reproduction{};          ///< what the reproducer wrote when it was run
};

/// "Embree 3.13.5: far root"
std::string bug_title(const BugReport& bug);

/// The cause, where the system's file knows it; otherwise empty.
std::string known_cause(const BugReport& bug);

/// What the reproducer says of itself (reproducer.hpp): title, expected, got, the exact answer.
std::string about_bug(const BugReport& bug);

/// The report: what, expected, got, cause, versions, the question in decimal and hexadecimal, the exact answer, data
/// that would explain it, and the reproducer: itself, or where `is_beside` the name of its file.
std::string bug_text(const BugReport& bug, bool is_beside);

}  // namespace durero::conform
