#pragma once
/// Parses expressions, schema expressions, predicates and schema texts.

#include "durero/zed/syntax/parser.hpp"
#include "zed/syntax/connectives.hpp"
#include "zed/syntax/regrouping.hpp"
#include "zed/syntax/token_stream.hpp"

namespace durero::zed {

class TermParser {
 public:
  /// A `regrouping`, where there is one, is told what ISO's grammar would take for another tree.
  explicit TermParser(TokenStream& in, IsoGrouping* regrouping = nullptr) : in_(in), regrouping_(regrouping) {}

  /// A sort of term: an expression has no relation, but in brackets.
  enum class Sort : unsigned char { any, expression };

  /// Parses a term in which every operator binds at least as tightly as `least`.
  Term term(int least = binding::weakest, Sort sort = Sort::any);

  /// Parses declarations, then predicates behind a `|`, if any, and stops before what cannot belong to it. Where it is
  /// `labelled`, in a box, each predicate keeps its label.
  SchemaText schema_text(bool labelled = false);

  std::vector<Predicate> predicates(bool labelled);
  std::vector<Name> names();  ///< takes a, b, …

  /// Takes the name of an operator as it is declared, `_ below _`, or with names for operands, `X below Y`, which then
  /// are `formals`; nothing where none stands here.
  std::optional<Name> operator_name(std::vector<Name>& formals);

 private:
  /// How a term was made: by an operator, and by one that binds otherwise in ISO's Z.
  struct Making {
    bool by_operator = false, otherwise = false;
  };
  Term leading(Making& made,
               Sort sort);  // takes what can stand first in a term: a quantifier, a prefix operator, an application
  Term size_applied(const Operator& op, Place place);
  void group(const Making& made, bool otherwise, std::size_t from, std::size_t to);
  void bind(Making& left, std::size_t from, std::size_t sign, bool otherwise);
  Connective bound(const Connective& sign) const;  // with the strength of the Z that is read
  Term application();
  Term applied(Term function);  // takes the arguments, and postfix operators behind them
  bool postfix(Term& so_far);   // takes one postfix operator, or iteration
  bool image(Term& so_far);     // takes one relational image
  Term primary();
  Term plain_primary();
  Term word_or_operator();
  Term quantifier(Kind kind, bool value_needed);
  Term let();
  Term conditional();
  Term numeral();
  Term theta();
  Term parenthesis();
  Term braces();
  Term brackets();
  Term sequence();
  Term binding_extension();
  Term infix(const Term& left, int strength, const Operator& op);
  Term relations(const Term& left, std::size_t from);
  Term membership_in_named(const Term& left, Term& right);
  Term product(const Term& left);
  Term hiding(Term left);
  Term enclosing(std::string_view name, Term left);
  Term own_operation(std::vector<Term> operands);  // takes an operator of a template, behind its left operand if any
  Term own_operand(const OperatorTemplate& of, std::size_t part);
  Term own_relation(Term left, Term& right);
  bool suffix(Term& so_far);  // takes one selection, decoration, renaming or list of actuals
  bool holds_schema_text() const;
  Term actuals_or_renaming(Term of);
  bool begins_primary(std::size_t ahead = 0) const;
  bool begins_declaration() const;
  std::size_t operator_ahead(std::size_t ahead, std::vector<Name>* formals) const;
  void refuse_list() const;
  Declaration declaration();
  Term checked(Term term) const;  // refuses a tree that is too deep
  std::vector<Term> terms(std::string_view closing);
  Term sequence_of(std::vector<Term> elements, Place place) const;

  TokenStream& in_;
  IsoGrouping* regrouping_;
  Making last_{};  // of the term that was taken last
  unsigned depth_ = 0;
};

}  // namespace durero::zed
