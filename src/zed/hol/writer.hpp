#pragma once
/// Writes terms of Z as terms of higher-order logic.

#include <map>
#include <set>

#include "durero/zed/hol/hol.hpp"
#include "zed/hol/dialect.hpp"

namespace durero::zed::hol {

/// The components of a schema with their types.
using Components = std::vector<std::pair<Name, Type>>;

/// The names that a term may have, and what each is written as.
using Written = std::map<Name, std::string>;

class HolWriter {
 public:
  HolWriter(const Specification& text, const Typing& typing, ProofAssistant prover);
  /// The text's definitions, then the claims.
  std::string run(const std::vector<NamedClaim>& claims, const std::string& theory);

 private:
  /// Values of applications in a relation, each with what says that it is one.
  using Applied = std::vector<std::pair<std::string, std::string>>;

  // Paragraphs are written in hol.cpp.
  void paragraph(const Section& section, const Paragraph& paragraph);
  void given(const GivenTypes& form);
  void free_type(const FreeType& form);
  void definition(const Section& section, const Definition& form);
  void schema(const Section& section, const Schema& form);
  void axiomatic(const Section& section, const Axiomatic& form);
  void define_schema(const Name& name, const Type& binding, const Term& body);
  const Type& type_of(const Section& section, const Name& name) const;
  bool is_whole(const Term& set) const;

  // Schemas and predicates are written in predicates.cpp.
  std::string predicate(const Term& term, const Written& scope);
  std::string quantified(const Term& term, const Written& scope);
  std::string only_one(const Term& term, const Written& scope);
  std::string relation(const Term& term, const Written& scope);
  std::string related(const Name& name, const Term& a, const Term& b, const Written& scope);
  std::string schema_holds(const Term& schema, const Written& scope);
  std::string called(const Name& name, const Components& components, const std::string& strokes, const Written& scope,
                     Place place);
  std::string unchanged(const Components& components, const Written& scope);
  Components components_of(const Term& schema) const;
  const Components* components_of(const Name& schema) const;
  /// Gives variables to what the text declares; says what its declarations and predicates ask.
  std::vector<std::string> declare(const SchemaText& text, const Written& outer, Written& inner, Binders& variables);
  std::string with(const Applied& applied, const std::string& body) const;

  // Terms are written in terms.cpp.
  std::string term(const Term& term, const Written& scope, Applied& applied);
  std::string reference(const Term& term, const Written& scope, Applied& applied);
  std::string application(const Term& term, const Written& scope, Applied& applied);
  std::string comprehension(const Term& term, const Written& scope);
  std::string extension(const std::vector<Term>& members, const Written& scope, Applied& applied);
  std::string conditional(const Term& term, const Written& scope, Applied& applied);
  std::string tuple(const std::vector<std::string>& parts) const;
  std::string type(const Type& type, Place place) const;
  std::string word(const Name& name, Place place) const;
  std::string variable(const Name& name, const Written& scope, Place place) const;
  std::string fresh() { return "value" + std::to_string(++values_); }

  const Specification& text_;
  const Typing& typing_;
  HolDialect dialect_;
  std::string out_;
  std::map<std::string, Components> schemas_;
  std::map<std::string, std::string> globals_;  // sets, constants and free types' constants, as written
  std::set<std::string> constructors_, given_, words_;
  unsigned values_ = 0, axioms_ = 0;
};

/// Throws ZError for a form that no rule covers.
[[noreturn]] void not_covered(Place place, const std::string& what);

}  // namespace durero::zed::hol
