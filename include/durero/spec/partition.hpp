#pragma once
/// Tests made from a text: an operation's predicate is a disjunction of conjunctions, and each of these is one case,
/// with a state that can be reached, inputs, and what the text then admits.

#include "durero/spec/explore.hpp"

namespace durero::spec {

/// One case of an operation.
struct OperationCase {
  std::string operation;                 ///< the name of its schema
  std::vector<std::string> disjuncts{};  ///< the sides that make it, in Unicode; none where the operation has one case
  bool is_found = false;                 ///< an example of it was found: all that follows
  std::vector<Transition> way{};         ///< leads to the state before
  zed::Valuation inputs{};               ///< the inputs of the example
  std::vector<Transition> admitted{};    ///< all that the text admits with these inputs, the example first
};

/// The cases of every operation of a machine.
struct OperationCases {
  std::vector<OperationCase> cases{};  ///< by operation
  std::vector<std::string> whole{};    ///< operations that could not be taken apart, each one case
  std::vector<std::string> bounded{};  ///< what the search for examples left out, by the flag that would admit it
};

/// Takes the operations apart, and looks for an example of each case in the states that the machine can reach. Where
/// none is found the case is infeasible, as far as the bounds go.
OperationCases operation_cases(const Machine& machine, const ExploreBounds& bounds);

}  // namespace durero::spec
