#pragma once
/// A machine whose operations are planned: its steps from a state, as numbers of values.

#include <map>

#include "durero/spec/explore.hpp"
#include "search_plan.hpp"

namespace durero::spec {

/// An operation, or the initial schema, planned.
struct PlannedOperation {
  std::string name;
  std::vector<zed::Name> inputs, outputs;
  std::vector<unsigned> before, after, given, returned;  ///< the places of the components, inputs and outputs
  FrameScope scope{};
  std::shared_ptr<const SearchPlan> plan{};  ///< null: the evaluator looks for its steps
  bool needs_invariant = false;              ///< it can happen only in states that the state schema admits
  std::vector<FactCount> counts{};
  std::vector<IdTest> checks{};  ///< what it says of a step that is given whole; none without a plan
  std::size_t width() const { return given.size() + returned.size() + after.size(); }
};

/// Steps, a row each: the inputs, the outputs, and the state after.
class StepRows {
 public:
  explicit StepRows(std::size_t width = 0) : width_(width) {}
  void clear() { ids_.clear(); }
  void reset(std::size_t width) {
    width_ = width;
    ids_.clear();
  }

  std::size_t size() const { return width_ == 0 ? 0 : ids_.size() / width_; }
  std::span<const ValueId> row(std::size_t at) const { return {ids_.data() + at * width_, width_}; }
  std::vector<ValueId>& ids() { return ids_; }

 private:
  std::size_t width_;
  std::vector<ValueId> ids_;
};

class PlannedMachine {
 public:
  /// With its operations as yet without plans.
  PlannedMachine(const Machine& machine, NumberBounds numbers);
  /// Plans them; `split` goes each side of their disjunctions on its own. Throws StoppedSearch, and the operations that
  /// were not planned stay without plans then.
  void plan(bool split = false);

  const Machine& machine() const { return machine_; }
  InternedValues& values() { return values_; }
  TermTranslator& translator() { return translator_; }
  std::size_t components() const { return machine_.components().size(); }
  std::vector<PlannedOperation>& operations() { return operations_; }
  PlannedOperation& initial() { return initial_; }

  /// The rows of an operation's steps from a state, or of the initial states; valid to the next call.
  StepRows& rows(PlannedOperation& operation, std::span<const ValueId> before);
  /// Calls `visit` with each row, and the sides of disjunctions by which it was found, where the plan splits them.
  void each_side(PlannedOperation& operation, std::span<const ValueId> before,
                 const std::function<void(const std::vector<zed::Term>& sides, std::span<const ValueId> row)>& visit);
  /// Whether the state schema admits the state.
  bool invariant(std::span<const ValueId> state);
  /// The step that a row is.
  Transition transition(const PlannedOperation& operation, std::span<const ValueId> row) const;
  /// The values of the state's components.
  zed::Valuation valuation(std::span<const ValueId> state) const;
  std::vector<ValueId> ids(const zed::Valuation& state);
  /// Puts the values of a step into the frame, where the operation's tests and claims read them.
  void load(const PlannedOperation& operation, std::span<const ValueId> before, std::span<const ValueId> row);
  IdFrame frame() { return frame_.data(); }
  /// A test of a state, whose components are read where load_state() puts them.
  IdTest state_test(const zed::Term& predicate);
  void load_state(std::span<const ValueId> state);
  /// A test of the operation's steps.
  IdTest step_test(const PlannedOperation& operation, const zed::Term& predicate);
  /// The values that were left out, by the flag that would admit it.
  std::set<std::string>& bounded() { return bounded_; }
  /// Decides whether a step that was given is one of the operation. Throws Undecided.
  bool admits(const PlannedOperation& operation, std::span<const ValueId> before, std::span<const ValueId> row);

 private:
  void plan_invariant();
  void plan(PlannedOperation& operation, bool is_initial, bool split);
  /// Keeps the sets of sequences that names are declared from.
  void keep_sequences(const zed::SchemaText& text);
  /// The value of a name, written as what is declared from its set: a member of `seq X` as a sequence.
  zed::Value written(const zed::Name& name, ValueId id) const;
  void evaluate(const PlannedOperation& operation, std::span<const ValueId> before);
  void note(const ReachedTransitions& found, const std::string& what);
  void fit() {
    if (frame_.size() < translator_.frame_size()) frame_.resize(translator_.frame_size(), 0);
  }

  const Machine& machine_;
  InternedValues values_;
  TermTranslator translator_;
  std::vector<ValueId> frame_;
  FrameScope state_scope_;
  std::vector<unsigned> state_places_;
  std::vector<IdTest> invariant_;
  std::vector<ValueId> asked_;  // the state of which the invariant was asked last, and the answer
  bool admitted_ = false;
  std::vector<zed::Term> state_facts_, after_facts_;  // what the state schema says of a state, and of that after a step
  std::vector<PlannedOperation> operations_;
  PlannedOperation initial_;
  std::map<zed::Name, zed::Value> sequences_;  // the set that each of these names is declared from
  StepRows rows_;
  std::set<std::string> bounded_;
};

}  // namespace durero::spec
