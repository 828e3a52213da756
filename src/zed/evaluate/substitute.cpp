#include "zed/evaluate/substitute.hpp"

#include <algorithm>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

bool any_of_names(const Components& names, const std::map<Name, Term>& by) {
  return std::any_of(names.begin(), names.end(), [&](const Name& name) { return by.contains(name); });
}

/// The names that a term takes from the scope without writing them.
Components implied_names(const Term& term, const Definitions& definitions) {
  if (term->kind == Kind::theta) {
    Components names = components(term->children[0], definitions).value_or(Components{});
    for (Name& name : names) name.strokes += term->name.strokes;
    return names;
  }
  return components(term, definitions).value_or(Components{});
}

class Substitution {
 public:
  Substitution(const std::map<Name, Term>& by, const Definitions& definitions) : by_(by), definitions_(definitions) {}

  std::optional<Term> of(const Term& term) const {
    if (term->kind == Kind::reference && term->children.empty()) {
      if (const auto at = by_.find(term->name); at != by_.end()) return at->second;
    }
    if (any_of_names(implied_names(term, definitions_), by_)) return std::nullopt;
    if (term->text) return bound(term);
    Node node = *term;
    if (!replace(node.children, *this)) return std::nullopt;
    return make(std::move(node));
  }

 private:
  static bool replace(std::vector<Term>& terms, const Substitution& with) {
    for (Term& term : terms) {
      auto now = with.of(term);
      if (!now) return false;
      term = std::move(*now);
    }
    return true;
  }

  /// Substitutes in a term that binds names, which stay as they are.
  std::optional<Term> bound(const Term& term) const {
    Node node = *term;
    SchemaText text = *node.text;
    const Components names = components(text, definitions_);
    std::map<Name, Term> inner_by = by_;
    for (const Name& name : names) inner_by.erase(name);
    for (const auto& [name, value] : inner_by)
      for (const Name& binder : names)
        if (depends_on(value, binder, definitions_) && depends_on(term, name, definitions_)) return std::nullopt;
    const Substitution inner(inner_by, definitions_);
    for (Declaration& declaration : text.declarations) {
      if (declaration.form == Declaration::Form::included && any_of_names(components(declaration, definitions_), by_))
        return std::nullopt;
      auto set = of(declaration.term);
      if (!set) return std::nullopt;
      declaration.term = std::move(*set);
    }
    for (Predicate& predicate : text.predicates) {
      auto now = inner.of(predicate.term);
      if (!now) return std::nullopt;
      predicate.term = std::move(*now);
    }
    node.text = std::make_shared<const SchemaText>(std::move(text));
    if (!replace(node.children, inner)) return std::nullopt;
    return make(std::move(node));
  }

  const std::map<Name, Term>& by_;
  const Definitions& definitions_;
};

}  // namespace

bool depends_on(const Term& term, const Name& name, const Definitions& definitions) {
  if (match::is_reference(term, name)) return true;
  const Components implied = implied_names(term, definitions);
  if (std::find(implied.begin(), implied.end(), name) != implied.end()) return true;
  const auto in = [&](const Term& part) { return depends_on(part, name, definitions); };
  if (term->text) {
    for (const Declaration& declaration : term->text->declarations)
      if (in(declaration.term)) return true;
    for (const Predicate& predicate : term->text->predicates)
      if (in(predicate.term)) return true;
  }
  return std::any_of(term->children.begin(), term->children.end(), in);
}

std::optional<Term> substituted(const Term& term, const std::map<Name, Term>& by, const Definitions& definitions) {
  return Substitution(by, definitions).of(term);
}

}  // namespace durero::zed
