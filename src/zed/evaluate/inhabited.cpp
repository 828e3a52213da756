#include "zed/evaluate/inhabited.hpp"

#include <algorithm>

#include "zed/operators.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// All of them, or one of them, in the order no < open < yes.
Truth every(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes ? b : a;
}
Truth some_of(Truth a, Truth b) {
  if (a == Truth::yes || b == Truth::yes) return Truth::yes;
  return a == Truth::no ? b : a;
}

/// A question about the members of sets, with what is known of the free types.
class MemberQuestion {
 public:
  MemberQuestion(const Definitions& definitions, const Inhabited& free_types)
      : definitions_(definitions), free_types_(free_types) {}

  Truth of(const Term& set) const {
    constexpr unsigned most_nested = 200;  // definitions in each other, so that one that names itself comes to an end
    if (nested_ > most_nested) return Truth::open;
    switch (set->kind) {
      case Kind::reference:
        return named(set);
      case Kind::power:
        return Truth::yes;  // ∅ is one
      case Kind::product: {
        Truth all = Truth::yes;
        for (const Term& factor : set->children) all = every(all, of(factor));
        return all;
      }
      case Kind::set_extension:
        return extension(set);
      case Kind::comprehension:  // the term of some values may have no value
        return set->children.empty() ? declared(*set->text) : every(Truth::open, declared(*set->text));
      case Kind::schema_text:
        return declared(*set->text);
      case Kind::application:
        return applied(set);
      default:
        return Truth::open;
    }
  }

 private:
  static Truth extension(const Term& set) {
    if (set->children.empty()) return Truth::no;
    const auto is_number = [](const Term& each) { return each->kind == Kind::number; };
    return std::all_of(set->children.begin(), set->children.end(), is_number) ? Truth::yes : Truth::open;
  }

  Truth named(const Term& set) const {
    if (const auto known = free_types_.find(set->name); known != free_types_.end()) return known->second;
    const Meaning* meaning = definitions_.find(set->name);
    if (!meaning) return of_toolkit(set);
    if (meaning->kind == Meaning::Kind::given) return Truth::yes;  // a type has values
    const auto* schema = std::get_if<Schema>(&meaning->paragraph->form);
    const auto* definition = std::get_if<Definition>(&meaning->paragraph->form);
    ++nested_;
    const Truth here = schema && schema->formals.empty()           ? declared(schema->text)
                       : definition && definition->formals.empty() ? of(definition->value)
                                                                   : Truth::open;
    --nested_;
    return here;
  }

  /// ∅ is among all relations, functions and sequences that need not be total or have members.
  Truth of_toolkit(const Term& set) const {
    const std::string word = set->name.text();
    const auto is_one = [&](std::initializer_list<const char*> words) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (is_one({"ℤ", "ℕ", "ℕ₁", "ℤ₁", "𝔸", "𝔽_", "seq_", "iseq_", "_↔_", "_⇸_", "_⤔_", "_⇻_", "_⤕_"}))
      return Truth::yes;
    if (word == "∅") return Truth::no;
    if (is_one({"ℙ₁_", "𝔽₁_", "seq₁_", "id_"}) && set->children.size() == 1) return of(set->children[0]);
    const bool total = word == "_→_" && set->children.size() == 2;  // where there is no argument, ∅ is one
    return total && of(set->children[1]) == Truth::yes ? Truth::yes : Truth::open;
  }

  /// A set has no member where a variable has no value; a condition may leave none out, or all.
  Truth declared(const SchemaText& text) const {
    Truth all = text.predicates.empty() ? Truth::yes : Truth::open;
    for (const Declaration& each : text.declarations)
      all = every(all, each.form == Declaration::Form::defined ? Truth::open : of(each.term));
    return all;
  }

  Truth applied(const Term& set) const {
    const auto sides = [&](const char* by) { return match::operands(set, by); };
    if (const Node* both = sides("_∪_")) return some_of(of(both->children[0]), of(both->children[1]));
    if (const Node* both = sides("_∩_")) return every(Truth::open, every(of(both->children[0]), of(both->children[1])));
    if (const Node* both = sides("_∖_")) return every(Truth::open, of(both->children[0]));
    return Truth::open;
  }

  const Definitions& definitions_;
  const Inhabited& free_types_;
  mutable unsigned nested_ = 0;
};

}  // namespace

Truth has_member(const Term& set, const Definitions& definitions, const Inhabited& free_types) {
  return MemberQuestion(definitions, free_types).of(set);
}

// A type is taken to have no member until a branch shows one, so that a member needs no member of its own type. What a
// branch shows only grows with what other types have: the order is no < open < yes, and has_member() keeps it.
Inhabited inhabited_free_types(const Definitions& definitions) {
  std::vector<const FreeType*> forms;
  Inhabited known;
  for (const Section& section : definitions.sections())
    for (const Paragraph& paragraph : section.paragraphs)
      if (const auto* form = std::get_if<FreeType>(&paragraph.form)) {
        forms.push_back(form);
        known[form->name] = Truth::no;
      }
  for (bool changes = true; changes;) {
    changes = false;
    for (const FreeType* form : forms) {
      Truth here = Truth::no;
      for (const Branch& branch : form->branches)
        here = some_of(here, branch.argument ? has_member(branch.argument, definitions, known) : Truth::yes);
      changes = changes || here != known[form->name];
      known[form->name] = here;
    }
  }
  return known;
}

}  // namespace durero::zed
