#include "zed/evaluate/choice.hpp"

#include <algorithm>
#include <functional>

#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

constexpr int most_choices = 2000;              // the most values tried for all names together
constexpr int greatest_choice = 20;             // the greatest number tried that no predicate names
constexpr std::size_t longest_numeral = 9;      // the most digits of a numeral whose neighbours are tried
constexpr std::size_t most_members_tried = 50;  // the most members tried of a finite set

/// Calls `visit` for each term inside, the term itself first.
void each_term(const Term& term, const std::function<void(const Node&)>& visit) {
  visit(*term);
  for (const Term& part : term->children) each_term(part, visit);
  if (!term->text) return;
  for (const Declaration& declaration : term->text->declarations) each_term(declaration.term, visit);
  for (const Predicate& predicate : term->text->predicates) each_term(predicate.term, visit);
}

/// Returns the numbers to try: 3, the number of members of a given set without any statement, then the other small
/// numbers, then the numerals of the predicates with their neighbours.
std::vector<Value> numbers(const std::vector<Predicate>& predicates) {
  std::vector<Value> all;
  const auto put = [&](int number) { all.emplace_back(Real(number)); };
  for (int number = 3; number >= 0; --number) put(number);
  for (int number = 4; number <= greatest_choice; ++number) put(number);
  for (const Predicate& predicate : predicates)
    each_term(predicate.term, [&](const Node& node) {
      if (node.kind != Kind::number || node.name.word.size() > longest_numeral) return;
      for (const int step : {0, 1, -1}) all.emplace_back(Real::natural(node.name.word) + Real(step));
    });
  for (int number = 1; number <= greatest_choice; ++number) put(-number);
  return all;
}

}  // namespace

void WitnessSearch::add(const Name& name, const Term& set) {
  names_.push_back(name);
  sets_.push_back(set);
  values_.emplace_back();
  taken_.push_back(false);
}

std::string WitnessSearch::names_text() const {
  std::string text;
  for (const Name& name : names_) text += (text.empty() ? "" : ", ") + name.text();
  return text;
}

Truth WitnessSearch::find() {
  std::vector<std::size_t> tried;
  return look(tried);
}

/// Gives each name outside `tried` a value by equations and finite sets.
Truth WitnessSearch::complete(const std::vector<std::size_t>& tried) {
  const auto unit = std::make_shared<Unit>();
  Scope outer{.unit = unit};
  std::vector<unsigned> slots(names_.size());
  for (const std::size_t i : tried) outer.names[names_[i]] = {slots[i] = Slots::take(*unit), {}};
  SchemaText text;
  text.predicates = predicates_;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (std::find(tried.begin(), tried.end(), i) == tried.end())
      text.declarations.push_back({Declaration::Form::typed, {names_[i]}, {Place{}}, sets_[i], {}});
  Scope inner{.outer = &outer, .unit = unit};
  const CompiledSchemaText head = compiler_.head(text, outer, inner);
  for (const auto& [name, local] : inner.names)
    slots[static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin())] = *local.slot;
  Frame frame(unit->size, context_);
  for (const std::size_t i : tried) frame.slots[slots[i]] = values_[i];
  int found = 0;
  const Truth some = head.search->each(frame, [&](Frame& inside) {
    for (std::size_t i = 0; i < names_.size() && found == 0; ++i) values_[i] = inside.slots[slots[i]];
    return ++found < 2;
  });
  if (found == 0) return some;
  for (const Variable& variable : head.search->variables()) {
    const auto name = static_cast<std::size_t>(std::find(slots.begin(), slots.end(), variable.slot) - slots.begin());
    taken_[name] = !variable.value && (found > 1 || some == Truth::open);
  }
  return Truth::yes;
}

std::vector<Value> WitnessSearch::candidates(std::size_t name) {
  const Value set = compiler_.evaluated(sets_[name], context_);
  if (!set.set()) return {};
  std::vector<Value> all;
  if (const auto* members = set.set()->members())
    all.assign(members->begin(),
               members->begin() + static_cast<std::ptrdiff_t>(std::min(members->size(), most_members_tried)));
  else if (set.set()->numbers() != Numbers::none)
    all = numbers(predicates_);
  else if (set.set()->contains(Real(), context_) != Truth::yes)  // a whole type has no known member
    all = {empty_set()};
  std::erase_if(all, [&](const Value& each) {
    try {
      return contains_value(set, each, context_) != Truth::yes;
    } catch (const EvaluationError&) {
      return true;
    }
  });
  return all;
}

Truth WitnessSearch::look(std::vector<std::size_t>& tried) {
  Truth here = Truth::open;
  try {
    here = complete(tried);
  } catch (const Unsatisfied&) {
    throw;
  } catch (const EvaluationError&) {  // trying values may decide it
  }
  if (here != Truth::open) return here;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (std::find(tried.begin(), tried.end(), i) != tried.end()) continue;
    const std::vector<Value> all = candidates(i);
    if (all.empty()) continue;
    tried.push_back(i);
    for (const Value& value : all) {
      if (++tries_ > most_choices) break;
      values_[i] = value;
      if (look(tried) == Truth::yes) {
        taken_[i] = true;
        return Truth::yes;
      }
    }
    tried.pop_back();
    return Truth::open;
  }
  return Truth::open;
}

}  // namespace durero::zed
