#include "zed/coq/terms.hpp"

#include <fmt/format.h>

#include "durero/zed/syntax/defect.hpp"
#include "zed/operators.hpp"

namespace durero::zed::coq {
namespace {

Carrier type_of_operation(const std::string& word, const std::vector<Expr>& of) {
  const auto part = [&](std::size_t i) {
    const Carrier& pair = of[0].type.element();
    return pair.parts.size() == 2 ? pair.parts[i] : Carrier();
  };
  if (word == "dom") return Carrier::set(part(0));
  if (word == "ran" || word == "_⦇_⦈") return Carrier::set(part(1));
  if (word == "_∼") return Carrier::set(Carrier::product({part(1), part(0)}));
  if (word == "_⩤_" || word == "_◁_") return of[1].type;
  return of[0].type;
}

/// The function of Coq that decides an order of the reals; empty for another relation.
std::string_view decision(std::string_view relation) {
  if (relation == "_≤_") return "Rle_dec";
  if (relation == "_<_") return "Rlt_dec";
  if (relation == "_≥_") return "Rge_dec";
  if (relation == "_>_") return "Rgt_dec";
  return {};
}

}  // namespace

void uncovered(Place place, const std::string& what) {
  throw ZError(place, what + " has no rule of translation to Coq",
               "expected one that the head of the exported file names");
}

std::string Carrier::text(bool argument) const {
  std::string out = name;
  if (form == Form::set) {
    const Carrier& of = parts[0];
    out = of.form == Form::product && of.parts.size() == 2
              ? "rel " + of.parts[0].text(true) + " " + of.parts[1].text(true)
              : "set " + of.text(true);
  } else if (form == Form::product) {
    out.clear();
    for (const Carrier& part : parts) out += (out.empty() ? "" : " * ") + part.text(part.form == Form::product);
  }
  return argument && form != Form::named ? "(" + out + ")" : out;
}

const Carrier& Carrier::element() const {
  static const Carrier none;
  return form == Form::set ? parts[0] : none;
}

std::string Translator::fresh(const std::string& stem, const CoqScope& scope) const {
  for (int i = 1;; ++i) {
    std::string name = stem + std::to_string(i);
    if (!scope.variables.contains(name) && !symbols.contains(Name{name, {}})) return name;
  }
}

const CoqSymbol* Translator::find(const Name& name) const {
  const auto entry = symbols.find(name);
  return entry == symbols.end() ? nullptr : &entry->second;
}

bool Translator::is_set(const Term& term) const {
  const auto type = typing_.type_of(term);
  return type && type->is(Type::Kind::power);
}

Expr Translator::term(const Term& term, CoqScope& scope, Frame& frame) const {
  const Node& node = *term;
  switch (node.kind) {
    case Kind::reference:
      return reference(node, scope, frame);
    case Kind::number:
      return {node.name.word, atomic, Carrier::named("R")};
    case Kind::application:
      return application(node, scope, frame);
    case Kind::power:
      return {"ℙ " + this->term(node.children[0], scope, frame).at(applied), applied + 20,
              Carrier::set(Carrier::set(carrier(node.children[0], scope)))};
    case Kind::product:
      return product(term, scope, frame);
    case Kind::theta: {
      const auto entry = scope.states.find({node.children[0]->name.word, node.name.strokes});
      if (node.children[0]->kind != Kind::reference || entry == scope.states.end()) uncovered(node.place, "this θ");
      return entry->second;
    }
    case Kind::selection:
      return selection(node, scope, frame);
    case Kind::tuple:
      return tuple(node, scope, frame);
    case Kind::set_extension:
      return set_extension(node, scope, frame);
    case Kind::comprehension:
      return comprehension(node, scope);
    case Kind::conditional:
      return is_set(term) ? conditional_set(term, scope) : conditional_number(node, scope, frame);
    case Kind::mu:
      return apply_partial(node, nullptr, scope, frame);
    default:
      uncovered(node.place, "this expression");
  }
}

Expr Translator::selection(const Node& node, CoqScope& scope, Frame& frame) const {
  const Expr of = term(node.children[0], scope, frame);
  if (const CoqSymbol* schema = find({of.type.name, {}}))
    for (const Slot& slot : schema->signature)
      if (slot.name == node.name) return {slot.variable + " " + of.at(applied - 1), applied, slot.type};
  uncovered(node.place, "this selection");
}

Expr Translator::tuple(const Node& node, CoqScope& scope, Frame& frame) const {
  Expr out{"(", atomic, Carrier::product({})};
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Expr part = term(node.children[i], scope, frame);
    out.text += (i == 0 ? "" : ", ") + part.at(both - 1);
    out.type.parts.push_back(part.type);
  }
  out.text += ")";
  return out;
}

Expr Translator::set_extension(const Node& node, CoqScope& scope, Frame& frame) const {
  Expr out{"∅", atomic, Carrier::set({})};
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Expr operand = term(node.children[i], scope, frame);
    const std::string single = "⦃" + operand.text + "⦄";
    out = {i == 0 ? single : out.text + " ∪ " + single, i == 0 ? atomic : plus, Carrier::set(operand.type)};
  }
  return out;
}

Expr Translator::product(const Term& product, CoqScope& scope, Frame& frame) const {
  const Carrier of = Carrier::set(carrier(product, scope));
  if (whole(product)) return {"univ", atomic, of};
  if (product->children.size() != 2) uncovered(product->place, "a product of several parts of types");
  const Expr left = term(product->children[0], scope, frame), right = term(product->children[1], scope, frame);
  return {fmt::format("cartesian {} {}", left.at(applied - 1), right.at(applied - 1)), applied, of};
}

/// A conditional on how two reals compare, which Coq decides, is a number where both branches are.
Expr Translator::conditional_number(const Node& node, CoqScope& scope, Frame& frame) const {
  const Node& condition = *node.children[0];
  const std::string_view decided =
      condition.kind == Kind::relation && condition.names.size() == 1 ? decision(condition.names[0].word) : "";
  if (decided.empty()) uncovered(node.place, "a conditional inside a term on more than how two numbers compare");
  const Expr a = term(condition.children[0], scope, frame), b = term(condition.children[1], scope, frame);
  const Expr yes = term(node.children[1], scope, frame), no = term(node.children[2], scope, frame);
  if (yes.type.text() != "R") uncovered(node.place, "a conditional inside a term that is no number");
  return {fmt::format("if {} {} {} then {} else {}", decided, a.at(applied - 1), b.at(applied - 1), yes.text, no.text),
          binder, yes.type};
}

/// A conditional whose branches are sets is the set of what is in the branch that is meant.
Expr Translator::conditional_set(const Term& conditional, const CoqScope& scope) const {
  const std::string x = fresh("x", scope);
  CoqScope inside = scope;
  inside.variables.insert(x);
  Frame unused;
  CoqScope branch = scope;
  const Carrier type = term(conditional->children[1], branch, unused).type;
  return {"fun " + x + " => " + member({x, atomic, type.element()}, conditional, inside).text, binder, type};
}

Expr Translator::reference(const Node& node, CoqScope& scope, Frame& frame) const {
  if (const auto entry = scope.names.find(node.name); entry != scope.names.end()) return entry->second;
  if (node.name.word == "∅") return {"∅", atomic, Carrier::set({})};
  const OperatorRow* row = operator_row(node.name.word);
  if (row && !row->coq.graph.empty()) {
    const Carrier real = Carrier::named("R");
    return {fmt::format("graph {}", row->coq.graph), applied,
            Carrier::set(Carrier::product({Carrier::product({real, real}), real}))};
  }
  if (row && row->binding.role == Role::generic && row->coq.level > 0) {
    std::vector<Expr> of;
    of.reserve(node.children.size());
    for (const Term& child : node.children) of.push_back(term(child, scope, frame));
    const CoqNotation& by = row->coq;
    if (of.size() == 1) return {fmt::format("{} {}", by.text, of[0].at(applied)), by.level, Carrier::set(of[0].type)};
    return {fmt::format("{} {} {}", of[0].at(plus), by.text, of[1].at(plus)), by.level,
            Carrier::set(Carrier::set(Carrier::product({of[0].type.element(), of[1].type.element()})))};
  }
  const CoqSymbol* symbol = find(node.name);
  if (!symbol) uncovered(node.place, "the name " + node.name.text());
  if (symbol->form == CoqSymbol::Form::carrier)
    return {symbol->ok.empty() ? "univ" : symbol->ok, atomic, Carrier::set(symbol->type)};
  if (symbol->form != CoqSymbol::Form::value) uncovered(node.place, "the function " + node.name.text() + " as a value");
  return {symbol->text, atomic, symbol->type};
}

Expr Translator::application(const Node& node, CoqScope& scope, Frame& frame) const {
  const Node& function = *node.children[0];
  const Name& name = function.name;
  if (function.kind == Kind::reference && !scope.names.contains(name)) {
    const CoqSymbol* symbol = find(name);
    if (symbol && symbol->form == CoqSymbol::Form::function) {
      Expr out{symbol->text, applied, symbol->type};
      for (const Term& part : split(node.children[1], symbol->arity))
        out.text += " " + term(part, scope, frame).at(applied - 1);
      return out;
    }
    if (!symbol) {
      const std::size_t operands = name.word.starts_with("_") ? 2 : 1;
      return operation(name.word, split(node.children[1], operands), scope, frame, node);
    }
  }
  return apply_partial(node, nullptr, scope, frame);
}

Expr Translator::operation(const std::string& word, const std::vector<Term>& arguments, CoqScope& scope, Frame& frame,
                           const Node& node) const {
  if (word == "⋃") return generalized_union(arguments[0], scope, frame);
  std::vector<Expr> of;
  of.reserve(arguments.size());
  for (const Term& part : arguments) of.push_back(term(part, scope, frame));
  if (word == "_↦_")
    return {"(" + of[0].at(both - 1) + ", " + of[1].at(both - 1) + ")", atomic,
            Carrier::product({of[0].type, of[1].type})};
  const OperatorRow* row = operator_row(word);
  if (!row || row->coq.text.empty()) uncovered(node.place, "the operation " + word);
  const CoqNotation& by = row->coq;
  if (by.level > 0 && of.size() != 2) uncovered(node.place, "this " + word);
  if (by.level > 0)
    return {fmt::format("{} {} {}", of[0].at(by.level), by.text, of[1].at(by.level - 1)), by.level,
            type_of_operation(word, of)};
  Expr out{std::string(by.text), applied, type_of_operation(word, of)};
  for (const Expr& argument : of) out.text += " " + argument.at(applied - 1);
  return out;
}

}  // namespace durero::zed::coq
