#pragma once
/// An intensional set or function is known by what its members satisfy: a comprehension or λ with its environment.

#include "zed/evaluate/compiler.hpp"

namespace durero::zed {

/// A closure is a compiled head and term, with the values that the slots around them had.
struct Closure {
  std::shared_ptr<const Unit> unit;
  std::vector<Value> captured;
  CompiledSchemaText head;
  Code term;                            ///< it is null where the characteristic tuple is the value
  std::shared_ptr<const Node> written;  ///< as the text has it
  /// The slots around it that it reads, each with the name by which the text knows it.
  std::vector<std::pair<std::string, unsigned>> free{};

  Frame frame(Context& context) const;
  /// Says whether nothing that it reads depends on an unknown.
  bool closed() const;
  /// Writes the text; in a closed wording behind a `let` with the values of its free names.
  std::string spelled(Set::Wording wording) const;
};

/// Copies the first `count` slots.
std::vector<Value> captured(const Frame& frame, unsigned count);

/// Makes the set { D | P • E }, which counts its steps where it is asked without a context.
Value intensional_set(Closure closure, Steps& steps);
/// Makes the function λ D | P • E, which counts its steps likewise.
Value lambda_function(Closure closure, Steps& steps);

/// The clauses that an axiomatic box states of a function: the first one whose head the argument satisfies gives its
/// value.
struct Clauses {
  std::vector<Closure> clauses;
  std::optional<Value> domain;  ///< the box may state it
  std::optional<Value> source;  ///< of a total function, the set that it is declared from
  bool all_said = true;         ///< these clauses are all that the box says of it
};
/// Makes a function that is compiled when it is first applied, as its clauses may name it.
Value axiomatic_function(std::string name, std::function<Clauses(Context&)> compile);
/// Makes a set whose clauses have the value 1 for members, and else 0.
Value axiomatic_set(std::string name, std::function<Clauses(Context&)> compile);

}  // namespace durero::zed
