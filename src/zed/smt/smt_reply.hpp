#pragma once
/// The reply to a script is read: whether the solver found values, and which.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/zed/value/real.hpp"

namespace durero::zed {

/// A parenthesised list of SMT-LIB, or one word of it.
struct SmtList {
  std::string word{};            ///< a list has none
  std::vector<SmtList> items{};  ///< a word has none
};

/// The kinds of replies. `garbled` is a reply that says none of the three.
struct SmtVerdict {
  enum class Answer : std::uint8_t { sat, unsat, unknown, garbled };
  Answer answer = Answer::garbled;
  std::map<std::string, SmtList> values{};  ///< by the symbol
};

/// Reads a reply to (check-sat) and (get-value …).
SmtVerdict read_reply(const std::string& output);
/// Returns the number that a term is, or nothing: a rational, or the root of a polynomial of degree two.
std::optional<Real> number_of(const SmtList& term);

}  // namespace durero::zed
