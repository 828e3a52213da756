#pragma once
/// Writes a Z text with claims about it in higher-order logic, as Coq and Isabelle/HOL have it. A schema is a predicate
/// on its components, a function its set of pairs, and an application outside the domain makes the relation false in
/// which it stands. Numbers are integers. Nothing is proved there: a claim is a definition of type Prop, or bool.

#include <string>
#include <vector>

#include "durero/zed/coq/coq.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::zed {

/// The languages.
enum class ProofAssistant : unsigned char { coq, isabelle };

/// A predicate about a text, and the name of its definition.
struct NamedClaim {
  std::string name;  ///< letters, digits and _
  Term claim;        ///< its schemas are the text's
};

/// Returns the text's definitions and the claims as one file, which ends in a line end; the text's own conjectures are
/// left out. The name is that of Isabelle's theory. Throws ExportError where something has a form that no rule covers.
/// Precondition: `typing` is check(text), and both are without defects.
std::string to_hol(const Specification& text, const Typing& typing, const std::vector<NamedClaim>& claims,
                   ProofAssistant prover, const std::string& name);

}  // namespace durero::zed
