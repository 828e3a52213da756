#pragma once
/// The variables of a term whose values cannot be gone through.

#include "durero/spec/refusal.hpp"
#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::spec {

/// The names that a section of a text sees.
struct SeenNames {
  const zed::Typing& text;
  const std::string section;
};

/// The error of a term that is open: which of its variables range over sets that are not finite, and what would bound
/// them. `typing` has the types of the term.
OpenVariables open_variables(const zed::Term& term, const zed::Typing& typing, const SeenNames& seen,
                             const zed::Evaluator& evaluator);

}  // namespace durero::spec
