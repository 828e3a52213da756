#pragma once
/// A defect says what is wrong with a Z text, and where.

#include <stdexcept>
#include <string>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// An error means that the text is refused; a warning means that it is read, and is suspect.
struct Defect {
  enum class Severity { error, warning };
  std::string file;
  Place place;
  std::string what;      ///< this is wrong
  std::string expected;  ///< this is expected instead
  Severity severity = Severity::error;

  /// Returns `FILE:LINE:COLUMN: what is wrong; what is expected`, with `warning: ` after the place of a warning. It is
  /// one line of visible characters, whatever the text holds.
  std::string text() const;
};

/// A ZError is thrown by a step that cannot go on, and caught where the next paragraph begins.
class ZError : public std::runtime_error {
 public:
  ZError(Place where, const std::string& wrong, const std::string& wanted)
      : std::runtime_error(wrong + "; " + wanted), place(where), what_is_wrong(wrong), expected(wanted) {}
  Place place;
  std::string what_is_wrong, expected;

  Defect in(const std::string& file) const { return {file, place, what_is_wrong, expected, Defect::Severity::error}; }
};

}  // namespace durero::zed
