/// Checks names: scopes, instances of generics, and the schemas that a decoration, Δ or Ξ implies; with the errors and
/// limits of the type-checker.

#include <fmt/core.h>

#include <algorithm>
#include <ranges>

#include "durero/text/utf8.hpp"
#include "zed/types/checker.hpp"

namespace durero::zed {
void Checker::error(Place place, std::string what, std::string expected) {
  if (into_.defects.size() - errors_at_start_ >= max_errors)
    throw ZError(place, "too many errors to go on", fmt::format("expected fewer than {}", max_errors));
  into_.defects.push_back({file_, place, std::move(what), std::move(expected), Defect::Severity::error});
}

Type Checker::fresh() {
  if (++variables_ > max_variables)
    throw ZError(at_, fmt::format("a paragraph with more than {} types to be determined", max_variables),
                 "expected it in several paragraphs");
  return Type::variable();
}

void Checker::spend(std::size_t steps) {
  work_ += steps;
  if (work_ > max_work) throw ZError(at_, "the section is too large to be checked", "expected a shorter section");
}

Type Checker::wrong(Place place, std::string what, std::string expected) {
  error(place, std::move(what), std::move(expected));
  return Type::unknown();
}

std::vector<Type> Checker::actuals(const Node& node) {
  std::vector<Type> types;
  types.reserve(node.children.size());
  for (const Term& actual : node.children) types.push_back(element(actual, "a generic actual"));
  return types;
}

Type Checker::reference(const Node& node) {
  const std::vector<Type> given = actuals(node);
  if (const auto type = lookup(node.name, given.empty() ? nullptr : &given, node.place)) return *type;
  return wrong(node.place, node.name.text() + " is not declared", expected_name(node.name));
}

/// In ISO Z a name with strokes is a name like others. The decoration of a schema has a space before its stroke.
std::string Checker::expected_name(const Name& name) const {
  if (name.word.find("↗") != name.word.npos)
    return "expected a declared name; an iteration has blanks, R ↗ n ↙ (R~^{~n~} in LaTeX)";
  if (const std::string parent = expected_parent(name); !parent.empty()) return parent;
  std::string strokes = name.strokes;
  while (!strokes.empty() && text::continues(strokes.back())) strokes.pop_back();
  if (strokes.empty()) return nearest_name(name);
  const std::string stroke = name.strokes.substr(strokes.size() - 1);
  strokes.pop_back();
  const Name base{name.word, strokes};
  const auto entry = globals_.find(base);
  if (entry == globals_.end() || !entry->second->scheme.type.is_schema_set()) return nearest_name(name);
  return fmt::format("expected {0} {1} ({0}~{1} in LaTeX) for the decoration of the schema {0}", base.text(), stroke);
}

/// Names the parent that would give a name of the toolkit which no ancestor declares; nothing for any other name.
std::string Checker::expected_parent(const Name& name) const {
  const auto at = toolkit().find(name);
  if (at == toolkit().end() || toolkit_.has(at->second.section)) return {};
  return fmt::format("expected {} among the ancestors, or a declaration", name_of(at->second.section));
}

/// The names of all paragraphs so far and of the toolkit. A paragraph adds names, so that their number tells two lists
/// apart.
const KnownNames& Checker::global_names() const {
  if (!global_names_ || global_names_of_ != globals_.size()) {
    std::vector<std::string> known;
    for (const auto& [global, meaning] : globals_) known.push_back(global.text());
    for (const auto& [own, entry] : toolkit())
      if (toolkit_.has(entry.section)) known.push_back(own.text());
    global_names_.emplace(std::move(known));
    global_names_of_ = globals_.size();
  }
  return *global_names_;
}

/// Names what is in scope and may be meant: a name that is a slip away, with Δ and Ξ for what they stand before.
std::string Checker::nearest_name(const Name& name) const {
  std::vector<std::string> in_scopes;
  for (const auto& scope : scopes_)
    for (const auto& [local, type] : scope.fields) in_scopes.push_back(local.text());
  const KnownNames locals(std::move(in_scopes));
  const KnownNames& globals = global_names();
  if (const std::string apart = taken_apart(name.text(), locals, globals); !apart.empty()) {
    std::string in_latex = apart;
    std::replace(in_latex.begin(), in_latex.end(), ' ', '~');
    return fmt::format("expected a declared name; did you mean {} ({} in LaTeX)?", apart, in_latex);
  }
  if (const auto other = with_strokes(name.word, locals, globals))
    return fmt::format("expected a declared name, such as {}", *other);
  std::string sign;
  for (const std::string_view doubling : {"Δ", "Ξ"})
    if (name.word.starts_with(doubling)) sign = doubling;
  const auto meant = nearest(name.text().substr(sign.size()), locals, globals);
  return meant ? fmt::format("expected a declared name; did you mean {}{}?", sign, *meant) : "expected a declared name";
}

std::optional<Type> Checker::lookup(const Name& name, const std::vector<Type>* actuals, Place place) {
  for (const auto& scope : std::views::reverse(scopes_)) {
    const Type* type = scope.find(name);
    if (!type && scope.is_open) return fresh();
    if (!type) continue;
    if (actuals) error(place, name.text() + " is a variable", "expected no generic actuals after it");
    return *type;
  }
  if (const auto at = globals_.find(name); at != globals_.end()) {
    if (at->second->form == Global::Form::lost) return Type::unknown();
    return instance(name, at->second->scheme, actuals, place);
  }
  if (const Scheme* scheme = toolkit_scheme(name, toolkit_)) return instance(name, *scheme, actuals, place);
  return implied_schema(name, actuals, place);
}

/// A binding takes its components from the scope, and there each must have one type: a generic name has many.
std::optional<Type> Checker::component_in_scope(const Name& name, Place place) {
  const std::size_t generic = generics_.size();
  std::optional<Type> type = lookup(name, nullptr, place);
  if (generics_.size() > generic)
    error(place, fmt::format("the component {} is generic where it is taken from", name.text()),
          "expected it with one type in scope");
  return type;
}

Type Checker::instance(const Name& name, const Scheme& scheme, const std::vector<Type>* actuals, Place place) {
  if (actuals) {
    spend(scheme.type.size());
    if (actuals->size() == scheme.formals.size()) return scheme.type.substitute(scheme.formals, *actuals);
    return wrong(place, fmt::format("{} has {} generic actuals", name.text(), actuals->size()),
                 fmt::format("expected {}", scheme.formals.size()));
  }
  std::vector<Type> types;
  for (std::size_t i = 0; i < scheme.formals.size(); ++i) {
    types.push_back(fresh());
    generics_.push_back({name, {place, types.back()}});
  }
  return scheme.type.substitute(scheme.formals, types);
}

/// Returns the type of ΔS and ΞS where only S is declared.
std::optional<Type> Checker::implied_schema(const Name& name, const std::vector<Type>* actuals, Place place) {
  const bool delta = name.word.starts_with("Δ"), xi = name.word.starts_with("Ξ");
  if ((!delta && !xi) || !name.strokes.empty()) return std::nullopt;
  const Name base{name.word.substr(std::string_view("Δ").size()), {}};
  const auto schema = base.empty() ? std::nullopt : lookup(base, actuals, place);
  if (!schema || schema->is(Type::Kind::unknown)) return schema;
  return schema->is_schema_set() ? std::optional(doubled(*schema, place)) : std::nullopt;
}

void Checker::push(Fields fields) {
  FieldTable table{std::move(fields)};
  for (std::size_t i = 0; i < table.fields.size(); ++i) table.positions[table.fields[i].first] = i;
  push(std::move(table));
}

FieldTable Checker::pop() {
  FieldTable table = std::move(scopes_.back());
  scopes_.pop_back();
  return table;
}

void Checker::finish_paragraph() {
  if (into_.defects.size() == errors_before_) {
    for (const auto& [name, instance] : generics_) {
      spend(instance.second.size());
      if (!instance.second.has_variables()) continue;
      if (alone_ && name.word == "⟨,,⟩" && unify(instance.second, Type::given({"𝔸", ""}))) continue;
      error(instance.first, fmt::format("the generic actuals of {} are not determined", name.text()),
            name.word == "{}" ? "expected ∅[…], or a use that gives its type"
                              : fmt::format("expected {}[…], or a use that gives its type", name.text()));
      break;  // the others may hang together with this one
    }
  }
  generics_.clear();
  variables_ = 0;
  errors_before_ = into_.defects.size();
}

}  // namespace durero::zed
