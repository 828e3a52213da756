// Writes sets as predicates: comprehensions, unions, and the types that carry them.
#include <fmt/format.h>

#include "durero/zed/syntax/defect.hpp"
#include "zed/coq/terms.hpp"

namespace durero::zed::coq {

// ⋃ { i : I | P • S } is the union of S over those i.
Expr Translator::generalized_union(const Term& family, CoqScope& scope, Frame&) const {
  if (family->kind != Kind::comprehension || family->children.empty()) uncovered(family->place, "this ⋃");
  CoqScope inside = scope;
  const Signature slots = declare(*family->text, inside);
  if (slots.size() != 1 || slots[0].state) uncovered(family->place, "⋃ over several variables");
  const Expr value = set(family->children[0], inside);
  const std::string index = slots[0].variable;
  Expr over;
  if (family->text->predicates.empty()) {
    over = set(slots[0].set, scope);
  } else {
    over = {"fun " + index + " => " + all_of(conditions(*family->text, slots, scope, inside)).text, binder, {}};
  }
  return {fmt::format("⋃[{}] (fun {} => {})", over.text, index, value.text), plus, value.type};
}

// { x : S | P } is written fun x => x ∈ S /\ P, and { D | P • E } is written fun y => exists D, P /\ y = E.
Expr Translator::comprehension(const Node& node, const CoqScope& scope) const {
  CoqScope inside = scope;
  const Signature slots = declare(*node.text, inside);
  std::vector<Expr> conjuncts = conditions(*node.text, slots, scope, inside);
  const bool has_value = node.kind == Kind::comprehension && !node.children.empty();
  if (!has_value) {
    if (slots.size() != 1) uncovered(node.place, "a set of tuples, inside a term,");
    return {"fun " + slots[0].variable + " => " + all_of(conjuncts).text, binder, Carrier::set(slots[0].type)};
  }
  Frame unused;
  CoqScope copy = inside;
  const Carrier type = term(node.children[0], copy, unused).type;
  const std::string y = fresh("y", inside);
  inside.variables.insert(y);
  conjuncts.push_back(is_value({y, atomic, type}, node.children[0], inside));
  return {fmt::format("fun {} => exists {}, {}", y, binders(slots, true), all_of(conjuncts).text), binder,
          Carrier::set(type)};
}

Expr Translator::set(const Term& set, const CoqScope& scope) const {
  Frame frame;
  CoqScope inside = scope;
  const Expr direct = term(set, inside, frame);
  if (frame.empty()) return direct;
  inside = scope;
  const std::string x = fresh("x", scope);
  inside.variables.insert(x);
  return {"fun " + x + " => " + member({x, atomic, direct.type.element()}, set, inside).text, binder, direct.type};
}

Carrier Translator::carrier(const Term& set, const CoqScope& outer) const {
  CoqScope scope = outer;
  Frame frame;
  if (set->kind == Kind::product) {
    Carrier out = Carrier::product({});
    for (const Term& term : set->children) out.parts.push_back(carrier(term, outer));
    return out;
  }
  if (set->kind == Kind::reference && set->name.word == "_⇸_")
    return Carrier::set(Carrier::product({carrier(set->children[0], outer), carrier(set->children[1], outer)}));
  if (set->kind == Kind::reference && set->name.word == "ℙ₁_") return Carrier::set(carrier(set->children[0], outer));
  return term(set, scope, frame).type.element();
}

bool Translator::whole(const Term& set) const {
  if (set->kind == Kind::power || set->kind == Kind::product) {
    for (const Term& term : set->children)
      if (!whole(term)) return false;
    return true;
  }
  if (set->kind != Kind::reference) return false;
  const CoqSymbol* symbol = find(set->name);
  return symbol && symbol->form == CoqSymbol::Form::carrier && symbol->ok.empty();
}

}  // namespace durero::zed::coq
