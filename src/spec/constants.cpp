#include "durero/spec/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "durero/text/nearest.hpp"
#include "durero/text/utf8.hpp"

namespace durero::spec {
namespace {

using zed::Name;
using zed::Place;
using zed::Term;

Name name_of(const std::string& word) {
  const std::size_t stroke = word.find_first_of("'?!");
  return {word.substr(0, stroke), stroke == word.npos ? "" : word.substr(stroke)};
}

std::vector<std::string> constants_of(const Knowledge& known) {
  std::vector<std::string> names;
  for (const auto& [name, global] : known.typing.scopes.at(known.section))
    if (global->form == zed::Global::Form::axiom && global->scheme.formals.empty()) names.push_back(name.text());
  std::sort(names.begin(), names.end());
  return names;
}

const zed::Global& constant_of(const std::string& word, const Knowledge& known) {
  const zed::Global* global = known.typing.find(known.section, name_of(word));
  if (global && global->form == zed::Global::Form::axiom && global->scheme.formals.empty()) return *global;
  throw ConstantError({1, 1}, "the text has no constant " + word,
                      "expected " + text::nearest(word, constants_of(known)).value_or("a name of an axiomatic box"));
}

/// The value with its sets listed, which does not need the evaluator that gave it; nothing where one cannot be.
std::optional<zed::Value> listed(const zed::Value& value) {
  const auto each = [](const auto& parts) -> std::optional<std::vector<zed::Value>> {
    std::vector<zed::Value> all;
    for (const zed::Value& part : parts) {
      auto lasting = listed(part);
      if (!lasting) return std::nullopt;
      all.push_back(std::move(*lasting));
    }
    return all;
  };
  if (const zed::Set* set = value.set()) {
    const auto members = set->members() ? each(*set->members()) : std::nullopt;
    return members ? std::optional(zed::Value::set(*members)) : std::nullopt;
  }
  if (const auto* tuple = value.tuple()) {
    const auto parts = each(tuple->parts);
    return parts ? std::optional(zed::Value::tuple(*parts)) : std::nullopt;
  }
  if (const auto* binding = value.binding()) {
    const auto parts = each(binding->values);
    return parts ? std::optional(zed::Value::binding(binding->names, *parts)) : std::nullopt;
  }
  return value;
}

/// The value of the text behind the sign, of the type of the constant.
zed::Value value_of(const std::string& typed, std::size_t sign, const zed::Global& constant, const Knowledge& known) {
  std::uint32_t first = 1;  // the column behind the sign
  for (std::size_t at = 0; at <= sign; ++at) first += text::continues(typed[at]) ? 0 : 1;
  try {
    const Term term = parsed(typed.substr(sign + 1), notation_of(known.specification));
    const Term equation = zed::relation({{"_=_", {}}}, {zed::reference(constant.name, {}, term->place), term});
    const zed::Typing typing = zed::check_term(known.typing, known.section, equation, zed::calculator_names(), "VALUE");
    if (!typing.ok()) throw zed::ZError(typing.defects[0].place, typing.defects[0].what, typing.defects[0].expected);
    const zed::Evaluator evaluator(known.specification.sections, known.given);
    const zed::Value value = evaluator.value(term);
    if (value.is_undefined() || value.is_open())
      throw zed::ZError(term->place, "this has no value", "expected one of " + constant.name.text());
    if (auto lasting = listed(value)) return std::move(*lasting);
    throw zed::ZError(term->place, "this is a set that cannot be listed", "expected a value of finite sets");
  } catch (const zed::ZError& error) {
    throw ConstantError({1, error.place.column + first - 1}, error.what_is_wrong, error.expected);
  } catch (const zed::EvaluationError& error) {
    throw ConstantError({1, first}, std::string("this is not decided: ") + error.what(), "expected a value");
  }
}

}  // namespace

zed::Valuation typed_constants(const std::vector<std::string>& typed, const Knowledge& known) {
  zed::Valuation constants;
  if (typed.empty()) return constants;
  for (const std::string& each : typed) {
    const std::size_t sign = each.find('=');
    if (sign == each.npos || sign == 0 || sign + 1 == each.size())
      throw ConstantError({1, 1}, each + " gives no value", "expected NAME=VALUE");
    const zed::Global& constant = constant_of(each.substr(0, sign), known);
    constants.emplace_back(constant.name, value_of(each, sign, constant, known));
  }
  zed::Valuation all = known.given;
  all.insert(all.end(), constants.begin(), constants.end());
  const zed::Evaluator evaluator(known.specification.sections, all);
  for (const auto& [name, value] : constants) try {
      evaluator.check_given(name);
    } catch (const zed::Unsatisfied& error) {
      throw ConstantError({1, 1}, error.what(), "expected a value that the text admits");
    }
  return constants;
}

zed::Valuation given_constants(const zed::Specification& text, const std::vector<std::string>& typed) {
  const std::string section = "constants";
  zed::Section all;
  all.file = "--let";
  all.name = section;
  for (const zed::Section& parent : text.sections) all.parents.push_back(parent.name);
  zed::Specification with = text;
  with.sections.push_back(std::move(all));
  const zed::Typing typing = zed::check(with);
  return typed_constants(typed, {with, typing, section, {}});
}

GivenScope given_scope(const zed::Specification& text, const std::vector<std::string>& let,
                       const std::vector<std::string>& scope) {
  Calculator calculator(text);
  calculator.let(let);
  GivenScope given;
  try {
    given.within = calculator.scope(scope);
  } catch (const ConstantError& error) {
    throw ScopeError(error.place, error.what_is_wrong, error.expected);
  }
  for (std::string& line : given.within) line = line.substr(std::string("within ").size());
  const zed::Typing typing = zed::check(text);
  const auto is_of_text = [&](const Name& name) {  // the members' own names are not
    return std::any_of(text.sections.begin(), text.sections.end(),
                       [&](const zed::Section& section) { return typing.find(section.name, name) != nullptr; });
  };
  for (const auto& each : calculator.given())
    if (is_of_text(each.first)) given.values.push_back(each);
  return given;
}

std::vector<std::string> taken_lines(const zed::Valuation& taken) {
  std::vector<std::string> lines;
  for (const auto& [name, value] : taken)
    lines.push_back(fmt::format("{0} = {1} was taken; --let {0}=VALUE chooses another", name.text(), value.text()));
  return lines;
}

}  // namespace durero::spec
