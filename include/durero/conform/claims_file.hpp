#pragma once
/// Files of claims: what a program that anyone ran by hand answered to the rays of a suite. Three formats.
///
/// JSON lines, in any order, one a ray:
///
///   {"case":"generic/0000","ray":0,"outcome":"hit","element":"e0","t":4,"point":[0,0,4]}
///   {"case":"generic/0000","ray":1,"outcome":"miss"}
///
/// A hit has t or point or both; `element` stands where the program knows it. What is no number is the string "nan",
/// "inf" or "-inf". `outcome` may also be `crashed` or `hung`, and `why` may say more of it.
///
/// CSV: a head that names its columns, `case` and `ray`, then any of `outcome`, `element`, `t`, `x`, `y`, `z`; an empty
/// field is none. Without an outcome a line with a t or a point is a hit, another a miss.
///
/// .npy: float64 of shape (n,), the t of every ray of the suite in its order, or (n, 4), t and the point; t = ∞ is a
/// miss.
///
/// A ray without a line is unanswered.

#include <span>
#include <string>
#include <vector>

#include "durero/conform/claim.hpp"
#include "durero/conform/suite.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// The word of an outcome, spelt as its enumerator.
std::string_view name(Claim::Outcome outcome);

/// The claims on the rays of one case, in their order.
using Claims = std::vector<Claim>;

/// Reads a file of any of the three: what starts as .npy does is one, what is named so or `.csv` too, the rest are JSON
/// lines. Answers the claims on each case, in their order. Throws InputError, also on a case, a ray or an element that
/// the suite has not, and on a ray with two claims.
std::vector<Claims> read_claims(const io::Source& source, std::span<const SuiteCase> cases);

/// The claim as a line of JSON, without line end. Precondition: it is no unanswered one.
std::string claim_json(const SuiteCase& of, std::size_t ray, const Claim& claim);

}  // namespace durero::conform
