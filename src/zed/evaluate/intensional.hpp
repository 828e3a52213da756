#pragma once
/// Sets and functions known by what their members satisfy: comprehensions and λ with their environment.

#include "zed/evaluate/compiler.hpp"

namespace durero::zed {

/// A compiled head and term, and the values of the slots around it.
struct Closure {
  std::shared_ptr<const Unit> unit;
  std::vector<Value> captured;
  Head head;
  Code term;  ///< null for the characteristic tuple
  std::string text;

  Frame frame(Context& context) const;
};

/// The first `count` slots.
std::vector<Value> captured(const Frame& frame, unsigned count);

/// { D | P • E }
Value intensional_set(Closure closure);
/// λ D | P • E
Value lambda_function(Closure closure);

/// A function of an axiomatic description: the first clause whose head its argument satisfies gives the value.
struct Clauses {
  std::vector<Closure> clauses;
  std::optional<Value> domain;  ///< where it is stated
};
/// Compiled when it is first applied, as its clauses may name it.
Value axiomatic_function(std::string name, std::function<Clauses(Context&)> compile);

}  // namespace durero::zed
