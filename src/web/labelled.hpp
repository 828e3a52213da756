#pragma once
/// The lines of a paragraph: its declarations and predicates, each on one line in Unicode, with its label.

#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::web {

/// A declaration or a predicate, or a paragraph that has neither.
struct LabelledLine {
  std::string text;       ///< in Unicode
  std::string label{};    ///< empty where it has none
  zed::Place place{};     ///< in its file
  bool declares = false;  ///< it is a declaration
};

/// The lines of a paragraph, in the order of the text.
std::vector<LabelledLine> lines_of(const zed::Paragraph& paragraph);

/// The word of its notation: `given`, `free`, `definition`, `axiom`, `generic`, `schema` or `conjecture`.
std::string_view kind_of(const zed::Paragraph& paragraph);

}  // namespace durero::web
