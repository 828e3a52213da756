#pragma once
/// Each pattern of the syntax tree has one place here: it says what a term is, or gives its parts where it is of that
/// form.

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed::match {

/// Says whether a term is this name, with or without actuals.
inline bool is_reference(const Term& term, const Name& name) {
  return term->kind == Kind::reference && term->name == name;
}

/// Says whether a term is `a op b`, one relation between two operands.
inline bool is_relation(const Term& term, std::string_view word) {
  return term->kind == Kind::relation && term->children.size() == 2 && term->names[0].word == word;
}

/// Says whether a term is a = b.
inline bool is_equation(const Term& term) { return is_relation(term, "_=_"); }

/// Returns the application where a term is `f x` for a name f, or null.
inline const Node* application_of_name(const Term& term) {
  return term->kind == Kind::application && term->children[0]->kind == Kind::reference ? term.get() : nullptr;
}

/// Returns x of `f x` where f is this word, such as `dom`, or null.
inline const Term* argument_of(const Term& term, std::string_view word) {
  const Node* application = application_of_name(term);
  return application && application->children[0]->name.word == word ? &application->children[1] : nullptr;
}

/// Returns the pair (a, b) of `a op b` where op is this word, such as `_∪_`, or null.
inline const Node* operands(const Term& term, std::string_view word) {
  const Term* argument = argument_of(term, word);
  return argument && (*argument)->kind == Kind::tuple && (*argument)->children.size() == 2 ? argument->get() : nullptr;
}

/// Returns the strokes of an included schema which its characteristic tuple takes off: that of S ′ is θ S ′, a binding
/// of the components of S (ISO/IEC 13568, 9.2).
std::string characteristic_strokes(const Term& included);

/// Calls `visit` for every name that a term mentions, free or bound; the components behind a θ are left out.
void each_name(const Term& term, const std::function<void(const Name&)>& visit);

/// Says whether a term refers to one of the names, free or bound.
bool mentions(const Term& term, const std::set<Name>& names);

/// Returns the comprehension among two sets of which the other is written ∅ or {}; null where they are not such. A name
/// means what it does in the toolkit if `is_toolkit` says so.
const Term* comprehension_beside_empty(const Term& a, const Term& b,
                                       const std::function<bool(const Name&)>& is_toolkit);

}  // namespace durero::zed::match
