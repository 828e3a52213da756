/// The proof obligations of a simulation, as terms of Z.
#include "obligations.hpp"

#include <fmt/format.h>

#include "durero/zed/print/print.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Term;

Term schema_named(const std::string& name) { return zed::reference({name, ""}); }

Term dashed(const Term& schema) {
  zed::Node node;
  node.kind = Kind::decoration;
  node.children = {schema};
  node.name.strokes = "'";
  return zed::make(std::move(node));
}

Term both_hold(const Term& a, const Term& b) { return zed::node(Kind::conjunction, {a, b}); }

Term first_abstract(const Refinement& refinement) {
  const Term init = schema_named(refinement.abstract_init);
  return refinement.abstract_primed ? init : dashed(init);
}

Term first_concrete(const Refinement& refinement) {
  const Term init = schema_named(refinement.concrete_init);
  return refinement.concrete_primed ? init : dashed(init);
}

namespace {

Term pre(const std::string& operation) { return zed::node(Kind::precondition, {schema_named(operation)}); }

zed::Declaration inclusion_of(const Term& schema) { return {zed::Declaration::Form::included, {}, {}, schema, {}}; }

/// ∀ or ∃ of the declarations, where the condition holds; it may be null.
Term over(Kind quantifier, std::vector<zed::Declaration> declarations, const Term& condition, const Term& claim) {
  zed::SchemaText text;
  text.declarations = std::move(declarations);
  if (condition) text.predicates.push_back({condition, "", {}});
  return zed::quantified(quantifier, std::move(text), {claim});
}

/// The terms that the obligations of one refinement are made of.
struct ObligationParts {
  explicit ObligationParts(const Refinement& refinement)
      : of(refinement), a(schema_named(of.abstract)), c(schema_named(of.concrete)), r(schema_named(of.retrieve)) {}
  const Refinement& of;
  Term a, c, r;

  Term total(Kind some) const {
    return over(Kind::forall, {inclusion_of(c)}, {}, over(some, {inclusion_of(a)}, {}, r));
  }

  Term initialisation(bool each) const {
    const Term first = first_abstract(of), begun = first_concrete(of);
    if (each) return over(Kind::forall, {inclusion_of(begun), inclusion_of(dashed(r))}, {}, first);
    const Term some = over(Kind::exists, {inclusion_of(dashed(a))}, {}, both_hold(first, dashed(r)));
    return over(Kind::forall, {inclusion_of(begun)}, {}, some);
  }

  Term forward_applicability(const OperationPair& pair) const {
    return over(Kind::forall, {inclusion_of(r), inclusion_of(pre(pair.abstract))}, {}, pre(pair.concrete));
  }

  Term forward_correctness(const OperationPair& pair, bool functional) const {
    const Term done = schema_named(pair.concrete), allowed = schema_named(pair.abstract);
    if (functional)
      return over(Kind::forall, {inclusion_of(r), inclusion_of(dashed(r)), inclusion_of(done)}, pre(pair.abstract),
                  allowed);
    const Term some = over(Kind::exists, {inclusion_of(dashed(a))}, {}, both_hold(dashed(r), allowed));
    return over(Kind::forall, {inclusion_of(r), inclusion_of(done)}, pre(pair.abstract), some);
  }

  /// Says that every abstract state which the concrete one stands for admits the inputs.
  Term abstract_may(const OperationPair& pair) const {
    return over(Kind::forall, {inclusion_of(a)}, r, pre(pair.abstract));
  }

  Term backward_applicability(const OperationPair& pair) const {
    std::vector<zed::Declaration> declarations{inclusion_of(c)};
    for (const auto& [name, set] : pair.inputs)
      declarations.push_back({zed::Declaration::Form::typed, {name}, {{}}, set, {}});
    return over(Kind::forall, std::move(declarations), abstract_may(pair), pre(pair.concrete));
  }

  Term backward_correctness(const OperationPair& pair) const {
    const Term came = over(Kind::exists, {inclusion_of(a)}, {}, both_hold(r, schema_named(pair.abstract)));
    return over(Kind::forall, {inclusion_of(schema_named(pair.concrete)), inclusion_of(dashed(r))}, abstract_may(pair),
                came);
  }
};

}  // namespace

std::string obligation_word(ObligationKind kind) {
  switch (kind) {
    case ObligationKind::function:
      return "the retrieve schema is a function";
    case ObligationKind::total:
      return "the retrieve schema is total";
    case ObligationKind::initialisation:
      return "initialisation";
    case ObligationKind::applicability:
      return "applicability";
    case ObligationKind::correctness:
      return "correctness";
  }
  return {};
}

std::vector<Obligation> obligations(const Refinement& of, bool functional) {
  const ObligationParts parts(of);
  const std::size_t none = of.operations.size();
  std::vector<Obligation> all;
  const std::string of_retrieve = of.retrieve + ".conj.1";
  if (of.backward) all.push_back({ObligationKind::total, of_retrieve, parts.total(Kind::exists), none});
  if (!of.backward && functional)
    all.push_back({ObligationKind::function, of_retrieve, parts.total(Kind::exists_one), none});
  all.push_back({ObligationKind::initialisation, of.concrete_init + ".conj.1",
                 parts.initialisation(functional || of.backward), none});
  for (std::size_t i = 0; i < none; ++i) {
    const OperationPair& pair = of.operations[i];
    const Term applies = of.backward ? parts.backward_applicability(pair) : parts.forward_applicability(pair);
    const Term agrees = of.backward ? parts.backward_correctness(pair) : parts.forward_correctness(pair, functional);
    all.push_back({ObligationKind::applicability, pair.concrete + ".conj.1", applies, i});
    all.push_back({ObligationKind::correctness, pair.concrete + ".conj.2", agrees, i});
  }
  return all;
}

}  // namespace durero::spec
