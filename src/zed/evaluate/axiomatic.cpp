/// Compiles paragraphs to values. An axiomatic description gives a name a value where one of its predicates is an
/// equation for it: `f(x) = e` under ∀ and its guard, or for some arguments each (cases.hpp), `f = λ …`, `dom f = S`,
/// `c = e`, a linear equation, `f(x) * f(x) = x` for the root, or the laws of a power (powers.hpp).

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/evaluate/cases.hpp"
#include "zed/evaluate/compiler.hpp"
#include "zed/evaluate/free_types.hpp"
#include "zed/evaluate/infinite_by_form.hpp"
#include "zed/evaluate/intensional.hpp"
#include "zed/evaluate/powers.hpp"
#include "zed/operators.hpp"
#include "zed/syntax/match.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

using match::is_equation;

bool is_application(const Term& term, const Name& function) {
  return term->kind == Kind::application && match::is_reference(term->children[0], function);
}

bool mentions(const Term& term, const Name& name) { return match::mentions(term, {name}); }

/// Returns the names that an argument consists of: `x`, `(x, y)`, with `θS` for the schema text's inclusion of S; or
/// nothing.
std::optional<std::vector<Name>> argument_names(const Term& argument) {
  std::vector<Name> names;
  const auto add = [&](const Term& part) {
    if (part->kind == Kind::reference && part->children.empty()) {
      names.push_back(part->name);
    } else if (part->kind == Kind::theta && part->name.strokes.empty()) {
      names.push_back({"θ" + part->children[0]->name.word, part->children[0]->name.strokes});
    } else {
      return false;
    }
    return true;
  };
  if (argument->kind != Kind::tuple) return add(argument) ? std::optional(names) : std::nullopt;
  for (const Term& part : argument->children) {
    if (!add(part)) return std::nullopt;
  }
  return names;
}

/// Returns the groups of the head in the order in which the argument names them, each once; nothing where it does not.
std::optional<std::vector<TupleComponent>> in_order(const std::vector<Name>& names, const CompiledSchemaText& head,
                                                    const Scope& scope) {
  std::vector<TupleComponent> groups;
  for (const Name& name : names) {
    std::optional<unsigned> slot;
    if (const auto entry = scope.names.find(name); entry != scope.names.end()) slot = entry->second.slot;
    if (name.word.starts_with("θ")) {
      const auto at = scope.thetas.find(name.text().substr(std::string("θ").size()));
      if (at != scope.thetas.end()) slot = at->second;
    }
    const auto group = std::find_if(head.groups.begin(), head.groups.end(),
                                    [&](const TupleComponent& candidate) { return slot && candidate.slot == *slot; });
    if (group == head.groups.end()) return std::nullopt;
    groups.push_back(*group);
  }
  return groups.size() == head.groups.size() ? std::optional(groups) : std::nullopt;
}

/// The formals of a generic box, and their actuals where it is referred to with these. In the box, the name alone is
/// then the same instance.
struct GenericInstance {
  std::vector<Name> formals;
  std::vector<Term> actuals{};
  const Value* itself = nullptr;
};

/// Returns the scope in which the box is compiled: a formal without an actual is a whole type.
Scope scope_of(Compiler& compiler, GenericInstance instance, const Name& name, const std::shared_ptr<Unit>& unit) {
  instance.formals.push_back(any_value);
  Scope scope = compiler.formals(instance.formals, instance.actuals, Scope{.unit = unit});
  if (const Value* itself = instance.itself) scope.names[name] = {{}, [itself](Frame&) { return *itself; }};
  return scope;
}

/// Returns the equation for f in `body` as a clause under the head of `forall`; nothing where it has another form.
std::optional<Closure> clause(Compiler& compiler, const Name& function, const GenericInstance& instance,
                              const Node& forall) {
  const Term& body = forall.children[0];
  if (!is_equation(body)) return std::nullopt;
  const Term &left = body->children[0], &right = body->children[1];
  const Node* factors = match::operands(left, "_*_");
  const bool squared = factors && factors->children[0] == factors->children[1];
  const Term& applied = squared ? factors->children[0] : left;
  if (!is_application(applied, function)) return std::nullopt;
  if (squared && applied->children[1] != right) return std::nullopt;
  const auto names = argument_names(applied->children[1]);
  if (!names) return std::nullopt;
  const auto unit = std::make_shared<Unit>();
  const Scope outside = scope_of(compiler, instance, function, unit);
  Scope inner{.outer = &outside, .unit = unit};
  CompiledSchemaText head = compiler.head(*forall.text, outside, inner);
  const auto groups = in_order(*names, head, inner);
  if (!groups) return std::nullopt;
  head.groups = *groups;
  Code value = compiler.expression(right, inner);
  if (squared) value = [of = std::move(value)](Frame& frame) { return functions::root(of(frame), frame.context); };
  return Closure{unit, {}, std::move(head), std::move(value), std::make_shared<const Node>(forall)};
}

/// Returns the clause of a function whose box states the laws of a power.
Closure power_clause(Compiler& compiler, const Name& name, const Axiomatic& form) {
  Closure closure = clause(compiler, name, GenericInstance{}, *power_head(name, form)).value();
  closure.term = [arguments = std::move(closure.term)](Frame& frame) {
    const Value of = arguments(frame);
    return functions::power(first(of), second(of), frame.context);
  };
  return closure;
}

std::optional<Value> stated_domain(Compiler& compiler, const Name& function, const Axiomatic& form, Context& context) {
  for (const Predicate& predicate : form.text.predicates) {
    if (!is_equation(predicate.term)) continue;
    const Term* of = match::argument_of(predicate.term->children[0], "dom");
    if (of && match::is_reference(*of, function)) {
      return compiler.evaluated(predicate.term->children[1], context);
    }
  }
  return std::nullopt;
}

/// Says whether the box has an equation for applications of a function, or for the square of one.
bool defines_function(const Name& name, const Axiomatic& form) {
  const bool squared =
      std::any_of(form.text.predicates.begin(), form.text.predicates.end(), [&](const Predicate& each) {
        if (each.term->kind != Kind::forall || !is_equation(each.term->children[0])) return false;
        const Term& left = each.term->children[0]->children[0];
        return left->kind == Kind::application && mentions(left, name);
      });
  return squared || !cases_of_function(form.text.predicates, name).clauses.empty();
}

void add_clauses(Clauses& to, Compiler& compiler, const Name& name, const GenericInstance& instance,
                 const Cases& cases) {
  to.all_said = to.all_said && cases.all_said;
  for (const Term& each : cases.clauses) {
    auto compiled = clause(compiler, name, instance, *each);
    to.all_said = to.all_said && compiled;
    if (compiled) to.clauses.push_back(std::move(*compiled));
  }
}

/// Returns the clauses of a function in the predicates of the box, in their order.
Clauses function_clauses(Compiler& compiler, const Name& name, const Axiomatic& form, const GenericInstance& instance) {
  Clauses clauses;
  for (const Predicate& predicate : form.text.predicates) {
    auto equation =
        predicate.term->kind == Kind::forall ? clause(compiler, name, instance, *predicate.term) : std::nullopt;
    if (equation)
      clauses.clauses.push_back(std::move(*equation));
    else
      add_clauses(clauses, compiler, name, instance, cases_of_function({predicate}, name));
  }
  return clauses;
}

/// Returns the λ of an equation f = λ D | P • E, or null.
const Term* stated_lambda(const Name& name, const Axiomatic& form) {
  for (const Predicate& predicate : form.text.predicates)
    if (is_equation(predicate.term) && match::is_reference(predicate.term->children[0], name) &&
        predicate.term->children[1]->kind == Kind::lambda)
      return &predicate.term->children[1];
  return nullptr;
}

/// Returns the set S of a function that is declared from S → T, or from another set of total functions.
std::optional<Value> source(Compiler& compiler, const Name& name, const Axiomatic& form, Context& context) {
  const Term* set = declared_set(name, form);
  if (!set || (*set)->kind != Kind::reference || (*set)->children.size() != 2) return std::nullopt;
  const OperatorRow* row = operator_row((*set)->name.word);
  if (!row || !row->arrow || !row->arrow->function || !row->arrow->total) return std::nullopt;
  return compiler.evaluated((*set)->children[0], context);
}

}  // namespace

const Term* declared_set(const Name& name, const Axiomatic& form) {
  for (const Declaration& declaration : form.text.declarations) {
    if (std::find(declaration.names.begin(), declaration.names.end(), name) != declaration.names.end())
      return &declaration.term;
  }
  return nullptr;
}

const Term* other_side(const Term& equation, const Name& name) {
  if (!is_equation(equation)) return nullptr;
  for (const std::size_t side : {0U, 1U}) {
    const Term& other = equation->children[1 - side];
    if (match::is_reference(equation->children[side], name) && !mentions(other, name)) return &other;
  }
  return nullptr;
}

bool is_by_cases(const Name& name, const Axiomatic& form) {
  const auto& predicates = form.text.predicates;
  const auto gives_all = [&](const Predicate& each) {
    const Term* whole = other_side(each.term, name);
    return whole && (*whole)->kind != Kind::lambda;
  };
  if (std::any_of(predicates.begin(), predicates.end(), gives_all)) return false;
  return states_power(name, form) || defines_function(name, form) || stated_lambda(name, form) ||
         !cases_of_set(predicates, name).clauses.empty();
}

Value Compiler::evaluated(const Term& term, Context& context) {
  const auto unit = std::make_shared<Unit>();
  const Scope scope{.unit = unit};
  const Code code = expression(term, scope);
  Frame frame(unit->size, context);
  return code(frame);
}

Value Compiler::axiomatic(Meaning& global, Context& context) {
  const auto& form = std::get<Axiomatic>(global.paragraph->form);
  const Name& name = global.name;
  if (name.text() == "ℝ") return reals("ℝ");  // the axioms of the reals are assumed, not evaluated
  if (form.formals.empty() && !is_by_cases(name, form)) return of_boxes_.value(global, context);
  if (states_power(name, form)) {
    return axiomatic_function(name.text(), [this, &form, name](Context&) {
      Clauses clauses;
      clauses.clauses.push_back(power_clause(*this, name, form));
      return clauses;
    });
  }
  if (defines_function(name, form)) {
    return axiomatic_function(name.text(), [this, &form, name](Context& inside) {
      Clauses clauses = function_clauses(*this, name, form, {form.formals});
      clauses.domain = stated_domain(*this, name, form, inside);
      if (form.formals.empty()) clauses.source = source(*this, name, form, inside);
      return clauses;
    });
  }
  if (const Term* lambda = stated_lambda(name, form)) return evaluated(*lambda, context);
  if (!cases_of_set(form.text.predicates, name).clauses.empty())
    return axiomatic_set(name.text(), [this, &form, name](Context&) {
      Clauses clauses;
      add_clauses(clauses, *this, name, {form.formals}, cases_of_set(form.text.predicates, name));
      return clauses;
    });
  throw LackingEvaluation(Lack::instance, name.text() + " is generic, and no function: it is not evaluated");
}

// The actuals are terms without local names. An instance by clauses may name itself, and the compiler owns it.
Value Compiler::generic_instance(const Meaning& global, const std::vector<Term>& actuals, Context& context) {
  const auto& form = std::get<Axiomatic>(global.paragraph->form);
  const Name& name = global.name;
  Value& kept = constants_.emplace_back();
  const GenericInstance instance{form.formals, actuals, &kept};
  const auto& predicates = form.text.predicates;
  const auto whole = [&](const Term& term) {
    const auto unit = std::make_shared<Unit>();
    const Scope scope = scope_of(*this, instance, name, unit);
    const Code code = expression(term, scope);
    Frame frame(unit->size, context);
    return code(frame);
  };
  for (const Predicate& each : predicates)
    if (const Term* term = other_side(each.term, name)) return kept = whole(*term);
  if (defines_function(name, form))
    return kept = axiomatic_function(name.text(), [this, &form, name, instance](Context&) {
             Clauses clauses = function_clauses(*this, name, form, instance);
             clauses.all_said = false;  // the sets of its declaration may say more
             return clauses;
           });
  if (!cases_of_set(predicates, name).clauses.empty())
    return kept = axiomatic_set(name.text(), [this, &form, name, instance](Context&) {
             Clauses clauses;
             add_clauses(clauses, *this, name, instance, cases_of_set(form.text.predicates, name));
             return clauses;
           });
  throw LackingEvaluation(Lack::instance, name.text() + " is generic, and no function: it is not evaluated");
}

Value Compiler::schema_value(const Meaning& global, Context& context) {
  const auto unit = std::make_shared<Unit>();
  const Scope scope{.unit = unit};
  const Code code = schema_set(reference(global.name), scope);
  Frame frame(unit->size, context);
  return code(frame);
}

// The definition is compiled without actuals: the formals of a generic one are whole types.
Value Compiler::definition_value(const Meaning& global, Context& context) {
  const auto& definition = std::get<Definition>(global.paragraph->form);
  const auto unit = std::make_shared<Unit>();
  const Scope outside{.unit = unit};
  const Scope scope = formals(definition.formals, {}, outside);
  const Code code = expression(definition.value, scope);
  Frame frame(unit->size, context);
  return code(frame);
}

namespace {

const std::string branch_type(const Meaning& global) { return std::get<FreeType>(global.paragraph->form).name.text(); }

const Branch& branch(const Meaning& global) {
  const auto& branches = std::get<FreeType>(global.paragraph->form).branches;
  return *std::find_if(branches.begin(), branches.end(),
                       [&](const Branch& branch) { return branch.name == global.name; });
}

/// Marks for a scope that the value of a name is being computed.
class Busy {
 public:
  explicit Busy(Meaning& global) : global_(global) {
    if (global.busy) throw LackingEvaluation(Lack::ground, global.name.text() + " is defined by itself");
    global.busy = true;
  }
  ~Busy() { global_.busy = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  Meaning& global_;
};

}  // namespace

Value Compiler::constructor_arguments(const Meaning& global, Context& context) {
  return evaluated(branch(global).argument, context);
}

/// Returns the values of a free type: a finite set where its constructors have finitely many arguments.
Value Compiler::free_type(const Meaning& global, Context& context) {
  if (!inhabited_) inhabited_ = inhabited_free_types(definitions_);
  std::vector<FreeBranch> branches;
  std::uint32_t order = 0;
  for (const Branch& each : std::get<FreeType>(global.paragraph->form).branches) {
    const std::uint32_t place = order++;
    if (each.argument && has_member(each.argument, definitions_, *inhabited_) == Truth::no) continue;
    branches.push_back({Value::atom(global.name.text(), each.name.text(), place), {}});
    if (each.argument)
      branches.back().arguments = [this, argument = each.argument](Context& inside) {
        return evaluated(argument, inside);
      };
  }
  const FreeTypeForm form{inhabited_->at(global.name) == Truth::yes,
                          is_infinite_by_form(reference(global.name), definitions_, *inhabited_)};
  return free_type_set(global.name.text(), std::move(branches), form, context);
}

Value Compiler::global(Meaning& global, Context& context) {
  if (global.value) return *global.value;
  const Busy busy(global);
  Context apart(context.steps);  // its value depends on no unknown
  apart.depth = context.depth;
  switch (global.kind) {
    case Meaning::Kind::given:
      global.value = given_set(global.name.text());
      break;
    case Meaning::Kind::free_type:
      global.value = free_type(global, apart);
      break;
    case Meaning::Kind::constant:
      global.value = Value::atom(branch_type(global), global.name.text(), global.order);
      break;
    case Meaning::Kind::constructor:
      global.value = constructor_function(branch_type(global), global.name.text(), global.order,
                                          constructor_arguments(global, apart));
      break;
    case Meaning::Kind::axiomatic:
      global.value = axiomatic(global, apart);
      break;
    case Meaning::Kind::definition:
      global.value = components(reference(global.name), definitions_) ? schema_value(global, apart)
                                                                      : definition_value(global, apart);
      break;
    case Meaning::Kind::schema:
      global.value = schema_value(global, apart);
      break;
  }
  return *global.value;
}

}  // namespace durero::zed
