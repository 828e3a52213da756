#pragma once
/// Writes a Z text as Coq: one source for the program and for the proofs. The rules of the translation stand at the
/// head of what is written.

#include <stdexcept>
#include <string>

#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::zed {

/// Returns the text as a file of Coq, which ends in a line end. Throws ExportError where a paragraph has a form that no
/// rule covers. Precondition: `typing` is check(specification), and both are without defects.
std::string to_coq(const Specification& specification, const Typing& typing);

/// The error of a paragraph that no rule covers: `what()` is `FILE:LINE:COLUMN: what is wrong; what is expected`.
class ExportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace durero::zed
