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
#include "durero/zed/types/types.hpp"

namespace durero::zed {

/// A global is a name that a paragraph declares for the sections that see it.
struct Global {
  enum class Form { given, free_type, branch, definition, axiom, schema, lost };
  Name name;
  Scheme scheme;
  Form form = Form::given;
  std::string section, file;
  Place place;
};

/// A typing is what type-checking found. It keeps no syntax tree alive: type_of() is for the trees that were checked.
struct Typing {
  std::vector<Defect> defects;
  /// Each expression has a type, and each schema expression that stands as a predicate. Relations, the connectives and
  /// quantifiers between predicates, true and false have none.
  std::unordered_map<const Node*, Type> types;
  /// Each section sees these names, among them those of its ancestors and not those of the toolkit.
  std::map<std::string, std::unordered_map<Name, std::shared_ptr<const Global>>> scopes;
  std::map<std::string, bool> sees_toolkit;

  bool ok() const { return defects.empty(); }
  std::optional<Type> type_of(const Term& term) const;
  const Global* find(const std::string& section, const Name& name) const;
};

/// Checks a specification; several defects are reported, in the order of the text. What a paragraph that could not
/// be read would declare is taken to have any type.
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
