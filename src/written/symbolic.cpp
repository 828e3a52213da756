#include "symbolic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"

namespace durero::written {

using number::Rational;
using zed::Kind;
using zed::Name;
using zed::Term;

namespace {

/// The limit on steps, which no text written by hand reaches.
constexpr std::uint64_t most_steps = 1'000'000;
constexpr unsigned most_depth = 400;

ScopePtr global_scope(const std::string& section) {
  return std::make_shared<const SymbolicScope>(SymbolicScope{{}, nullptr, section});
}

const SymbolicValue* find(const ScopePtr& scope, const Name& name) {
  for (const SymbolicScope* at = scope.get(); at != nullptr; at = at->outer.get())
    if (const auto found = at->names.find(name); found != at->names.end()) return &found->second;
  return nullptr;
}

/// The parts of an argument, of which a tuple has several.
std::vector<Term> parts_of(const Term& argument) {
  return argument->kind == Kind::tuple ? argument->children : std::vector{argument};
}

bool is_equation(const Term& term) {
  return term->kind == Kind::relation && term->children.size() == 2 && term->names[0].word == "_=_";
}

/// The equation f(x) = e under its ∀.
std::optional<FunctionParameters> clause(const zed::Axiomatic& form, const Name& function) {
  for (const zed::Predicate& predicate : form.text.predicates) {
    if (predicate.term->kind != Kind::forall || !is_equation(predicate.term->children[0])) continue;
    const Term& left = predicate.term->children[0]->children[0];
    if (left->kind != Kind::application || left->children[0]->kind != Kind::reference ||
        left->children[0]->name != function)
      continue;
    return FunctionParameters{*predicate.term->text, parts_of(left->children[1]),
                              predicate.term->children[0]->children[1], ""};
  }
  return std::nullopt;
}

/// The definition λ D • e, whose argument is the characteristic tuple of D.
FunctionParameters of_lambda(const Term& lambda) {
  FunctionParameters found{*lambda->text, {}, lambda->children[0], ""};
  for (const zed::Declaration& declaration : lambda->text->declarations) {
    for (const Name& name : declaration.names) found.formal.push_back(zed::reference(name));
    if (declaration.form == zed::Declaration::Form::included)
      found.formal.push_back(zed::node(Kind::theta, {declaration.term}, declaration.place));
  }
  return found;
}

}  // namespace

Symbolic::Symbolic(const zed::Specification& specification, const zed::Typing& typing)
    : specification_(specification),
      typing_(typing),
      steps_(most_steps),
      evaluator_(specification.sections, {}, &steps_) {}

void Symbolic::refuse(const ScopePtr& scope, const zed::Place& place, const std::string& what,
                      const std::string& expected) const {
  throw Refusal{{specification_.find(scope->section)->file, place, what, expected}};
}

const zed::Global* Symbolic::global(const ScopePtr& scope, const Name& name) const {
  return typing_.find(scope->section, name);
}

const zed::Paragraph* Symbolic::paragraph_of(const zed::Global& global) const {
  for (const zed::Paragraph& paragraph : specification_.find(global.section)->paragraphs)
    if (zed::is_named(paragraph, global.name.text())) return &paragraph;
  return nullptr;
}

std::optional<FunctionParameters> Symbolic::parameters(const std::string& section, const Name& function) const {
  const zed::Global* const known = typing_.find(section, function);
  const zed::Paragraph* const paragraph = known ? paragraph_of(*known) : nullptr;
  if (paragraph == nullptr) return std::nullopt;
  std::optional<FunctionParameters> found;
  if (const auto* const box = std::get_if<zed::Axiomatic>(&paragraph->form)) found = clause(*box, function);
  if (const auto* const definition = std::get_if<zed::Definition>(&paragraph->form))
    if (definition->value->kind == Kind::lambda) found = of_lambda(definition->value);
  if (found) found->section = known->section;
  return found;
}

SymbolicValue Symbolic::apply(const std::string& section, const Name& function, const Tuple& arguments) {
  steps_ = zed::Steps(most_steps);
  depth_ = 0;
  return call(parameters(section, function).value(), arguments, {});
}

void Symbolic::let_numerals_be_off(const Rational& part, std::size_t first) {
  numeral_part_ = part;
  first_error_ = first;
  numeral_errors_.clear();
}

Formula Symbolic::numeral(const Term& term) {
  const Rational value(number::Integer(term->name.word.text()));
  if (numeral_part_ == 0 || value == 0) return {value};
  const std::size_t error =
      numeral_errors_.try_emplace(term.get(), first_error_ + numeral_errors_.size()).first->second;
  return Formula::off_by(value, error, numeral_part_ * value);
}

Outside Symbolic::outside(const Fields& names, const Term& schema, const ScopePtr& scope) {
  const zed::Global* const known = schema->kind == Kind::reference ? global(scope, schema->name) : nullptr;
  const zed::Paragraph* const paragraph = known ? paragraph_of(*known) : nullptr;
  const auto* const box = paragraph ? std::get_if<zed::Schema>(&paragraph->form) : nullptr;
  if (box == nullptr) return {{}, zed::to_unicode(schema)};
  const ScopePtr there = global_scope(known->section);
  for (const zed::Declaration& declaration : box->text.declarations) {
    for (const Name& name : declaration.names)
      if (!holds_as_given(member_of(names.at(name), declaration.term, there)))
        return {name, fmt::format("{} ∈ {}", name.text(), zed::to_unicode(declaration.term))};
    if (declaration.form == zed::Declaration::Form::included &&
        !holds_as_given(member_of({names}, declaration.term, there)))
      return outside(names, declaration.term, there);
  }
  const ScopePtr inner = std::make_shared<const SymbolicScope>(SymbolicScope{names, there, there->section});
  for (const zed::Predicate& predicate : box->text.predicates)
    if (!holds_as_given(condition(predicate.term, inner))) return {{}, zed::to_unicode(predicate.term)};
  return {{}, zed::to_unicode(schema)};
}

/// The value of a call. The parameters have the arguments as values, which must be in the sets of the head and satisfy
/// it.
SymbolicValue Symbolic::call(const FunctionParameters& function, const Tuple& arguments, const Fields& around) {
  const ScopePtr outer = std::make_shared<const SymbolicScope>(SymbolicScope{around, nullptr, function.section});
  Fields names;
  for (std::size_t i = 0; i < function.formal.size(); ++i) {
    const Term& formal = function.formal[i];
    if (formal->kind == Kind::theta) {
      const auto* const fields = std::get_if<Fields>(&arguments[i].form);
      if (fields == nullptr) refuse(outer, formal->place, "its argument is no binding", "expected one");
      names.insert(fields->begin(), fields->end());
    } else {
      names.insert_or_assign(formal->name, arguments[i]);
    }
  }
  for (const zed::Declaration& declaration : function.head.declarations) {
    if (declaration.form == zed::Declaration::Form::included) {
      if (!holds_as_given(member_of(SymbolicValue{names}, declaration.term, outer)))
        throw outside(names, declaration.term, outer);
    }
    for (const Name& name : declaration.names) {
      if (!names.contains(name) || holds_as_given(member_of(names.at(name), declaration.term, outer))) continue;
      const auto* const fields = std::get_if<Fields>(&names.at(name).form);
      if (fields != nullptr && function.formal.size() == 1) throw outside(*fields, declaration.term, outer);
      throw Outside{name, fmt::format("{} ∈ {}", name.text(), zed::to_unicode(declaration.term))};
    }
  }
  const ScopePtr scope = std::make_shared<const SymbolicScope>(SymbolicScope{names, outer, function.section});
  for (const zed::Predicate& predicate : function.head.predicates)
    if (!holds_as_given(condition(predicate.term, scope))) throw Outside{{}, zed::to_unicode(predicate.term)};
  return value(function.body, scope);
}

SymbolicValue Symbolic::value(const Term& term, const ScopePtr& scope) {
  steps_.take();
  if (++depth_ > most_depth) refuse(scope, term->place, "definitions are nested too deeply", "expected fewer");
  const auto rise = std::shared_ptr<void>(nullptr, [this](void*) { --depth_; });
  switch (term->kind) {
    case Kind::number:
      return {numeral(term)};
    case Kind::reference:
      return reference(term, scope);
    case Kind::selection:
    case Kind::tuple_selection:
      return selected(term, scope);
    case Kind::theta:
      return theta(term, scope);
    case Kind::application:
      return application(term, scope);
    case Kind::tuple: {
      Tuple parts;
      for (const Term& part : term->children) parts.push_back(value(part, scope));
      return {std::move(parts)};
    }
    case Kind::binding_extension: {
      Fields fields;
      for (std::size_t i = 0; i < term->names.size(); ++i)
        fields.insert_or_assign(term->names[i], value(term->children[i], scope));
      return {std::move(fields)};
    }
    case Kind::let:
      return value(term->children[0], let_scope(term, scope));
    case Kind::conditional: {
      const Condition which = condition(term->children[0], scope);
      if (which.kind != Condition::Kind::constant)
        refuse(scope, term->place, "which of the two it is depends on the point", "expected one polynomial");
      return value(term->children[which.truth ? 1 : 2], scope);
    }
    default:  // sets and functions are evaluated where a member or a value is asked for
      return {Suspended{term, scope}};
  }
}

ScopePtr Symbolic::let_scope(const Term& term, const ScopePtr& scope) {
  Fields names;
  for (const zed::Declaration& declaration : term->text->declarations)
    names.insert_or_assign(declaration.names[0], value(declaration.term, scope));
  return std::make_shared<const SymbolicScope>(SymbolicScope{std::move(names), scope, scope->section});
}

SymbolicValue Symbolic::reference(const Term& term, const ScopePtr& scope) {
  if (const SymbolicValue* const local = find(scope, term->name)) return *local;
  const zed::Global* const known = global(scope, term->name);
  const zed::Paragraph* const paragraph = known ? paragraph_of(*known) : nullptr;
  if (paragraph == nullptr) return {Suspended{term, scope}};  // of the toolkit
  if (const auto* const definition = std::get_if<zed::Definition>(&paragraph->form);
      definition && definition->formals.empty())
    return value(definition->value, global_scope(known->section));
  const bool is_number = known->scheme.formals.empty() && known->form == zed::Global::Form::axiom &&
                         !parameters(scope->section, term->name) && !known->scheme.type.is(zed::Type::Kind::power);
  return is_number ? constant(term, scope) : SymbolicValue{Suspended{term, global_scope(scope->section)}};
}

/// The value of a name that the axioms determine.
SymbolicValue Symbolic::constant(const Term& term, const ScopePtr& scope) {
  try {
    return converted(evaluator_.value(term->name), term, scope);
  } catch (const zed::EvaluationError& error) {
    refuse(scope, term->place, error.what(), "expected a name with a value");
  }
}

SymbolicValue Symbolic::converted(const zed::Value& known, const Term& term, const ScopePtr& scope) const {
  if (const zed::Real* const real = known.real(); real && real->is_surd()) {
    const number::Surd surd = real->surd();
    if (surd.y == 0) return {Formula(surd.x)};
  }
  if (const zed::BindingValue* const binding = known.binding()) {
    Fields fields;
    for (std::size_t i = 0; i < binding->names->size(); ++i)
      fields.emplace((*binding->names)[i], converted(binding->values[i], term, scope));
    return {std::move(fields)};
  }
  refuse(scope, term->place, fmt::format("{} is {}", term->name.text(), known.text()),
         "expected a rational number, or a binding of such");
}

SymbolicValue Symbolic::theta(const Term& term, const ScopePtr& scope) {
  const auto type = typing_.type_of(term);
  Fields fields;
  if (type && type->is(zed::Type::Kind::schema)) {
    const zed::Type settled = type->settled();  // which holds the names
    for (const Name& name : settled.fields()) {
      const SymbolicValue* const local = find(scope, {name.word, name.strokes + term->name.strokes});
      if (local == nullptr) refuse(scope, term->place, name.text() + " has no value here", "expected one");
      fields.emplace(name, *local);
    }
  }
  return {std::move(fields)};
}

SymbolicValue Symbolic::selected(const Term& term, const ScopePtr& scope) {
  const SymbolicValue whole = value(term->children[0], scope);
  if (const auto* const fields = std::get_if<Fields>(&whole.form))
    if (const auto found = fields->find(term->name); found != fields->end()) return found->second;
  if (const auto* const tuple = std::get_if<Tuple>(&whole.form)) return tuple->at(std::stoul(term->name.word) - 1);
  refuse(scope, term->place, zed::to_unicode(term) + " is not followed", "expected a part of something that is known");
}

const Formula& Symbolic::formula(const SymbolicValue& value, const Term& term, const ScopePtr& scope) const {
  if (const auto* const found = std::get_if<Formula>(&value.form)) return *found;
  refuse(scope, term->place, zed::to_unicode(term) + " is no polynomial in the coordinates of the point",
         "expected sums, differences and products");
}

SymbolicValue Symbolic::arithmetic(const Term& term, const ScopePtr& scope) {
  const std::string& word = term->children[0]->name.word;
  const std::vector<Term> parts = parts_of(term->children[1]);
  const auto part = [&](std::size_t i) {
    const SymbolicValue known = value(parts[i], scope);
    return formula(known, parts[i], scope);
  };
  try {
    if (word == "-_") return {Formula() - part(0)};
    if (word == "_+_") return {part(0) + part(1)};
    if (word == "_-_") return {part(0) - part(1)};
    return {part(0) * part(1)};
  } catch (const std::length_error& error) {
    refuse(scope, term->place, fmt::format("{} is {}", zed::to_unicode(term), error.what()),
           fmt::format("expected a degree of {} at most, and fewer digits", Formula::max_degree));
  }
}

SymbolicValue Symbolic::application(const Term& term, const ScopePtr& scope) {
  const Term& of = term->children[0];
  const bool is_global = of->kind == Kind::reference && find(scope, of->name) == nullptr;
  if (is_global && !global(scope, of->name)) {
    for (const std::string_view word : {"_+_", "_-_", "_*_", "-_"})
      if (of->name.word == word && parts_of(term->children[1]).size() == (word == "-_" ? 1U : 2U))
        return arithmetic(term, scope);
    return {Suspended{term, scope}};  // of the toolkit: maybe a union
  }
  std::optional<FunctionParameters> function = is_global ? parameters(scope->section, of->name) : std::nullopt;
  Fields around;
  if (!function) {
    const SymbolicValue known = value(of, scope);
    const auto* const lambda = std::get_if<Suspended>(&known.form);
    if (lambda && lambda->term->kind == Kind::lambda) {
      function = of_lambda(lambda->term);
      function->section = lambda->scope->section;
      for (const SymbolicScope* at = lambda->scope.get(); at; at = at->outer.get())
        around.insert(at->names.begin(), at->names.end());
    }
  }
  if (!function)
    refuse(scope, term->place, zed::to_unicode(of) + " is defined by no equation that gives its value",
           fmt::format("expected ∀ … • {}(…) = …", zed::to_unicode(of)));
  const SymbolicValue argument = value(term->children[1], scope);
  const auto* const tuple = std::get_if<Tuple>(&argument.form);
  const Tuple arguments = function->formal.size() == 1 || tuple == nullptr ? Tuple{argument} : *tuple;
  try {
    return call(*function, arguments, around);
  } catch (const Outside& outside) {
    refuse(scope, term->place, fmt::format("{} may be applied outside its domain", zed::to_unicode(of)),
           fmt::format("expected {}", outside.expected));
  } catch (const Refusal& refusal) {  // in another file's definition: the error is reported where this one uses it
    if (refusal.defect.file == specification_.find(scope->section)->file) throw;
    refuse(scope, term->place, refusal.defect.what, refusal.defect.expected);
  }
}

}  // namespace durero::written
