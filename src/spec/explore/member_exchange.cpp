#include "member_exchange.hpp"

#include <algorithm>

namespace durero::spec {

using zed::Term;

namespace {

/// The names of the given sets in a type.
void add_given(std::set<std::string>& sets, const zed::Type& type) {
  if (type.is(zed::Type::Kind::given)) sets.insert(type.name().text());
  for (const zed::Type& part : type.parts()) add_given(sets, part);
}

/// The given sets of which a value holds members.
void add_held(std::set<std::string>& sets, const InternedValues& values, ValueId id) {
  if (values.form(id) == InternedForm::atom) sets.insert(values.atom(id)->type);
  for (const ValueId part : values.parts(id)) add_held(sets, values, part);
}

bool names_word(const Term& term, const std::string& word) {
  if (term->kind == zed::Kind::reference && term->name.text() == word) return true;
  if (std::any_of(term->children.begin(), term->children.end(),
                  [&](const Term& child) { return names_word(child, word); }))
    return true;
  if (!term->text) return false;
  return std::any_of(term->text->declarations.begin(), term->text->declarations.end(),
                     [&](const auto& each) { return names_word(each.term, word); }) ||
         std::any_of(term->text->predicates.begin(), term->text->predicates.end(),
                     [&](const auto& each) { return names_word(each.term, word); });
}

}  // namespace

MemberExchange::MemberExchange(PlannedMachine& machine, const std::vector<Term>& predicates) : machine_(machine) {
  const Machine::Parts& parts = machine.machine().parts();
  std::set<std::string> sets;
  for (const auto& [set, words] : parts.carriers)
    if (words.size() > 1) sets.insert(set);
  drop_named(sets, predicates);
  drop_held(sets);
  for (const std::string& set : sets) {
    sets_.push_back(set);
    std::vector<ValueId> members;
    for (const std::string& word : parts.carriers.at(set))
      members.push_back(machine.values().of(zed::Value::atom(set, word)));
    for (std::size_t i = 0; i + 1 < members.size(); ++i) swaps_.push_back({members[i], members[i + 1]});
  }
}

void MemberExchange::drop_named(std::set<std::string>& sets, const std::vector<Term>& predicates) const {
  for (const auto& [set, words] : machine_.machine().parts().carriers)
    for (const std::string& word : words)
      for (const Term& predicate : predicates)
        if (names_word(predicate, word)) sets.erase(set);
}

/// A constant whose value is not listed may tell apart the members of any set in its type.
void MemberExchange::drop_held(std::set<std::string>& sets) {
  const Machine::Parts& parts = machine_.machine().parts();
  std::set<std::string> held, members;
  for (const auto& [set, words] : parts.carriers) members.insert(words.begin(), words.end());
  for (const zed::Name& constant : parts.evaluator->constants()) {
    if (members.contains(constant.text())) continue;
    try {
      parts.begin_question();
      add_held(held, machine_.values(), machine_.values().of(parts.evaluator->value(constant)));
    } catch (const std::runtime_error&) {  // it has no value here, or none that is listed
      const zed::Global* global = parts.typing.find(Machine::Parts::section_name, constant);
      if (global) add_given(held, global->scheme.type);
    }
  }
  for (const std::string& set : held) sets.erase(set);
}

ValueId MemberExchange::exchanged(Swap& swap, ValueId id) {
  if (id == swap.first) return swap.second;
  if (id == swap.second) return swap.first;
  InternedValues& values = machine_.values();
  const auto parts = values.parts(id);
  if (parts.empty()) return id;
  if (id < swap.known.size() && swap.known[id] != 0) return swap.known[id];
  std::vector<ValueId> others;
  others.reserve(parts.size());
  for (const ValueId part : parts) others.push_back(exchanged(swap, part));
  const ValueId to = values.remade(id, others);
  if (swap.known.size() < values.size()) swap.known.resize(values.size() + values.size() / 2, 0);
  swap.known[id] = to;
  swap.known[to] = id;
  return to;
}

void MemberExchange::exchange(std::size_t at, std::span<const ValueId> state, std::vector<ValueId>& to) {
  to.clear();
  for (const ValueId id : state) to.push_back(exchanged(swaps_[at], id));
}

}  // namespace durero::spec
