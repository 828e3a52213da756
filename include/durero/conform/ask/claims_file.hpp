#pragma once
/// A file of claims holds a program's answers to the rays of a suite, for programs that somebody runs by hand. There
/// are three formats.
///
/// JSON lines, one for each ray, in any order:
///
///   {"case":"generic/0000","ray":0,"outcome":"hit","element":"e0","t":4,"point":[0,0,4]}
///   {"case":"generic/0000","ray":1,"outcome":"miss"}
///
/// A hit has t or point or both; `element` stands where the program knows it, and so do `normal`, `face` (front or
/// back) and `uv`, two numbers. A number that is not finite is the string "nan", "inf" or "-inf". `outcome` may also be
/// `crashed` or `hung`, and `why` may give the reason. Where all hits were asked for, `hits` lists them in the place of
/// element, t and point; where their number was, `count` gives it.
///
/// CSV: a head names the columns, `case` and `ray`, then any of `outcome`, `element`, `t`, `x`, `y`, `z`; an empty
/// field is absent. Without an outcome a line with a t or a point is a hit, and any other line a miss.
///
/// .npy: float64 of shape (n,), the t of every ray of the suite in its order, or (n, 4), t and the point; t = ∞ is a
/// miss.
///
/// A ray without a line is unanswered. Of a user's own rays there is one case, which no line need name.

#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// The word of an outcome, spelt as its enumerator.
std::string_view name(Claim::Outcome outcome);

/// The claims on the rays of one case, in their order.
using Claims = std::vector<Claim>;

/// Reads a file of any of the three formats: a file that starts as .npy does or has that ending is .npy, a file named
/// `.csv` is CSV, and any other is JSON lines. Returns the claims on each case, in the order of the cases and their
/// rays. Throws InputError, also on a case, a ray or an element that the suite has not, and on a ray with two claims.
std::vector<Claims> read_claims(const io::Source& source, std::span<const SuiteCase> cases);

/// The claim as a line of JSON, without line end. Precondition: the claim is not unanswered.
std::string claim_json(const SuiteCase& of, std::size_t ray, const Claim& claim);

}  // namespace durero::conform
