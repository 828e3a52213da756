#pragma once
/// What the clauses of a schema say of given values: each clause, and whether it holds.

#include <vector>

#include "durero/contract/contract.hpp"

namespace durero::model {

/// A clause and whether it holds.
struct Judgement {
  const contract::clause* what;  ///< the clause, which lives as long as the program
  bool holds;                    ///< of the values that it was evaluated on
};
/// In the order of the text.
using Judgements = std::vector<Judgement>;

/// Checks every judgement as a contract at this price. `values()` prints what the clauses speak of; it runs only for
/// a broken one.
template <class Values = decltype(contract::no_values)&>
void check(const Judgements& judgements, contract::cost price, Values&& values = contract::no_values) {
  for (const Judgement& judgement : judgements)
    contract::check(
        *judgement.what, [&] { return judgement.holds; }, values, price);
}

/// True when every judgement holds.
bool all_hold(const Judgements& judgements) noexcept;

}  // namespace durero::model
