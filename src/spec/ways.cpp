#include "ways.hpp"

#include <algorithm>

namespace durero::spec {

using zed::Name;
using zed::Truth;
using zed::Type;
using zed::Valuation;
using zed::Value;

namespace {

/// A name is tried with so many values at most.
constexpr std::size_t most_values = 200;

bool is_number(const Type& type) { return type.is(Type::Kind::given) && type.name().text() == "𝔸"; }

/// The transition that values of the components make; `after` is named as the state's components are.
class Gatherer {
 public:
  Gatherer(const std::string& operation, const std::vector<Name>& components) {
    transition_.operation = operation;
    for (const Name& name : components) transition_.after.emplace_back(name, Value());
  }
  void give(const Name& name, const Value& value, bool plain_is_after) {
    for (auto& [component, after] : transition_.after)
      if (name == Name{component.word, component.strokes + "'"} || (plain_is_after && name == component)) after = value;
    if (name.strokes.ends_with("?")) transition_.inputs.emplace_back(name, value);
    if (name.strokes.ends_with("!")) transition_.outputs.emplace_back(name, value);
  }
  Transition take() {
    const auto by_name = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::sort(transition_.inputs.begin(), transition_.inputs.end(), by_name);
    std::sort(transition_.outputs.begin(), transition_.outputs.end(), by_name);
    return std::move(transition_);
  }

 private:
  Transition transition_;
};

std::pair<std::vector<Name>, std::vector<Value>> apart(const Valuation& known) {
  std::pair<std::vector<Name>, std::vector<Value>> both;
  for (const auto& [name, value] : known) {
    both.first.push_back(name);
    both.second.push_back(value);
  }
  return both;
}

/// Puts a value there that is not there yet.
void put(std::vector<Value>& values, const Value& value) {
  const bool there =
      std::any_of(values.begin(), values.end(), [&](const Value& each) { return zed::same(each, value); });
  if (!there && values.size() < most_values) values.push_back(value);
}

/// Puts the set with one member more, and with one less.
void put_neighbours(std::vector<Value>& values, const std::vector<Value>& of, const std::vector<Value>& others) {
  for (const Value& other : others) {
    std::vector<Value> more = of;
    more.push_back(other);
    put(values, Value::set(std::move(more)));
  }
  for (std::size_t i = 0; i < of.size(); ++i) {
    std::vector<Value> less = of;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    put(values, Value::set(std::move(less)));
  }
}

}  // namespace

/// Adds what equations and finite sets give. Nothing where a bound was met.
std::optional<Truth> Ways::complete(const Valuation& known) {
  const auto [names, given] = apart(known);
  const zed::Completion& completion = parts_.completion(schema_, names);
  const bool plain_is_after = before_.empty();  // an initial schema may be one of S itself
  const Truth all = completion.each(given, [&](std::span<const Value> sought) {
    Gatherer gatherer(schema_, parts_.components);
    for (const auto& [name, value] : known) gatherer.give(name, value, plain_is_after);
    for (std::size_t i = 0; i < sought.size(); ++i) gatherer.give(completion.sought()[i], sought[i], plain_is_after);
    Transition transition = gatherer.take();
    if (std::find(found_.transitions.begin(), found_.transitions.end(), transition) != found_.transitions.end())
      return true;
    if (found_.transitions.size() == most_) {
      found_.bounded = "--choices";
      return false;
    }
    found_.transitions.push_back(std::move(transition));
    return true;
  });
  return found_.bounded == "--choices" ? std::nullopt : std::optional(all);
}

std::vector<Value> Ways::values(const Name& name) const {
  const Type& type = parts_.types.at(name);
  const Name plain{name.word, name.strokes.ends_with("'") ? name.strokes.substr(0, name.strokes.size() - 1) : "?"};
  const auto at = std::find_if(before_.begin(), before_.end(), [&](const auto& each) { return each.first == plain; });
  std::vector<Value> values;
  if (at != before_.end()) {
    put(values, at->second);
    if (const zed::Real* number = at->second.real())
      for (int n = 1; n <= parts_.setup.numbers; ++n)
        for (const int step : {n, -n}) put(values, *number + zed::Real(step));
    if (const zed::Set* set = at->second.set(); set && set->members() && type.is(Type::Kind::power))
      put_neighbours(values, *set->members(), parts_.samples(type.parts()[0]));
  }
  for (const Value& value : parts_.samples(type)) put(values, value);
  return values;
}

/// How many of its first values are not refuted: an equation refutes all but one, or all.
std::size_t Ways::possible(Valuation& known, const Name& name) const {
  constexpr std::size_t most_asked = 16;
  std::size_t count = 0;
  std::vector<Value> all = values(name);
  for (std::size_t i = 0; i < std::min(all.size(), most_asked); ++i) {
    known.emplace_back(name, all[i]);
    const auto [names, given] = apart(known);
    known.pop_back();
    try {
      const auto stop = [](std::span<const Value>) { return false; };
      count += parts_.completion(schema_, names).each(given, stop) == Truth::no ? 0 : 1;
    } catch (const zed::EvaluationError&) {
      ++count;
    }
  }
  return count;
}

/// Of the names that are sought, the one to try values of: that which the rest leaves the most, so that none is tried
/// that an equation gives. Of several numbers come before what is made of several: the fewer there are to try, the
/// better. Nothing where no name has values.
std::optional<Name> Ways::next_to_try(Valuation& known) const {
  std::vector<Name> names = parts_.completion(schema_, apart(known).first).sought();
  std::erase_if(names, [&](const Name& name) { return values(name).empty(); });
  std::stable_partition(names.begin(), names.end(), [&](const Name& name) { return is_number(parts_.types.at(name)); });
  if (names.empty()) return std::nullopt;
  std::vector<std::size_t> counts;
  counts.reserve(names.size());
  for (const Name& name : names) counts.push_back(names.size() == 1 ? 1 : possible(known, name));
  return names[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

/// Says whether to go on.
bool Ways::look(Valuation& known) {
  std::optional<Truth> all = Truth::open;
  try {
    all = complete(known);
  } catch (const zed::EvaluationError& error) {
    error_ = error;
  }
  if (all != Truth::open) return all.has_value();
  found_.undecided = true;
  const std::optional<Name> next = next_to_try(known);
  if (!next) return true;
  found_.tried.insert(*next);
  for (const Value& value : values(*next)) {
    if (++tried_ > parts_.setup.inputs) {
      found_.bounded = "--inputs";
      return false;
    }
    known.emplace_back(*next, value);
    const bool on = look(known);
    known.pop_back();
    if (!on) return false;
  }
  return true;
}

bool Ways::add_listed(const Valuation& known) {
  try {
    return complete(known) != Truth::open;
  } catch (const zed::EvaluationError& error) {
    error_ = error;
    return false;
  }
}

bool Ways::add(const Valuation& known) {
  try {
    Valuation all = known;
    return look(all);
  } catch (const zed::StepsSpent&) {
    if (!found_.undecided) throw;
    found_.bounded = "--steps";
    return false;
  }
}

void Ways::add_each(const Valuation& known, const std::vector<Name>& inputs) {
  std::vector<std::vector<Value>> samples;
  samples.reserve(inputs.size());
  for (const Name& input : inputs) samples.push_back(parts_.samples(parts_.types.at(input)));
  if (!samples.empty()) found_.bounded = "--numbers";
  std::size_t choices = 0;
  std::vector<std::size_t> at(samples.size(), 0);
  for (;;) {
    if (choices++ == parts_.setup.inputs) {
      found_.bounded = "--inputs";
      return;
    }
    Valuation all = known;
    for (std::size_t i = 0; i < samples.size(); ++i) all.emplace_back(inputs[i], samples[i][at[i]]);
    if (!add(all)) return;
    std::size_t digit = samples.size();
    while (digit > 0 && ++at[digit - 1] == samples[digit - 1].size()) at[--digit] = 0;
    if (digit == 0) return;
  }
}

ReachedTransitions Ways::found() {
  if (found_.transitions.empty() && error_) throw zed::EvaluationError(*error_);
  return std::move(found_);
}

}  // namespace durero::spec
