#include <fmt/core.h>

#include <utility>

#include "durero/zed/print/print.hpp"
#include "zed/syntax/symbols.hpp"
#include "zed/types/checker.hpp"

namespace durero::zed {
namespace {

/// Names a term in an error, in full where it is short.
std::string named(const Term& term) {
  constexpr std::size_t longest = 60;
  const std::string text = to_unicode(term);
  return text.size() <= longest && text.find('\n') == text.npos ? text : "this expression";
}

Type pair(const Type& a, const Type& b) { return Type::product({a, b}); }

}  // namespace

Type Checker::limited(Type type) {
  if (type.size() <= Type::max_size && type.depth() <= Type::max_depth) return type;
  return wrong(at_, fmt::format("a type of more than {} parts or {} levels", Type::max_size, Type::max_depth),
               "expected a smaller type");
}

Type Checker::expression(const Term& term) {
  const Place before = at_;
  at_ = term->place;
  spend(1);
  Type type = limited(infer(*term));
  spend(type.size() / 8);  // something is done with it later
  into_.types.insert_or_assign(term.get(), type);
  at_ = before;
  return type;
}

Type Checker::infer(const Node& node) {
  switch (node.kind) {
    case Kind::reference:
      return reference(node);
    case Kind::number:
      return arithmos();
    case Kind::set_extension:
      return set_extension(node);
    case Kind::tuple: {
      std::vector<Type> parts;
      parts.reserve(node.children.size());
      for (const Term& part : node.children) parts.push_back(expression(part));
      return Type::product(std::move(parts));
    }
    case Kind::product: {
      std::vector<Type> parts;
      parts.reserve(node.children.size());
      for (const Term& part : node.children) parts.push_back(element(part, "a factor of ×"));
      return Type::power(Type::product(std::move(parts)));
    }
    case Kind::power:
      return Type::power(Type::power(element(node.children[0], "the operand of ℙ")));
    case Kind::selection:
      return selection(node);
    case Kind::tuple_selection:
      return tuple_selection(node);
    case Kind::binding_extension:
      return binding_extension(node);
    case Kind::theta:
      return theta(node);
    case Kind::application:
      return application(node);
    case Kind::comprehension:
    case Kind::lambda:
    case Kind::mu:
      return quantified(node);
    case Kind::let:
      return let(node, Mode::value);
    case Kind::conditional:
      return conditional(node);
    case Kind::truth:
    case Kind::falsity:
    case Kind::relation:
      predicate(Term(std::make_shared<const Node>(node)));
      return wrong(node.place, "a predicate stands where an expression is expected", "expected an expression");
    default:
      return schema_expression(node);
  }
}

Type Checker::element(const Term& set, const char* role) {
  const Type type = expression(set);
  if (type.is(Type::Kind::power)) return type.parts()[0];
  const Type element = fresh();
  if (unify(type, Type::power(element))) return element;
  return wrong(set->place, fmt::format("{} has the type {}", named(set), type.text()),
               fmt::format("expected a set as {}", role));
}

Type Checker::set_extension(const Node& node) {
  const Type element = fresh();
  for (const Term& term : node.children) {
    const Type type = expression(term);
    if (!unify(element, type))
      error(term->place, fmt::format("{} has the type {} in a set of {}", named(term), type.text(), element.text()),
            "expected elements of one type");
  }
  if (node.children.empty()) generics_.push_back({{"{}", {}}, {node.place, element}});
  return Type::power(element);
}

std::optional<std::pair<Type, Type>> Checker::sides_of(const Type& type) {
  if (type.is(Type::Kind::power)) {
    const Type& element = type.parts()[0];
    const bool pairs = element.is(Type::Kind::product) && element.parts().size() == 2;
    if (pairs && !element.parts()[1].is(Type::Kind::unknown))  // which would leave its variable open
      return std::pair(element.parts()[0], element.parts()[1]);
  }
  const std::pair sides{fresh(), fresh()};
  if (!unify(type, Type::power(pair(sides.first, sides.second)))) return std::nullopt;
  return sides;
}

Type Checker::application(const Node& node) {
  const Type function = expression(node.children[0]), argument = expression(node.children[1]);
  const auto sides = sides_of(function);
  if (!sides)
    return wrong(node.place, fmt::format("{} has the type {}", named(node.children[0]), function.text()),
                 node.children[1]->place.line > node.children[0]->place.line
                     ? "expected a function before its argument, or a new line \\\\ between the two"
                     : "expected a function before its argument");
  const auto& [taken, given] = *sides;
  if (unify(taken, argument)) return given;
  const Term& named_function = node.children[0];
  const Operator* op = named_function->kind == Kind::reference ? operator_of_name(named_function->name.word) : nullptr;
  error(node.place,
        op ? fmt::format("{} is applied to {}", op->symbol, argument.text())
           : fmt::format("{} is applied to an argument of type {}", named(named_function), argument.text()),
        fmt::format("expected {}", taken.text()));
  return given;
}

Type Checker::quantified(const Node& node) {
  push(signature(*node.text));
  predicates(*node.text);
  const Type tuple = characteristic(*node.text);
  const Type value = node.children.empty() ? tuple : expression(node.children[0]);
  pop();
  if (node.kind == Kind::comprehension) return Type::power(value);
  if (node.kind == Kind::lambda) return Type::power(pair(tuple, value));
  return value;
}

Type Checker::characteristic(const SchemaText& text) {
  std::vector<Type> parts;
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::included) {
      Term schema = declaration.term;
      while (schema->kind == Kind::decoration) schema = schema->children[0];  // the tuple of S ′ is θ S ′
      const auto type = into_.types.find(schema.get());
      const bool known = type != into_.types.end() && type->second.is_schema_set();
      parts.push_back(known ? type->second.parts()[0] : undetermined());
    }
    for (const Name& name : declaration.names) parts.push_back(*scopes_.back().find(name));
  }
  if (text.declarations.empty()) return Type::schema({});  // that of no declaration is the empty binding
  if (parts.empty()) return wrong(at_, "nothing is declared", "expected a declaration");
  return parts.size() == 1 ? parts[0] : Type::product(std::move(parts));
}

Type Checker::let(const Node& node, Mode mode) {
  push(signature(*node.text));
  Type type = Type::unknown();
  if (mode == Mode::value) {
    type = expression(node.children[0]);
  } else {
    predicate(node.children[0]);
  }
  pop();
  return type;
}

Type Checker::conditional(const Node& node) {
  predicate(node.children[0]);
  const Type yes = expression(node.children[1]), no = expression(node.children[2]);
  if (unify(yes, no)) return yes;
  return wrong(node.place, fmt::format("then gives {}, else gives {}", yes.text(), no.text()), "expected one type");
}

Type Checker::selection(const Node& node) { return component_of(node, expression(node.children[0])); }

Type Checker::component_of(const Node& node, const Type& binding) {
  if (binding.is(Type::Kind::unknown)) return binding;
  if (binding.is(Type::Kind::schema)) {
    if (const Type* type = binding.field(node.name)) return *type;
    return wrong(node.place, fmt::format("{} has no component {}", binding.text(), node.name.text()),
                 "expected one of its components");
  }
  return selected_later(node, binding);
}

/// A variable may be found to be a binding or a tuple further on: `e.1 = 5 ∧ e ∈ ℕ × ℕ`.
Type Checker::selected_later(const Node& node, const Type& of) {
  if (of.is(Type::Kind::variable)) {
    const Type part = fresh();
    selections_.push_back({&node, of, part});
    return part;
  }
  const bool tuple = node.kind == Kind::tuple_selection;
  return wrong(node.place, fmt::format("{} has the type {}", named(node.children[0]), of.text()),
               fmt::format("expected a {} before .{}", tuple ? "tuple" : "binding", node.name.text()));
}

/// Tries the selections that were left open, until none is solved any more; those that stay open are reported.
void Checker::solve() {
  for (std::size_t before = selections_.size() + 1; selections_.size() < before;) {
    before = selections_.size();
    const std::vector<Selection> open = std::exchange(selections_, {});
    spend(open.size());
    for (const Selection& selection : open) {
      if (selection.of.is(Type::Kind::variable)) {
        selections_.push_back(selection);
      } else {
        unify_selected(selection);
      }
    }
  }
  for (const Selection& selection : selections_) {
    const bool tuple = selection.node->kind == Kind::tuple_selection;
    error(selection.node->place, fmt::format("{} has the type ?", named(selection.node->children[0])),
          fmt::format("expected a {} before .{}", tuple ? "tuple" : "binding", selection.node->name.text()));
  }
  selections_.clear();
}

void Checker::unify_selected(const Selection& selection) {
  const Node& node = *selection.node;
  const Type part = node.kind == Kind::tuple_selection ? part_of(node, selection.of) : component_of(node, selection.of);
  if (!unify(selection.part, part))
    error(node.place, fmt::format("{} has the type {}", named(Term(std::make_shared<const Node>(node))), part.text()),
          fmt::format("expected {}", selection.part.text()));
}

Type Checker::tuple_selection(const Node& node) { return part_of(node, expression(node.children[0])); }

Type Checker::part_of(const Node& node, const Type& tuple) {
  if (tuple.is(Type::Kind::unknown)) return tuple;
  const std::string& digits = node.name.word;
  if (tuple.is(Type::Kind::product)) {
    const std::size_t position = digits.size() < 9 ? static_cast<std::size_t>(std::stoul(digits)) : 0;
    if (position >= 1 && position <= tuple.parts().size()) return tuple.parts()[position - 1];
    return wrong(node.place, fmt::format("{} has no part {}", tuple.text(), digits),
                 fmt::format("expected 1 to {}", tuple.parts().size()));
  }
  return selected_later(node, tuple);
}

Type Checker::binding_extension(const Node& node) {
  Fields fields;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Type type = expression(node.children[i]);
    for (const auto& [name, other] : fields)
      if (name == node.names[i]) return wrong(node.place, name.text() + " is bound twice", "expected distinct names");
    fields.emplace_back(node.names[i], type);
  }
  return Type::schema(std::move(fields));
}

/// θS' takes each component x of S from x' in scope.
Type Checker::theta(const Node& node) {
  const auto fields = schema_fields(node.children[0], "behind θ");
  if (!fields) return undetermined();
  spend(fields->size());
  for (const auto& [name, type] : *fields) {
    const Name wanted{name.word, name.strokes + node.name.strokes};
    const auto declared = component_in_scope(wanted, node.place);
    if (!declared) {
      error(node.place, wanted.text() + " is not declared", "expected the components of the schema behind θ in scope");
    } else if (!unify(*declared, type)) {
      error(node.place, fmt::format("{} has the type {}", wanted.text(), declared->text()),
            fmt::format("expected {}, as in the schema behind θ", type.text()));
    }
  }
  return Type::schema(*fields);
}

}  // namespace durero::zed
