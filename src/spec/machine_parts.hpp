#pragma once
/// What a machine is made of.

#include <map>
#include <optional>
#include <set>

#include "durero/spec/animation.hpp"
#include "durero/spec/calculator.hpp"
#include "durero/spec/spec.hpp"
#include "search_watch.hpp"

namespace durero::spec {

struct Machine::Parts {
  static constexpr const char* section_name = "run";

  struct Claim {
    zed::Term term;
    std::string text, place;
    /// Of one that speaks of no state, once it was tried; and open, of one that takes too many steps.
    std::optional<zed::Truth> truth{};
  };

  Parts(const zed::Specification& text, Setup how);

  Setup setup;
  zed::Specification specification;
  Notation notation;
  zed::Typing typing;
  std::map<std::string, std::vector<std::string>> carriers{};
  zed::Valuation given{};  ///< of the evaluator
  std::string state{}, init{};
  std::vector<zed::Name> components{};
  std::map<zed::Name, zed::Type> types{};  ///< of the components of states and operations
  std::vector<MachineOperation> operations{};
  std::vector<Claim> claims{};
  mutable zed::Steps steps{};
  mutable SearchWatch watch{};  ///< of the exploration that asks
  std::unique_ptr<zed::Evaluator> evaluator{};

  /// Counts the steps from 0 again. Throws StoppedSearch.
  void begin_question() const {
    watch.ask();
    steps = zed::Steps(setup.steps);
  }
  const zed::SchemaCheck& check(const std::string& schema) const;
  const zed::Completion& completion(const std::string& schema, const std::vector<zed::Name>& known) const;
  /// Every name that the transition gives a value: those of the state before, of the state after with ', and its own.
  zed::Valuation named(const zed::Valuation& before, const Transition& transition) const;
  /// Whether values of the type have numbers in them, of which there is no end.
  bool has_numbers(const zed::Type& type) const;
  /// The truth of a claim, or of its instance with these names; open where it cannot be decided.
  zed::Truth truth(const zed::Term& term, const zed::Valuation& locals, Claim& claim) const;
  /// Some values of the type, the same each time.
  std::vector<zed::Value> samples(const zed::Type& type) const;

 private:
  using Fields = std::map<std::string, std::vector<zed::Name>>;
  void declare_carriers();
  [[noreturn]] void refuse_given(const std::string& set) const;
  void take_constants();
  Fields schemas() const;
  void choose_state(const Fields& schemas);
  void choose_init(const Fields& schemas);
  void add_operations(const Fields& schemas);
  void add_types(const std::string& schema);
  void add_claims();

  mutable std::map<std::string, zed::SchemaCheck> checks_{};
  mutable std::map<std::pair<std::string, std::vector<zed::Name>>, zed::Completion> completions_{};
};

}  // namespace durero::spec
