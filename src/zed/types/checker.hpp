#pragma once
/// The type-checker checks expressions in checker_terms.cpp, predicates, names and schemas in the files of these names,
/// schemas whose components are told later in checker_passes.cpp, and paragraphs and sections in typecheck.cpp.

#include <fmt/core.h>

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "durero/zed/types/typecheck.hpp"
#include "zed/types/known_names.hpp"
#include "zed/types/toolkit.hpp"

namespace durero::zed {

/// The fields of a signature stand in the order of declaration.
using Fields = std::vector<std::pair<Name, Type>>;

/// The table holds a signature that grows, or a scope, and where each name stands in it.
struct FieldTable {
  Fields fields;
  std::unordered_map<Name, std::size_t> positions{};
  bool is_open = false;  ///< a schema is included whose components are not known yet: it may declare any name

  /// Returns the type of a name, or null.
  const Type* find(const Name& name) const {
    const auto at = positions.find(name);
    return at == positions.end() ? nullptr : &fields[at->second].second;
  }
};

/// These limit what one section may ask for, so that no text makes the checker hang or run out of stack: the longest
/// section of spec/ takes 10^4 steps, its largest paragraph 200 variables. Freeing a type recurses once for each
/// variable in a chain of them.
inline constexpr std::size_t max_work = 20000000, max_variables = 4000, max_errors = 1000;

class Checker {
 public:
  using Globals = std::unordered_map<Name, std::shared_ptr<const Global>>;

  Checker(std::string file, Globals& globals, ToolkitSections toolkit, Typing& into)
      : file_(std::move(file)), globals_(globals), toolkit_(toolkit), into_(into) {}

  // Checks a term as an expression, and returns its type, or as a predicate.
  Type expression(const Term& term);
  void predicate(const Term& term);

  // Opens a scope with these names, or closes the innermost one and returns it.
  void push(Fields fields);
  void push(FieldTable table) { scopes_.push_back(std::move(table)); }
  FieldTable pop();

  /// Checks a part of the text, again and again while a pass tells the components of a schema that the pass before it
  /// did not know; and a last time, which reports those that nothing tells.
  template <class Check>
  void in_passes(Check&& check) {
    Pass pass{};
    do {
      pass = begin_pass();
      check();
      solve();
    } while (!is_last(pass));
  }

  /// Returns what the declarations of a schema text declare; its predicates are left to predicates().
  FieldTable signature(const SchemaText& text);
  void predicates(const SchemaText& text);

  void error(Place place, std::string what, std::string expected);
  Type wrong(Place place, std::string what, std::string expected);

  /// Refuses what the paragraph has left undetermined, unless it has errors already.
  /// Takes what is checked for a term without a text around it: an empty sequence that nothing gives a type is one of
  /// numbers then.
  void take_alone() { alone_ = true; }
  void finish_paragraph();

  /// Determines what the types of bindings and tuples were not known for; to be called before a paragraph declares.
  void solve();

 private:
  enum class Mode { value, truth };

  Type infer(const Node& node);
  Type reference(const Node& node);
  std::string expected_name(const Name& name) const;
  std::string nearest_name(const Name& name) const;
  std::string expected_parent(const Name& name) const;
  const KnownNames& global_names() const;
  std::optional<Type> lookup(const Name& name, const std::vector<Type>* actuals, Place place);
  std::optional<Type> component_in_scope(const Name& name, Place place);
  Type instance(const Name& name, const Scheme& scheme, const std::vector<Type>* actuals, Place place);
  std::optional<Type> implied_schema(const Name& name, const std::vector<Type>* actuals, Place place);
  std::vector<Type> actuals(const Node& node);
  Type set_extension(const Node& node);
  Type application(const Node& node);
  Type quantified(const Node& node);
  Type conditional(const Node& node);
  Type selection(const Node& node);
  Type component_of(const Node& node, const Type& binding);
  Type tuple_selection(const Node& node);
  Type part_of(const Node& node, const Type& tuple);
  Type selected_later(const Node& node, const Type& of);
  Type binding_extension(const Node& node);
  Type theta(const Node& node);
  Type let(const Node& node, Mode mode);
  void relation(const Node& node);
  void relate(const Name& relation, const Node& left, const Type& a, const Node& right, const Type& b);
  void schema_predicate(const Node& node, const Type& type);

  /// A pass begins with so many defects and generic instances.
  struct Pass {
    std::size_t defects, generics;
  };
  Pass begin_pass() const { return {into_.defects.size(), generics_.size()}; }
  bool is_last(const Pass& pass);
  bool awaits(const Node& node, const Type& type);
  /// Returns the type of an expression, or of a set of bindings, of which no more is known: one to be determined, where
  /// the components of some schema are awaited; else unknown, as an error was reported.
  Type undetermined() { return awaited_.empty() ? Type::unknown() : fresh(); }
  Type undetermined_schema() { return awaited_.empty() ? Type::unknown() : Type::power(fresh()); }

  Type schema_expression(const Node& node);
  Type schema_of_text(const SchemaText& text);
  Type schema_quantifier(const Node& node);
  Type renaming(const Node& node);
  Type hiding(const Node& node);
  Type joined(const Node& node, const char* what, const std::string& left_stroke, const std::string& right_stroke);
  Type precondition(const Node& node);
  Type doubled(const Type& schema, Place place);
  std::optional<Fields> schema_fields(const Term& term, const char* role);
  /// Adds fields, or one, to those of the table; a name in both must have one type.
  void merge(FieldTable& table, const Fields& more, Place place, const char* what);
  void merge(FieldTable& table, const Name& name, const Type& type, Place place, const char* what);
  /// Returns both signatures as one.
  Fields merged(const Fields& left, const Fields& right, Place place);
  Type schema_set(Fields fields) { return limited(Type::power(Type::schema(std::move(fields)))); }

  /// Returns X and Y where a type is that of a relation, ℙ (X × Y), or may be; nothing where it is another.
  std::optional<std::pair<Type, Type>> sides_of(const Type& type);
  /// Returns the type of the elements of a set expression.
  Type element(const Term& set, const char* role);
  /// Returns the type of the characteristic tuple of a schema text (ISO/IEC 13568, 9.2), of which the scope is open.
  Type characteristic(const SchemaText& text);
  /// Returns the type; where it is too large it reports an error and returns unknown.
  Type limited(Type type);

  /// Makes a new variable that unification is to determine.
  Type fresh();
  /// Counts work; past the limit the section cannot be checked to its end, and a ZError says so.
  void spend(std::size_t steps);

  /// A selection waits for the type that it selects from.
  struct Selection {
    const Node* node;
    Type of, part;
  };
  void unify_selected(const Selection& selection);

  std::string file_;
  Globals& globals_;
  mutable std::optional<KnownNames> global_names_;  // those of so many globals, once a message has asked for them
  mutable std::size_t global_names_of_ = 0;
  ToolkitSections toolkit_;  // that are seen
  Typing& into_;
  std::vector<FieldTable> scopes_;
  std::vector<std::pair<Name, std::pair<Place, Type>>> generics_;  // these instances are to be determined
  std::vector<Selection> selections_;
  std::vector<std::pair<const Node*, Type>> awaited_;  // schemas of this pass whose components are not known yet
  std::unordered_map<const Node*, Type> told_;         // and the types of schemas that passes before it told
  bool is_strict_ = false;                             // nothing more is told: a schema without components is an error
  bool alone_ = false;                                 // the term is no part of a text
  Place at_;                                           // the node being checked stands here
  std::size_t errors_before_ = 0, errors_at_start_ = into_.defects.size();
  std::size_t work_ = 0, variables_ = 0;
};

}  // namespace durero::zed
