#pragma once
/// A mutation is a small random change of a question, towards what systems find hard: other scales, grazing rays,
/// numbers that are equal or nearly so.

#include "conform/judge/measured_question.hpp"
#include "durero/conform/random.hpp"

namespace durero::conform {

/// Changes the question one to three times. `other` is a question whose elements it may take.
Draft mutated(const MeasuredQuestion& question, const Draft& other, Random& random);

/// Rounds every number to binary32 but the unit vectors, which are no such numbers.
void round_to_binary32(Draft& draft);

}  // namespace durero::conform
