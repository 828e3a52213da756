/// Finds of which form the members of a set are, and makes variables of a form.

#include <algorithm>

#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"
#include "zed/smt/smt_values.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// A form without the texts of a term: each of its parts is to be made.
SmtTerm cleared(const SmtTerm& term) {
  SmtTerm form = term;
  form.text.clear();
  form.defined = "true";
  form.function = form.sequence = false;
  for (SmtTerm& part : form.parts) part = cleared(part);
  for (std::string& each : form.present) each.clear();
  return form;
}

SmtTerm common_shape(const SmtTerm& a, const SmtTerm& b);

/// The form that has each of these members.
std::optional<SmtTerm> shape_of_members(const std::vector<SmtTerm>& members) {
  if (members.empty()) return std::nullopt;
  SmtTerm made = cleared(members.front());
  for (const SmtTerm& each : members) made = common_shape(made, each);
  return made;
}

/// The form of sets that has the members of both sets: so many slots as the larger one.
SmtTerm common_set_shape(const SmtTerm& a, const SmtTerm& b) {
  std::vector<SmtTerm> members = a.parts;
  members.insert(members.end(), b.parts.begin(), b.parts.end());
  SmtTerm made{SmtSort::set};
  if (const auto form = shape_of_members(members)) made.parts.assign(std::max(a.parts.size(), b.parts.size()), *form);
  made.present.assign(made.parts.size(), "");
  return made;
}

/// The form that has the members of both sets.
SmtTerm common_shape(const SmtTerm& a, const SmtTerm& b) {
  if (a.sort == SmtSort::set && b.sort == SmtSort::set) return common_set_shape(a, b);
  if (a.parts.size() != b.parts.size() || a.type != b.type || a.names != b.names)
    throw Untranslated("values of two forms are in one set");
  SmtTerm made = cleared(a.sort == SmtSort::real ? a : b.sort == SmtSort::real ? b : a);
  for (std::size_t i = 0; i < made.parts.size(); ++i) made.parts[i] = common_shape(a.parts[i], b.parts[i]);
  return made;
}

}  // namespace

SmtTerm SmtTranslator::comprehension_shape(const Term& set, const SmtScope& scope) {
  if (!set->children.empty()) {
    const TemporaryCount inside(quantifiers_, quantifiers_ + 1);
    SmtScope inner{&scope};
    bind(*set->text, scope, inner);
    return cleared(expression(set->children[0], inner));
  }
  SmtTerm tuple{SmtSort::tuple};
  for (const Declaration& each : set->text->declarations) {
    if (each.form != Declaration::Form::typed) refuse(set, "is not translated");
    tuple.parts.insert(tuple.parts.end(), each.names.size(), shape(each.term, scope));
  }
  return tuple.parts.size() == 1 ? SmtTerm(tuple.parts[0]) : tuple;
}

/// Of the members of a set of the toolkit the form is known.
std::optional<SmtTerm> SmtTranslator::toolkit_shape(const Term& set, const SmtScope& scope) {
  if (is_toolkit(set, scope)) {
    const std::string word = set->name.text();
    if (word == "𝔸") return SmtTerm{SmtSort::real};
    if (word == "ℤ" || word == "ℕ" || word == "ℕ₁" || word == "ℤ₁") return SmtTerm{};
    return std::nullopt;
  }
  const Node* application = match::application_of_name(set);
  if (!application || !is_toolkit(application->children[0], scope)) return std::nullopt;
  const std::string by = application->children[0]->name.text();
  const Term& argument = application->children[1];
  if (by == "_‥_") return SmtTerm{};
  if (argument->kind != Kind::tuple || argument->children.size() != 2) return std::nullopt;
  if (by == "_∪_") return common_shape(shape(argument->children[0], scope), shape(argument->children[1], scope));
  if (by == "_∩_" || by == "_∖_") return shape(argument->children[0], scope);
  return std::nullopt;
}

/// Returns a term of the form that the members of a set have: its texts mean nothing.
SmtTerm SmtTranslator::shape(const Term& set, const SmtScope& scope) {
  count();
  if (const Term* of = abbreviated(set, scope)) return shape(*of, global_);
  if (auto known = toolkit_shape(set, scope)) return std::move(*known);
  if (auto family = family_shape(set, scope)) return std::move(*family);
  if (set->kind == Kind::product) {
    SmtTerm tuple{SmtSort::tuple};
    for (const Term& each : set->children) tuple.parts.push_back(shape(each, scope));
    return tuple;
  }
  if (set->kind == Kind::comprehension) return comprehension_shape(set, scope);
  if (set->kind == Kind::set_extension && !set->children.empty()) {
    std::vector<SmtTerm> members;
    for (const Term& each : set->children) members.push_back(expression(each, scope));
    return *shape_of_members(members);
  }
  const bool global = set->kind == Kind::reference && !find(set->name, scope);
  const Meaning* meaning = global ? definitions_.find(set->name) : nullptr;
  if (meaning && (meaning->kind == Meaning::Kind::given || meaning->kind == Meaning::Kind::free_type))
    return {SmtSort::atom, "", "true", set->name.text()};
  const bool schema = set->kind == Kind::schema_text || set->kind == Kind::decoration;
  if (schema || (meaning && meaning->kind == Meaning::Kind::schema)) return schema_shape(set);
  std::vector<SmtTerm> members;
  if (is_closed(set, scope)) {
    const Value all = value(set, scope);
    if (is_all_numbers(all)) return {SmtSort::real};
    for (const Value& each : few_members(all, set)) members.push_back(of_value(each));
  } else {
    members = as_slots(expression(set, scope)).parts;
  }
  const auto form = shape_of_members(members);
  if (!form) refuse(set, "has no member");
  return *form;
}

/// The form of the bindings of a schema.
SmtTerm SmtTranslator::schema_shape(const Term& schema) {
  std::map<Name, SmtTerm> sorted;
  for (const Declaration& each : schema_text(schema).declarations)
    for (const Name& name : each.names) sorted.emplace(name, shape(each.term, global_));
  SmtTerm binding{SmtSort::binding};
  for (auto& [name, part] : sorted) {
    binding.names.push_back(name);
    binding.parts.push_back(std::move(part));
  }
  return binding;
}

}  // namespace durero::zed
