#pragma once
/// How single tokens are spelled in either mark-up, and what must stand between two of them.

#include <string>

#include "durero/zed/syntax/markup.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

class Spelling {
 public:
  /// `markup` has the commands beyond the toolkit's, and must outlive this.
  explicit Spelling(const Markup& markup) : markup_(markup) {}

  /// Spells a token in LaTeX mark-up; a `-` that stands behind no operand is the sign \negate.
  std::string latex(const Token& token, bool behind_operand) const;

  /// Spells a token in Unicode.
  static std::string unicode(const Token& token);

  /// Says whether one of the mark-ups would read two tokens otherwise, or they would be hard to read, without a blank
  /// between them. They get one in both, so that the way to the other and back changes nothing.
  bool separates(const Token& left, const Token& right, bool left_negates) const;

  /// Says whether LaTeX mark-up would read two tokens as one across a blank, so that they need a `~` for it.
  bool joins(const Token& left, const Token& right) const;

 private:
  /// Says whether a token is spelled by a command that TeX gives its own space.
  bool is_command(const Token& token) const;

  const Markup& markup_;
};

}  // namespace durero::zed
