/// Translates expressions.

#include <algorithm>

#include "zed/evaluate/cases.hpp"
#include "zed/evaluate/constants.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/smt/smt_slots.hpp"
#include "zed/smt/smt_translator.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {
namespace {

/// The definition of a function is put in as long as this lives.
struct Expanding {
  std::unordered_set<std::string>& functions;
  const std::string& name;
  ~Expanding() { functions.erase(name); }
};

bool is_positive_numeral(const std::string& text) {
  return text.find_first_not_of("0123456789") == text.npos && text != "0";
}

/// The quotient of the toolkit is the greatest whole number that is at most n / d, and the remainder has the sign of d.
/// SMT-LIB rounds so where d is positive; its remainder is never negative.
std::string quotient_text(const std::string& n, const std::string& d, bool remainder) {
  if (is_positive_numeral(d)) return smt_call(remainder ? "mod" : "div", {n, d});
  const std::string quotient = smt_choice(smt_call(">", {d, "0"}), smt_call("div", {n, d}),
                                          smt_call("div", {smt_call("-", {n}), smt_call("-", {d})}));
  return remainder ? smt_call("-", {n, smt_call("*", {d, quotient})}) : quotient;
}

SmtTerm quotient_of(const SmtTerm& a, const SmtTerm& b, bool remainder) {
  const SmtTerm n = as_integer(a), d = as_integer(b);
  SmtTerm made{SmtSort::integer, quotient_text(n.text, d.text, remainder)};
  const std::string divides = is_positive_numeral(d.text) ? "true" : smt_not(smt_call("=", {d.text, "0"}));
  made.defined = smt_all({n.defined, d.defined, divides});
  return made;
}

SmtTerm fraction_of(const SmtTerm& a, const SmtTerm& b) {
  const SmtTerm n = as_real(a), d = as_real(b);
  SmtTerm made{SmtSort::real, smt_call("/", {n.text, d.text})};
  made.defined = smt_all({n.defined, d.defined, smt_not(smt_call("=", {d.text, "0.0"}))});
  return made;
}

SmtTerm computed(const std::string& by, SmtTerm a, SmtTerm b) {
  bring_together(a, b);
  const bool sum = by == "+", difference = by == "-";
  SmtTerm made{a.sort, sum          ? smt_plus(a.text, b.text)
                       : difference ? smt_minus(a.text, b.text)
                                    : smt_call(by, {a.text, b.text})};
  made.defined = smt_all({a.defined, b.defined});
  return made;
}

/// The number behind one of ℕ; no other has one.
SmtTerm successor_of(const SmtTerm& number) {
  const SmtTerm whole = as_integer(number);
  SmtTerm made{SmtSort::integer, smt_plus(whole.text, "1")};
  made.defined = smt_all({whole.defined, smt_compare("<=", "0", whole.text)});
  return made;
}

}  // namespace

SmtTerm SmtTranslator::expression(const Term& term, const SmtScope& scope) {
  count();
  SmtTerm made = is_closed(term, scope) ? of_value(value(term, scope)) : open_expression(term, scope);
  written(text_size(made));
  return shared(std::move(made));
}

/// Translates an expression that depends on a variable.
SmtTerm SmtTranslator::open_expression(const Term& term, const SmtScope& scope) {
  switch (term->kind) {
    case Kind::reference:
      return named(term, scope);
    case Kind::set_extension:
    case Kind::comprehension:
    case Kind::lambda:
    case Kind::product:
      return set_expression(term, scope);
    case Kind::tuple:
    case Kind::binding_extension:
      return parts(term, scope);
    case Kind::selection:
    case Kind::tuple_selection:
      return selection(term, scope);
    case Kind::application:
      return application(term, scope);
    case Kind::conditional:
      return conditional(term, scope);
    case Kind::let: {
      SmtScope inner{&scope};
      let(*term->text, scope, inner);
      return expression(term->children[0], inner);
    }
    default:
      refuse(term, "is not translated");
  }
}

SmtTerm SmtTranslator::parts(const Term& term, const SmtScope& scope) {
  SmtTerm made{term->kind == Kind::tuple ? SmtSort::tuple : SmtSort::binding};
  std::vector<std::pair<Name, Term>> named;
  for (std::size_t i = 0; i < term->children.size(); ++i)
    named.emplace_back(term->kind == Kind::tuple ? Name() : term->names[i], term->children[i]);
  if (made.sort == SmtSort::binding)
    std::sort(named.begin(), named.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> defined;
  for (const auto& [name, part] : named) {
    made.parts.push_back(expression(part, scope));
    defined.push_back(made.parts.back().defined);
    if (made.sort == SmtSort::binding) made.names.push_back(name);
  }
  made.defined = smt_all(defined);
  return made;
}

SmtTerm SmtTranslator::selection(const Term& term, const SmtScope& scope) {
  const SmtTerm whole = expression(term->children[0], scope);
  std::size_t at = whole.parts.size();
  if (term->kind == Kind::tuple_selection && whole.sort == SmtSort::tuple)
    at = std::stoul(term->name.word) - 1;
  else if (term->kind == Kind::selection && whole.sort == SmtSort::binding)
    at = static_cast<std::size_t>(std::find(whole.names.begin(), whole.names.end(), term->name) - whole.names.begin());
  if (at >= whole.parts.size()) refuse(term, "selects from what has no such part");
  SmtTerm part = whole.parts[at];
  part.defined = smt_all({whole.defined, part.defined});
  return part;
}

SmtTerm SmtTranslator::conditional(const Term& term, const SmtScope& scope) {
  return smt_chosen(shared(predicate(term->children[0], scope), "Bool"), expression(term->children[1], scope),
                    expression(term->children[2], scope));
}

/// Returns the value of a function of the toolkit, where it is one that SMT-LIB has.
std::optional<SmtTerm> SmtTranslator::arithmetic(const std::string& by, const Term& argument, const SmtScope& scope) {
  static const std::map<std::string, std::string> plain = {{"_+_", "+"}, {"_-_", "-"}, {"_*_", "*"}};
  if (by == "-_") return computed("-", {SmtSort::integer, "0"}, expression(argument, scope));
  if (by == "succ") return successor_of(expression(argument, scope));
  const bool known = plain.contains(by) || by == "_div_" || by == "_mod_" || by == "_/_" || by == "_↦_" ||
                     by == "first" || by == "second";
  if (!known) return std::nullopt;
  const SmtTerm pair = expression(argument, scope);
  if (pair.sort != SmtSort::tuple || pair.parts.size() != 2) refuse(argument, "is no pair");
  const SmtTerm &a = pair.parts[0], &b = pair.parts[1];
  if (by == "_↦_") return pair;
  if (by == "first" || by == "second") {
    SmtTerm part = by == "first" ? a : b;
    part.defined = pair.defined;
    return part;
  }
  if (by == "_/_") return fraction_of(a, b);
  if (by == "_div_" || by == "_mod_") return quotient_of(a, b, by == "_mod_");
  return computed(plain.at(by), a, b);
}

SmtTerm SmtTranslator::application(const Term& term, const SmtScope& scope) {
  const Term &function = term->children[0], &argument = term->children[1];
  if (is_toolkit(function, scope)) {
    if (auto made = arithmetic(function->name.text(), argument, scope)) return std::move(*made);
    if (auto made = set_operation(function->name.text(), argument, scope)) return std::move(*made);
    refuse(term, "is not translated");
  }
  if (const auto known = rules(function, scope)) {
    const SmtTerm of = expression(argument, scope);
    const std::string name = function->kind == Kind::reference ? function->name.text() : "";
    if (name.empty()) return applied(*known, of);
    if (!expanding_.insert(name).second) refuse(function, "is recursive");
    const Expanding here{expanding_, name};
    return applied(*known, of);
  }
  if (is_closed(function, scope)) return looked_up(value(function, scope), expression(argument, scope));
  return applied_slots(expression(function, scope), expression(argument, scope));
}

/// Returns the definition of a function: a λ, or the cases of its box; nothing where it has none.
std::optional<std::vector<SmtTranslator::Rule>> SmtTranslator::rules(const Term& function,
                                                                     const SmtScope& scope) const {
  if (function->kind == Kind::lambda) {
    Rule rule{*function->text, {}, function->children[0], &scope};
    for (const Declaration& each : function->text->declarations) {
      if (each.form != Declaration::Form::typed) return std::nullopt;
      rule.parameters.insert(rule.parameters.end(), each.names.begin(), each.names.end());
    }
    return std::vector{rule};
  }
  if (function->kind != Kind::reference || !function->children.empty()) return std::nullopt;
  if (const SmtMeaning* local = find(function->name, scope))
    return local->lambda ? rules(local->lambda, *local->scope) : std::nullopt;
  if (const Term* of = abbreviated(function, scope)) return rules(*of, global_);
  const Meaning* meaning = definitions_.find(function->name);
  if (!meaning || meaning->kind != Meaning::Kind::axiomatic) return std::nullopt;
  std::vector<Rule> found = axioms(*meaning);
  return found.empty() ? std::nullopt : std::optional(std::move(found));
}

std::vector<SmtTranslator::Rule> SmtTranslator::axioms(const Meaning& function) const {
  const auto& form = std::get<Axiomatic>(function.paragraph->form);
  if (!form.formals.empty()) return {};
  for (const Predicate& each : form.text.predicates) {
    const Term* other = match::is_equation(each.term) ? other_side(each.term, function.name) : nullptr;
    if (other && (*other)->kind == Kind::lambda) return rules(*other, global_).value_or(std::vector<Rule>{});
  }
  const Cases cases = cases_of_function(form.text.predicates, function.name);
  std::vector<Rule> found;
  for (const Term& clause : cases.clauses) {
    if (match::mentions(clause->children[0]->children[1], {function.name}))
      throw Untranslated(function.name.text() + " is recursive");
    const Term &equation = clause->children[0], &argument = equation->children[0]->children[1];
    Rule rule{*clause->text, {}, equation->children[1], &global_};
    for (const Term& each : argument->kind == Kind::tuple ? argument->children : std::vector{argument}) {
      if (each->kind != Kind::reference) return {};
      rule.parameters.push_back(each->name);
    }
    found.push_back(std::move(rule));
  }
  return found;
}

/// The first case that has the argument gives the value; where none has it, there is none.
SmtTerm SmtTranslator::applied(const std::vector<Rule>& rules, const SmtTerm& argument) {
  SmtTerm made{SmtSort::integer, "0", "false"};
  for (std::size_t i = rules.size(); i-- > 0;) {
    const Rule& rule = rules[i];
    const bool one = rule.parameters.size() == 1;
    if (!one && argument.parts.size() != rule.parameters.size())
      throw Untranslated("a function is applied to what is not its parameters one by one");
    SmtScope inner{rule.scope};
    for (std::size_t p = 0; p < rule.parameters.size(); ++p)
      inner.names[rule.parameters[p]].term = one ? argument : argument.parts[p];
    std::vector<std::string> here;
    for (const Declaration& each : rule.declared.declarations) {
      if (each.form != Declaration::Form::typed) throw Untranslated("the parameters of a function are not translated");
      for (const Name& name : each.names) {
        const auto parameter = inner.names.find(name);
        if (parameter == inner.names.end()) throw Untranslated("the cases of a function are not translated");
        const SmtMembership in = each.term->kind == Kind::reference && each.term->name == any_value
                                     ? SmtMembership()
                                     : member(*parameter->second.term, each.term, *rule.scope);
        here.push_back(smt_all({in.defined, in.holds}));
      }
    }
    for (const Predicate& each : rule.declared.predicates) here.push_back(predicate(each.term, inner));
    made = smt_chosen(shared(smt_all(here), "Bool"), expression(rule.value, inner), made);
  }
  made.defined = smt_all({argument.defined, made.defined});
  return made;
}

/// The value of a finite function; it has none where two pairs disagree.
SmtTerm SmtTranslator::looked_up(const Value& function, const SmtTerm& argument) {
  constexpr std::size_t most_pairs = 256;
  if (function.is_undefined()) return {SmtSort::integer, "0", "false"};
  const auto* pairs = function.set() ? function.set()->members() : nullptr;
  if (!pairs || pairs->size() > most_pairs) throw Untranslated(function.text() + " is no small table");
  SmtTerm made{SmtSort::integer, "0", "false"};
  for (std::size_t i = pairs->size(); i-- > 0;) {
    const TupleValue* pair = (*pairs)[i].tuple();
    if (!pair || pair->parts.size() != 2) throw Untranslated(function.text() + " is no table");
    const auto is_again = [&](std::size_t j) {
      return j < pairs->size() && same((*pairs)[j].tuple()->parts[0], pair->parts[0]);
    };
    SmtTerm value = of_value(pair->parts[1]);
    if (is_again(i + 1) || (i > 0 && is_again(i - 1))) value.defined = "false";
    made = smt_chosen(smt_equal(argument, of_value(pair->parts[0])), std::move(value), made);
  }
  made.defined = smt_all({argument.defined, made.defined});
  return made;
}

}  // namespace durero::zed
