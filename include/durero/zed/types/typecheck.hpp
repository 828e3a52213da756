#pragma once
/// Z's type system (ISO/IEC 13568, clause 13) resolves every name and gives every expression its type.
///
/// A schema text binds its names in its predicates and behind its •, not in its own declarations. A name with strokes
/// is a name of its own, and no decoration: that of the schema S is `S '`. ΔS and ΞS, declared nowhere, are S with S '.
/// A schema in the place of a predicate needs its components in scope, with their types.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/syntax/toolkit_sections.hpp"
#include "durero/zed/types/types.hpp"

namespace durero::zed {

/// A global is a name that a paragraph declares for the sections that see it.
struct Global {
  /// The form of a declaration.
  enum class Form {
    given,       ///< A of [ A, B ]
    free_type,   ///< T of T ::= a | b ⟪ E ⟫
    branch,      ///< a and b there
    definition,  ///< N of N == E, a schema too
    axiom,       ///< a name of an `axdef` or `gendef` box
    schema,      ///< the name of a `schema` box
    lost         ///< in a paragraph that could not be read; it has any type
  };
  Name name;                  ///< with its strokes; a section that sees two declarations of it is a defect
  Scheme scheme;              ///< its type as an expression: that of a given set A is ℙ A
  Form form = Form::given;    ///< how it is declared
  std::string section, file;  ///< it is declared in this section, which stands in this file
  /// Its name stands here; of a name that an `axdef` includes the box begins here, and of one that is lost its section.
  Place place;
};

/// A typing is the result of type-checking. It keeps no syntax tree alive: type_of() is for the trees that were
/// checked.
struct Typing {
  std::vector<Defect> defects;  ///< errors of names and types; those of reading are in the Specification
  /// Each expression has a type, and each schema expression that stands as a predicate. Relations, the connectives and
  /// quantifiers between predicates, true and false have none.
  std::unordered_map<const Node*, Type> types;
  /// Each section sees these names, among them those of its ancestors and not those of the toolkit.
  std::map<std::string, std::unordered_map<Name, std::shared_ptr<const Global>>> scopes;
  /// Each section sees the names of these sections of the toolkit, which are the prelude and its ancestors among them.
  std::map<std::string, ToolkitSections> toolkit;

  /// Says whether all that was checked is well-typed. What could not be read was not checked.
  bool ok() const { return defects.empty(); }
  /// Returns the type of a term of a tree that was checked; nothing for any other, and for a term without a type
  /// (`types`).
  std::optional<Type> type_of(const Term& term) const;
  /// Returns the global that a section sees under this name at its end; null for a name of the toolkit, a bound one, or
  /// none.
  const Global* find(const std::string& section, const Name& name) const;
};

/// Checks a specification; several defects are reported, in the order of the text. A name of a paragraph that could not
/// be read is taken to have any type.
Typing check(const Specification& specification);

/// Returns the names for an expression that is typed by hand and that no section sees: / and √ of numbers, with which
/// values are printed. They are to be given to check_term among its locals.
std::vector<std::pair<Name, Type>> calculator_names();

/// Says whether the language and its toolkit leave a word free for a name: `s1` is free, and `dom`, `a-b` and `if` are
/// not.
bool is_free_word(const std::string& word);

/// Checks one expression or predicate as if it stood at the end of a section of what was checked, with `locals` in
/// scope. `file` is what its defects name.
Typing check_term(const Typing& known, const std::string& section, const Term& term,
                  const std::vector<std::pair<Name, Type>>& locals = {}, const std::string& file = "expression");

}  // namespace durero::zed
