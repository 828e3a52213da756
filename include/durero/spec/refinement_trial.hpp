#pragma once
/// Tries the obligations of a refinement in small scopes: on the pairs of states that both reach together from their
/// initial states, and on all states within the scope. To try is not to prove; what is false is shown by two traces.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/spec/animation.hpp"
#include "durero/spec/refinement.hpp"

namespace durero::spec {

/// How far a refinement is tried. A scope of n has given sets of n members, numbers from −n to n, and sequences and
/// tables with so many places.
struct RefinementBounds {
  std::size_t scope = 3;            ///< the scopes from 1 to this are tried
  std::size_t states = 300;         ///< in each, so many pairs of states are reached, and so many states are listed
  std::uint64_t steps = 1'000'000;  ///< one question may take so many (zed::Steps)
  std::map<std::string, std::vector<std::string>> given{};  ///< the members of given sets, whatever the scope
  std::vector<std::string> constants{};                     ///< the values of constants, `NAME=VALUE` each
};

/// Two traces after which an obligation is false.
struct RefinementCounterexample {
  std::size_t scope = 0;                       ///< it was found in this scope
  bool reached = false;                        ///< the traces begin with the initial schemas, and not in any states
  std::vector<Transition> abstract, concrete;  ///< as far as each goes
  std::string why;                             ///< a sentence that says what is false then
};

/// The result of trying one obligation. A case is a choice of values for what it quantifies that satisfies its
/// conditions.
struct ObligationTrial {
  Obligation obligation;                                     ///< as stated
  std::size_t held = 0;                                      ///< the cases in which it is true
  std::size_t open = 0;                                      ///< those in which it is not decided
  std::string why_open;                                      ///< the reason for one of them
  std::optional<RefinementCounterexample> counterexample{};  ///< the first case in which it is false, if any
};

/// The results of trying all of them.
struct RefinementTrial {
  bool functional = false;           ///< the obligations are those of a retrieve function
  std::vector<ObligationTrial> all;  ///< in the order of obligations()
  std::vector<std::string> bounds;   ///< what each scope had
  std::vector<std::string> taken;    ///< a line for each constant for which a value was taken
  /// Whether each obligation was tried, and is true in every case.
  bool holds() const;
};

/// Tries all obligations of a refinement. Precondition: the refinement is of the text, which is without defects. Throws
/// what Machine does for its setup.
RefinementTrial try_refinement(const zed::Specification& text, const Refinement& refinement,
                               const RefinementBounds& bounds);

/// The answer as text: each obligation with its result, the bounds, and each counterexample as a pair of traces.
std::string refinement_answer(const zed::Specification& text, const Refinement& refinement,
                              const RefinementBounds& bounds, const RefinementTrial& trial);

}  // namespace durero::spec
