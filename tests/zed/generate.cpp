#include "zed/generate.hpp"

#include <string>
#include <utility>

namespace durero::zed::test {
namespace {

using rc::gen::elementOf;
using rc::gen::inRange;

const std::vector<std::string> words = {"x", "S", "mi_radio", "ΔEscena", "f2",  "dom",
                                        "∅", "⋃", "ℕ₁",       "ΞS",      "min", "u_"};
const std::vector<std::string> strokes = {"", "", "", "'", "?", "!", "₁", "'!"};
const std::vector<std::string> infix_functions = {"_+_", "_-_", "_∪_",   "_∩_", "_↦_",  "_◁_",
                                                  "_⩤_", "_▷_", "_div_", "_⊕_", "_⦇_⦈", "_↗_↙"};
const std::vector<std::string> unary_functions = {"-_", "#_", "_∼", "_⁺", "_∗"};
const std::vector<std::string> infix_generics = {"_⇸_", "_→_", "_↔_", "_⤔_"};
const std::vector<std::string> prefix_generics = {"𝔽_", "ℙ₁_", "seq_", "seq₁_", "id_"};
const std::vector<std::string> relations = {"_=_", "_∈_", "_≤_", "_⊆_", "_∉_", "_partition_"};
const std::vector<Kind> binaries = {Kind::conjunction, Kind::disjunction, Kind::implication, Kind::equivalence,
                                    Kind::composition, Kind::piping,      Kind::projection};
const std::vector<Kind> quantifiers = {Kind::forall, Kind::exists, Kind::exists_one,   Kind::lambda,
                                       Kind::mu,     Kind::let,    Kind::comprehension};

template <class T>
T one_of(std::initializer_list<T> all) {
  return *elementOf(std::vector<T>(all));
}

Name any_name() { return {*elementOf(words), *elementOf(strokes)}; }

std::vector<Name> any_names() {
  std::vector<Name> names;
  for (int n = *inRange(1, 4); n > 0; --n) names.push_back(any_name());
  return names;
}

Term with(Kind kind, std::vector<Term> children, Name name, std::vector<Name> names = {}) {
  return make({.kind = kind,
               .place = {},
               .name = std::move(name),
               .children = std::move(children),
               .names = std::move(names),
               .text = {}});
}

Term any(int size);

std::vector<Term> several(int least, int most, int size) {
  std::vector<Term> terms;
  const int count = *inRange(least, most + 1);
  for (int i = 0; i < count; ++i) terms.push_back(any((size - 1) / std::max(count, 1)));
  return terms;
}

Declaration any_declaration(int size, bool defining) {
  const int form = defining ? 1 : *inRange(0, 3);
  if (form == 0) return {Declaration::Form::typed, any_names(), {}, any(size), {}};
  if (form == 1) return {Declaration::Form::defined, {any_name()}, {}, any(size), {}};
  return {Declaration::Form::included, {}, {}, any(size), {}};
}

SchemaText any_text(int size, int least, bool labelled = false) {
  SchemaText text;
  for (int n = *inRange(least, 3); n > 0; --n) text.declarations.push_back(any_declaration(size / 4, false));
  for (int n = *inRange(0, 3); n > 0; --n) {
    const std::string label = labelled && *inRange(0, 2) == 0 ? "S.inv." + std::to_string(n) : "";
    text.predicates.push_back({any(size / 4), label, {}});
  }
  return text;
}

Term any_quantified(int size) {
  const Kind kind = *elementOf(quantifiers);
  if (kind == Kind::let) {
    SchemaText text;
    for (int n = *inRange(1, 3); n > 0; --n) text.declarations.push_back(any_declaration(size / 4, true));
    return quantified(kind, std::move(text), {any(size / 2)});
  }
  const bool set = kind == Kind::comprehension;
  SchemaText text = any_text(size, set ? 1 : 0);
  if (text.declarations.empty() && text.predicates.empty()) text.predicates.push_back({any(size / 4), "", {}});
  if (set || kind == Kind::mu) {
    const bool valued = *inRange(0, 2) == 0;
    // { S } with nothing else is the set of one element S
    const bool extension = set && !valued && text.predicates.empty() && text.declarations.size() == 1 &&
                           text.declarations[0].form == Declaration::Form::included;
    if (!valued && !extension) return quantified(kind, std::move(text), {});
  }
  return quantified(kind, std::move(text), {any(size / 2)});
}

Term any_operation(int size) {
  switch (*inRange(0, 5)) {
    case 0:
      return operation(*elementOf(infix_functions), {any(size / 2), any(size / 2)});
    case 1:
      return operation(*elementOf(unary_functions), {any(size - 1)});
    case 2:
      return reference({*elementOf(infix_generics), ""}, {any(size / 2), any(size / 2)});
    case 3:
      return reference({*elementOf(prefix_generics), ""}, {any(size - 1)});
    default:
      return apply(any(size / 2), any(size / 2));
  }
}

Term any_sequence(int size) {
  std::vector<Term> pairs;
  for (Term& item : several(0, 3, size))
    pairs.push_back(node(Kind::tuple, {number(std::to_string(pairs.size() + 1)), std::move(item)}));
  return operation("⟨,,⟩", {node(Kind::set_extension, std::move(pairs))});
}

Term any_relation(int size) {
  if (*inRange(0, 6) == 0) return relation({{"disjoint_", ""}}, {any(size - 1)});
  std::vector<Term> operands = several(2, 3, size);
  std::vector<Name> names;
  for (std::size_t i = 1; i < operands.size(); ++i) names.push_back({*elementOf(relations), ""});
  return relation(std::move(names), std::move(operands));
}

Term any_suffixed(int size) {
  switch (*inRange(0, 5)) {
    case 0:
      return with(Kind::selection, {any(size - 1)}, any_name());
    case 1:
      return with(Kind::tuple_selection, {any(size - 1)}, {std::to_string(*inRange(1, 12)), ""});
    case 2:
      return with(Kind::decoration, {any(size - 1)}, {"", one_of<std::string>({"'", "!", "₃"})});
    case 3:
      return with(Kind::renaming, {any(size - 1)}, {}, {any_name(), any_name(), any_name(), any_name()});
    default:
      return with(Kind::hiding, {any(size - 1)}, {}, any_names());
  }
}

Term any_leaf() {
  switch (*inRange(0, 6)) {
    case 0:
      return number(std::to_string(*inRange(0, 1000)));
    case 1:
      return node(one_of<Kind>({Kind::truth, Kind::falsity}), {});
    case 2:
      return reference({*elementOf(infix_functions), ""});
    default:
      return reference(any_name());
  }
}

/// The strokes of θ S ' are those of θ; in θ S' they are of the name.
Term any_theta(int size) {
  Term schema = any(size - 1);
  return with(Kind::theta, {schema}, {"", *elementOf(strokes)});
}

Term any(int size) {
  if (size <= 1) return any_leaf();
  switch (*inRange(0, 17)) {
    case 0:
      return any_leaf();
    case 16:
      return reference(any_name(), several(1, 2, size));
    case 1:
      return node(Kind::set_extension, several(0, 3, size));
    case 2:
      return node(one_of<Kind>({Kind::tuple, Kind::product}), several(2, 3, size));
    case 3:
      return node(one_of<Kind>({Kind::power, Kind::negation, Kind::precondition}), {any(size - 1)});
    case 4:
      return any_suffixed(size);
    case 5: {
      std::vector<Term> values = several(0, 2, size);
      std::vector<Name> names;
      for (std::size_t i = 0; i < values.size(); ++i) names.push_back(any_name());
      return with(Kind::binding_extension, std::move(values), {}, std::move(names));
    }
    case 6:
      return any_theta(size);
    case 7:
      return node(Kind::conditional, several(3, 3, size));
    case 8:
      return quantified(Kind::schema_text, any_text(size, 0), {});
    case 9:
      return any_sequence(size);
    case 10:
    case 11:
      return any_relation(size);
    case 12:
      return any_quantified(size);
    case 13:
      return node(*elementOf(binaries), several(2, 2, size));
    default:
      return any_operation(size);
  }
}

Paragraph any_paragraph(int size) {
  const std::vector<Name> formals = *inRange(0, 2) == 0 ? std::vector<Name>() : any_names();
  switch (*inRange(0, 6)) {
    case 0:
      return {{}, GivenTypes{any_names(), {}}};
    case 1: {
      FreeType type{any_name(), {}, false};
      for (int n = *inRange(1, 4); n > 0; --n)
        type.branches.push_back({any_name(), *inRange(0, 2) ? any(size / 3) : Term(), {}});
      return {{}, std::move(type)};
    }
    case 2:
      return {{}, Definition{any_name(), formals, any(size), *inRange(0, 2) ? "N.def.1" : ""}};
    case 3: {
      Axiomatic box{formals, any_text(size, 1, true)};
      return {{}, std::move(box)};
    }
    case 4:
      return {{}, Schema{any_name(), formals, any_text(size, 0, true)}};
    default:
      return {{}, Conjecture{{any(size), "N.axiom.2", {}}, formals}};
  }
}

}  // namespace

rc::Gen<Term> expression(int size) {
  return rc::gen::exec([size] { return any(size); });
}

rc::Gen<Paragraph> paragraph(int size) {
  return rc::gen::exec([size] { return any_paragraph(size); });
}

}  // namespace durero::zed::test
