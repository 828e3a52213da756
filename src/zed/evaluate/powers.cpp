#include "zed/evaluate/powers.hpp"

#include <algorithm>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

bool is_number(const Term& term, std::string_view digits) {
  return term->kind == Kind::number && term->name.word == digits;
}

bool is_variable(const Term& term) { return term->kind == Kind::reference && term->children.empty(); }

/// Returns (x, a) of `f(x, a)`, or null.
const Node* arguments(const Name& f, const Term& term) {
  const Node* application = match::application_of_name(term);
  if (!application || application->children[0]->name != f) return nullptr;
  const Term& pair = application->children[1];
  return pair->kind == Kind::tuple && pair->children.size() == 2 ? pair.get() : nullptr;
}

enum class Law { none, to_zero, to_one, of_one, exponents_add };

Law law(const Name& f, const Term& equation) {
  if (!match::is_equation(equation)) return Law::none;
  const Term& right = equation->children[1];
  const Node* left = arguments(f, equation->children[0]);
  if (!left) return Law::none;
  const Term &x = left->children[0], &a = left->children[1];
  if (is_number(x, "1")) return is_variable(a) && is_number(right, "1") ? Law::of_one : Law::none;
  if (!is_variable(x)) return Law::none;
  if (is_number(a, "0")) return is_number(right, "1") ? Law::to_zero : Law::none;
  if (is_number(a, "1")) return right == x ? Law::to_one : Law::none;
  const Node* sum = match::operands(a, "_+_");
  const Node* product = match::operands(right, "_*_");
  if (!sum || !product) return Law::none;
  const Node *first = arguments(f, product->children[0]), *second = arguments(f, product->children[1]);
  const bool adds = first && second && first->children[0] == x && second->children[0] == x &&
                    first->children[1] == sum->children[0] && second->children[1] == sum->children[1] &&
                    is_variable(sum->children[0]) && is_variable(sum->children[1]) &&
                    !(sum->children[0] == sum->children[1]);
  return adds ? Law::exponents_add : Law::none;
}

void each_conjunct(const Term& term, const std::function<void(const Term&)>& visit) {
  if (term->kind != Kind::conjunction) return visit(term);
  for (const Term& child : term->children) each_conjunct(child, visit);
}

/// Returns S and T where f is declared S × T → U, or null.
const Node* declared_on(const Name& f, const Axiomatic& form) {
  for (const Declaration& declaration : form.text.declarations) {
    if (std::ranges::find(declaration.names, f) == declaration.names.end()) continue;
    const Term& set = declaration.term;
    if (set->kind != Kind::reference || set->name.word != "_→_") return nullptr;
    const Term& from = set->children[0];
    return from->kind == Kind::product && from->children.size() == 2 ? from.get() : nullptr;
  }
  return nullptr;
}

}  // namespace

bool states_power(const Name& f, const Axiomatic& form) {
  if (!declared_on(f, form)) return false;
  std::vector<Law> stated;
  for (const Predicate& predicate : form.text.predicates) {
    if (predicate.term->kind != Kind::forall || !predicate.term->text->predicates.empty()) continue;
    each_conjunct(predicate.term->children[0], [&](const Term& conjunct) { stated.push_back(law(f, conjunct)); });
  }
  return std::ranges::all_of(std::vector{Law::to_zero, Law::to_one, Law::of_one, Law::exponents_add},
                             [&](Law each) { return std::ranges::find(stated, each) != stated.end(); });
}

Term power_head(const Name& f, const Axiomatic& form) {
  const Node* sets = declared_on(f, form);
  const Name x{"x", ""}, a{"a", ""};
  SchemaText text;
  text.declarations.push_back({Declaration::Form::typed, {x}, {Place{}}, sets->children[0], {}});
  text.declarations.push_back({Declaration::Form::typed, {a}, {Place{}}, sets->children[1], {}});
  const Term pair = node(Kind::tuple, {reference(x), reference(a)});
  const Term equation = relation({Name{"_=_", ""}}, {apply(reference(f), pair), pair});
  return quantified(Kind::forall, std::move(text), {equation});
}

}  // namespace durero::zed
