#pragma once
/// The signs that Coq and Isabelle write in two ways: connectives, binders, types and definitions.

#include <string>
#include <utility>
#include <vector>

#include "durero/zed/hol/hol.hpp"

namespace durero::zed::hol {

/// Variables with their types; a type may be empty, and is then inferred.
using Binders = std::vector<std::pair<std::string, std::string>>;

/// Writes terms in one of the languages, each in parentheses.
struct HolDialect {
  ProofAssistant prover;

  std::string all(const Binders& variables, const std::string& body) const;
  std::string some(const Binders& variables, const std::string& body) const;
  std::string function(const std::string& variable, const std::string& body) const;
  std::string all_of(const std::vector<std::string>& parts) const;
  std::string any_of(const std::string& a, const std::string& b) const;
  std::string implied(const std::string& a, const std::string& b) const;
  std::string equivalent(const std::string& a, const std::string& b) const;
  std::string denied(const std::string& a) const;

  std::string set_of(const std::string& type) const;
  std::string pair_of(const std::vector<std::string>& types) const;
  std::string integers() const { return prover == ProofAssistant::coq ? "Z" : "int"; }
  std::string truth() const { return prover == ProofAssistant::coq ? "True" : "True"; }
  std::string whole(const std::string& type) const;

  /// A predicate or a value, with arguments.
  std::string definition(const std::string& name, const Binders& arguments, const std::string& type,
                         const std::string& body) const;
  std::string given(const std::string& name) const;
  /// A free type: each branch with the type of its argument, or none.
  std::string free_type(const std::string& name, const Binders& branches) const;
  std::string constant(const std::string& name, const std::string& type) const;
  std::string axiom(const std::string& name, const std::string& body) const;
  std::string comment(const std::string& text) const;
  /// The lines before and behind the definitions.
  std::string head(const std::string& theory) const;
  std::string tail() const;

 private:
  std::string bound(const char* coq, const char* isabelle, const Binders& variables, const std::string& body) const;
};

}  // namespace durero::zed::hol
