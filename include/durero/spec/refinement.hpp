#pragma once
/// A data refinement of one state by another, as a simulation: which operation carries out which, and what is to be
/// proved so that nobody who uses the operations can tell the concrete state from the abstract one. The obligations are
/// Z, conjectures about the text's own schemas.

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::spec {

/// The names that a refinement is asked for by.
struct RefinementCall {
  std::string abstract, concrete, retrieve;  ///< the state schemas, and the schema that relates them
  /// Operations or initial schemas, `AOP` and `COP`; without one, partners are found by their names.
  std::vector<std::pair<std::string, std::string>> pairs{};
  bool backward = false;  ///< a backward simulation; else a forward one
};

/// The error of a call that names no refinement of the text: `what()` is `what is wrong; what is expected`.
class RefinementError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An operation of the abstract state, and that of the concrete one which carries it out. Both have the same inputs and
/// outputs.
struct OperationPair {
  std::string abstract, concrete;                       ///< the names of the schemas
  std::vector<std::pair<zed::Name, zed::Term>> inputs;  ///< those of both, each with the set of its type
  std::vector<zed::Name> outputs;                       ///< those of both
};

/// A refinement of a text: its parts by the names of their schemas.
struct Refinement {
  std::string abstract, concrete, retrieve;  ///< the states, and the schema that relates them
  std::string abstract_init, concrete_init;  ///< the initial schemas
  bool abstract_primed = true;               ///< whether that of the abstract state is of S ', and not of S
  bool concrete_primed = true;               ///< the same of the concrete state
  std::vector<OperationPair> operations;     ///< in the order of the abstract names
  std::vector<std::string> alone;            ///< operations of either state without a partner
  bool backward = false;                     ///< a backward simulation; else a forward one
};

/// Finds the parts of a refinement. A partner of `Op` is, where it is the only one, the operation that the concrete
/// state's name tells (`Op1` where `S1` refines `S`), or else one whose name begins or ends with `Op`. Throws
/// RefinementError where a name is no such schema, partners differ in their inputs or outputs, or the states share a
/// component. Precondition: `typing` is check(text), and both are without defects.
Refinement refinement_of(const zed::Specification& text, const zed::Typing& typing, const RefinementCall& call);

/// The kinds of obligations.
enum class ObligationKind {
  function,        ///< each concrete state stands for one abstract state
  total,           ///< each concrete state stands for some abstract state
  initialisation,  ///< the concrete state begins as the abstract one may
  applicability,   ///< where the abstract operation may happen, the concrete one may
  correctness      ///< what the concrete operation does, the abstract one allows
};

/// The word of a kind, as it is printed.
std::string obligation_word(ObligationKind kind);

/// An obligation: a conjecture, and what it is of.
struct Obligation {
  ObligationKind kind;    ///< which of its kind
  std::string label;      ///< `SCHEMA.conj.N` of the concrete schema, or of the retrieve schema
  zed::Term claim;        ///< P of ⊢? P
  std::size_t operation;  ///< its place in Refinement::operations; their number where it is of no operation
};

/// The obligations to be proved. Where the retrieve schema gives each concrete state one abstract state, `functional`,
/// the obligations of a forward simulation are simpler, and that it does is the first of them.
std::vector<Obligation> obligations(const Refinement& refinement, bool functional);

/// The obligations as a section of Z, whose parents are the sections of the text: in LaTeX, or else in Unicode.
/// Precondition: the refinement is of the text.
std::string obligations_text(const zed::Specification& text, const Refinement& refinement,
                             const std::vector<Obligation>& all, bool latex);

}  // namespace durero::spec
