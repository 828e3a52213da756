#pragma once
/// A trial evaluates a conjecture of a Z text on states. It is no proof: a conjecture that no state refutes may still
/// be false.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/smt/smt.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// Samples are members of sets and bindings of schemas, by the name of the set or schema. Values for any other are made
/// up by its type.
using Samples = std::map<std::string, std::vector<Value>>;

/// The result of trying one conjecture. A state gives a value to each name that the outermost quantifier declares, and
/// satisfies the conditions on them; a conjecture that begins with no quantifier has one state.
struct Trial {
  std::string file;           ///< the conjecture stands in this file
  Place place;                ///< at its ⊢?
  std::string label;          ///< the comment that ends it says it, if any
  std::size_t tried = 0;      ///< the states where it was decided and true; for ∃, the states looked at for a witness
  bool is_evaluated = false;  ///< it is true in every state: the evaluation of the whole of it says so
  std::string counterexample{};  ///< a state where it is false, a name and value a line; empty where none was met
  std::string why_not{};         ///< where `tried` is 0 and there is no counterexample: the reason
  std::string solver_said{};     ///< what came of asking the solver; empty where it was not asked
  Valuation taken{};             ///< the values taken for constants by then (Evaluator::taken)
};

/// The bounds of a trial.
struct TrialBounds {
  std::size_t states = 8;         ///< the most states of a conjecture, except for the witness of an ∃
  std::size_t draws = 64;         ///< the most values drawn, not all of which need be states
  std::uint64_t steps = 1000000;  ///< the most steps of its evaluation
  Valuation constants{};          ///< constants of the text, and given sets, have these values
  std::optional<std::pair<std::int64_t, std::int64_t>> numbers{};  ///< those tried are from one to the other
  const SmtProgram* solver = nullptr;  ///< it is asked of what is neither decided nor refuted then; null: none is
};

/// Tries every conjecture. Without samples the whole of it is evaluated first. Where that does not decide it, the
/// states of a small scope come first, given sets of three members where they have no others, numbers up to 3 or within
/// the bounds, and what is made of them, and states by chance then. The conjectures are in the order of the text. The
/// states are the same at every call. Precondition: `typing` is check(specification), and both are without defects.
std::vector<Trial> try_conjectures(const Specification& specification, const Typing& typing,
                                   const Samples& samples = {}, const TrialBounds& bounds = {});

}  // namespace durero::zed
