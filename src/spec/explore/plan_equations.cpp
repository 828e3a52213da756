/// Plans what equations, memberships and inner quantifiers give.
#include "plan_maker.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

bool PlanMaker::add_equation(Pending& pending, Steps& steps) {
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
std::optional<std::pair<unsigned, Term>> PlanMaker::solved_for(const Pending& pending, const Term& left,
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
bool PlanMaker::add_inner(Pending& pending) {
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

std::optional<PlanMaker::Match> PlanMaker::match(const Pending& pending, const Term& pattern, const FrameScope& scope,
                                                 Places& given) {
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
bool PlanMaker::add_membership(Pending& pending, Steps& steps) {
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

}  // namespace durero::spec
