#pragma once
/// Anyone's Z text stepped through as a machine. What its schemas mean as operations is said by convention alone: a
/// *state* is a schema S, an *operation* a schema with all components of S and of S ', its *inputs* are the other
/// components with ? and its *outputs* those with !, and an *initial* schema, such as Init, has the components of S or
/// of S ' and no others of S.
///
/// A given set has no members of its own: here it has so many as `Setup` says, and what is found holds for those.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::spec {

/// How a text is animated.
struct Setup {
  std::string state, init;                                ///< the names of these schemas; empty: as the conventions say
  std::map<std::string, std::vector<std::string>> given;  ///< the members of given sets, by the names of the sets
  std::vector<std::string> constants{};                   ///< the values of constants, `NAME=VALUE` each
  std::size_t members = 3;                                ///< how many the other given sets have: NAME1, NAME2, …
  int numbers = 2;                  ///< numbers are looked for in −numbers‥numbers, and so far from that before
  std::size_t inputs = 1000;        ///< so many choices of inputs, and of what is left open, are tried for an operation
  std::uint64_t steps = 1'000'000;  ///< one question may take so many (zed::Steps)
};

/// An operation of a machine: its name, and the components beside the states.
struct MachineOperation {
  std::string name;                        ///< of its schema
  std::vector<zed::Name> inputs, outputs;  ///< those with ?, and those with !
};

/// A transition: what was done, with what, and the state after it. The first of a trace is that of the initial schema.
struct Transition {
  std::string operation;                           ///< the name of its schema
  zed::Valuation inputs, outputs, after;           ///< `after` by the names of the state's components
  bool operator==(const Transition& other) const;  ///< by the same values
};

/// What was found, and what was left out in looking for it.
struct ReachedTransitions {
  std::vector<Transition> transitions;  ///< each once
  bool undecided = false;               ///< there may be others: equations do not give them
  std::set<zed::Name> tried{};          ///< some values of these were tried, as equations leave something open
  std::string bounded;                  ///< the flag that kept it from being looked further; empty: none did
};

/// The names, with commas between them.
std::string name_list(const std::set<zed::Name>& names);

/// A conjecture of the text, and whether it holds where it was tried.
struct ConjectureResult {
  std::string claim;                    ///< in Unicode
  std::string place;                    ///< FILE:LINE
  zed::Truth truth = zed::Truth::open;  ///< open: it could not be decided
  bool of_states = false;               ///< it speaks of a state or a transition
};

/// The text as a machine. Not for use by two threads at once.
class Machine {
 public:
  /// Throws std::invalid_argument where the text has no state schema, or none of the names that the setup says,
  /// ConstantError (constants.hpp) where a constant cannot be what it says, and zed::ZError where it has defects.
  Machine(const zed::Specification& specification, Setup setup);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const std::string& state() const;                  ///< the name of the state schema
  const std::string& init() const;                   ///< that of the initial schema; empty where the text has none
  const std::vector<zed::Name>& components() const;  ///< those of the state, in the order of the text
  const std::vector<MachineOperation>& operations() const;  ///< sorted by name
  /// The operation of that name, or null.
  const MachineOperation* find(const std::string& name) const;
  /// The given sets, with their members, as Z: `NAME == {NAME1, NAME2}`.
  std::vector<std::string> carriers() const;
  /// A line for each constant for which a value was taken, as nothing gives it one.
  std::vector<std::string> taken() const;

  /// @{ All that follow throw zed::StepsSpent where a question takes more steps than it may.
  /// The initial states, `most` at most.
  ReachedTransitions initial(std::size_t most) const;
  /// What the operation may do in that state; inputs that are not given are looked for.
  ReachedTransitions steps(const zed::Valuation& before, const MachineOperation& operation,
                           const zed::Valuation& inputs, std::size_t most) const;
  /// Whether the transition is one of the operation, or its state one of the initial schema.
  zed::Truth is_step(const zed::Valuation& before, const Transition& transition) const;
  /// Each conjunct of the state schema.
  std::vector<zed::ConjunctTruth> invariant(const zed::Valuation& state) const;
  /// Each conjunct of the operation that the state and the inputs decide, and the others open.
  std::vector<zed::ConjunctTruth> preconditions(const zed::Valuation& before, const MachineOperation& operation,
                                                const zed::Valuation& inputs) const;
  /// The conjectures, those of states in this transition (whose `operation` is empty where there is none before it).
  std::vector<ConjectureResult> conjectures(const zed::Valuation& before, const Transition& transition) const;
  /// @}

  /// The value of a Z term that was typed for a component of the state or of an operation. Throws zed::ZError.
  zed::Value typed(const std::string& text, const zed::Name& component) const;
  /// A component's value as Z that typed() reads.
  std::string written(const zed::Name& component, const zed::Value& value) const;
  /// The type of a component of the state, or of an operation, as Z.
  std::string type_text(const zed::Name& component) const;

  struct Parts;                ///< what it is made of
  const Parts& parts() const;  ///< for what explores it

 private:
  std::unique_ptr<Parts> parts_;
};

/// Where a machine has come to, and by what way.
class Animation {
 public:
  /// Of a machine that outlives it, with no state yet.
  explicit Animation(const Machine& machine) : machine_(machine) {}

  /// The way so far; the first transition is the initial one.
  const std::vector<Transition>& way() const { return way_; }
  /// The state now; null before the first.
  const zed::Valuation* now() const { return way_.empty() ? nullptr : &way_.back().after; }
  /// The state before the last transition; null where there is none.
  const zed::Valuation* before() const { return way_.size() < 2 ? nullptr : &way_[way_.size() - 2].after; }
  /// Goes on by a transition that the machine found.
  void take(Transition transition) { way_.push_back(std::move(transition)); }
  /// Takes the last transition back; false where there is none but the first.
  bool back();
  /// Begins anew.
  void restart() { way_.clear(); }

  /// The way as text: docs/formats/others.md says how.
  std::string saved() const;
  /// Goes the way of such a text, and checks each transition by the text. Throws zed::ZError with the place in it; the
  /// way is then as it was.
  void replay(const std::string& text);

 private:
  const Machine& machine_;
  std::vector<Transition> way_;
};

/// The states that a machine can reach, breadth first.
struct Exploration {
  std::uint64_t states = 0, transitions = 0;  ///< so many were found
  std::vector<std::string> bounded;           ///< what was left out, by the flag that would admit it
  std::optional<ConjectureResult> refuted;    ///< the first conjecture that is false in a state or a transition
  std::vector<Transition> way;                ///< leads there
  std::uint64_t open = 0;                     ///< conjectures, in states and transitions, that could not be decided
  std::uint64_t claims = 0;                   ///< the conjectures that were decided there
};

/// The states that an exploration found, and the transitions between them.
struct StateGraph {
  /// A transition between two states, by their places among these.
  struct Edge {
    std::size_t from;  ///< the state before
    std::size_t to;    ///< the state after
    Transition step;   ///< what leads there
  };
  std::vector<zed::Valuation> states;  ///< each once; the first ones are initial
  std::size_t initial = 0;             ///< how many are
  std::vector<Edge> steps;             ///< as they were found, to states that are listed
};

/// Explores from that state on, to `most_states` states. The way begins with that state's own. `graph`, where given, is
/// filled.
Exploration explore(const Machine& machine, const std::vector<Transition>& from, std::size_t most_states,
                    StateGraph* graph = nullptr);

}  // namespace durero::spec
