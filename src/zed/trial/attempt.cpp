#include "zed/trial/attempt.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace durero::zed {
namespace {

bool is_result(const Name& name) { return name.strokes.find_first_of("'!") != std::string::npos; }

/// The number of states that may be looked at to find which names conjuncts make of others.
constexpr std::size_t most_narrowings = 32;

/// Gives so many numbers at most, those nearest to 0 first, and a positive one before the negative.
std::vector<Real> small_numbers(const TrialBounds& bounds, std::size_t most) {
  if (!bounds.numbers) return {Real(0), Real(1), Real(2), Real(3), Real(-1)};
  const auto [low, high] = *bounds.numbers;
  std::vector<Real> numbers;
  const std::int64_t nearest = low > 0 ? low : high < 0 ? -high : 0;
  for (std::int64_t n = nearest; n <= std::max(high, -low) && numbers.size() < most; ++n) {
    if (n <= high && n >= low) numbers.emplace_back(static_cast<double>(n));
    if (n > 0 && -n >= low && -n <= high && numbers.size() < most) numbers.emplace_back(static_cast<double>(-n));
  }
  return numbers;
}

void refute(Trial& trial, const std::vector<Name>& names, const std::vector<Value>& state) {
  for (std::size_t i = 0; i < names.size(); ++i)
    trial.counterexample += "  " + names[i].text() + " = " + state[i].text() + "\n";
  if (names.empty()) trial.counterexample = "  it has no variables\n";
}

}  // namespace

bool Members::knows(const std::string& set, std::size_t index) {
  const std::vector<Value>& samples = draw_.samples(set);
  std::vector<std::optional<bool>>& known = known_[set];
  known.resize(samples.size());
  if (!known[index]) {
    try {
      known[index] = evaluator_.contains(evaluator_.value(Name{set, ""}), samples[index]) == Truth::yes;
    } catch (const EvaluationError&) {
      known[index] = false;
    }
  }
  return *known[index];
}

Attempt::Attempt(const Ground& ground, const QuantifiedClaim& claim)
    : ground_(ground),
      claim_(claim),
      check_(ground.evaluator.schema(claim.claimed_name)),
      placed_(check_.components().size()) {
  const auto& declarations = claim.assumed.declarations;
  for (std::size_t i = 0; i < declarations.size(); ++i) add_sources(declarations[i], i, true);
  const auto& names = check_.components();
  std::vector<Name> results;
  std::copy_if(names.begin(), names.end(), std::back_inserter(results), is_result);
  narrowings_ = results.empty() ? most_narrowings : 0;
  make(results.empty() ? made_by_conjuncts(claim.assumed) : std::move(results));
}

/// From now on these names are made of the rest.
void Attempt::make(std::vector<Name> names) {
  made_ = std::move(names);
  made_places_.clear();
  results_.reset();
  const auto& all = check_.components();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::find(made_.begin(), made_.end(), all[i]) != made_.end()) made_places_.push_back(i);
}

void Attempt::note(const std::string& undecided) {
  if (undecided_.empty()) undecided_ = undecided;
}

void Attempt::run(Trial& trial) {
  if (!ground_.is_own) {
    if (evaluate(trial)) return;
    run_small(trial);
    if (!trial.counterexample.empty() || witness_) return;
    ground_.steps = Steps(ground_.bounds.steps);
  }
  run_drawn(trial);
}

/// Evaluates the whole claim. Says whether that decides it.
bool Attempt::evaluate(Trial& trial) {
  Truth truth = Truth::open;
  try {
    truth = ground_.evaluator.holds(claim_.whole);
  } catch (const EvaluationError&) {  // states may decide it
  } catch (const StepsSpent&) {
  }
  ground_.steps = Steps(ground_.bounds.steps);
  if (truth == Truth::open) return false;
  trial.is_evaluated = truth == Truth::yes;
  if (trial.is_evaluated) trial.tried = 1;
  if (truth == Truth::no) show_denial(trial);
  return true;
}

/// Tells a state where the claim is false. Precondition: the evaluation says that there is one.
void Attempt::show_denial(Trial& trial) {
  if (claim_.wants_witness) {
    trial.counterexample = "  there is no witness\n";
    return;
  }
  try {
    const Completion denial = ground_.evaluator.completion(claim_.denied_name, {});
    denial.first({}, [&](std::span<const Value> values) {
      refute(trial, denial.sought(), {values.begin(), values.end()});
    });
  } catch (const EvaluationError&) {  // states that are tried may show it
  } catch (const StepsSpent&) {
  }
  if (!trial.counterexample.empty()) return;
  run_small(trial);
  if (trial.counterexample.empty()) trial.counterexample = "  its evaluation says so, and no state was met\n";
}

/// Small members of the set of a declaration; none where they are not known.
std::vector<Value> Attempt::small(const Source& source, std::size_t most) {
  if (source.is_binding) return {};
  try {
    SmallScope scope;
    scope.numbers = small_numbers(ground_.bounds, most);
    scope.most = most;
    scope.given = names_of_a_given_set;
    return ground_.evaluator.some_members(ground_.evaluator.value(source.set), scope);
  } catch (const EvaluationError&) {
    return {};
  }
}

/// Looks at the states of a small scope, so many at most as it would draw four times.
void Attempt::run_small(Trial& trial) try {
  std::vector<std::size_t> places;
  std::vector<std::vector<Value>> values;
  for (const Source& source : sources_) places.insert(places.end(), source.places.begin(), source.places.end());
  const std::size_t most = 4 * ground_.bounds.draws;
  if (places.empty() || most == 0) return;
  const double share = std::pow(static_cast<double>(most), 1.0 / static_cast<double>(places.size()));
  for (const Source& source : sources_) {
    const std::vector<Value> some = small(source, std::max<std::size_t>(2, static_cast<std::size_t>(share)));
    if (some.empty()) return;
    values.insert(values.end(), source.places.size(), some);
  }
  for (std::size_t way = 0; way < most && trial.counterexample.empty() && !witness_; ++way) {
    State state = nothing_known();
    std::size_t rest = way;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i] != nowhere) state.values[places[i]] = values[i][rest % values[i].size()];
      rest /= values[i].size();
    }
    if (rest > 0) return;  // all of them were looked at
    try {
      on(state, trial);
    } catch (const EvaluationError& error) {
      note(error.what());
    }
  }
} catch (const StepsSpent&) {  // states by chance have steps of their own
}

void Attempt::run_drawn(Trial& trial) {
  const TrialBounds& bounds = ground_.bounds;
  const bool closed = claim_.assumed.declarations.empty();
  const std::size_t draws = closed ? 1 : bounds.draws;
  const std::size_t most = trial.tried + (claim_.wants_witness ? draws : bounds.states);
  for (std::size_t draw = 0; draw < draws && trial.tried < most && trial.counterexample.empty() && !witness_; ++draw) {
    try {
      on(drawn(draw), trial);
    } catch (const EvaluationError& error) {
      note(error.what());
    }
  }
  if (claim_.wants_witness && !witness_) return ask_for_witness(trial);
  if (trial.tried == 0 && trial.why_not.empty())
    trial.why_not = undecided_.empty() ? "none of the values drawn are a state" : undecided_;
}

/// Where no values drawn are a witness, equations may give one, or say that there is none.
void Attempt::ask_for_witness(Trial& trial) {
  Truth some = Truth::open;
  try {
    if (ground_.is_own) some = ground_.evaluator.holds(claim_.whole);
  } catch (const EvaluationError& error) {
    note(error.what());
  }
  if (some == Truth::no) trial.counterexample = "  there is no witness\n";
  if (some == Truth::yes) {
    trial.tried = 1;
  } else if (trial.tried > 0) {
    trial.why_not = "none of " + std::to_string(trial.tried) + " states is a witness";
    trial.tried = 0;
  } else {
    trial.why_not = undecided_.empty() ? "none of the values drawn are a state" : undecided_;
  }
}

// A schema without samples is drawn declaration by declaration, so that each input comes from the set that is named.
void Attempt::add_sources(const Declaration& declaration, std::size_t number, bool outermost) {
  const bool included = declaration.form == Declaration::Form::included;
  const std::string* samples = ground_.draw.samples_of(declaration.term);
  if (const SchemaText* text = included && !samples ? ground_.draw.text(declaration.term) : nullptr) {
    for (const Declaration& each : text->declarations) add_sources(each, number, false);
    return;
  }
  Source source{element_of(declaration.term), declaration.term, samples};
  source.declaration = number;
  source.is_declaration = outermost;
  if (included) return add_included(declaration.term, std::move(source));
  for (const Name& name : declaration.names) source.places.push_back(place_of(name));
  sources_.push_back(std::move(source));
}

// Of ΔS, and ΞS, the state before is drawn where S has samples: the other is what an operation makes of it.
void Attempt::add_included(const Term& schema, Source source) {
  const std::string& word = schema->name.word;
  const bool change = schema->kind == Kind::reference && (word.starts_with("Δ") || word.starts_with("Ξ"));
  const Term before = change ? reference({word.substr(std::string("Δ").size()), ""}) : schema;
  const bool sampled = change && ground_.draw.samples_of(before);
  if (sampled) {
    source.samples = ground_.draw.samples_of(before);
    source.is_declaration = false;
  }
  source.is_binding = true;
  for (const Name& name : source.element.fields())
    if (!sampled || !is_result(name)) source.places.push_back(place_of(name));
  sources_.push_back(std::move(source));
}

std::size_t Attempt::place_of(const Name& name) {
  const auto& names = check_.components();
  const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (at == names.size() || placed_[at]) return nowhere;
  placed_[at] = true;
  return at;
}

const Type& Attempt::element_of(const Term& set) {
  const auto known = elements_.find(set.get());
  if (known != elements_.end()) return known->second;
  const std::optional<Type> type = ground_.typing.type_of(set);
  if (!type || !type->is(Type::Kind::power)) throw EvaluationError("the type of a declaration is not known");
  return elements_.emplace(set.get(), type->settled().parts()[0]).first->second;
}

Attempt::State Attempt::nothing_known() const {
  return {std::vector<Value>(placed_.size(), Value(Open{})),
          {std::vector<bool>(claim_.assumed.declarations.size() + claim_.assumed.predicates.size() + 1), {}}};
}

Attempt::State Attempt::drawn(std::size_t draw) {
  State state = nothing_known();
  Chances chances(draw);
  for (const Source& source : sources_) draw_from(source, chances, state);
  return state;
}

void Attempt::draw_from(const Source& source, Chances& chances, State& state) {
  bool known = source.is_declaration && source.samples;
  const auto one = [&] {
    if (!source.samples) return ground_.draw.of(source.element, chances);
    const std::vector<Value>& samples = ground_.draw.samples(*source.samples);
    const std::size_t index = chances.below(samples.size());
    known = known && ground_.members.knows(*source.samples, index);
    return samples[index];
  };
  const auto put = [&](std::size_t place, const Value& value) {
    if (place == nowhere) known = false;
    if (place != nowhere) state.values[place] = value;
  };
  if (source.is_binding) {
    const Value binding = one();
    for (std::size_t i = 0; i < source.places.size(); ++i) put(source.places[i], binding.binding()->values[i]);
    state.known.bindings.push_back(*binding.get<BindingPtr>());
  } else {
    for (const std::size_t place : source.places) put(place, one());
  }
  state.known.parts[source.declaration] = known;
}

/// Looks for values of what is made of the rest. The answer is that of Completion::each, and open where it cannot say.
Truth Attempt::completed(const State& drawn, std::vector<Value>& found) {
  const auto& names = check_.components();
  const auto is_made = [&](std::size_t i) {
    return std::find(made_places_.begin(), made_places_.end(), i) != made_places_.end();
  };
  std::vector<Name> known;
  std::vector<Value> given;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!is_made(i)) {
      known.push_back(names[i]);
      given.push_back(drawn.values[i]);
    }
  try {
    if (!results_) results_ = ground_.evaluator.completion(claim_.assumed_name, known);
    return results_->each(given, [&](std::span<const Value> sought) {
      found = drawn.values;
      for (std::size_t i = 0; i < made_places_.size(); ++i) found[made_places_[i]] = sought[i];
      return false;
    });
  } catch (const EvaluationError& error) {
    note(error.what());
    if (!results_) make({});  // what cannot be compiled is not tried again
    return Truth::open;
  }
}

// An after-state and outputs are what an operation makes of the rest, as other values are what a conjunct makes of
// those that it starts from; by chance few values drawn are that. So where they are no state, the first that the text
// gives for the rest takes their place. Which names conjuncts make is a guess: where it cannot be said what they are,
// one of them may be none that is made.
bool Attempt::complete(const State& drawn, std::vector<Value>& found) {
  const Truth all_said = completed(drawn, found);
  if (!found.empty()) narrowings_ = 0;
  if (all_said != Truth::open || narrowings_ == 0) return !found.empty();
  --narrowings_;
  const std::vector<Name> all = made_;
  for (std::size_t i = 0; i < all.size() && all.size() > 1; ++i) {
    std::vector<Name> fewer = all;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    make(std::move(fewer));
    completed(drawn, found);
    if (found.empty()) continue;
    narrowings_ = 0;
    return true;
  }
  make(all);
  return false;
}

bool Attempt::Before::operator()(const std::vector<Value>& a, const std::vector<Value>& b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](const Value& x, const Value& y) { return compare(x, y) < 0; });
}

void Attempt::on(const State& drawn, Trial& trial) {
  if (!drawn_.insert(drawn.values).second) return;
  const SchemaCheck::Apart truth = check_.apart(drawn.values, drawn.known);
  if (truth.before == Truth::yes) return judge(drawn.values, truth.last, trial);
  if (truth.before == Truth::open) note("a variable is not determined");
  if (made_.empty()) return;
  State rest = drawn;
  for (const std::size_t place : made_places_) rest.values[place] = Open{};
  std::vector<Value> found;
  if (!check_.refuted(rest.values, rest.known) && complete(drawn, found))
    judge(found, check_.last(found, drawn.known), trial);
}

void Attempt::judge(const std::vector<Value>& values, Truth last, Trial& trial) {
  if (last == Truth::open) return note("a variable is not determined");
  if (last == Truth::no && !claim_.wants_witness) return refute(trial, check_.components(), values);
  if (met_.insert(values).second) ++trial.tried;
  witness_ = claim_.wants_witness && last == Truth::yes;
}

}  // namespace durero::zed
