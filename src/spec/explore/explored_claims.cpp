/// The claims of an exploration: what they ask, and where they are false.
#include <algorithm>

#include "explore_impl.hpp"
#include "spec/claims.hpp"

namespace durero::spec {

using zed::Name;
using zed::Term;

namespace {

/// S ⇒ Q, where Q is asked first: it is true of most states, and much the smaller.
IdTest consequent_first(const Term& instance, const std::function<IdTest(const Term&)>& test_of) {
  return [schemas = test_of(instance->children[0]), rest = test_of(instance->children[1])](IdFrame frame) {
    try {
      if (rest(frame)) return true;
    } catch (const Undecided&) {
      if (!schemas(frame)) return true;
      throw;
    }
    return !schemas(frame);
  };
}

}  // namespace

Term StateSpace::Impl::state_predicate(const std::string& text, const std::string& option) const {
  const Machine::Parts& parts = machine.parts();
  std::vector<std::pair<Name, zed::Type>> locals = zed::calculator_names();
  for (const Name& name : machine.components()) locals.emplace_back(name, parts.types.at(name));
  Term term = parsed(text, parts.notation);
  const zed::Typing typing = zed::check_term(parts.typing, Machine::Parts::section_name, term, locals, option);
  if (!typing.ok()) {
    const zed::Defect& first = typing.defects.front();
    throw zed::ZError(first.place, first.what, first.expected);
  }
  const auto type = typing.type_of(term);
  if (type && !type->is_schema_set()) throw zed::ZError(term->place, "this is an expression", "expected a predicate");
  return term;
}

void StateSpace::Impl::add_claim(const std::string& text, const std::string& place, const Term& term) {
  claims.push_back({text, place, term, true, planned.state_test(term)});
}

/// Each conjecture is asked where it has all the names that it speaks of.
void StateSpace::Impl::add_claims() {
  const Machine::Parts& parts = machine.parts();
  const auto has_all = [](const FrameScope& scope, const std::vector<Name>& names) {
    return std::all_of(names.begin(), names.end(), [&](const Name& name) { return scope.places.contains(name); });
  };
  for (Machine::Parts::Claim& each : const_cast<Machine::Parts&>(parts).claims) {
    const auto names = included_names(parts.typing, each.term);
    ExploredClaim claim{each.text, each.place, each.term};
    if (!names) {
      const zed::Truth truth = each.truth ? *each.truth : parts.truth(each.term, {}, each);
      each.truth = truth;
      claim.asked = true;
      claim.open_somewhere = truth == zed::Truth::open;
      ++(claim.open_somewhere ? report.unanswered : report.answers);
      claim.false_somewhere = truth == zed::Truth::no;
      if (claim.false_somewhere) report.refuted.push_back({each.text, each.place, {}, {}});
      claims.push_back(std::move(claim));
      continue;
    }
    const Term instance = claim_instance(each.term);
    const auto& components = machine.components();
    claim.of_state = std::all_of(names->begin(), names->end(), [&](const Name& name) {
      return std::find(components.begin(), components.end(), name) != components.end();
    });
    if (claim.of_state) {
      claim.test = consequent_first(instance, [&](const Term& part) { return planned.state_test(part); });
    } else {
      const auto& operations = planned.operations();
      for (std::size_t i = 0; i < operations.size(); ++i)
        if (has_all(operations[i].scope, *names)) claim.step_tests.emplace_back(i, IdTest());
      if (has_all(planned.initial().scope, *names)) claim.step_tests.emplace_back(operations.size(), IdTest());
    }
    claims.push_back(std::move(claim));
  }
}

/// Translates a claim for the steps of an operation.
IdTest StateSpace::Impl::step_claim(const ExploredClaim& claim, std::size_t operation) {
  auto& operations = planned.operations();
  const PlannedOperation& of = operation == operations.size() ? planned.initial() : operations[operation];
  return consequent_first(claim_instance(claim.term), [&](const Term& part) { return planned.step_test(of, part); });
}

template <class Test>
void StateSpace::Impl::ask(ExploredClaim& claim, Test&& test, const std::function<Refutation()>& refutation) {
  if (claim.false_somewhere) return;
  claim.asked = true;
  try {
    const bool holds = test(planned.frame());
    ++report.answers;
    if (holds) return;
    claim.false_somewhere = true;
    refutations.push_back(refutation());
  } catch (const Undecided&) {
    claim.open_somewhere = true;
    ++report.unanswered;
  } catch (const NotInterned&) {
    claim.open_somewhere = true;
    ++report.unanswered;
  }
}

void StateSpace::Impl::try_state(StateIndex at) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (!claims[i].test) continue;
    planned.load_state(table.state(at));
    ask(claims[i], claims[i].test, [&] { return Refutation{i, at, any_operation, {}}; });
  }
}

void StateSpace::Impl::try_step(std::size_t operation, StateIndex before, std::span<const ValueId> row) {
  const auto& operations = planned.operations();
  const bool is_initial = operation == operations.size();
  for (std::size_t i = 0; i < claims.size(); ++i)
    for (auto& [of, test] : claims[i].step_tests) {
      if (of != operation || claims[i].false_somewhere) continue;
      if (!test) test = step_claim(claims[i], operation);
      planned.load(is_initial ? planned.initial() : operations[operation],
                   is_initial ? std::span<const ValueId>() : table.state(before), row);
      ask(claims[i], test, [&] {
        return Refutation{i, before, static_cast<std::uint32_t>(operation), {row.begin(), row.end()}};
      });
    }
}

void StateSpace::Impl::add_refuted() {
  for (const Refutation& each : refutations) {
    const ExploredClaim& claim = claims[each.claim];
    FalseClaim refuted{claim.text, claim.place, {}, {}};
    const auto& operations = planned.operations();
    if (each.operation == any_operation)
      refuted.way = way_to(each.before);
    else if (each.operation == operations.size())
      refuted.way = {planned.transition(planned.initial(), each.row)};
    else {
      // The step is from the first state of a class; a way that leads to another state of it has one like it.
      refuted.way = way_to(each.before);
      const auto& operation = operations[each.operation];
      if (!exchange) {
        refuted.way.push_back(planned.transition(operation, each.row));
      } else {
        add_false_step(refuted.way, each);
      }
    }
    report.refuted.push_back(std::move(refuted));
  }
}

/// The first step from the end of the way that makes the claim false.
void StateSpace::Impl::add_false_step(std::vector<Transition>& way, const Refutation& refutation) {
  auto& operation = planned.operations()[refutation.operation];
  const std::vector<ValueId> before = planned.ids(way.back().after);
  const StepRows rows = planned.rows(operation, before);
  for (const auto& [of, test] : claims[refutation.claim].step_tests)
    for (std::size_t i = 0; i < rows.size() && of == refutation.operation; ++i) {
      planned.load(operation, before, rows.row(i));
      if (test(planned.frame())) continue;
      way.push_back(planned.transition(operation, rows.row(i)));
      return;
    }
}

}  // namespace durero::spec
