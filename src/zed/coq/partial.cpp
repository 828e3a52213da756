/// Writes partial applications, and μ, as Coq text: a value is asked for by the pairs of its function.
#include <fmt/format.h>

#include "zed/coq/terms.hpp"

namespace durero::zed::coq {

Expr Translator::partial(const std::string& in, const std::string& before, const Carrier& type, CoqScope& scope,
                         Frame& frame) const {
  const std::string key = before + " ∈ " + in;
  auto known = scope.known.find(key);
  if (known == scope.known.end()) {
    const std::string v = fresh("v", scope);
    scope.variables.insert(v);
    known = scope.known.emplace(key, v).first;
    frame.emplace_back(v, (before.empty() ? v : "(" + before + ", " + v + ")") + " ∈ " + in);
  }
  return {known->second, atomic, type};
}

bool Translator::is_partial(const Node& node, const CoqScope& scope) const {
  if (node.kind == Kind::mu) return true;
  if (node.kind != Kind::application) return false;
  const Node& function = *node.children[0];
  if (function.kind != Kind::reference || scope.names.contains(function.name)) return true;
  const CoqSymbol* symbol = find(function.name);
  return symbol && symbol->form != CoqSymbol::Form::function;
}

// The value of a partial application or of a μ is a variable of the frame. Where y is given, the text says that it is
// y.
Expr Translator::apply_partial(const Node& node, const Expr* y, CoqScope& scope, Frame& frame) const {
  std::string in, before;
  Carrier type;
  if (node.kind == Kind::mu) {
    if (!node.children.empty()) uncovered(node.place, "a μ with a value");
    const Expr among = comprehension(node, scope);
    in = "is_mu " + among.at(applied - 1);
    type = among.type.element();
  } else {
    const Node& function = *node.children[0];
    const CoqSymbol* symbol = scope.names.contains(function.name) ? nullptr : find(function.name);
    if (symbol && symbol->form == CoqSymbol::Form::partial) {
      in = symbol->text;
      for (const Term& part : split(node.children[1], symbol->arity))
        in += " " + term(part, scope, frame).at(applied - 1);
      type = symbol->type;
    } else {
      const Expr argument = term(node.children[1], scope, frame);
      const Expr relation = term(node.children[0], scope, frame);
      const Carrier& pair = relation.type.element();
      if (pair.parts.size() != 2) uncovered(node.place, "this application");
      before = argument.at(both - 1);
      in = relation.at(related - 1);
      type = pair.parts[1];
    }
  }
  if (!y) return partial(in, before, type, scope, frame);
  return {(before.empty() ? y->text : "(" + before + ", " + y->text + ")") + " ∈ " + in, related, {}};
}

}  // namespace durero::zed::coq
