#include "search_plan.hpp"

#include <algorithm>
#include <deque>

#include "value_domains.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

bool SearchPlan::from(std::size_t step, IdFrame frame, const std::function<bool()>& visit) const {
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

namespace {

using Places = std::set<unsigned>;

bool meets(const Places& a, const Places& b) {
  return std::any_of(a.begin(), a.end(), [&](unsigned each) { return b.contains(each); });
}

/// A disjunction has more combinations of sides than so many: the plan is then given up.
constexpr std::size_t most_sides = 256;
/// A set of so few members is listed before a disjunction is gone side by side.
constexpr double few_members = 64;

bool has_term(const std::vector<Term>& terms, const Term& term) {
  return std::find(terms.begin(), terms.end(), term) != terms.end();
}

}  // namespace

/// Orders the facts of a search. What is known grows by the steps that are planned.
class PlanMaker {
 public:
  PlanMaker(TermTranslator& translator, SearchPlan& plan, const PlanWish& wish)
      : translator_(translator), plan_(plan), wish_(wish) {}

  void make(const SoughtNames& sought) {
    Pending pending;
    scopes_.push_back(sought.scope);
    add(pending, sought, scopes_.back());
    plan(std::move(pending), plan_.steps_, {});
  }

 private:
  struct Fact {
    Term term;
    const FrameScope* scope;
    bool whole = false;                                                // it is asked as it stands, and not taken apart
    bool counted = true;                                               // how it is answered is counted
    std::shared_ptr<const TermTranslator::Translated<IdTest>> test{};  // once it was translated
  };
  struct Sought {
    DomainPtr set;
    Name name;
  };
  struct Pending {
    std::map<unsigned, Sought> unknown;
    std::vector<Fact> facts;
  };
  using Steps = std::vector<SearchPlan::Step>;

  void add(Pending& pending, const SoughtNames& sought, const FrameScope& scope) {
    for (std::size_t i = 0; i < sought.variables.size(); ++i)
      pending.unknown.emplace(sought.variables[i].first, Sought{sought.variables[i].second, sought.names[i].first});
    for (const Term& fact : sought.facts)
      if (!has_term(wish_.held, fact)) pending.facts.push_back({fact, &scope});
  }

  static Places unknown_places(const Pending& pending) {
    Places places;
    for (const auto& [at, sought] : pending.unknown) places.insert(at);
    return places;
  }

  void plan(Pending pending, Steps& steps, std::vector<Term> sides) {
    for (;;) {
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
  bool add_tests(Pending& pending, Steps& steps) {
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

  const TermTranslator::Translated<IdTest>& test_of(Fact& fact) {
    if (!fact.test)
      fact.test = std::make_shared<const TermTranslator::Translated<IdTest>>(
          translator_.predicate_read(fact.term, *fact.scope));
    return *fact.test;
  }

  IdTest counted(const Term& fact, IdTest test) {
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
  static std::optional<unsigned> sought_name(const Pending& pending, const Term& term, const FrameScope& scope) {
    if (term->kind != Kind::reference || !term->children.empty()) return std::nullopt;
    const auto at = scope.find(term->name);
    return at && pending.unknown.contains(*at) ? at : std::nullopt;
  }

  /// Gives a name its value; what is declared of it is asked.
  void give(Pending& pending, Steps& steps, unsigned at, IdCode value) {
    const DomainPtr set = pending.unknown.at(at).set;
    pending.unknown.erase(at);
    const bool ask = set && !set->is_whole();
    steps.push_back({[at, value = std::move(value), set = ask ? set : nullptr](IdFrame frame) {
                       frame[at] = value(frame);
                       return frame[at] != 0 && (!set || set->has(frame[at], frame));
                     },
                     {}});
  }

  bool add_equation(Pending& pending, Steps& steps) {
    const Places unknown = unknown_places(pending);
    for (std::size_t i = 0; i < pending.facts.size(); ++i) {
      const Fact fact = pending.facts[i];
      const Node& node = *fact.term;
      if (fact.whole || node.kind != Kind::relation || node.names.size() != 1 || node.names[0].word != "_=_") continue;
      for (const bool turned : {false, true}) {
        const Term &left = node.children[turned ? 1 : 0], &right = node.children[turned ? 0 : 1];
        const auto solved = solved_for(pending, left, right, *fact.scope);
        if (!solved) continue;
        auto value = translator_.expression_read(solved->second, *fact.scope);
        if (meets(value.reads, unknown)) continue;
        pending.facts.erase(pending.facts.begin() + static_cast<std::ptrdiff_t>(i));
        give(pending, steps, solved->first, std::move(value.code));
        return true;
      }
    }
    return false;
  }

  /// x = right, where left is x, x + b, b + x, x − b or b − x.
  static std::optional<std::pair<unsigned, Term>> solved_for(const Pending& pending, const Term& left,
                                                             const Term& right, const FrameScope& scope) {
    if (const auto at = sought_name(pending, left, scope)) return std::pair(*at, right);
    if (left->kind != Kind::application || left->children[0]->kind != Kind::reference) return std::nullopt;
    const std::string& word = left->children[0]->name.word;
    const Node& operands = *left->children[1];
    if ((word != "_+_" && word != "_-_") || operands.kind != Kind::tuple) return std::nullopt;
    const Term &a = operands.children[0], &b = operands.children[1];
    if (const auto at = sought_name(pending, a, scope))
      return std::pair(*at, zed::operation(word == "_+_" ? "_-_" : "_+_", {right, b}, left->place));
    if (const auto at = sought_name(pending, b, scope))
      return std::pair(*at, word == "_+_" ? zed::operation("_-_", {right, a}, left->place)
                                          : zed::operation("_-_", {a, right}, left->place));
    return std::nullopt;
  }

  /// ∃ D | P • Q of names that are sought: its variables are sought too.
  bool add_inner(Pending& pending) {
    const Places unknown = unknown_places(pending);
    for (std::size_t i = 0; i < pending.facts.size(); ++i) {
      const Fact fact = pending.facts[i];
      if (fact.whole || fact.term->kind != Kind::exists) continue;
      SoughtNames inner = translator_.sought(*fact.term->text, *fact.scope);
      scopes_.push_back(inner.scope);
      translator_.add_facts(inner.facts, fact.term->children[0]);
      pending.facts.erase(pending.facts.begin() + static_cast<std::ptrdiff_t>(i));
      add(pending, inner, scopes_.back());
      plan_.repeats_ = true;
      return true;
    }
    return false;
  }

  /// Takes a member apart: sought names are given its parts, and other parts are compared.
  using Match = std::function<bool(ValueId value, IdFrame frame)>;
  std::optional<Match> match(const Pending& pending, const Term& pattern, const FrameScope& scope, Places& given) {
    const Places unknown = unknown_places(pending);
    if (const auto at = sought_name(pending, pattern, scope)) {
      if (!given.insert(*at).second) return [at = *at](ValueId value, IdFrame frame) { return frame[at] == value; };
      const DomainPtr set = pending.unknown.at(*at).set;
      return [at = *at, set = set && !set->is_whole() ? set : nullptr](ValueId value, IdFrame frame) {
        frame[at] = value;
        return !set || set->has(value, frame);
      };
    }
    auto known = translator_.expression_read(pattern, scope);
    if (!meets(known.reads, unknown))
      return [code = std::move(known.code)](ValueId value, IdFrame frame) { return code(frame) == value; };
    const bool maplet = pattern->kind == Kind::application && pattern->children[0]->kind == Kind::reference &&
                        pattern->children[0]->name.word == "_↦_";
    const Term& tuple = maplet ? pattern->children[1] : pattern;
    if (tuple->kind != Kind::tuple) return std::nullopt;
    std::vector<Match> parts;
    for (const Term& child : tuple->children) {
      auto part = match(pending, child, scope, given);
      if (!part) return std::nullopt;
      parts.push_back(std::move(*part));
    }
    return [&values = translator_.values(), parts](ValueId value, IdFrame frame) {
      const auto of = values.parts(value);
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i](of[i], frame)) return false;
      return true;
    };
  }

  /// Goes through the members of a known set of which a name that is sought, or a tuple of such, is one.
  bool add_membership(Pending& pending, Steps& steps) {
    const Places unknown = unknown_places(pending);
    for (std::size_t i = 0; i < pending.facts.size(); ++i) {
      const Fact fact = pending.facts[i];
      const Node& node = *fact.term;
      if (fact.whole || node.kind != Kind::relation || node.names.size() != 1 || node.names[0].word != "_∈_") continue;
      const auto set = translator_.domain_read(node.children[1], *fact.scope);
      if (meets(set.reads, unknown) || set.code->size() > few_members) continue;
      Places given;
      const auto part = match(pending, node.children[0], *fact.scope, given);
      if (!part || given.empty()) continue;
      for (const unsigned at : given) pending.unknown.erase(at);
      pending.facts.erase(pending.facts.begin() + static_cast<std::ptrdiff_t>(i));
      steps.push_back({{}, [set = set.code, match = *part](IdFrame frame, const std::function<bool()>& on) {
                         return set->each(frame, [&](ValueId value) { return !match(value, frame) || on(); });
                       }});
      return true;
    }
    return false;
  }

  /// Lists the smallest set of a name that no equation may give, unless sets of any size are listed.
  bool add_listing(Pending& pending, Steps& steps, double below) {
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
  static Places given_by_equations(const Pending& pending) {
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

  /// The sides of a fact, each as the facts that it adds; none where it is no disjunction.
  std::vector<std::vector<Fact>> sides_of(const Fact& fact) const {
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
  bool add_sides(Pending& pending, Steps& steps, const std::vector<Term>& before, bool any) {
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
        plans->push_back(std::make_unique<SearchPlan>());
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

  static Term side_text(const std::vector<Fact>& side) {
    Term text = side[0].term;
    for (std::size_t i = 1; i < side.size(); ++i)
      text = zed::node(Kind::conjunction, {text, side[i].term}, text->place);
    return text;
  }

  void add_side(Pending& rest, const std::vector<Fact>& side) {
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

  /// The bounds that facts x ≤ e, x < e, e ≤ x and e < x set a sought number.
  struct Bounds {
    std::vector<std::pair<IdCode, int>> low, high;  // each with what is added to it
  };
  Bounds bounds_of(Pending& pending, unsigned at) {
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
  bool add_range(Pending& pending, Steps& steps, bool by_setup) {
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

  TermTranslator& translator_;
  SearchPlan& plan_;
  const PlanWish& wish_;
  std::deque<FrameScope> scopes_;
  std::size_t sides_ = 0;
};

std::shared_ptr<const SearchPlan> planned_search(TermTranslator& translator, const SoughtNames& sought,
                                                 const PlanWish& wish) {
  auto plan = std::make_shared<SearchPlan>();
  PlanMaker(translator, *plan, wish).make(sought);
  return plan;
}

}  // namespace durero::spec
