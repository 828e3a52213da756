#include "zed/evaluate/cases.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

const Name the_argument{"the argument", ""};  // no text can write it

/// A case is an equation for an application, and the schema text that it stands under.
struct ApplicationEquation {
  SchemaText under;
  Term argument, value;
};

Term equation(const Term& a, const Term& b) { return relation({{"_=_", {}}}, {a, b}); }
Term truth_value(bool value) { return number(value ? "1" : "0", {}); }

/// Adds the facts that give a value the form of a pattern, so that equations determine the names in the pattern.
void take_apart(const Term& pattern, const Term& value, std::vector<Predicate>& facts) {
  const auto call = [&](const char* function) { return apply(reference({function, ""}), value); };
  const auto sequence = [](const Term& term) {  // the pairs of ⟨a, b⟩
    const Term* pairs = match::argument_of(term, "⟨,,⟩");
    return pairs && (*pairs)->kind == Kind::set_extension ? pairs->get() : nullptr;
  };
  const auto single = [&](const Term& term) -> const Term* {  // x of ⟨x⟩
    const Node* pairs = sequence(term);
    return pairs && pairs->children.size() == 1 ? &pairs->children[0]->children[1] : nullptr;
  };
  if (const Node* joined = match::operands(pattern, "_⁀_")) {
    const Term &left = joined->children[0], &right = joined->children[1];
    if (const Term* first = single(left)) {
      take_apart(*first, call("head"), facts);
      return take_apart(right, call("tail"), facts);
    }
    if (const Term* last = single(right)) {
      take_apart(*last, call("last"), facts);
      return take_apart(left, call("front"), facts);
    }
  }
  if (const Node* pairs = sequence(pattern); pairs && !pairs->children.empty()) {
    const Term length = number(std::to_string(pairs->children.size()), {});
    facts.push_back({equation(apply(reference({"#_", ""}), value), length), {}, {}});
    for (const Term& pair : pairs->children) take_apart(pair->children[1], apply(value, pair->children[0]), facts);
    return;
  }
  if (pattern->kind != Kind::tuple) return facts.push_back({equation(value, pattern), {}, {}});
  for (std::size_t i = 0; i < pattern->children.size(); ++i) {
    Node part{.kind = Kind::tuple_selection,
              .place = {},
              .name = {std::to_string(i + 1), ""},
              .children = {value},
              .names = {},
              .text = {}};
    take_apart(pattern->children[i], make(std::move(part)), facts);
  }
}

bool declares_nothing(const SchemaText& text) { return text.declarations.empty(); }

/// Says whether an argument is names that D declares, or a tuple of such, each once.
bool is_plain(const Term& argument, const SchemaText& under) {
  const auto declared = [&](const Term& part) {
    if (part->kind == Kind::theta) return part->name.strokes.empty();
    return part->kind == Kind::reference && part->children.empty() &&
           std::any_of(under.declarations.begin(), under.declarations.end(), [&](const Declaration& each) {
             return std::find(each.names.begin(), each.names.end(), part->name) != each.names.end();
           });
  };
  if (argument->kind != Kind::tuple) return declared(argument);
  const auto& parts = argument->children;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!declared(parts[i]) || std::find(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(i), parts[i]) !=
                                   parts.begin() + static_cast<std::ptrdiff_t>(i))
      return false;
  return true;
}

/// Says whether the names of a plain argument are all that D declares: then the clause can stand as in the text.
bool names_all(const Term& argument, const SchemaText& under) {
  std::size_t declared = 0;
  for (const Declaration& each : under.declarations)
    declared += each.form == Declaration::Form::included ? 1 : each.names.size();
  return declared == (argument->kind == Kind::tuple ? argument->children.size() : 1);
}

Term clause(const Name& function, ApplicationEquation each, Place place) {
  const auto all = [&](SchemaText text, const Term& argument, const Term& value) {
    return quantified(Kind::forall, std::move(text), {equation(apply(reference(function), argument), value)}, place);
  };
  if (is_plain(each.argument, each.under) && names_all(each.argument, each.under))
    return all(std::move(each.under), each.argument, each.value);
  const Term argument = reference(the_argument);
  SchemaText one;
  one.declarations.push_back({Declaration::Form::typed, {the_argument}, {Place{}}, reference(any_value), {}});
  take_apart(each.argument, argument, declares_nothing(each.under) ? one.predicates : each.under.predicates);
  if (declares_nothing(each.under)) {
    for (Predicate& guard : each.under.predicates) one.predicates.push_back(std::move(guard));
    return all(std::move(one), argument, each.value);
  }
  one.predicates.push_back({quantified(Kind::exists, each.under, {node(Kind::truth, {})}, place), {}, {}});
  const Term value = quantified(Kind::mu, std::move(each.under), {each.value}, place);
  return all(std::move(one), argument, value);
}

/// Says whether a text inside another declares a name of it again, or may do so.
bool declares_again(const SchemaText& outer, const SchemaText& inner) {
  const auto names_one = [&](const Declaration& declaration) {
    return declaration.form == Declaration::Form::included ||
           std::any_of(declaration.names.begin(), declaration.names.end(), [&](const Name& name) {
             return std::any_of(outer.declarations.begin(), outer.declarations.end(), [&](const Declaration& each) {
               return std::find(each.names.begin(), each.names.end(), name) != each.names.end();
             });
           });
  };
  return !declares_nothing(outer) && std::any_of(inner.declarations.begin(), inner.declarations.end(), names_one);
}

/// Reads a predicate without ∀, ⇒ and ∧ as a case of the name; nothing where it is none.
using Leaf = std::function<std::optional<ApplicationEquation>(const Term&)>;

/// Finds the cases in a predicate. ∀ D • A ⇒ B ∧ C may have one in B and one in C.
void find(const Term& predicate, const SchemaText& under, const Name& name, const Leaf& leaf, Cases& found) {
  if (!match::mentions(predicate, {name})) return;
  const Node& node = *predicate;
  if (node.kind == Kind::conjunction) {
    for (const Term& part : node.children) find(part, under, name, leaf, found);
    return;
  }
  SchemaText inside = under;
  if (node.kind == Kind::implication && !match::mentions(node.children[0], {name})) {
    inside.predicates.push_back({node.children[0], {}, {}});
    return find(node.children[1], inside, name, leaf, found);
  }
  if (node.kind == Kind::forall && !declares_again(under, *node.text)) {
    const auto& text = *node.text;
    inside.declarations.insert(inside.declarations.end(), text.declarations.begin(), text.declarations.end());
    inside.predicates.insert(inside.predicates.end(), text.predicates.begin(), text.predicates.end());
    return find(node.children[0], inside, name, leaf, found);
  }
  if (auto here = leaf(predicate)) {
    here->under = under;
    return found.clauses.push_back(clause(name, std::move(*here), node.place));
  }
  found.all_said = false;
}

Cases cases(const std::vector<Predicate>& predicates, const Name& name, const Leaf& leaf) {
  Cases found;
  for (const Predicate& predicate : predicates) find(predicate.term, {}, name, leaf, found);
  return found;
}

}  // namespace

Cases cases_of_function(const std::vector<Predicate>& predicates, const Name& function) {
  std::vector<Predicate> others;
  for (const Predicate& predicate : predicates) {
    const Term* of =
        match::is_equation(predicate.term) ? match::argument_of(predicate.term->children[0], "dom") : nullptr;
    if (!of || !match::is_reference(*of, function)) others.push_back(predicate);
  }
  return cases(others, function, [&](const Term& term) -> std::optional<ApplicationEquation> {
    if (!match::is_equation(term)) return std::nullopt;
    const Term& left = term->children[0];
    if (left->kind != Kind::application || !match::is_reference(left->children[0], function)) return std::nullopt;
    return ApplicationEquation{{}, left->children[1], term->children[1]};
  });
}

Cases cases_of_set(const std::vector<Predicate>& predicates, const Name& set) {
  /// The operand of x ∈ S, and (x, y) of x S y.
  const auto member = [&](const Term& term) -> std::optional<Term> {
    if (match::is_relation(term, "_∈_") && match::is_reference(term->children[1], set)) return term->children[0];
    if (term->kind == Kind::relation && term->names.size() == 1 && term->names[0] == set)
      return term->children.size() == 1 ? term->children[0] : node(Kind::tuple, term->children);
    return std::nullopt;
  };
  return cases(predicates, set, [&](const Term& term) -> std::optional<ApplicationEquation> {
    if (const auto of = member(term)) return ApplicationEquation{{}, *of, truth_value(true)};
    if (term->kind == Kind::negation)
      if (const auto of = member(term->children[0])) return ApplicationEquation{{}, *of, truth_value(false)};
    if (match::is_relation(term, "_∉_") && match::is_reference(term->children[1], set))
      return ApplicationEquation{{}, term->children[0], truth_value(false)};
    if (term->kind != Kind::equivalence) return std::nullopt;
    const auto of = member(term->children[0]);
    if (!of) return std::nullopt;
    return ApplicationEquation{
        {}, *of, node(Kind::conditional, {term->children[1], truth_value(true), truth_value(false)})};
  });
}

}  // namespace durero::zed
