#pragma once
/// The names that are declared, for the message about one that is not: which of them may be meant.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace durero::zed {

/// Names as their texts. A name that is looked for again is found at once.
class KnownNames {
 public:
  explicit KnownNames(std::vector<std::string> names);

  /// The first name, in the order of texts, that is this word with strokes behind it.
  std::optional<std::string> with_strokes(std::string_view word) const;
  /// The name of which the word is a slip, or whose English it is (text::nearest).
  const std::optional<std::string>& nearest(const std::string& word) const;
  /// Whether the text is a word of a name, of which some have several; and whether it is one of an operator.
  std::optional<bool> is_of_operator(std::string_view text) const;

 private:
  std::vector<std::string> names_;                  // sorted
  std::map<std::string, bool, std::less<>> words_;  // whether each is one of an operator
  mutable std::map<std::string, std::optional<std::string>> found_;
};

/// Names what may be meant of two lists together: a name that is the word with strokes, or one that it is a slip of.
std::optional<std::string> with_strokes(std::string_view word, const KnownNames& a, const KnownNames& b);
/// The nearest of both lists.
std::optional<std::string> nearest(const std::string& word, const KnownNames& a, const KnownNames& b);
/// Returns the word as two or three words of these names with blanks between them, which LaTeX mark-up joins, or as an
/// operator and a numeral; nothing where it is not made of such.
std::string taken_apart(std::string_view word, const KnownNames& a, const KnownNames& b, int most = 3);

}  // namespace durero::zed
