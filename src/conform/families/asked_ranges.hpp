#pragma once
/// The ranges of rays lie where systems fail: at crossings, and so near them that the last bits decide.

#include <vector>

#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// The ranges of shadow rays: each ends far behind the first hit, anywhere before it, or very near it. Precondition:
/// the case was answered.
std::vector<AskedRange> shadow_ranges(const SuiteCase& of, NumberFormat numbers, Random& random);

/// The ranges of first hits: from, to, just before and just behind any crossing of the ray, between two of them, from
/// 0, of one number, and empty. Precondition: the case was answered.
std::vector<AskedRange> ranges_near_crossings(const SuiteCase& of, NumberFormat numbers, Random& random);

}  // namespace durero::conform
