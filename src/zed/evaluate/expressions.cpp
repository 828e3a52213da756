/// Compiles expressions.

#include <algorithm>

#include "zed/evaluate/compiler.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/evaluate/intensional.hpp"
#include "zed/operators.hpp"
#include "zed/syntax/match.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {

void cannot(const Node& node, const std::string& what) {
  throw EvaluationError(what + ", at line " + std::to_string(node.place.line) + ", column " +
                        std::to_string(node.place.column));
}

// A value that depends on no slot around it is computed once. The compiler owns it: the code of a function may stand
// for a value that holds the function, `dom f` in the definition of f, and neither would ever be freed.
Code Compiler::expression(const Term& term, const Scope& scope) {
  const std::size_t before = reads_.size();
  const unsigned base = scope.unit->next;
  Code code = compiled(term, scope);
  const bool closed = std::none_of(reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end(),
                                   [&](unsigned slot) { return slot < base; });
  if (!closed || (term->kind == Kind::reference && term->children.empty())) return code;
  return Code::once(std::move(code), constants_.emplace_back());
}

Code Compiler::compiled(const Term& term, const Scope& scope) {
  const Node& node = *term;
  switch (node.kind) {
    case Kind::reference:
      return name(node, scope);
    case Kind::number:
      return [value = Value(Real::natural(node.name.word))](Frame&) { return value; };
    case Kind::set_extension:
      return parts(node, scope, Value::set);
    case Kind::tuple:
      return parts(node, scope, Value::tuple);
    case Kind::product:
      return parts(node, scope, product_set);
    case Kind::power:
      return [base = expression(node.children[0], scope)](Frame& frame) { return power_set(base(frame), {}); };
    case Kind::binding_extension:
      return binding_extension(node, scope);
    case Kind::selection:
    case Kind::tuple_selection:
      return selection(node, scope);
    case Kind::theta:
      return theta(node, scope);
    case Kind::application:
      return application(node, scope);
    case Kind::comprehension:
      return comprehension(node, scope);
    case Kind::lambda:
      return lambda(node, scope);
    case Kind::mu:
      return mu(node, scope);
    case Kind::let:
      return let(node, scope);
    case Kind::conditional:
      return conditional(node, scope);
    default:
      return schema_set(term, scope);
  }
}

Code Compiler::parts(const Node& node, const Scope& scope, Value (*make)(std::vector<Value>)) {
  std::vector<Code> codes;
  codes.reserve(node.children.size());
  for (const Term& child : node.children) codes.push_back(expression(child, scope));
  return [codes = std::move(codes), make](Frame& frame) {
    std::vector<Value> values;
    values.reserve(codes.size());
    for (const Code& code : codes) values.push_back(code(frame));
    return make(std::move(values));
  };
}

Code Compiler::binding_extension(const Node& node, const Scope& scope) {
  std::vector<std::pair<Name, Code>> sorted;
  for (std::size_t i = 0; i < node.names.size(); ++i) {
    sorted.emplace_back(node.names[i], expression(node.children[i], scope));
  }
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return [names = signature(node.names), sorted = std::move(sorted)](Frame& frame) {
    std::vector<Value> values;
    for (const auto& [name, code] : sorted) values.push_back(code(frame));
    return Value::binding(names, std::move(values));
  };
}

Code Compiler::selection(const Node& node, const Scope& scope) {
  const Code whole = expression(node.children[0], scope);
  if (node.kind == Kind::tuple_selection) {
    return [whole, position = std::stoul(node.name.word) - 1](Frame& frame) -> Value {
      const HeldValue of(whole, frame);
      const Value& value = *of;
      if (value.is_undefined()) return {};
      if (!value.tuple() || may_be_undefined(value)) return Open{};
      return value.tuple()->parts.at(position);
    };
  }
  struct Last {
    Signature names;
    std::size_t position = 0;
  };
  return [whole, name = node.name, last = std::make_shared<Last>()](Frame& frame) -> Value {
    const HeldValue of(whole, frame);
    const Value& value = *of;
    if (value.is_undefined()) return {};
    const BindingValue* binding = value.binding();
    if (!binding || may_be_undefined(value)) return Open{};
    if (last->names == binding->names) return binding->values[last->position];
    const Value* member = binding->component(name);
    if (!member) throw EvaluationError(value.text() + " has no component " + name.text());
    *last = {binding->names, static_cast<std::size_t>(member - binding->values.data())};
    return *member;
  };
}

namespace {

/// Says whether two values are one: the same number, or shared.
bool identical(const Value& a, const Value& b) {
  if (a.form().index() != b.form().index()) return false;
  return std::visit(
      [&b](const auto& x) {
        using Form = std::decay_t<decltype(x)>;
        if constexpr (requires { x.get(); } || std::is_same_v<Form, Real>)
          return x == *b.get<Form>();
        else
          return false;
      },
      a.form());
}

}  // namespace

void Compiler::remember(const BindingPtr& binding) {
  constexpr std::size_t most = 4;
  if (std::find(bindings_.begin(), bindings_.end(), binding) != bindings_.end()) return;
  if (bindings_.size() == most) bindings_.pop_back();
  bindings_.push_front(binding);
}

Value Compiler::binding_of(const Signature& names, std::vector<Value> values) {
  for (const BindingPtr& known : bindings_)
    if ((known->names == names || *known->names == *names) &&
        std::equal(values.begin(), values.end(), known->values.begin(), known->values.end(), identical))
      return known;
  Value made = Value::binding(names, std::move(values));
  if (const auto* binding = made.get<BindingPtr>()) remember(*binding);
  return made;
}

namespace {

/// Says whether two arguments are one: identical, or tuples of identical parts.
bool same_argument(const Value& a, const Value& b) {
  const TupleValue *s = a.tuple(), *t = b.tuple();
  if (!s || !t) return identical(a, b);
  return s == t || std::equal(s->parts.begin(), s->parts.end(), t->parts.begin(), t->parts.end(), identical);
}

}  // namespace

Value Compiler::applied(const Value& function, const Value& argument, Context& context) {
  constexpr std::size_t most = 64;  // a scene of the tests has ten elements, and each some sets
  for (const Application& known : applications_)
    if (identical(known.function, function) && same_argument(known.argument, argument)) return known.result;
  Value result = apply_value(function, argument, context);
  if (!result.set() || !zed::closed(argument)) return result;
  if (applications_.size() == most) applications_.pop_back();
  applications_.push_front({function, argument, result});
  return result;
}

Code Compiler::theta(const Node& node, const Scope& scope) {
  const Term& schema = node.children[0];
  auto names = components(schema, definitions_);
  if (!names) cannot(node, "θ of what is no schema");
  std::sort(names->begin(), names->end());
  std::vector<Code> codes;
  for (const Name& name : *names) {
    codes.push_back(this->name(*reference(decorated(name, node.name.strokes), {}, node.place), scope));
  }
  std::optional<unsigned> whole;
  if (schema->kind == Kind::reference && schema->children.empty() && node.name.strokes.empty()) {
    for (const Scope* here = &scope; here && !whole; here = here->outer) {
      const auto entry = here->thetas.find(schema->name.text());
      if (entry != here->thetas.end()) whole = entry->second;
      // A scope that names a component anew has another θ.
      if (std::any_of(names->begin(), names->end(), [&](const Name& each) { return here->names.contains(each); }))
        break;
    }
  }
  return [this, names = signature(*names), codes = std::move(codes), whole](Frame& frame) {
    if (whole && !frame.slots[*whole].is_undefined()) return frame.slots[*whole];
    std::vector<Value> values;
    values.reserve(codes.size());
    for (const Code& code : codes) values.push_back(code(frame));
    return binding_of(names, std::move(values));
  };
}

Code Compiler::application(const Node& node, const Scope& scope) {
  const Term &function = node.children[0], &argument = node.children[1];
  const bool named =
      function->kind == Kind::reference && !find(function->name, scope) && !definitions_.find(function->name);
  const OperatorRow* row = named ? operator_row(function->name.text()) : nullptr;
  const bool generic = row && row->binding.role == Role::generic;
  if (row && !generic && row->evaluation.unary) {
    return [compute = row->evaluation.unary, a = expression(argument, scope)](Frame& frame) {
      const Computing value(frame.context);
      return counted(compute, frame.context, *HeldValue(a, frame));
    };
  }
  if (row && row->evaluation.binary && argument->kind == Kind::tuple && argument->children.size() == 2) {
    const Term& through = argument->children[0];
    if (const Term* relation = match::argument_of(through, "_∼"); relation && function->name.word == "_⦇_⦈") {
      return [r = expression(*relation, scope), s = expression(argument->children[1], scope)](Frame& frame) {
        const Computing value(frame.context);
        const HeldValue inverted(r, frame);
        return counted(inverse_image, frame.context, *inverted, *HeldValue(s, frame));
      };
    }
    return [compute = row->evaluation.binary, a = expression(argument->children[0], scope),
            b = expression(argument->children[1], scope)](Frame& frame) {
      const Computing value(frame.context);
      const HeldValue left(a, frame);
      return counted(compute, frame.context, *left, *HeldValue(b, frame));
    };
  }
  const auto gives_sets = std::make_shared<bool>(false);  // what has given no set yet is not looked for among the kept
  return [this, f = expression(function, scope), a = expression(argument, scope), gives_sets](Frame& frame) {
    const Computing value(frame.context);
    frame.context.steps.take();
    const HeldValue left(f, frame), right(a, frame);
    Value result = *gives_sets ? applied(*left, *right, frame.context) : apply_value(*left, *right, frame.context);
    *gives_sets = *gives_sets || result.set();
    return result;
  };
}

Code Compiler::conditional(const Node& node, const Scope& scope) {
  return [condition = predicate(node.children[0], scope), yes = expression(node.children[1], scope),
          no = expression(node.children[2], scope)](Frame& frame) -> Value {
    const Truth here = [&] {
      const Necessary not_here(frame.context, false);
      return evaluate(condition, frame);
    }();
    if (here == Truth::open) return Open{};
    return here == Truth::yes ? yes(frame) : no(frame);
  };
}

}  // namespace durero::zed
