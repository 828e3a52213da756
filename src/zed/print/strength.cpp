#include "zed/print/strength.hpp"

#include <algorithm>

#include "zed/syntax/term_parser.hpp"

namespace durero::zed {

const Operator* operator_of(const Node& node) {
  const bool application = node.kind == Kind::application;
  const Node& named = application ? *node.children[0] : node;
  if (named.kind != Kind::reference || !named.name.strokes.empty()) return nullptr;
  const Operator* op = operator_of_name(named.name.word);
  if (!op || (op->role == Role::generic) == application || op->role == Role::relation) return nullptr;
  if (application && !named.children.empty()) return nullptr;
  const std::size_t operands = op->fixity == Fixity::infix ? 2 : 1;
  if (!application) return node.children.size() == operands ? op : nullptr;
  if (operands == 1) return op;
  const Node& argument = *node.children[1];
  return argument.kind == Kind::tuple && argument.children.size() == 2 ? op : nullptr;
}

bool is_image(const Node& node) {
  return node.kind == Kind::application && node.children[0]->kind == Kind::reference &&
         node.children[0]->name == Name{"_⦇_⦈", {}} && node.children[0]->children.empty() &&
         node.children[1]->kind == Kind::tuple && node.children[1]->children.size() == 2;
}

static constexpr Sign signs[] = {
    {Kind::equivalence, "⇔", binding::equivalence, binding::equivalence, binding::equivalence + 1},
    {Kind::implication, "⇒", binding::implication, binding::implication + 1, binding::implication},
    {Kind::disjunction, "∨", binding::disjunction, binding::disjunction, binding::disjunction + 1},
    {Kind::conjunction, "∧", binding::conjunction, binding::conjunction, binding::conjunction + 1},
    {Kind::composition, "⨟", binding::composition, binding::composition, binding::composition + 1},
    {Kind::piping, "⨠", binding::piping, binding::piping, binding::piping + 1},
    {Kind::projection, "⨡", binding::projection, binding::projection, binding::projection + 1},
    {Kind::negation, "¬", binding::negation, 0, binding::negation},
    {Kind::precondition, "pre", binding::precondition, 0, binding::precondition},
    {Kind::power, "ℙ", binding::prefix, 0, binding::prefix},
};

const Sign* sign_of(Kind kind) {
  const auto* found =
      std::find_if(std::begin(signs), std::end(signs), [kind](const Sign& s) { return s.kind == kind; });
  return found == std::end(signs) ? nullptr : found;
}

bool is_quantifier(Kind kind) {
  return kind == Kind::forall || kind == Kind::exists || kind == Kind::exists_one || kind == Kind::lambda ||
         kind == Kind::mu || kind == Kind::let;
}

int operator_strength(const Operator& op) {
  if (op.fixity == Fixity::prefix) return binding::prefix;
  if (op.fixity == Fixity::postfix) return binding::postfix;
  return binding::infix + op.precedence;
}

const Node* sequence_of(const Node& application) {
  if (application.kind != Kind::application || application.children[0]->kind != Kind::reference) return nullptr;
  if (application.children[0]->name.word != "⟨,,⟩") return nullptr;
  const Node& pairs = *application.children[1];
  return pairs.kind == Kind::set_extension ? &pairs : nullptr;
}

int strength(const Node& node) {
  if (const Sign* sign = sign_of(node.kind)) return sign->strength;
  if (is_quantifier(node.kind)) return binding::weakest;
  if (const Operator* op = operator_of(node)) return operator_strength(*op);
  switch (node.kind) {
    case Kind::relation:
      return binding::relation;
    case Kind::conditional:
      return binding::conditional;
    case Kind::hiding:
      return binding::hiding;
    case Kind::product:
      return binding::infix + product_precedence;
    case Kind::application:
      if (sequence_of(node)) return binding::primary;
      return is_image(node) ? binding::postfix : binding::application;
    case Kind::schema_text:  // behind a name, its bracket would begin generic actuals
      return binding::application;
    default:
      return binding::primary;
  }
}

}  // namespace durero::zed
