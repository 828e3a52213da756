#pragma once
/// A file of ranges holds the ends of the rays of a suite, or of a user: in each line T of a shadow ray, T0 T1 of a
/// range, or R, the radius of a ball that is cast. What stands behind # is a comment, and a line without numbers is
/// passed over.

#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/judge/truth.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// Reads the ranges of so many rays, in their order. Throws InputError where there are more or fewer, and on what is no
/// such number. Precondition: has_numbers(question).
std::vector<AskedRange> read_ranges(const io::Source& source, QuestionKind question, std::size_t rays);

/// The file of these ranges. Precondition: that of read_ranges().
std::string ranges_text(QuestionKind question, std::span<const AskedRange> ranges);

}  // namespace durero::conform
