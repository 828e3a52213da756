#include "zed/print/strength.hpp"

#include <algorithm>

#include "zed/syntax/connectives.hpp"
#include "zed/syntax/match.hpp"

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

std::pair<std::string_view, std::string_view> enclosing_signs(const Node& node) {
  const bool two = node.kind == Kind::application && node.children[0]->children.empty() &&
                   node.children[1]->kind == Kind::tuple && node.children[1]->children.size() == 2;
  if (two && match::is_reference(node.children[0], {"_⦇_⦈", {}})) return {"⦇", "⦈"};
  if (two && match::is_reference(node.children[0], {"_↗_↙", {}})) return {"↗", "↙"};
  return {};
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
  if (const Connective* sign = connective_of(node.kind)) return sign->strength;
  if (quantifier_of(node.kind)) return binding::weakest;
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
      if (node.children[0]->kind == Kind::reference && node.children[0]->name.strokes.empty() &&
          is_prefix_word(node.children[0]->name.word))
        return binding::prefix;
      return enclosing_signs(node).first.empty() ? binding::application : binding::postfix;
    case Kind::schema_text:  // behind a name, its bracket would begin generic actuals
      return binding::application;
    default:
      return binding::primary;
  }
}

bool shows_relation(const Node& node) {
  if (node.kind == Kind::relation) return true;
  return connective_of(node.kind) && strength(node) < binding::relation &&
         std::ranges::any_of(node.children, [](const Term& operand) { return shows_relation(*operand); });
}

}  // namespace durero::zed
