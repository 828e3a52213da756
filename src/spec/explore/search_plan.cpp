#include "search_plan.hpp"

#include <algorithm>

#include "plan_maker.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

bool SearchPlan::from(std::size_t step, IdFrame frame, const std::function<bool()>& visit) const {
  watch_->count();
  for (; step < steps_.size() && steps_[step].test; ++step)
    if (!steps_[step].test(frame)) return true;
  if (step == steps_.size()) return visit();
  const struct {
    const SearchPlan& plan;
    std::size_t next;
    IdFrame frame;
    const std::function<bool()>& visit;
  } rest{*this, step + 1, frame, visit};
  return steps_[step].go(frame, [&rest] { return rest.plan.from(rest.next, rest.frame, rest.visit); });
}

bool has_term(const std::vector<Term>& terms, const Term& term) {
  return std::find(terms.begin(), terms.end(), term) != terms.end();
}

bool PlanMaker::meets(const Places& a, const Places& b) {
  return std::any_of(a.begin(), a.end(), [&](unsigned each) { return b.contains(each); });
}

void PlanMaker::make(const SoughtNames& sought) {
  Pending pending;
  scopes_.push_back(sought.scope);
  add(pending, sought, scopes_.back());
  plan(std::move(pending), plan_.steps_, {});
}

void PlanMaker::add(Pending& pending, const SoughtNames& sought, const FrameScope& scope) {
  for (std::size_t i = 0; i < sought.variables.size(); ++i)
    pending.unknown.emplace(sought.variables[i].first, Sought{sought.variables[i].second, sought.names[i].first});
  for (const Term& fact : sought.facts)
    if (!has_term(wish_.held, fact)) pending.facts.push_back({fact, &scope});
}

PlanMaker::Places PlanMaker::unknown_places(const Pending& pending) {
  Places places;
  for (const auto& [at, sought] : pending.unknown) places.insert(at);
  return places;
}

void PlanMaker::plan(Pending pending, Steps& steps, std::vector<Term> sides) {
  for (;;) {
    translator_.parts().watch.ask();
    if (wish_.split && add_sides(pending, steps, sides, true)) return;
    if (add_tests(pending, steps) || add_equation(pending, steps)) continue;
    if (pending.unknown.empty()) break;
    if (add_inner(pending) || add_membership(pending, steps) || add_listing(pending, steps, few_members)) continue;
    if (add_sides(pending, steps, sides, false)) return;
    if (add_range(pending, steps, false) || add_listing(pending, steps, unlisted) ||
        (wish_.bound_numbers && add_range(pending, steps, true)))
      continue;
    throw NotInterned("nothing lists the values of " + pending.unknown.begin()->second.name.text());
  }
  if (!wish_.split) return;
  plan_.all_sides_.push_back(sides);
  const auto& plan = plan_;
  steps.push_back({[&plan, sides](IdFrame) {
                     plan.sides_ = sides;
                     return true;
                   },
                   {}});
}

/// Asks each fact of which all is known.
bool PlanMaker::add_tests(Pending& pending, Steps& steps) {
  const Places unknown = unknown_places(pending);
  bool some = false;
  for (std::size_t i = 0; i < pending.facts.size();) {
    const auto& test = test_of(pending.facts[i]);
    if (meets(test.reads, unknown)) {
      ++i;
      continue;
    }
    const Fact& fact = pending.facts[i];
    steps.push_back({fact.counted && !fact.whole ? counted(fact.term, test.code) : test.code, {}});
    pending.facts.erase(pending.facts.begin() + static_cast<std::ptrdiff_t>(i));
    some = true;
  }
  return some;
}

const TermTranslator::Translated<IdTest>& PlanMaker::test_of(Fact& fact) {
  if (!fact.test)
    fact.test =
        std::make_shared<const TermTranslator::Translated<IdTest>>(translator_.predicate_read(fact.term, *fact.scope));
  return *fact.test;
}

IdTest PlanMaker::counted(const Term& fact, IdTest test) {
  if (!wish_.counts || has_term(wish_.uncounted, fact)) return test;
  auto& counts = *wish_.counts;
  std::size_t at = 0;
  while (at < counts.size() && !(counts[at].fact == fact)) ++at;
  if (at == counts.size()) counts.push_back({fact});
  return [&counts, at, test = std::move(test)](IdFrame frame) {
    const bool holds = test(frame);
    ++(holds ? counts[at].yes : counts[at].no);
    return holds;
  };
}

/// The name that a term is, where its value is sought.
std::optional<unsigned> PlanMaker::sought_name(const Pending& pending, const Term& term, const FrameScope& scope) {
  if (term->kind != Kind::reference || !term->children.empty()) return std::nullopt;
  const auto at = scope.find(term->name);
  return at && pending.unknown.contains(*at) ? at : std::nullopt;
}

/// Gives a name its value; what is declared of it is asked.
void PlanMaker::give(Pending& pending, Steps& steps, unsigned at, IdCode value) {
  const DomainPtr set = pending.unknown.at(at).set;
  pending.unknown.erase(at);
  const bool ask = set && !set->is_whole();
  steps.push_back({[at, value = std::move(value), set = ask ? set : nullptr](IdFrame frame) {
                     frame[at] = value(frame);
                     return frame[at] != 0 && (!set || set->has(frame[at], frame));
                   },
                   {}});
}

std::shared_ptr<const SearchPlan> planned_search(TermTranslator& translator, const SoughtNames& sought,
                                                 const PlanWish& wish) {
  auto plan = std::make_shared<SearchPlan>(translator.parts().watch);
  PlanMaker(translator, *plan, wish).make(sought);
  return plan;
}

}  // namespace durero::spec
