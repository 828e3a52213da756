#include "durero/spec/calculator.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "durero/model/escena.hpp"
#include "durero/spec/constants.hpp"
#include "durero/text/nearest.hpp"
#include "durero/zed/evaluate/unfold.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/parser.hpp"
#include "spec/open_variables.hpp"
#include "spec/solved.hpp"

namespace durero::spec {
namespace {

using zed::Name;

constexpr const char* section_name = "call";
constexpr const char* file_name = "EXPR";
constexpr const char* elements = "Elemento";  // the given set of the text

/// A section that sees the whole text.
zed::Section calling_section(const zed::Specification& specification) {
  zed::Section section;
  section.file = file_name;
  section.name = section_name;
  for (const zed::Section& parent : specification.sections) section.parents.push_back(parent.name);
  return section;
}

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

/// A backslash before a letter or before a character that only LaTeX writes with one; `A \ B` alone is a difference.
bool is_latex(std::string_view typed) {
  const auto begins_command = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || std::string_view("_{}#&%").find(c) != std::string::npos;
  };
  for (std::size_t at = typed.find('\\'); at != typed.npos; at = typed.find('\\', at + 1))
    if (at + 1 < typed.size() && begins_command(typed[at + 1])) return true;
  return false;
}

/// [ S ]
zed::Term schema_of(const zed::Term& term) {
  zed::SchemaText text;
  text.declarations.push_back({zed::Declaration::Form::included, {}, {}, term, term->place});
  return zed::quantified(zed::Kind::schema_text, std::move(text), {}, term->place);
}

constexpr std::size_t most_names = 8;  // that a message lists

/// SET1, SET2, …, so many as a number says, or the words between commas.
std::vector<std::string> typed_members(const std::string& set, const std::string& typed) {
  std::vector<std::string> members;
  if (typed.empty()) return members;
  if (typed.size() < 3 && typed.find_first_not_of("0123456789") == typed.npos) {
    for (unsigned long i = 1; i <= std::stoul(typed); ++i) members.push_back(set + std::to_string(i));
    return members;
  }
  for (std::size_t from = 0; from <= typed.size();) {
    const std::size_t comma = std::min(typed.find(',', from), typed.size());
    members.push_back(typed.substr(from, comma - from));
    from = comma + 1;
  }
  return members;
}

}  // namespace

zed::Term parsed(const std::string& typed) { return parsed(typed, notation_of(text())); }

zed::Term parsed(const std::string& typed, const Notation& notation) {
  return is_latex(typed) ? zed::parse_latex(typed, notation.markup, notation.operators)
                         : zed::parse_unicode(typed, notation.operators);
}

Notation notation_of(const zed::Specification& specification) {
  Notation notation;
  for (const auto& [section, commands] : specification.markup) notation.markup.insert(commands.begin(), commands.end());
  for (const auto& [section, words] : specification.operators) notation.operators.insert(words.begin(), words.end());
  return notation;
}

Calculator::Calculator() : Calculator(text()) {}

Calculator::Calculator(zed::Specification specification) : specification_(std::move(specification)) {
  specification_.sections.push_back(calling_section(specification_));
  typing_ = zed::check(specification_);
  if (!typing_.ok()) {
    const zed::Defect& first = typing_.defects.front();
    throw zed::ZError(first.place, first.what, first.expected);
  }
}

Calculator::Calculator(const model::Escena& escena) : Calculator() {
  given_ = components(escena);
  declare(escena);
  typing_ = zed::check(specification_);
}

void Calculator::declare(const model::Escena& escena) {
  using Form = zed::Declaration::Form;
  zed::Axiomatic box;
  box.text.declarations.push_back({Form::included, {}, {}, zed::reference({"Escena", ""}), {}});
  zed::Declaration names{Form::typed, {}, {}, zed::reference({elements, ""}), {}};
  const auto add = [&](const Name& name, const model::Elemento& e) {
    names.names.push_back(name);
    names.places.push_back({});
    given_.emplace_back(name, value(e));
  };
  const std::size_t of_escena = given_.size();
  const auto is_component = [&](const Name& name) {
    return std::any_of(given_.begin(), given_.begin() + static_cast<std::ptrdiff_t>(of_escena),
                       [&](const auto& component) { return component.first == name; });
  };
  for (const model::Elemento& e : escena.elementos) {
    const Name plain{e.name(), ""};
    add({quoted(e.name()), ""}, e);
    if (!zed::is_free_word(e.name()) || typing_.find(section_name, plain) || is_component(plain)) continue;
    add(plain, e);
    plain_.insert(e.name());
  }
  if (!names.names.empty()) box.text.declarations.push_back(std::move(names));
  specification_.sections.back().paragraphs.push_back({{}, std::move(box)});
}

void Calculator::let(const std::vector<std::string>& typed) {
  const std::string section = section_name;
  const zed::Valuation constants = typed_constants(typed, {specification_, typing_, section, given_});
  given_.insert(given_.end(), constants.begin(), constants.end());
}

/// Gives the set these members, declares their names, and returns a line that says so.
std::string Calculator::declare(const Name& set, const std::vector<std::string>& members, zed::Axiomatic& box) {
  zed::Declaration names{zed::Declaration::Form::typed, {}, {}, zed::reference(set), {}};
  const auto is_given = [&](const Name& name) {
    return std::any_of(given_.begin(), given_.end(), [&](const auto& each) { return each.first == name; });
  };
  if (is_given(set)) throw ConstantError({1, 1}, set.text() + " has members already", "expected it once");
  std::vector<zed::Value> values;
  for (const std::string& word : members) {
    const Name name{word, ""};
    if (!zed::is_free_word(word) || typing_.find(section_name, name) || is_given(name))
      throw ConstantError({1, 1}, word + " cannot name a member of " + set.text(), "expected a new word");
    names.names.push_back(name);
    names.places.emplace_back();
    values.push_back(zed::Value::atom(set.text(), word));
    given_.emplace_back(name, values.back());
  }
  box.text.declarations.push_back(std::move(names));
  const zed::Value all = zed::Value::set(std::move(values));
  given_.emplace_back(set, all);
  return "within " + set.text() + " = " + all.text();
}

std::vector<std::string> Calculator::scope(const std::vector<std::string>& typed) {
  std::vector<std::string> constants, lines;
  zed::Axiomatic box;
  for (const std::string& each : typed) {
    const std::size_t sign = std::min(each.find('='), each.size());
    const Name name{each.substr(0, sign), ""};
    const zed::Global* global = typing_.find(section_name, name);
    if (!global || global->form != zed::Global::Form::given) {
      constants.push_back(each);
      continue;
    }
    const std::vector<std::string> members =
        typed_members(name.text(), sign < each.size() ? each.substr(sign + 1) : "");
    if (members.empty())
      throw ConstantError({1, 1}, each + " gives no members", "expected SET=NUMBER, up to 99, or SET=WORD,WORD");
    lines.push_back(declare(name, members, box));
  }
  if (!box.text.declarations.empty()) {
    specification_.sections.back().paragraphs.push_back({{}, std::move(box)});
    typing_ = zed::check(specification_);
  }
  let(constants);
  return lines;
}

/// Names some that there are, where none is near.
std::string Calculator::expected(const zed::Defect& defect) const {
  if (defect.expected != "expected a declared name") return defect.expected;
  std::vector<std::string> names;
  for (const auto& [name, global] : typing_.scopes.at(section_name))
    if (global->form != zed::Global::Form::lost) names.push_back(name.text());
  std::sort(names.begin(), names.end());
  std::string some;
  for (std::size_t i = 0; i < std::min(names.size(), most_names); ++i) some += (i > 0 ? ", " : ", such as ") + names[i];
  return defect.expected + some;
}

zed::Typing Calculator::check(zed::Term& term, const LocalNames& locals) const {
  auto names = zed::calculator_names();
  names.insert(names.end(), locals.types.begin(), locals.types.end());
  zed::Typing typing = zed::check_term(typing_, section_name, term, names, file_name);
  if (typing.ok()) return typing;
  const zed::Term schema = schema_of(term);
  zed::Typing as_schema = zed::check_term(typing_, section_name, schema, names, file_name);
  if (!as_schema.ok()) {
    const zed::Defect& first = typing.defects.front();
    throw zed::ZError(first.place, first.what, expected(first));
  }
  term = schema;
  return as_schema;
}

std::string Calculator::spelled(const zed::AtomName& atom) const {
  return atom.type == elements && !plain_.contains(atom.text) ? quoted(atom.text) : atom.text;
}

/// A generic has the type of its declaration, with other types for the formals: unification gives these.
std::optional<std::vector<zed::Term>> Calculator::actuals_of(const zed::Term& generic,
                                                             const zed::Typing& typing) const {
  const zed::Global* const declared = typing_.find(section_name, generic->name);
  auto type = typing.type_of(generic);
  if (!type) type = typing_.type_of(generic);
  if (!declared || !type) return std::nullopt;
  std::vector<zed::Type> found;
  for (std::size_t i = 0; i < declared->scheme.formals.size(); ++i) found.push_back(zed::Type::variable());
  if (!unify(declared->scheme.type.substitute(declared->scheme.formals, found), *type)) return std::nullopt;
  std::vector<zed::Term> actuals;
  for (const zed::Type& each : found) {
    const zed::Type actual = each.settled();
    if (!actual.is_known()) return std::nullopt;
    actuals.push_back(zed::parse_unicode(actual.text(zed::Type::max_size)));
  }
  return actuals;
}

std::optional<std::string> Calculator::written_out(const zed::Term& schema, const zed::Type& type,
                                                   const zed::Typing& typing) const {
  const auto carrier = [&](const Name& component) {
    const zed::Type* of = type.parts()[0].field(component);
    return of && of->is_known() ? zed::parse_unicode(of->text(zed::Type::max_size)) : zed::Term();
  };
  const auto text = zed::unfolded(schema, specification_.sections, carrier,
                                  [&](const zed::Term& generic) { return actuals_of(generic, typing); });
  return text ? std::optional(zed::to_unicode(*text)) : std::nullopt;
}

void Calculator::add_local(LocalNames& to, const std::string& name, const std::string& typed, zed::Steps& steps) const {
  const Notation notation = notation_of(specification_);
  const zed::Term local = parsed(name, notation);
  if (local->kind != zed::Kind::reference || !local->children.empty())
    throw zed::ZError(local->place, "this is no name", "expected one, such as radio?");
  zed::Term term = parsed(typed, notation);
  const zed::Typing typing = check(term, to);
  const std::optional<zed::Type> type = typing.type_of(term);
  if (!type) throw zed::ZError(term->place, "a predicate has no value", "expected an expression");
  const zed::Evaluator evaluator(specification_.sections, given_, &steps);
  zed::Value value = evaluator.value(term, to.values);
  if (value.is_open() || value.is_undefined())
    throw zed::ZError(term->place, "this has no value", "expected an expression that has one");
  to.types.emplace_back(local->name, type->settled());
  to.values.emplace_back(local->name, std::move(value));
}

Calculator::Result Calculator::evaluate(const std::string& typed, zed::Steps& steps, const LocalNames& locals,
                                        const zed::SmtProgram* solver) const {
  zed::Term term = parsed(typed, notation_of(specification_));
  const zed::Typing typing = check(term, locals);
  const zed::Evaluator evaluator(specification_.sections, given_, &steps);
  const std::optional<zed::Type> type = typing.type_of(term);
  if (!type) {  // it is a predicate
    const auto open = [&] { return open_variables(term, typing, {typing_, section_name}, evaluator); };
    zed::SmtFinding found = decided(term, {specification_.sections, evaluator, locals.values}, steps, solver, open);
    const bool yes = found.truth == zed::Truth::yes;
    return {yes ? "true" : "false", yes, evaluator.taken(), std::move(found.said)};
  }
  const zed::Value result = evaluator.value(term, locals.values);
  if (result.is_open()) throw open_variables(term, typing, {typing_, section_name}, evaluator);
  const bool listed = !result.set() || result.set()->members();
  if (!listed && type->is_schema_set())
    if (auto text = written_out(term, type->settled(), typing)) return {std::move(*text), true, evaluator.taken()};
  const auto spelling = [this](const zed::AtomName& atom) { return spelled(atom); };
  return {result.text(type->settled(), spelling), !result.is_undefined(), evaluator.taken()};
}

std::vector<std::string> Calculator::names(const std::string& typed, zed::Steps& steps) const {
  zed::Term term = parsed(typed, notation_of(specification_));
  const zed::Typing typing = check(term);
  const std::optional<zed::Type> type = typing.type_of(term);
  const std::string told = type ? type->settled().text(zed::Type::max_size) : "a predicate";
  const std::string wanted = std::string("ℙ ") + elements;
  if (told != wanted)
    throw zed::ZError(term->place, "the term is of type " + told, "expected a set of elements, " + wanted);
  const zed::Evaluator evaluator(specification_.sections, given_, &steps);
  const zed::Value result = evaluator.value(term);
  if (result.is_undefined()) throw zed::EvaluationError("the set is undefined");
  if (!result.set() || !result.set()->members()) throw zed::EvaluationError("the set is not finite");
  std::vector<std::string> names;
  for (const zed::Value& member : *result.set()->members()) names.push_back((*member.get<zed::Atom>())->text);
  std::ranges::sort(names);
  return names;
}

}  // namespace durero::spec
