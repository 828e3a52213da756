/// Translates the sets that names are declared from.
#include "translator.hpp"
#include "value_domains.hpp"

namespace durero::spec {

using zed::Kind;
using zed::Name;
using zed::Node;
using zed::Term;

TermTranslator::Translated<DomainPtr> TermTranslator::domain_read(const Term& term, const FrameScope& scope) {
  return with_reads([&] { return domain(term, scope); });
}

DomainPtr TermTranslator::domain(const Term& term, const FrameScope& scope) {
  const Node& node = *term;
  const auto part = [&](std::size_t i) { return domain(node.children[i], scope); };
  if (node.kind == Kind::power) return power_set(values_, part(0), false);
  if (node.kind == Kind::product) {
    std::vector<DomainPtr> parts;
    for (std::size_t i = 0; i < node.children.size(); ++i) parts.push_back(part(i));
    return product_set(values_, std::move(parts));
  }
  if (node.kind == Kind::reference && !scope.find(node.name))
    if (DomainPtr named = domain_of_name(term, scope)) return named;
  constexpr double some = 4;  // a guess at the size of a set that is known later
  return set_given(
      values_, expression(term, scope), [this](ValueId set, ValueId value) { return contained(set, value); }, some);
}

/// The set of a name that has its own form; null for any other, which is an expression.
DomainPtr TermTranslator::domain_of_name(const Term& term, const FrameScope& scope) {
  const Node& node = *term;
  const std::string word = node.name.text();
  const auto at = globals_.find(node.name);
  if (at == globals_.end()) {
    const auto part = [&](std::size_t i) { return domain(node.children[i], scope); };
    if (word == "ℕ") return whole_numbers(values_, 0);
    if (word == "ℤ") return whole_numbers(values_, std::nullopt);
    if (word == "ℕ₁") return whole_numbers(values_, 1);
    if (node.children.size() == 2)
      if (const auto arrow = arrow_properties(word)) return arrow_set(values_, part(0), part(1), *arrow);
    if (node.children.size() != 1) return nullptr;
    if (word == "𝔽_") return power_set(values_, part(0), false);
    if (word == "𝔽₁_" || word == "ℙ₁_") return power_set(values_, part(0), true);
    if (word == "seq_" || word == "seq₁_") return sequence_set(values_, part(0), word == "seq₁_", false);
    if (word == "iseq_") return sequence_set(values_, part(0), false, true);
    return nullptr;
  }
  if (!node.children.empty()) return nullptr;
  const auto& form = at->second->form;
  const auto* free = std::get_if<zed::FreeType>(&form);
  if (std::holds_alternative<zed::GivenTypes>(form) || (free && free->name == node.name)) {
    const ValueId all = global(node.name);
    if (values_.form(all) != InternedForm::set) return whole_type(values_, std::nullopt);
    const auto members = values_.members(all);
    return whole_type(values_, std::vector<ValueId>(members.begin(), members.end()));
  }
  const auto* definition = std::get_if<zed::Definition>(&form);
  if (definition && definition->formals.empty() && names_no_schema(node.name)) return domain(definition->value, {});
  return nullptr;
}

}  // namespace durero::spec
