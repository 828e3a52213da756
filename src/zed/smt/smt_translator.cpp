#include "zed/smt/smt_translator.hpp"

#include <algorithm>
#include <set>

#include "durero/zed/evaluate/unfold.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_values.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// Says whether θ stands in a term: it depends on names that it does not mention.
bool has_theta(const Term& term) {
  if (term->kind == Kind::theta) return true;
  const auto in_text = [](const SchemaText& text) {
    return std::any_of(text.declarations.begin(), text.declarations.end(),
                       [](const Declaration& each) { return has_theta(each.term); }) ||
           std::any_of(text.predicates.begin(), text.predicates.end(),
                       [](const Predicate& each) { return has_theta(each.term); });
  };
  return std::any_of(term->children.begin(), term->children.end(), has_theta) || (term->text && in_text(*term->text));
}

std::set<Name> names_declared(const SchemaText& text) {
  std::set<Name> names;
  for (const Declaration& each : text.declarations) names.insert(each.names.begin(), each.names.end());
  return names;
}

}  // namespace

void SmtTranslator::refuse(const Term& term, const std::string& why) {
  throw Untranslated(describe(*term) + " " + why);
}

void SmtTranslator::count() {
  if (++terms_ > most_terms) throw Untranslated("what it stands for is too long");
}

/// Counts the characters of a term as it is made: all that is held at one time was counted.
void SmtTranslator::written(std::size_t characters) {
  limit_text(characters);
  if ((written_ += characters) > most_written) throw Untranslated("what it stands for is too long");
}

/// Returns a symbol for a long text, so that what is made of it stays short. Under a quantifier there is none: the text
/// may have the quantifier's variables.
std::string SmtTranslator::shared(const std::string& text, const std::string& sort) {
  constexpr std::size_t most_short = 100;
  if (text.size() <= most_short || quantifiers_ > 0 || smt_constant(text)) return text;
  const auto [at, is_new] = names_of_texts_.emplace(text, "d" + std::to_string(names_of_texts_.size()));
  if (is_new) shared_ += smt_call("define-fun", {at->second, "()", sort, text}) + "\n";
  return at->second;
}

SmtTerm SmtTranslator::shared(SmtTerm term) {
  for (SmtTerm& part : term.parts) part = shared(std::move(part));
  for (std::string& present : term.present) present = shared(present, "Bool");
  term.defined = shared(term.defined, "Bool");
  term.text = shared(term.text, term.sort == SmtSort::real ? "Real" : "Int");
  return term;
}

const SmtMeaning* SmtTranslator::find(const Name& name, const SmtScope& scope) const {
  for (const SmtScope* here = &scope; here; here = here->outer)
    if (const auto found = here->names.find(name); found != here->names.end()) return &found->second;
  return nullptr;
}

/// Says whether a term names what the toolkit defines, and neither a variable nor a name of the text.
bool SmtTranslator::is_toolkit(const Term& term, const SmtScope& scope) const {
  return term->kind == Kind::reference && !find(term->name, scope) && !definitions_.find(term->name) &&
         operator_row(term->name.text()) != nullptr;
}

/// Says whether a term depends on no variable. One that mentions a variable's name is taken to depend on it.
bool SmtTranslator::is_closed(const Term& term, const SmtScope& scope) const {
  bool closed = !has_theta(term);
  match::each_name(term, [&](const Name& name) {
    const SmtMeaning* meaning = find(name, scope);
    closed = closed && (!meaning || meaning->value);
  });
  return closed;
}

/// Returns the names in scope that stand for values.
Valuation SmtTranslator::known_values(const SmtScope& scope) {
  Valuation known;
  std::set<Name> seen;
  for (const SmtScope* here = &scope; here; here = here->outer)
    for (const auto& [name, meaning] : here->names)
      if (seen.insert(name).second && meaning.value) known.emplace_back(name, *meaning.value);
  return known;
}

Value SmtTranslator::value(const Term& term, const SmtScope& scope) const {
  try {
    Value value = evaluator_.value(term, known_values(scope));
    if (has_open(value)) refuse(term, "is not decided");
    return value;
  } catch (const EvaluationError& error) {
    throw Untranslated(error.what());
  }
}

const std::vector<Value>& SmtTranslator::members(const std::string& set) {
  const auto known = members_.find(set);
  if (known != members_.end()) return known->second;
  const auto found = carrier_(Name{set, ""});
  if (!found) throw Untranslated("the members of " + set + " are not known to be few names");
  return members_.emplace(set, *found).first->second;
}

SmtTerm SmtTranslator::of_value(const Value& value) {
  count();
  if (value.is_undefined()) return {SmtSort::integer, "0", "false"};
  if (const Real* number = value.real()) return smt_number(*number);
  if (const Atom* atom = value.get<Atom>()) {
    const std::vector<Value>& all = members((*atom)->type);
    const auto at = std::find_if(all.begin(), all.end(), [&](const Value& each) { return same(each, value); });
    if (at == all.end()) throw Untranslated(value.text() + " is not among the known members of " + (*atom)->type);
    return {SmtSort::atom, std::to_string(at - all.begin()), "true", (*atom)->type};
  }
  if (const TupleValue* tuple = value.tuple()) {
    SmtTerm made{SmtSort::tuple};
    for (const Value& part : tuple->parts) made.parts.push_back(of_value(part));
    return made;
  }
  if (const BindingValue* binding = value.binding()) {
    SmtTerm made{SmtSort::binding};
    made.names = *binding->names;
    for (const Value& part : binding->values) made.parts.push_back(of_value(part));
    return made;
  }
  if (value.set()) return of_members(value);
  throw Untranslated(value.text() + " is neither a number, a name, a tuple, a binding nor a set");
}

/// Translates a finite set of few members.
SmtTerm SmtTranslator::of_members(const Value& set) {
  constexpr std::size_t most = 256;
  const auto* members = members_up_to(set, most);
  if (!members) throw Untranslated(set.text() + " has too many members to be written out");
  SmtTerm made{SmtSort::set};
  for (const Value& each : *members) add_slot(made, of_value(each), "true");
  return merged_slots(std::move(made));
}

/// Returns the expression that an abbreviation of the text stands for; null where the term is none.
const Term* SmtTranslator::abbreviated(const Term& term, const SmtScope& scope) const {
  if (term->kind != Kind::reference || !term->children.empty() || find(term->name, scope)) return nullptr;
  const Meaning* meaning = definitions_.find(term->name);
  if (!meaning || meaning->kind != Meaning::Kind::definition) return nullptr;
  const auto& form = std::get<Definition>(meaning->paragraph->form);
  return form.formals.empty() ? &form.value : nullptr;
}

/// Returns a schema as one text that includes no other.
SchemaText SmtTranslator::schema_text(const Term& schema) const {
  const auto text = unfolded(schema, definitions_.sections(), [](const Name&) { return Term(); });
  if (!text || (*text)->kind != Kind::schema_text) refuse(schema, "is not written out as one schema text");
  return *(*text)->text;
}

void SmtTranslator::let(const SchemaText& text, const SmtScope& scope, SmtScope& inner) {
  for (const Declaration& each : text.declarations) {
    SmtMeaning& meaning = inner.names[each.names[0]];
    if (each.term->kind == Kind::lambda) {
      meaning.lambda = each.term;
      meaning.scope = &scope;
    } else if (is_closed(each.term, scope)) {
      meaning.value = value(each.term, scope);
    } else {
      meaning.term = expression(each.term, scope);
    }
  }
}

SmtBound SmtTranslator::bind(const SchemaText& text, const SmtScope& scope, SmtScope& inner) {
  SmtBound bound;
  const std::set<Name> own = names_declared(text);
  const auto declare = [&](const Name& name, SmtTerm variable) {
    inner.names[name].term = variable;
    bound.variables.emplace_back(name, std::move(variable));
  };
  const auto declare_from = [&](const Name& name, const Term& set, const SmtScope& of_set) {
    const SmtTerm variable = fresh(shape(set, of_set), bound);
    bound_slots(variable, set, of_set, bound);
    const SmtMembership in = member(variable, set, of_set);
    bound.conditions.push_back(smt_all({in.defined, in.holds}));
    declare(name, variable);
  };
  for (const Declaration& each : text.declarations) {
    if (match::mentions(each.term, own)) refuse(each.term, "has the name of a variable that is declared beside it");
    if (each.form == Declaration::Form::typed) {
      for (const Name& name : each.names) declare_from(name, each.term, scope);
    } else if (each.form == Declaration::Form::defined && is_closed(each.term, scope)) {
      const Value known = value(each.term, scope);
      if (known.is_undefined()) bound.conditions.emplace_back("false");
      inner.names[each.names[0]].value = known;
      bound.known.emplace_back(each.names[0], known);
    } else if (each.form == Declaration::Form::defined) {
      const SmtTerm known = expression(each.term, scope);
      bound.conditions.push_back(known.defined);
      declare(each.names[0], known);
    } else {
      for (const Declaration& component : schema_text(each.term).declarations)
        for (const Name& name : component.names)
          if (!inner.names.contains(name)) declare_from(name, component.term, global_);
    }
  }
  for (const Declaration& each : text.declarations)
    if (each.form == Declaration::Form::included) bound.conditions.push_back(schema(each.term, inner));
  for (const Predicate& each : text.predicates) bound.conditions.push_back(predicate(each.term, inner));
  return bound;
}

}  // namespace durero::zed
