#pragma once
/// Machines, their states and steps, as JSON.

#include <string>
#include <string_view>
#include <vector>

#include "durero/spec/animation.hpp"
#include "json_text.hpp"

namespace durero::web {

/// `true`, `false` or `open`.
std::string_view truth_word(zed::Truth truth);

/// Adds what a machine is: its state, its initial schema, its given sets and its components.
void add_machine(ObjectText& to, const spec::Machine& machine);
/// Its operations; from a state, where that is not null, the predicate by which the state alone refuses each. With
/// `look` a way to go on is looked for as well, and all predicates are told.
std::string operations_text(const spec::Machine& machine, const zed::Valuation* state, bool look);
/// Values by the names of components.
std::string values_text(const spec::Machine& machine, const zed::Valuation& values);
/// A step with the state behind it, and the components that are other than in `before`, where that is not null.
std::string transition_text(const spec::Machine& machine, const spec::Transition& step, const zed::Valuation* before);
/// Each step of a way.
std::string states_text(const spec::Machine& machine, const spec::Animation& way);
/// A step that goes on from a way, and the whole way with it.
std::string way_on_text(const spec::Machine& machine, const spec::Animation& way, const spec::Transition& step);
/// The conjuncts of the state schema in a state; none where they cannot be decided.
std::string invariant_text(const spec::Machine& machine, const zed::Valuation& state);
/// The conjectures that speak of the last step of a way, and those that speak of none. Throws io::InputError.
std::string claims_text(const spec::Machine& machine, const spec::Animation& way);

}  // namespace durero::web
