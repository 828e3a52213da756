#include <fmt/format.h>

#include <algorithm>

#include "durero/zed/syntax/defect.hpp"
#include "zed/hol/writer.hpp"

namespace durero::zed::hol {

std::string HolWriter::with(const Applied& applied, const std::string& body) const {
  std::string said = body;
  for (auto at = applied.rbegin(); at != applied.rend(); ++at)
    said = dialect_.some({{at->first, ""}}, dialect_.all_of({at->second, said}));
  return said;
}

std::string HolWriter::predicate(const Term& whole, const Written& scope) {
  const auto part = [&](std::size_t i) { return predicate(whole->children[i], scope); };
  switch (whole->kind) {
    case Kind::truth:
      return "True";
    case Kind::falsity:
      return "False";
    case Kind::negation:
      return dialect_.denied(part(0));
    case Kind::conjunction:
      return dialect_.all_of({part(0), part(1)});
    case Kind::disjunction:
      return dialect_.any_of(part(0), part(1));
    case Kind::implication:
      return dialect_.implied(part(0), part(1));
    case Kind::equivalence:
      return dialect_.equivalent(part(0), part(1));
    case Kind::forall:
    case Kind::exists:
      return quantified(whole, scope);
    case Kind::exists_one:
      return only_one(whole, scope);
    case Kind::relation:
      return relation(whole, scope);
    case Kind::reference:
    case Kind::number:
    case Kind::set_extension:
    case Kind::comprehension:
    case Kind::tuple:
    case Kind::product:
    case Kind::power:
    case Kind::selection:
    case Kind::tuple_selection:
    case Kind::binding_extension:
    case Kind::theta:
    case Kind::application:
    case Kind::lambda:
    case Kind::mu:
    case Kind::let:
    case Kind::conditional:
    case Kind::schema_text:
    case Kind::decoration:
    case Kind::renaming:
    case Kind::hiding:
    case Kind::composition:
    case Kind::piping:
    case Kind::projection:
    case Kind::precondition:
      break;
  }
  return schema_holds(whole, scope);
}

std::string HolWriter::quantified(const Term& whole, const Written& scope) {
  Written inner = scope;
  Binders variables;
  std::vector<std::string> asked = declare(*whole->text, scope, inner, variables);
  const std::string body = predicate(whole->children[0], inner);
  if (whole->kind == Kind::forall) return dialect_.all(variables, dialect_.implied(dialect_.all_of(asked), body));
  asked.push_back(body);
  return dialect_.some(variables, dialect_.all_of(asked));
}

/// There are such values, and any others such are the same.
std::string HolWriter::only_one(const Term& whole, const Written& scope) {
  Written inner = scope;
  Binders variables;
  std::vector<std::string> asked = declare(*whole->text, scope, inner, variables);
  asked.push_back(predicate(whole->children[0], inner));
  Written around = inner;
  for (const auto& [name, text] : inner)
    if (!scope.contains(name)) around[{" " + name.text(), ""}] = text;  // taken: the others get other names
  Written other = around;
  Binders others;
  for (const auto& [name, text] : inner) other.erase(scope.contains(name) ? Name{" ", ""} : name);
  std::vector<std::string> of_others = declare(*whole->text, other, other, others);
  of_others.push_back(predicate(whole->children[0], other));
  std::vector<std::string> same;
  for (std::size_t i = 0; i < variables.size(); ++i)
    same.push_back(fmt::format("({} = {})", others[i].first, variables[i].first));
  asked.push_back(dialect_.all(others, dialect_.implied(dialect_.all_of(of_others), dialect_.all_of(same))));
  return dialect_.some(variables, dialect_.all_of(asked));
}

std::vector<std::string> HolWriter::declare(const SchemaText& text, const Written& outer, Written& inner,
                                            Binders& variables) {
  std::vector<std::string> asked;
  const auto add = [&](const Name& name, const std::string& of, Place place) {
    const std::string v = variable(name, inner, place);
    inner[name] = v;
    if (std::none_of(variables.begin(), variables.end(), [&](const auto& each) { return each.first == v; }))
      variables.emplace_back(v, of);
  };
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::defined) not_covered(declaration.place, "a declaration by ==");
    for (const Name& name : declaration.names) add(name, "", declaration.place);
    if (declaration.form == Declaration::Form::included)
      for (const auto& [name, of] : components_of(declaration.term))
        add(name, type(of, declaration.place), declaration.place);
  }
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::included) asked.push_back(schema_holds(declaration.term, inner));
    for (const Name& name : declaration.names) {
      Applied applied;
      const std::string set = term(declaration.term, outer, applied);
      asked.push_back(with(applied, fmt::format("(z_in {} {})", inner.at(name), set)));
    }
  }
  for (const Predicate& each : text.predicates) asked.push_back(predicate(each.term, inner));
  return asked;
}

std::string HolWriter::relation(const Term& whole, const Written& scope) {
  if (whole->children.size() != whole->names.size() + 1) not_covered(whole->place, "this relation");
  std::vector<std::string> all;
  for (std::size_t i = 0; i < whole->names.size(); ++i)
    all.push_back(related(whole->names[i], whole->children[i], whole->children[i + 1], scope));
  return dialect_.all_of(all);
}

/// θ S = θ S ′ says it of each component.
std::string HolWriter::related(const Name& name, const Term& a, const Term& b, const Written& scope) {
  if (a->kind == Kind::theta || b->kind == Kind::theta) {
    if (a->kind != Kind::theta || b->kind != Kind::theta || name.word != "_=_")
      not_covered(a->place, "θ in this place");
    std::vector<std::string> same;
    for (const auto& [component, of] : components_of(a->children[0])) {
      const Name left{component.word, component.strokes + a->name.strokes},
          right{component.word, component.strokes + b->name.strokes};
      if (!scope.contains(left) || !scope.contains(right)) not_covered(a->place, "this θ");
      same.push_back(fmt::format("({} = {})", scope.at(left), scope.at(right)));
    }
    return dialect_.all_of(same);
  }
  Applied applied;
  const std::string x = term(a, scope, applied), y = term(b, scope, applied);
  const std::string& word = name.word;
  const auto said = [&]() -> std::string {
    if (word == "_=_") return fmt::format("({} = {})", x, y);
    if (word == "_≠_") return dialect_.denied(fmt::format("({} = {})", x, y));
    if (word == "_∈_") return fmt::format("(z_in {} {})", x, y);
    if (word == "_∉_") return dialect_.denied(fmt::format("(z_in {} {})", x, y));
    if (word == "_⊆_") return fmt::format("(z_subset {} {})", x, y);
    if (word == "_⊂_") return fmt::format("(z_psubset {} {})", x, y);
    if (word == "_<_") return fmt::format("(z_less {} {})", x, y);
    if (word == "_>_") return fmt::format("(z_less {} {})", y, x);
    if (word == "_≤_") return fmt::format("(z_at_most {} {})", x, y);
    if (word == "_≥_") return fmt::format("(z_at_most {} {})", y, x);
    not_covered(a->place, "the relation " + name.text());
  };
  return with(applied, said());
}

const Components* HolWriter::components_of(const Name& schema) const {
  const auto at = schemas_.find(schema.text());
  return at == schemas_.end() ? nullptr : &at->second;
}

namespace {

Components with_strokes(const Components& components, const std::string& strokes) {
  Components all;
  for (const auto& [name, type] : components) all.emplace_back(Name{name.word, name.strokes + strokes}, type);
  return all;
}

std::string state_of_change(const std::string& word) {
  return word.starts_with("Δ") || word.starts_with("Ξ") ? word.substr(2) : "";
}

}  // namespace

Components HolWriter::components_of(const Term& schema) const {
  if (schema->kind == Kind::reference) {
    if (const Components* known = components_of(schema->name)) return *known;
    if (const Components* state = components_of(Name{state_of_change(schema->name.word), ""})) {
      Components all = *state;
      for (auto& each : with_strokes(*state, "'")) all.push_back(std::move(each));
      return all;
    }
  }
  if (schema->kind == Kind::decoration) return with_strokes(components_of(schema->children[0]), schema->name.strokes);
  if (schema->kind == Kind::precondition) {
    Components before = components_of(schema->children[0]);
    std::erase_if(before, [](const auto& each) { return each.first.strokes.find_first_of("'!") != std::string::npos; });
    return before;
  }
  not_covered(schema->place, "this schema");
}

std::string HolWriter::called(const Name& name, const Components& components, const std::string& strokes,
                              const Written& scope, Place place) {
  std::string said = globals_.at(name.text());
  for (const auto& [component, type] : components) {
    const auto at = scope.find({component.word, component.strokes + strokes});
    if (at == scope.end()) not_covered(place, "a component out of scope");
    said += " " + at->second;
  }
  return "(" + said + ")";
}

std::string HolWriter::unchanged(const Components& components, const Written& scope) {
  std::vector<std::string> same;
  for (const auto& [name, type] : components)
    same.push_back(fmt::format("({} = {})", scope.at({name.word, name.strokes + "'"}), scope.at(name)));
  return dialect_.all_of(same);
}

std::string HolWriter::schema_holds(const Term& schema, const Written& scope) {
  if (schema->kind == Kind::schema_text) {
    Written inner = scope;
    std::vector<std::string> asked;
    for (const Declaration& declaration : schema->text->declarations) {
      if (declaration.form == Declaration::Form::defined) not_covered(declaration.place, "a declaration by ==");
      if (declaration.form == Declaration::Form::included) asked.push_back(schema_holds(declaration.term, scope));
      for (const Name& name : declaration.names) {
        Applied applied;
        const std::string set = term(declaration.term, scope, applied);
        asked.push_back(with(applied, fmt::format("(z_in {} {})", scope.at(name), set)));
      }
    }
    for (const Predicate& each : schema->text->predicates) asked.push_back(predicate(each.term, scope));
    return dialect_.all_of(asked);
  }
  if (schema->kind == Kind::precondition) {
    Written inner = scope;
    Binders hidden;
    for (const auto& [name, of] : components_of(schema->children[0]))
      if (name.strokes.find_first_of("'!") != std::string::npos) {
        inner.erase(name);
        const std::string v = variable(name, inner, schema->place);
        inner[name] = v;
        hidden.emplace_back(v, type(of, schema->place));
      }
    return dialect_.some(hidden, schema_holds(schema->children[0], inner));
  }
  if (schema->kind == Kind::decoration && schema->children[0]->kind == Kind::reference) {
    const Name& name = schema->children[0]->name;
    if (const Components* known = components_of(name))
      return called(name, *known, schema->name.strokes, scope, schema->place);
  }
  if (schema->kind != Kind::reference) {
    if (schema->kind == Kind::conjunction || schema->kind == Kind::disjunction) return predicate(schema, scope);
    not_covered(schema->place, "this schema expression");
  }
  if (const Components* known = components_of(schema->name))
    return called(schema->name, *known, "", scope, schema->place);
  const Name state{state_of_change(schema->name.word), ""};
  const Components* of_state = components_of(state);
  if (!of_state) not_covered(schema->place, "the schema " + schema->name.text());
  std::vector<std::string> said{called(state, *of_state, "", scope, schema->place),
                                called(state, *of_state, "'", scope, schema->place)};
  if (schema->name.word.starts_with("Ξ")) said.push_back(unchanged(*of_state, scope));
  return dialect_.all_of(said);
}

}  // namespace durero::zed::hol
