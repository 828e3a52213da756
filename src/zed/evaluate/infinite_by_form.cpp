#include "zed/evaluate/infinite_by_form.hpp"

#include <algorithm>
#include <set>

#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// A question about the size of sets. It remembers the names that it is inside of.
class SizeQuestion {
 public:
  SizeQuestion(const Definitions& definitions, const Inhabited& free_types)
      : definitions_(definitions), free_types_(free_types) {}

  bool is_infinite(const Term& set) {
    switch (set->kind) {
      case Kind::reference:
        return named(set);
      case Kind::power:
        return is_infinite(set->children[0]);
      case Kind::product:
        return some_beside_members(set->children);
      case Kind::schema_text:
        return declared(*set->text);
      case Kind::comprehension:
        return set->children.empty() && declared(*set->text);
      case Kind::application: {
        const Node* sides = match::operands(set, "_∪_");
        return sides && (is_infinite(sides->children[0]) || is_infinite(sides->children[1]));
      }
      default:
        return false;
    }
  }

 private:
  bool has_member(const Term& set) const { return zed::has_member(set, definitions_, free_types_) == Truth::yes; }

  /// Tuples are infinitely many where one part is of an infinite set, and there is something for each other part.
  bool some_beside_members(const std::vector<Term>& sets) {
    return std::all_of(sets.begin(), sets.end(), [&](const Term& each) { return has_member(each); }) &&
           std::any_of(sets.begin(), sets.end(), [&](const Term& each) { return is_infinite(each); });
  }

  bool declared(const SchemaText& text) {
    std::vector<Term> sets;
    for (const Declaration& each : text.declarations) {
      if (each.form == Declaration::Form::defined) return false;
      sets.push_back(each.term);
    }
    return text.predicates.empty() && some_beside_members(sets);
  }

  bool named(const Term& set) {
    const Meaning* meaning = definitions_.find(set->name);
    if (!meaning) return of_toolkit(set);
    const bool is_free_type = meaning->kind == Meaning::Kind::free_type;
    if (is_free_type && free_types_.at(set->name) != Truth::yes) return false;
    // A constructor makes another value of a value, with one more constructor in it: so there is no last.
    if (!inside_.insert(set->name).second) return is_free_type;
    bool infinite = false;
    if (const auto* form = std::get_if<FreeType>(&meaning->paragraph->form); form && is_free_type)
      infinite = std::any_of(form->branches.begin(), form->branches.end(),
                             [&](const Branch& each) { return each.argument && is_infinite(each.argument); });
    if (const auto* form = std::get_if<Definition>(&meaning->paragraph->form))
      infinite = form->formals.empty() && is_infinite(form->value);
    if (const auto* form = std::get_if<Schema>(&meaning->paragraph->form))
      infinite = form->formals.empty() && declared(form->text);
    inside_.erase(set->name);
    return infinite;
  }

  bool of_toolkit(const Term& set) {
    const std::string word = set->name.text();
    const auto is_one = [&](std::initializer_list<const char*> words) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (is_one({"ℤ", "ℕ", "ℕ₁", "ℤ₁", "𝔸"})) return true;
    if (set->children.size() != 1) return false;
    if (is_one({"seq_", "seq₁_"})) return has_member(set->children[0]);  // of any length
    return is_one({"iseq_", "ℙ₁_", "𝔽_", "𝔽₁_", "id_"}) && is_infinite(set->children[0]);
  }

  const Definitions& definitions_;
  const Inhabited& free_types_;
  std::set<Name> inside_;
};

}  // namespace

bool is_infinite_by_form(const Term& set, const Definitions& definitions, const Inhabited& free_types) {
  return SizeQuestion(definitions, free_types).is_infinite(set);
}

}  // namespace durero::zed
