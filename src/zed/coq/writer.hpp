#pragma once
/// The writer puts the paragraphs of a Z text as Coq, for coq/coq.cpp.

#include <string>

#include "durero/zed/syntax/reader.hpp"
#include "zed/coq/terms.hpp"

namespace durero::zed::coq {

/// These are the names that an axiomatic box declares, and their sets.
using Declarations = std::map<Name, Term>;

class CoqWriter {
 public:
  CoqWriter(const Specification& specification, const Typing& typing);
  std::string take() { return std::move(out_); }

 private:
  void section(const Section& section);
  void paragraph(const Paragraph& paragraph);
  void given(const GivenTypes& form);
  void free_type(const FreeType& form);
  void definition(const Definition& form);
  void axiomatic(const Axiomatic& form, Place place);
  void schema(const Schema& form);
  void conjecture(const Conjecture& form);

  void set_definition(const Definition& form);
  void lambda_definition(const Definition& form);
  void operation_definition(const Definition& form);
  void value_definition(const Definition& form);

  using Fields = std::vector<std::pair<std::string, std::string>>;  // each has its label
  void data(const Schema& form);
  void state_relations(const std::string& name, const Schema& form);
  void operation(const Schema& form);
  void conditions(const std::string& name, const SchemaText& text, const CoqScope& scope, Fields& to);
  void record(const std::string& head, const Fields& fields);

  void declare_axiom(const Declaration& declaration);
  bool explicit_definition(const Predicate& predicate, const Declarations& declared);
  bool partial_definition(const Predicate& conjunct, const Declarations& declared, const Predicate& domain);
  void implicit_definition(const Name& name, const Term& set, const std::vector<const Predicate*>& stated);

  /// Writes a sentence, broken into lines, with the label in a comment behind it.
  void sentence(const std::string& text, const std::string& label = {}, const std::string& indent = "");

  Translator in_;
  std::string out_;
};

}  // namespace durero::zed::coq
