#pragma once
/// The trial of one conjecture.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "zed/trial/claim.hpp"
#include "zed/trial/draw.hpp"

namespace durero::zed {

/// Knows which samples are members of the set that they are samples of: each is asked once, for all conjectures.
class Members {
 public:
  Members(const Evaluator& evaluator, const Draw& draw) : evaluator_(evaluator), draw_(draw) {}
  /// Says whether it is known that sample `index` of this set is a member. Precondition: there is one.
  bool knows(const std::string& set, std::size_t index);

 private:
  const Evaluator& evaluator_;
  const Draw& draw_;
  std::map<std::string, std::vector<std::optional<bool>>> known_;
};

/// What all trials of a text share, which outlives them.
struct Ground {
  const Typing& typing;
  const Draw& draw;
  const Evaluator& evaluator;
  const TrialBounds& bounds;
  Members& members;
  Steps& steps;  ///< of what is asked now
  bool is_own;   ///< samples are the text's own: states come from these alone
};

/// Tries one conjecture.
class Attempt {
 public:
  Attempt(const Ground& ground, const QuantifiedClaim& claim);
  /// Tries it, and notes what came of it. Throws what the evaluator throws where it cannot go on; what was tried before
  /// is noted then.
  void run(Trial& trial);

 private:
  /// The values of a declaration come from samples of a set, or are made up. Each has places among the components of
  /// the claim; a name that two declarations share has the value of the first.
  struct Source {
    Type element;
    Term set;                              ///< the declaration has this set or schema
    const std::string* samples = nullptr;  ///< the name of the set that has samples
    bool is_binding = false;               ///< one value gives all places, else each place has a value of its own
    std::vector<std::size_t> places{};     ///< `nowhere` for what is not asked of the value
    std::size_t declaration = 0;           ///< it stands in this declaration of the claim
    bool is_declaration = false;           ///< and is all that this declares
  };
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  /// Values for the components of the claim, and what is known of them.
  struct State {
    std::vector<Value> values;
    SchemaCheck::KnownTruth known;
  };

  bool evaluate(Trial& trial);
  void show_denial(Trial& trial);
  void run_small(Trial& trial);
  std::vector<Value> small(const Source& source, std::size_t most);
  void run_drawn(Trial& trial);
  void add_sources(const Declaration& declaration, std::size_t number, bool outermost);
  void add_included(const Term& schema, Source source);
  std::size_t place_of(const Name& name);
  const Type& element_of(const Term& set);
  State nothing_known() const;
  State drawn(std::size_t draw);
  void draw_from(const Source& source, Chances& chances, State& state);
  void on(const State& drawn, Trial& trial);
  bool complete(const State& drawn, std::vector<Value>& found);
  Truth completed(const State& drawn, std::vector<Value>& found);
  void make(std::vector<Name> names);
  void ask_for_witness(Trial& trial);
  void note(const std::string& undecided);
  void judge(const std::vector<Value>& values, Truth last, Trial& trial);

  const Ground& ground_;
  const QuantifiedClaim& claim_;
  SchemaCheck check_;
  std::vector<Source> sources_;
  std::vector<bool> placed_;              // components that some source gives
  std::vector<Name> made_;                // an operation makes these of the rest, or conjuncts do
  std::vector<std::size_t> made_places_;  // these are theirs
  std::optional<Completion> results_;     // gives these, once it is asked
  std::size_t narrowings_ = 0;            // so often fewer names may still be tried to be made of the rest
  std::map<const Node*, Type> elements_;  // the types of the members of sets that declarations name
  struct Before {
    bool operator()(const std::vector<Value>& a, const std::vector<Value>& b) const;
  };
  std::set<std::vector<Value>, Before> drawn_, met_;  // each draw is looked at once, and each state counts once
  std::string undecided_;                             // the first reason why some state decided nothing
  bool witness_ = false;
};

}  // namespace durero::zed
