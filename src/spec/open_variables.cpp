#include "spec/open_variables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/zed/print/print.hpp"

namespace durero::spec {
namespace {

using zed::Kind;
using zed::Term;
using zed::Type;

/// A variable that ranges over a set which is not listed.
struct EndlessVariable {
  std::string name, set;
  Type type;
  bool is_integer = false;
  bool is_finite = false;  ///< it is known to have an end, and is too great
};

/// Looks through a term for its variables.
class EndlessSearch {
 public:
  EndlessSearch(const zed::Typing& typing, const SeenNames& seen, const zed::Evaluator& evaluator)
      : typing_(typing), seen_(seen), evaluator_(evaluator) {}

  void look(const Term& term) {
    if (term->text) {
      for (const zed::Declaration& declaration : term->text->declarations) {
        declared(declaration);
        look(declaration.term);
      }
      for (const zed::Predicate& predicate : term->text->predicates) look(predicate.term);
    }
    for (const Term& child : term->children) look(child);
  }

  /// The given sets without members among the types of the variables.
  std::vector<std::string> given_sets() const {
    std::vector<std::string> sets;
    for (const EndlessVariable& each : found) add_given(each.type, sets);
    return sets;
  }

  std::vector<EndlessVariable> found{};

 private:
  /// The value of a declared set; nothing where it depends on another variable.
  std::optional<zed::Value> value_of(const Term& set) const {
    try {
      return evaluator_.value(set);
    } catch (const zed::EvaluationError&) {
      return std::nullopt;
    } catch (const zed::StepsSpent&) {
      return std::nullopt;
    }
  }

  void declared(const zed::Declaration& declaration) {
    if (declaration.form == zed::Declaration::Form::defined) return;
    const auto type = typing_.type_of(declaration.term);
    const auto set = value_of(declaration.term);
    if (!type || !type->is(Type::Kind::power) || !set || !set->set() || set->set()->members()) return;
    const Type element = type->settled().parts()[0];
    const std::string text = zed::to_unicode(declaration.term);
    const bool integers = set->set()->numbers() == zed::Numbers::integers;
    if (declaration.form == zed::Declaration::Form::typed) {
      for (const zed::Name& name : declaration.names)
        found.push_back({name.text(), text, element, integers, set->set()->size().has_value()});
    } else if (element.is(Type::Kind::schema)) {
      found.push_back({text, "its states", element, false});
    }
  }

  void add_given(const Type& type, std::vector<std::string>& to) const {
    for (const Type& part : type.parts()) add_given(part, to);
    if (!type.is(Type::Kind::given)) return;
    const zed::Global* global = seen_.text.find(seen_.section, type.name());
    if (!global || global->form != zed::Global::Form::given) return;
    const auto value = value_of(zed::reference(type.name()));
    const bool has_members = value && value->set() && value->set()->members();
    if (!has_members && std::find(to.begin(), to.end(), type.name().text()) == to.end())
      to.push_back(type.name().text());
  }

  const zed::Typing& typing_;
  const SeenNames& seen_;
  const zed::Evaluator& evaluator_;
};

bool has_number(const Type& type) {
  if (type.is(Type::Kind::given)) return type.name().text() == "𝔸";
  return std::any_of(type.parts().begin(), type.parts().end(), has_number);
}

/// The bounds that would do for the variables: whole numbers by an interval, other numbers by a finite set, and given
/// sets by members.
std::string bounds_for(const std::vector<EndlessVariable>& variables, const std::vector<std::string>& given) {
  std::vector<std::string> bounds;
  for (const EndlessVariable& each : variables)
    if (each.is_integer) bounds.push_back(fmt::format("a bound for {0}, as {0} : 0‥9", each.name));
  for (const EndlessVariable& each : variables)
    if (!each.is_integer && (has_number(each.type) || given.empty()))
      bounds.push_back((each.is_finite ? "a smaller set for " : "a finite set for ") + each.name);
  for (const std::string& set : given) bounds.push_back(fmt::format("members of {0}, as by --scope {0}=3", set));
  return fmt::format("expected {}", fmt::join(bounds, ", and "));
}

}  // namespace

OpenVariables open_variables(const Term& term, const zed::Typing& typing, const SeenNames& seen,
                             const zed::Evaluator& evaluator) {
  EndlessSearch search(typing, seen, evaluator);
  search.look(term);
  const std::vector<EndlessVariable>& variables = search.found;
  if (variables.empty())
    return {"a variable ranges over a set that is not finite, and no equation gives its value",
            "expected finite sets, or equations, for what is quantified"};
  const std::string expected = bounds_for(variables, search.given_sets());
  if (variables.size() == 1)
    return {fmt::format("{} ranges over {}, {}, and no equation gives its value", variables[0].name, variables[0].set,
                        variables[0].is_finite ? "which has too many members" : "of which there is no end"),
            expected};
  std::vector<std::string> names;
  for (const EndlessVariable& each : variables) names.push_back(each.name);
  return {fmt::format("one of {} ranges over a set that is not finite, and no equation gives its value",
                      fmt::join(names, ", ")),
          expected};
}

}  // namespace durero::spec
