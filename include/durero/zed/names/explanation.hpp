#pragma once
/// An explanation says what a name or an expression of a text is: its type, its value, and its declaration.

#include <optional>
#include <string>

#include "durero/zed/names/cross_reference.hpp"

namespace durero::zed {

/// The facts about the name or expression at a place.
struct Explanation {
  std::size_t from = 0, to = 0;  ///< the bytes of its name, or of the sign that makes the expression
  std::string notation;          ///< the name or expression, in Unicode
  std::string type;              ///< in Z notation; empty for a predicate, and where it is not known
  std::string value;             ///< empty where it is not closed, or not found within a few steps
  std::string declaration;       ///< the paragraph that declares the name, in Unicode; empty for a local one
  std::string form;              ///< the kind of the name, such as `schema` or `component`; empty for an expression
};

/// Explains what stands at a byte of a file: a name, or the expression or predicate that an operator, a quantifier or a
/// bracket makes. Nothing where neither is there. A value is that of a closed term in a text without errors, for which
/// no constant took a value, and which 50000 steps of evaluation find.
std::optional<Explanation> explanation(const CheckedTexts& of, const CrossReference& names, const std::string& file,
                                       std::size_t byte);

}  // namespace durero::zed
