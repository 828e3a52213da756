/// Plans the sides of disjunctions.
#include <algorithm>

#include "plan_maker.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

namespace {

/// A disjunction has more combinations of sides than so many: the plan is then given up.
constexpr std::size_t most_sides = 256;

}  // namespace

/// The sides of a fact, each as the facts that it adds; none where it is no disjunction.
std::vector<std::vector<PlanMaker::Fact>> PlanMaker::sides_of(const Fact& fact) const {
  if (fact.whole) return {};
  const Node& node = *fact.term;
  const auto no = [&](const Term& term) { return zed::node(Kind::negation, {term}, term->place); };
  const auto side = [&](std::initializer_list<Fact> facts) { return std::vector<Fact>(facts); };
  const auto of = [&](const Term& term, bool whole = false) { return Fact{term, fact.scope, whole}; };
  if (node.kind == Kind::disjunction) {
    const Term &a = node.children[0], &b = node.children[1];
    return {side({of(a)}), wish_.split ? side({of(b)}) : side({of(b), of(no(a), true)})};
  }
  if (node.kind == Kind::implication)
    return {side({of(no(node.children[0]))}), side({of(node.children[0]), of(node.children[1])})};
  if (node.kind == Kind::equivalence)
    return {side({of(node.children[0]), of(node.children[1])}),
            side({of(no(node.children[0])), of(no(node.children[1]))})};
  if (node.kind == Kind::negation && node.children[0]->kind == Kind::conjunction) {
    const Term &a = node.children[0]->children[0], &b = node.children[0]->children[1];
    return {side({of(no(a))}), wish_.split ? side({of(no(b))}) : side({of(no(b)), of(a, true)})};
  }
  return {};
}

/// Goes each side of a disjunction on its own.
bool PlanMaker::add_sides(Pending& pending, Steps& steps, const std::vector<Term>& before, bool any) {
  for (std::size_t i = 0; i < pending.facts.size(); ++i) {
    const auto sides = sides_of(pending.facts[i]);
    if (sides.empty() || (any && has_term(wish_.uncounted, pending.facts[i].term))) continue;
    if (!any && !meets(test_of(pending.facts[i]).reads, unknown_places(pending))) continue;
    auto plans = std::make_shared<std::vector<std::unique_ptr<SearchPlan>>>();
    for (const std::vector<Fact>& side : sides) {
      if (++sides_ > most_sides) throw NotInterned("a predicate has many disjuncts");
      Pending rest = pending;
      rest.facts.erase(rest.facts.begin() + static_cast<std::ptrdiff_t>(i));
      add_side(rest, side);
      std::vector<Term> way = before;
      if (sides_of(side.front()).empty()) way.push_back(side_text(side));
      plans->push_back(std::make_unique<SearchPlan>(translator_.parts().watch));
      plan(std::move(rest), plans->back()->steps_, way);
    }
    plan_.repeats_ = plan_.repeats_ || wish_.split;
    steps.push_back({{}, [plans](IdFrame frame, const std::function<bool()>& on) {
                       return std::all_of(plans->begin(), plans->end(),
                                          [&](const auto& side) { return side->each(frame, on); });
                     }});
    return true;
  }
  return false;
}

Term PlanMaker::side_text(const std::vector<Fact>& side) {
  Term text = side[0].term;
  for (std::size_t i = 1; i < side.size(); ++i) text = zed::node(Kind::conjunction, {text, side[i].term}, text->place);
  return text;
}

void PlanMaker::add_side(Pending& rest, const std::vector<Fact>& side) {
  for (const Fact& fact : side) {
    if (fact.whole) {
      rest.facts.push_back(fact);
      continue;
    }
    std::vector<Term> facts;
    translator_.add_facts(facts, fact.term);
    for (const Term& each : facts)
      if (!has_term(wish_.held, each)) rest.facts.push_back({each, fact.scope});
  }
}

}  // namespace durero::spec
