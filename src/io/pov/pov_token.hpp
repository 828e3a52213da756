#pragma once
/// The tokens of a POV-Ray text: numbers, names, texts in quotes, signs, and `#` with the name of a directive. Comments
/// are left out.

#include <cstddef>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io {

/// A token, and where it stands. A number that was computed stands where its expression does.
struct PovToken {
  std::string_view text;
  const Source* source;
  std::size_t offset;

  /// Whether it begins as a name does.
  bool is_name() const;
  /// Whether it is a number, without a sign.
  bool is_number() const;
  /// Whether it is the name of a directive, with its sign.
  bool is_directive() const { return text.starts_with('#'); }
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const {
    source->fail(offset, wrong, expected);
  }
};
using PovTokens = std::vector<PovToken>;

/// The tokens of a text, which must outlive them. Throws InputError where a comment or a text in quotes does not end.
PovTokens pov_tokens(const Source& source);

/// The text that stands in quotes.
std::string unquoted_pov_text(std::string_view quoted);

/// The text of the same words with one blank between them, by which texts are compared.
std::string pov_normal_text(std::string_view text);

}  // namespace durero::io
