#include <fmt/format.h>

#include <algorithm>

#include "durero/zed/syntax/defect.hpp"
#include "zed/coq/terms.hpp"
#include "zed/operators.hpp"

namespace durero::zed::coq {
namespace {

/// Returns the relation as Coq writes it, `<=`, or nothing where no rule covers it.
std::string_view coq_symbol(const std::string& relation) {
  const OperatorRow* row = operator_row(relation);
  return row ? row->coq.text : std::string_view();
}

}  // namespace

Expr Translator::predicate(const Term& term, const CoqScope& scope) const {
  const Node& node = *term;
  const auto part = [&](std::size_t i) { return predicate(node.children[i], scope); };
  switch (node.kind) {
    case Kind::truth:
      return {"True", atomic, {}};
    case Kind::falsity:
      return {"False", atomic, {}};
    case Kind::negation:
      return {"~ " + part(0).at(applied), negated, {}};
    case Kind::conjunction:
    case Kind::disjunction: {
      std::vector<Term> terms;
      flatten(node.kind, term, terms);
      std::vector<Expr> parts;
      parts.reserve(terms.size());
      for (const Term& child : terms) parts.push_back(predicate(child, scope));
      return node.kind == Kind::conjunction ? all_of(parts) : any_of(parts);
    }
    case Kind::implication:
      return {part(0).at(implied - 1) + " -> " + part(1).at(implied), implied, {}};
    case Kind::equivalence:
      return {part(0).at(implied - 5) + " <-> " + part(1).at(implied - 5), implied - 4, {}};
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
      return quantified(node, scope);
    case Kind::relation: {
      CoqScope inside = scope;
      Frame frame;
      const Expr body = relation(node, inside, frame, false);
      return framed(frame, body);
    }
    case Kind::reference:
      return call(node.name, scope, node.place);
    case Kind::decoration: {
      const auto name = schema_name(term);
      if (!name) uncovered(node.place, "this decoration");
      return call(*name, scope, node.place);
    }
    case Kind::hiding:
      return without(node.children[0], node.names, scope);
    case Kind::precondition:
      return without(node.children[0], after(node.children[0]), scope);
    case Kind::schema_text: {
      const Signature slots = signature(term);
      return all_of(conditions(*node.text, slots, scope, scope));
    }
    default:
      uncovered(node.place, "this predicate");
  }
}

Expr Translator::quantified(const Node& node, const CoqScope& scope) const {
  CoqScope inside = scope;
  const Signature slots = declare(*node.text, inside);
  std::vector<Expr> conjuncts = included(*node.text, inside);
  std::ranges::move(conditions(*node.text, slots, scope, inside), std::back_inserter(conjuncts));
  const Expr body = predicate(node.children[0], inside);
  if (node.kind == Kind::forall) {
    std::string out = fmt::format("forall {}, ", binders(slots, true));
    for (const Expr& expr : conjuncts) out += expr.at(implied - 1) + " -> ";
    return {out + body.text, binder, {}};
  }
  conjuncts.push_back(body);
  if (node.kind == Kind::exists_one && slots.size() != 1) uncovered(node.place, "∃₁ over several variables");
  return {fmt::format("{} {}, {}", node.kind == Kind::exists ? "exists" : "exists!", binders(slots, true),
                      all_of(conjuncts).text),
          binder,
          {}};
}

// a ≤ b < c is one predicate: the values of partial applications are those of all of it. Where it is `denied`, a = b is
// written as a ≠ b.
Expr Translator::relation(const Node& node, CoqScope& scope, Frame& frame, bool denied) const {
  std::vector<Expr> operands, parts;
  for (std::size_t i = 0; i + 1 < node.children.size(); ++i) operands.push_back(term(node.children[i], scope, frame));
  if (node.names.size() == 2 && !denied) {
    const std::string_view first = coq_symbol(node.names[0].word), second = coq_symbol(node.names[1].word);
    const auto rising = [](std::string_view by) { return by == "<=" || by == "<"; };
    if (rising(first) && rising(second)) {
      const Expr last = term(node.children[2], scope, frame);
      return {fmt::format("{} {} {} {} {}", operands[0].at(plus), first, operands[1].at(plus), second, last.at(plus)),
              related,
              {}};
    }
  }
  for (std::size_t i = 0; i < node.names.size(); ++i) {
    Name by = node.names[i];
    if (denied && node.names.size() == 1) {
      if (by.word == "_=_" || by.word == "_∈_")
        by.word = operator_row(by.word)->opposite;
      else
        return {"~ " + one_relation(by, node.children[i], node.children[i + 1], operands[i], scope, frame).at(applied),
                negated,
                {}};
    }
    parts.push_back(one_relation(by, node.children[i], node.children[i + 1], operands[i], scope, frame));
  }
  const Expr conjunction = all_of(parts);
  return denied && node.names.size() > 1 ? Expr{"~ " + conjunction.at(applied), negated, {}} : conjunction;
}

Expr Translator::one_relation(const Name& by, const Term& left, const Term& right, const Expr& a, CoqScope& scope,
                              Frame& frame) const {
  const std::string& word = by.word;
  const auto against = [&](std::string_view symbol) {
    return Expr{
        fmt::format("{} {} {}", a.at(related - 1), symbol, term(right, scope, frame).at(related - 1)), related, {}};
  };
  const bool sets = is_set(left);
  if (word == "_≠_" && sets) return {"~ " + against(operator_row("_=_")->coq.of_sets).at(applied), negated, {}};
  if (const CoqSymbol* set = right->kind == Kind::reference && left->kind == Kind::tuple ? find(right->name) : nullptr;
      set && set->form == CoqSymbol::Form::operation) {
    // (a, b) ∈ S, where S is { D | P } of several: a predicate on its arguments.
    Expr holds{set->text, applied, {}};
    for (const Term& part : left->children) holds.text += " " + term(part, scope, frame).at(applied - 1);
    if (word == "_∈_") return holds;
    if (word == "_∉_") return {"~ " + holds.at(applied), negated, {}};
  }
  if (word == "_∈_" && whole(right)) {
    // To be in a whole type is to have a value.
    const std::string c = fresh("c", scope);
    return {fmt::format("exists {} : {}, {} = {}", c, carrier(right).text(), c, a.at(related - 1)), binder, {}};
  }
  const OperatorRow* row = operator_row(word);
  if (!row || row->coq.text.empty()) uncovered(left->place, "the relation " + word);
  return against(sets && !row->coq.of_sets.empty() ? row->coq.of_sets : row->coq.text);
}

std::vector<Expr> Translator::constraint(const Expr& x, const Term& set, const CoqScope& scope) const {
  if (whole(set)) return {};
  return {member(x, set, scope)};
}

Expr Translator::member(const Expr& x, const Term& set, const CoqScope& scope) const {
  if (set->kind == Kind::conditional)
    return conditional(*set, scope,
                       [&](const Term& branch, const CoqScope& inside) { return member(x, branch, inside); });
  if (set->kind == Kind::comprehension && set->children.empty()) {
    CoqScope inside = scope;
    Signature slots = declare(*set->text, inside);
    if (slots.size() == 1) {
      inside.names[slots[0].name] = {x.text, x.level, slots[0].type};
      slots[0].variable = x.text;
      return all_of(conditions(*set->text, slots, scope, inside));
    }
  }
  if (set->kind == Kind::reference && set->name.word == "ℙ₁_") {
    if (!whole(set->children[0])) uncovered(set->place, "ℙ₁ of a part of a type");
    const std::string c = fresh("x", scope);
    return {fmt::format("exists {}, {} ∈ {}", c, c, x.at(related - 1)), binder, {}};
  }
  CoqScope inside = scope;
  Frame frame;
  const Expr in = term(set, inside, frame);
  return framed(frame, {fmt::format("{} ∈ {}", x.at(related - 1), in.at(related - 1)), related, {}});
}

Expr Translator::is_value(const Expr& y, const Term& value, const CoqScope& scope) const {
  if (value->kind == Kind::conditional)
    return conditional(*value, scope,
                       [&](const Term& branch, const CoqScope& inside) { return is_value(y, branch, inside); });
  CoqScope inside = scope;
  Frame frame;
  if (is_partial(*value, scope)) {
    const Expr is = apply_partial(*value, &y, inside, frame);
    return framed(frame, is);
  }
  const Expr right = term(value, inside, frame);
  return framed(frame,
                {fmt::format("{} {} {}", y.text, is_set(value) ? "≡" : "=", right.at(related - 1)), related, {}});
}

// Either the condition holds and the first is meant, or it does not and the second is. The values of partial
// applications in the condition are known in both.
Expr Translator::conditional(const Node& node, const CoqScope& scope,
                             const std::function<Expr(const Term&, const CoqScope&)>& leaf) const {
  CoqScope inside = scope;
  Frame frame;
  const Term& condition = node.children[0];
  Expr yes, no;
  if (condition->kind == Kind::relation) {
    yes = relation(*condition, inside, frame, false);
    no = relation(*condition, inside, frame, true);
  } else {
    yes = predicate(condition, scope);
    no = {"~ " + yes.at(applied), negated, {}};
  }
  const Expr first = all_of({yes, leaf(node.children[1], inside)});
  const Expr second = all_of({no, leaf(node.children[2], inside)});
  const Expr both_ways{"(" + first.text + ") \\/ (" + second.text + ")", either, {}};
  return framed(frame, both_ways);
}

}  // namespace durero::zed::coq
