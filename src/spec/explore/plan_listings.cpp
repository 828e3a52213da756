/// Plans which sets and which numbers are gone through.
#include <algorithm>

#include "plan_maker.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

/// Lists the smallest set of a name that no equation may give, unless sets of any size are listed.
bool PlanMaker::add_listing(Pending& pending, Steps& steps, double below) {
  const Places targets = below == unlisted ? Places{} : given_by_equations(pending);
  const std::pair<const unsigned, Sought>* best = nullptr;
  for (const auto& each : pending.unknown)
    if (each.second.set && !targets.contains(each.first) && each.second.set->size() < below &&
        (!best || each.second.set->size() < best->second.set->size()))
      best = &each;
  if (!best) return false;
  const unsigned at = best->first;
  const DomainPtr set = best->second.set;
  pending.unknown.erase(at);
  steps.push_back({{}, [at, set](IdFrame frame, const std::function<bool()>& on) {
                     return set->each(frame, [&](ValueId value) {
                       frame[at] = value;
                       return on();
                     });
                   }});
  return true;
}

/// The names that an equation, in some side of a disjunction too, may give.
PlanMaker::Places PlanMaker::given_by_equations(const Pending& pending) {
  Places places;
  const std::function<void(const Term&, const FrameScope&)> look = [&](const Term& term, const FrameScope& scope) {
    if (term->kind == Kind::relation && term->names.size() == 1 && term->names[0].word == "_=_")
      for (const Term& side : term->children)
        if (const auto at = sought_name(pending, side, scope)) places.insert(*at);
    const bool connects = term->kind == Kind::conjunction || term->kind == Kind::disjunction ||
                          term->kind == Kind::implication || term->kind == Kind::equivalence;
    if (connects)
      for (const Term& child : term->children) look(child, scope);
  };
  for (const Fact& fact : pending.facts) look(fact.term, *fact.scope);
  return places;
}

PlanMaker::Bounds PlanMaker::bounds_of(Pending& pending, unsigned at) {
  const Places unknown = unknown_places(pending);
  Bounds bounds;
  for (Fact& fact : pending.facts) {
    const Node& node = *fact.term;
    if (fact.whole || node.kind != Kind::relation || node.children.size() != 2) continue;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (sought_name(pending, node.children[side], *fact.scope) != at) continue;
      auto other = translator_.expression_read(node.children[1 - side], *fact.scope);
      if (meets(other.reads, unknown)) continue;
      const std::string& word = node.names[0].word;
      const bool less = word == "_<_" || word == "_≤_", more = word == "_>_" || word == "_≥_";
      const int strict = word == "_<_" || word == "_>_" ? 1 : 0;
      if (!less && !more) continue;
      fact.counted = false;  // no number beyond it is tried
      if (less == (side == 0))
        bounds.high.emplace_back(std::move(other.code), -strict);
      else
        bounds.low.emplace_back(std::move(other.code), strict);
    }
  }
  return bounds;
}

/// Goes through the whole numbers that facts bound, or that the setup does.
bool PlanMaker::add_range(Pending& pending, Steps& steps, bool by_setup) {
  for (const auto& [at, sought] : pending.unknown) {
    const auto from = sought.set ? sought.set->numbers_from() : std::nullopt;
    if (!from) continue;
    const Bounds bounds = bounds_of(pending, at);
    const bool has_low = *from || !bounds.low.empty(), has_high = !bounds.high.empty();
    if (!by_setup && !(has_low && has_high)) continue;
    if (!has_low || !has_high) plan_.bounded_.insert(sought.name);
    const NumberBounds limits = translator_.numbers();
    steps.push_back({{},
                     [&values = translator_.values(), place = at, from = *from, bounds, has_low, has_high, limits](
                         IdFrame frame, const std::function<bool()>& on) {
                       std::int64_t low = has_low ? from.value_or(INT64_MIN) : limits.low;
                       std::int64_t high = has_high ? INT64_MAX : limits.high;
                       for (const auto& [code, more] : bounds.low) {
                         const ValueId id = code(frame);
                         if (id == 0) return true;  // no relation holds of what is undefined
                         low = std::max(low, values.whole_number(id) + more);
                       }
                       for (const auto& [code, more] : bounds.high) {
                         const ValueId id = code(frame);
                         if (id == 0) return true;
                         high = std::min(high, values.whole_number(id) + more);
                       }
                       for (std::int64_t n = low; n <= high; ++n) {
                         frame[place] = values.number(n);
                         if (!on()) return false;
                       }
                       return true;
                     }});
    pending.unknown.erase(at);
    return true;
  }
  return false;
}

}  // namespace durero::spec
