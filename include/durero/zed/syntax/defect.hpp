#pragma once
/// A defect names a fault in a Z text, and its place.

#include <stdexcept>
#include <string>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// An error means that the text is refused. A warning means that it is read, and is suspect; an opinion, that it is Z
/// and that the house would write it in another way.
struct Defect {
  /// The weight of a defect.
  enum class Severity {
    error,    ///< the text is refused
    warning,  ///< the text is read, and is suspect
    opinion   ///< the text is right by ISO Z, and --strict refuses it
  };
  std::string file;                     ///< the file, by the name that it was read under
  Place place;                          ///< it is seen here, in that file
  std::string what;                     ///< this is wrong
  std::string expected;                 ///< this is expected instead
  Severity severity = Severity::error;  ///< all are errors except some of review.hpp

  /// Returns `FILE:LINE:COLUMN: what is wrong; what is expected`, with `warning: ` after the place of a warning and
  /// `opinion: ` after that of an opinion. It is one line of visible characters, whatever the text holds.
  std::string text() const;
};

/// A ZError is thrown by a step that cannot go on, and caught where the next paragraph begins.
class ZError : public std::runtime_error {
 public:
  /// Names the fault at a place of the text, and the expectation there. what() is `wrong; wanted`.
  ZError(Place where, const std::string& wrong, const std::string& wanted)
      : std::runtime_error(wrong + "; " + wanted), place(where), what_is_wrong(wrong), expected(wanted) {}
  Place place;                          ///< it is seen here; the file is not known yet
  std::string what_is_wrong, expected;  ///< Defect::what and Defect::expected

  /// Returns the fault as an error in a file of this name.
  Defect in(const std::string& file) const { return {file, place, what_is_wrong, expected, Defect::Severity::error}; }
};

}  // namespace durero::zed
