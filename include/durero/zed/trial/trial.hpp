#pragma once
/// Tries the conjectures of a Z text on states. To try is not to prove: what no state refutes is not therefore true.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"
#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// Members of sets and bindings of schemas, by the name of the set or schema. What has none here is made up by its
/// type.
using Samples = std::map<std::string, std::vector<Value>>;

/// What came of one conjecture. A state gives a value to each name that the outermost quantifier declares, and
/// satisfies what it asks of them; a conjecture that begins with no quantifier has one state.
struct Trial {
  std::string file;       ///< the conjecture stands in this file
  Place place;            ///< at its ⊢?
  std::string label;      ///< the comment that ends it says it, if any
  std::size_t tried = 0;  ///< on so many states it was decided, and true; of ∃, so many were looked at for the witness
  std::string counterexample;  ///< a state where it is false, a name and value a line; empty where none was met
  std::string why_not;         ///< where `tried` is 0 and there is no counterexample: the reason
  Given taken{};               ///< what was taken for constants by then (Evaluator::taken)
};

/// How far a trial goes.
struct TrialBounds {
  std::size_t states = 8;         ///< no more states are tried of a conjecture, but for the witness of an ∃
  std::size_t draws = 64;         ///< nor are more values drawn, of which not all need be states
  std::uint64_t steps = 1000000;  ///< nor is it evaluated any longer than so many steps
  Given constants{};              ///< constants of the text have these values
};

/// Tries every conjecture, in the order of the text. The states are the same at every call. Precondition: `typing` is
/// check(specification), and both are without defects.
std::vector<Trial> try_conjectures(const Specification& specification, const Typing& typing,
                                   const Samples& samples = {}, const TrialBounds& bounds = {});

}  // namespace durero::zed
