#pragma once
/// Compiles syntax trees to code: a name is resolved once, to a slot of the frame or to what a paragraph declares.

#include <deque>
#include <map>
#include <memory>
#include <unordered_map>

#include "zed/evaluate/constants.hpp"
#include "zed/evaluate/definitions.hpp"
#include "zed/evaluate/inhabited.hpp"
#include "zed/evaluate/search.hpp"

namespace durero::zed {

struct OperatorRow;
struct RelationOf;

/// A unit is the layout of one frame. It grows while code is compiled for it.
struct Unit {
  unsigned next = 0, size = 0;
};

/// A local name stands for a slot, or for code: a generic formal and a component that a paragraph declares do.
struct Local {
  std::optional<unsigned> slot;
  Code code;
  std::vector<unsigned> reads{};  ///< the code reads these slots
};

struct Scope {
  const Scope* outer = nullptr;
  std::shared_ptr<Unit> unit;
  std::unordered_map<Name, Local> names{};
  /// A binding of a whole schema that is at hand has a slot: the text of S, for `θ S`, leads to it.
  std::map<std::string, unsigned> thetas{};
  /// This is the scope in which the sets of a schema's declarations are resolved, as a text binds its names in its
  /// predicates and not in its own declarations. Null means the scope itself.
  const Scope* declarations = nullptr;

  const Scope& of_declarations() const { return declarations ? *declarations : *this; }
};

/// A group is a part of the characteristic tuple of a schema text: a variable, or the binding of an included schema.
struct TupleComponent {
  unsigned slot = 0;
  Signature names;                   ///< a binding has names; a variable has none
  std::vector<unsigned> components;  ///< each of these names has its slot
};

/// A head is a schema text compiled for a comprehension, a λ, a μ or a quantifier.
struct CompiledSchemaText {
  std::shared_ptr<const Solver> search;
  std::vector<TupleComponent> groups;
};

/// Takes a value apart into its groups' slots.
void assign(Frame& frame, const std::vector<TupleComponent>& groups, const Value& value);
/// Makes the characteristic tuple from the values in the slots.
Value characteristic(const Frame& frame, const std::vector<TupleComponent>& groups);
/// Makes the characteristic tuple with every part unknown.
Value unknown_characteristic(Frame& frame, const CompiledSchemaText& head);

/// These are the values that a let gives its names, each with the slot of its name.
struct LetValues {
  std::vector<std::pair<unsigned, Code>> slots_and_values;
  void give(Frame& frame) const;
};

class Compiler {
 public:
  explicit Compiler(Definitions& definitions) : definitions_(definitions) {}

  Code expression(const Term& term, const Scope& scope);
  Property predicate(const Term& term, const Scope& scope);
  /// Compiles the declarations, then the predicates with their labels.
  Property text(const SchemaText& text, const Scope& scope);
  /// Gives the variables of a schema text slots, named in `inner`. The search sees the conjuncts of `extra` too.
  CompiledSchemaText head(const SchemaText& text, const Scope& scope, Scope& inner, const Term& extra = {});

  /// Makes a scope of the formals of a generic paragraph: each stands for its actual, or else for its whole type.
  Scope formals(const std::vector<Name>& formals, const std::vector<Term>& actuals, const Scope& scope);

  Value global(Meaning& global, Context& context);
  /// Returns the value of a term without local names.
  Value evaluated(const Term& term, Context& context);
  Definitions& definitions() { return definitions_; }
  Constants& constants() { return of_boxes_; }
  /// Makes a binding that stands for θ S, or returns the binding with the same values that was made or remembered
  /// before: that one may already be known to satisfy S.
  Value binding_of(const Signature& names, std::vector<Value> values);
  void remember(const BindingPtr& binding);
  /// Applies the function. The last sets that functions returned are kept, as listing one may take long: to the same
  /// argument a function returns the same set.
  Value applied(const Value& function, const Value& argument, Context& context);

 private:
  // Expressions are compiled in expressions.cpp, names.cpp and binders.cpp.
  Code name(const Node& node, const Scope& scope);
  Code toolkit(const Node& node, const Scope& scope);
  Code set_expression(const Node& node, const OperatorRow& row, const Scope& scope);
  Code application(const Node& node, const Scope& scope);
  Code selection(const Node& node, const Scope& scope);
  Code theta(const Node& node, const Scope& scope);
  Code conditional(const Node& node, const Scope& scope);
  LetValues let_values(const SchemaText& text, const Scope& scope, Scope& inner);
  Code let(const Node& node, const Scope& scope);
  Code parts(const Node& node, const Scope& scope, Value (*make)(std::vector<Value>));
  Code binding_extension(const Node& node, const Scope& scope);
  /// Returns the slots below `base` that were read since `before`, each with its innermost name in the scope.
  std::vector<std::pair<std::string, unsigned>> free_names(std::size_t before, unsigned base, const Scope& scope) const;
  Code comprehension(const Node& node, const Scope& scope);
  Code lambda(const Node& node, const Scope& scope);
  Code mu(const Node& node, const Scope& scope);
  Code schema_set(const Term& term, const Scope& scope);
  Code compiled(const Term& term, const Scope& scope);

  // Predicates and schemas are compiled in predicates.cpp, schemas.cpp and heads.cpp.
  Property relation(const Term& term, const Scope& scope);
  void add_bounds(std::vector<ValueBound>& to, const RelationOf& relation, const Scope& scope) const;
  Property let_predicate(const Term& term, const Scope& scope);
  Property quantified(const Term& term, const Scope& scope);
  std::shared_ptr<const LinearQuestion> linear(const Node& quantifier, const Scope& scope, const Scope& inner);
  Property exists_one(const Node& node, const Scope& scope);
  Test by_numbers(Test test, const Term& same, const Scope& scope);
  Property schema(const Term& term, const Scope& scope);
  Property schema_reference(const Term& term, const Scope& scope);
  Property renamed(const Node& node, const Scope& scope);
  Property projection(const Node& node, const Scope& scope);
  Property schema_definition(const Meaning& global, const Scope& scope);
  Property change(const Name& of, bool unchanged, const Scope& scope);
  Property mapped(const Term& schema, const Scope& scope, const std::vector<std::pair<Name, Name>>& names);
  Property hidden(const Components& names, const Scope& scope, const std::function<Property(const Scope&)>& inside);
  Property joined_schemas(const Node& node, const std::string& stroke, const std::string& to_stroke,
                          const Scope& scope);
  Property declaration(const Declaration& declaration, const Scope& scope);
  Property inclusion(const Declaration& included, unsigned whole, const Scope& scope, const Scope& inner);

  // Paragraphs are compiled in axiomatic.cpp.
  Value axiomatic(Meaning& global, Context& context);
  Value schema_value(const Meaning& global, Context& context);
  Value constructor_arguments(const Meaning& global, Context& context);
  Value free_type(const Meaning& global, Context& context);
  Value generic_instance(const Meaning& global, const std::vector<Term>& actuals, Context& context);
  Code instance_with(const Node& node, const Meaning& global, const Scope& scope);
  Value definition_value(const Meaning& global, Context& context);

  const Local* find(const Name& name, const Scope& scope) const;
  Local component(const Name& name, const Scope& scope);

  Definitions& definitions_;
  Constants of_boxes_{*this};
  std::optional<Inhabited> inhabited_;  // asked for with the first free type
  struct Application {
    Value function, argument, result;
  };
  std::deque<BindingPtr> bindings_;       // the bindings of the last θ; an evaluation has few states at once
  std::deque<Application> applications_;  // the applications that returned a set, the last one first
  std::deque<Value> constants_;           // closed expressions have these values, each computed when first asked for
  std::vector<unsigned> reads_;           // the code that is being compiled reads these slots, in order of compilation
  std::string label_;                     // the definition that is being compiled has this label
  std::string strokes_;                   // the decorations around what is being compiled have these strokes
};

/// Takes slots for a scope, and gives them back at its end.
class Slots {
 public:
  explicit Slots(Unit& unit) : unit_(unit), before_(unit.next) {}
  ~Slots() { unit_.next = before_; }
  Slots(const Slots&) = delete;
  Slots& operator=(const Slots&) = delete;
  static unsigned take(Unit& unit) {
    const unsigned slot = unit.next++;
    if (unit.size < unit.next) unit.size = unit.next;
    return slot;
  }

 private:
  Unit& unit_;
  unsigned before_;
};

/// Computes an operator of the toolkit, and counts the steps that it takes, including the listing of its operands.
template <class Operator, class... Operands>
auto counted(Operator&& compute, Context& context, const Operands&... operands) {
  auto result = compute(operands..., context);
  context.steps.take(1 + (steps_for(operands) + ...));
  return result;
}

/// Throws an EvaluationError that names the place in the text.
[[noreturn]] void cannot(const Node& node, const std::string& what);

}  // namespace durero::zed
