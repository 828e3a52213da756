#include "durero/spec/partition.hpp"

#include <algorithm>

#include "durero/zed/print/print.hpp"
#include "planned_machine.hpp"

namespace durero::spec {

using zed::Term;

namespace {

/// The cases of one operation, with where each stands among all.
struct OpenCases {
  PlannedOperation* operation = nullptr;
  std::vector<std::vector<Term>> sides{};
  std::vector<std::size_t> cases{};
  std::size_t open = 0;
};

class CaseSearch {
 public:
  CaseSearch(const Machine& machine, const ExploreBounds& bounds)
      : space_(machine, bounds), split_(machine, {bounds.low, bounds.high}) {
    split_.plan(true);
  }

  OperationCases found() {
    for (PlannedOperation& operation : split_.operations()) add_cases(operation);
    const ExploreReport& report = space_.explore();
    all_.bounded = report.bounded;
    for (std::size_t at = 0; at < space_.size() && any_open(); ++at)
      for (OpenCases& each : open_)
        if (each.open > 0) look(each, at);
    return std::move(all_);
  }

 private:
  bool any_open() const {
    return std::any_of(open_.begin(), open_.end(), [](const OpenCases& each) { return each.open > 0; });
  }

  void add_cases(PlannedOperation& operation) {
    OpenCases open{&operation};
    if (operation.plan)
      for (const std::vector<Term>& sides : operation.plan->all_sides())
        if (std::find(open.sides.begin(), open.sides.end(), sides) == open.sides.end()) open.sides.push_back(sides);
    if (!operation.plan) {
      all_.whole.push_back(operation.name);
      open.sides.emplace_back();
    }
    for (const std::vector<Term>& sides : open.sides) {
      open.cases.push_back(all_.cases.size());
      all_.cases.push_back({operation.name});
      for (const Term& side : sides) all_.cases.back().disjuncts.push_back(zed::to_unicode(side));
    }
    open.open = open.cases.size();
    open_.push_back(std::move(open));
  }

  void look(OpenCases& open, std::size_t at) {
    PlannedOperation& operation = *open.operation;
    const std::vector<ValueId> before = split_.ids(space_.state(at));
    const auto take = [&](const std::vector<Term>& sides, std::span<const ValueId> row) {
      const auto side = std::find(open.sides.begin(), open.sides.end(), sides);
      if (side == open.sides.end()) return;
      OperationCase& here = all_.cases[open.cases[static_cast<std::size_t>(side - open.sides.begin())]];
      if (here.is_found) return;
      here.is_found = true;
      --open.open;
      found_.push_back(&here);
      here.admitted.push_back(split_.transition(operation, row));
    };
    found_.clear();
    if (operation.plan)
      split_.each_side(operation, before, take);
    else if (const StepRows& rows = split_.rows(operation, before); rows.size() > 0)
      take({}, rows.row(0));
    for (OperationCase* each : found_) complete(*each, operation, at, before);
  }

  /// Adds the way to the state before, and what else the text admits with the same inputs.
  void complete(OperationCase& here, PlannedOperation& operation, std::size_t at, const std::vector<ValueId>& before) {
    here.way = space_.way_to(at);
    here.inputs = here.admitted[0].inputs;
    const StepRows rows = split_.rows(operation, before);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Transition step = split_.transition(operation, rows.row(i));
      Transition same_inputs = step;
      same_inputs.outputs = here.admitted[0].outputs;
      same_inputs.after = here.admitted[0].after;
      if (same_inputs == here.admitted[0] && !(step == here.admitted[0])) here.admitted.push_back(step);
    }
  }

  StateSpace space_;
  PlannedMachine split_;
  std::vector<OpenCases> open_;
  std::vector<OperationCase*> found_;
  OperationCases all_;
};

}  // namespace

OperationCases operation_cases(const Machine& machine, const ExploreBounds& bounds) {
  ExploreBounds plain = bounds;
  plain.symmetry = false;  // each state has its own way
  return CaseSearch(machine, plain).found();
}

}  // namespace durero::spec
