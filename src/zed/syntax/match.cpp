#include "zed/syntax/match.hpp"

#include <algorithm>

namespace durero::zed::match {

std::string characteristic_strokes(const Term& included) {
  if (included->kind != Kind::decoration) return {};
  return characteristic_strokes(included->children[0]) + included->name.strokes;
}

void each_name(const Term& term, const std::function<void(const Name&)>& visit) {
  if (term->kind == Kind::reference) visit(term->name);
  for (const Term& child : term->children) each_name(child, visit);
  if (!term->text) return;
  for (const Declaration& declaration : term->text->declarations) {
    for (const Name& name : declaration.names) visit(name);
    each_name(declaration.term, visit);
  }
  for (const Predicate& predicate : term->text->predicates) each_name(predicate.term, visit);
}

namespace {

bool text_mentions(const SchemaText& text, const std::set<Name>& names) {
  return std::any_of(text.declarations.begin(), text.declarations.end(),
                     [&](const Declaration& declaration) { return mentions(declaration.term, names); }) ||
         std::any_of(text.predicates.begin(), text.predicates.end(),
                     [&](const Predicate& predicate) { return mentions(predicate.term, names); });
}

}  // namespace

bool mentions(const Term& term, const std::set<Name>& names) {
  if (term->kind == Kind::reference && names.contains(term->name)) return true;
  if (term->text && text_mentions(*term->text, names)) return true;
  return std::any_of(term->children.begin(), term->children.end(),
                     [&](const Term& child) { return mentions(child, names); });
}

const Term* comprehension_beside_empty(const Term& a, const Term& b,
                                       const std::function<bool(const Name&)>& is_toolkit) {
  const auto is_empty = [&](const Term& term) {
    if (term->kind == Kind::set_extension) return term->children.empty();
    return term->kind == Kind::reference && term->name.text() == "∅" && is_toolkit(term->name);
  };
  const Term* set = is_empty(b) ? &a : is_empty(a) ? &b : nullptr;
  return set && (*set)->kind == Kind::comprehension ? set : nullptr;
}

}  // namespace durero::zed::match
