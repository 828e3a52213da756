/// Compiles schemas in the place of predicates: their components are the names of the scope around them.

#include <algorithm>
#include <utility>

#include "zed/evaluate/compiler.hpp"

namespace durero::zed {
namespace {

template <class T>
class Restored {
 public:
  Restored(T& place, T now) : place_(place), before_(std::exchange(place, std::move(now))) {}
  ~Restored() { place_ = std::move(before_); }
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;

 private:
  T& place_;
  T before_;
};

}  // namespace

Local Compiler::component(const Name& name, const Scope& scope) {
  if (const Local* local = find(name, scope)) return *local;
  Local local;
  local.code = this->name(*reference(name), scope);
  return local;
}

Property Compiler::declaration(const Declaration& declaration, const Scope& scope) {
  std::vector<Property> parts;
  const std::size_t before = reads_.size();
  const Code set = expression(declaration.term, scope.of_declarations());
  const std::vector<unsigned> reads(reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end());
  for (const Name& name : declaration.names) {
    const Local local = component(name, scope);
    reads_.insert(reads_.end(), local.reads.begin(), local.reads.end());
    if (local.slot) reads_.push_back(*local.slot);
    const Code value = local.slot ? Code::of_slot(*local.slot) : local.code;
    Property property;
    if (declaration.form == Declaration::Form::defined) {
      property = test_of([value, set](Frame& frame) {
        const HeldValue a(value, frame), b(set, frame);
        return equal(*a, *b, frame.context);
      });
      if (local.slot) property.equations.push_back({*local.slot, set, reads});
    } else {
      property = test_of([value, set](Frame& frame) {
        const HeldValue member(value, frame), of(set, frame);
        return contains_value(*of, *member, frame.context);
      });
      if (local.slot) {
        property.declared = *local.slot;
        property.set = set;
        property.reads = reads;
      }
    }
    property.term = declaration.term;
    property.written =
        declaration.form == Declaration::Form::defined ? Property::Written::equal : Property::Written::member;
    property.declares = decorated(name, strokes_);
    property.strokes = strokes_;
    parts.push_back(std::move(property));
  }
  return all_of(std::move(parts));
}

Property Compiler::text(const SchemaText& text, const Scope& scope) {
  Property property;
  for (const Declaration& declared : text.declarations) {
    const Restored<std::string> none(label_, declared.form == Declaration::Form::included ? std::string() : label_);
    property.parts.push_back(declared.form == Declaration::Form::included ? predicate(declared.term, scope)
                                                                          : declaration(declared, scope));
  }
  for (const Predicate& conjunct : text.predicates) {
    Property part = predicate(conjunct.term, scope);
    part.label = conjunct.label.empty() ? label_ : conjunct.label;
    part.term = conjunct.term;
    part.strokes = strokes_;
    part.written = Property::Written::term;
    property.parts.push_back(std::move(part));
  }
  return property;
}

Property Compiler::schema(const Term& term, const Scope& scope) {
  const Node& node = *term;
  switch (node.kind) {
    case Kind::reference:
      return schema_reference(term, scope);
    case Kind::schema_text:
      return text(*node.text, scope);
    case Kind::decoration:
    case Kind::renaming:
      return renamed(node, scope);
    case Kind::hiding:
      return hidden(node.names, scope, [&](const Scope& inner) { return predicate(node.children[0], inner); });
    case Kind::precondition:
      return hidden(hidden_by_pre(node.children[0], definitions_), scope,
                    [&](const Scope& inner) { return predicate(node.children[0], inner); });
    case Kind::composition:
      return joined_schemas(node, "'", "", scope);
    case Kind::piping:
      return joined_schemas(node, "!", "?", scope);
    case Kind::projection:
      return projection(node, scope);
    default:
      cannot(node, "an expression stands in the place of a predicate");
  }
}

/// In S ' and S[new/old] a component of S is the name outside that the stroke or the renaming gives it.
Property Compiler::renamed(const Node& node, const Scope& scope) {
  std::vector<std::pair<Name, Name>> names;
  for (const Name& name : components(node.children[0], definitions_).value_or(Components{})) {
    Name outside = decorated(name, node.kind == Kind::decoration ? node.name.strokes : "");
    for (std::size_t i = 0; i + 1 < node.names.size(); i += 2) {
      if (name == node.names[i + 1]) outside = node.names[i];
    }
    names.emplace_back(name, outside);
  }
  const Restored<std::string> strokes(strokes_, strokes_ + node.name.strokes);
  return mapped(node.children[0], scope, names);
}

/// S ⨡ T is S and T without the components that only S has.
Property Compiler::projection(const Node& node, const Scope& scope) {
  const auto kept = components(node.children[1], definitions_).value_or(Components{});
  auto gone = components(node.children[0], definitions_).value_or(Components{});
  std::erase_if(gone, [&](const Name& name) { return std::find(kept.begin(), kept.end(), name) != kept.end(); });
  std::vector<Property> parts;
  parts.push_back(hidden(gone, scope, [&](const Scope& inner) { return predicate(node.children[0], inner); }));
  parts.push_back(predicate(node.children[1], scope));
  return all_of(std::move(parts));
}

Property Compiler::schema_reference(const Term& term, const Scope& scope) {
  const Node& node = *term;
  if (const Meaning* global = definitions_.find(node.name)) {
    const auto names = components(term, definitions_);
    if (!names) cannot(node, node.name.text() + " is no schema");
    const auto* schema = std::get_if<Schema>(&global->paragraph->form);
    const auto& parameters = schema ? schema->formals : std::get<Definition>(global->paragraph->form).formals;
    const Scope outer = formals(parameters, node.children, scope);
    Scope inner{.outer = &outer, .unit = scope.unit, .declarations = &outer};
    for (const Name& variable : *names) inner.names[variable] = component(variable, scope);
    return schema_definition(*global, inner);
  }
  for (const bool unchanged : {false, true}) {
    if (const auto of = implicit(node.name, unchanged ? "Ξ" : "Δ", definitions_)) return change(*of, unchanged, scope);
  }
  cannot(node, node.name.text() + " is not declared");
}

// The label of a definition stands for the predicate that is written in it, not for the schemas that it names.
Property Compiler::schema_definition(const Meaning& global, const Scope& scope) {
  const Restored<std::string> label(label_, std::string(global.label()));
  if (const auto* schema = std::get_if<Schema>(&global.paragraph->form)) return text(schema->text, scope);
  return predicate(std::get<Definition>(global.paragraph->form).value, scope);
}

// ΔS is S and S'; ΞS says moreover that θS = θS'.
Property Compiler::change(const Name& of, bool unchanged, const Scope& scope) {
  const Term schema = reference(of);
  std::vector<std::pair<Name, Name>> after;
  for (const Name& name : components(schema, definitions_).value_or(Components{})) {
    after.emplace_back(name, decorated(name, "'"));
  }
  std::vector<Property> parts;
  parts.push_back(predicate(schema, scope));
  {
    const Restored<std::string> strokes(strokes_, strokes_ + "'");
    parts.push_back(mapped(schema, scope, after));
  }
  if (unchanged) {
    const auto theta = [&](const std::string& strokes) {
      Node node{.kind = Kind::theta, .place = {}, .name = {{}, strokes}, .children = {schema}, .names = {}, .text = {}};
      return make(std::move(node));
    };
    parts.push_back(relation(zed::relation({{"_=_", {}}}, {theta(""), theta("'")}), scope));
    parts.back().written = Property::Written::term;
  }
  return all_of(std::move(parts));
}

Property Compiler::mapped(const Term& schema, const Scope& scope, const std::vector<std::pair<Name, Name>>& names) {
  Scope inner{.outer = &scope, .unit = scope.unit, .declarations = &scope.of_declarations()};
  for (const auto& [inside, outside] : names) inner.names[inside] = component(outside, scope);
  return predicate(schema, inner);
}

Property Compiler::hidden(const Components& names, const Scope& scope,
                          const std::function<Property(const Scope&)>& inside) {
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit, .declarations = &scope.of_declarations()};
  std::vector<Variable> variables;
  for (const Name& name : names) {
    const unsigned slot = Slots::take(*scope.unit);
    inner.names[name] = {slot, {}};
    variables.push_back({.name = name.text(), .slot = slot, .set = {}, .value = {}});
  }
  return exists_property(std::move(variables), inside(inner));
}

// In S ⨟ T and S ⨠ T, T takes the components that S leaves under a stroke.
Property Compiler::joined_schemas(const Node& node, const std::string& stroke, const std::string& to_stroke,
                                  const Scope& scope) {
  const Term &left = node.children[0], &right = node.children[1];
  const auto between = joined(left, stroke, right, to_stroke, definitions_);
  Components fresh;  // no text can write such a name
  std::vector<std::pair<Name, Name>> of_left, of_right;
  for (const Name& name : between) {
    fresh.push_back(Name{"between " + name.word, name.strokes});
    of_left.emplace_back(decorated(name, stroke), fresh.back());
    of_right.emplace_back(decorated(name, to_stroke), fresh.back());
  }
  return hidden(fresh, scope, [&](const Scope& inner) {
    std::vector<Property> parts;
    parts.push_back(mapped(left, inner, of_left));
    parts.push_back(mapped(right, inner, of_right));
    return all_of(std::move(parts));
  });
}

}  // namespace durero::zed
