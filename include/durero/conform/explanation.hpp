#pragma once
/// A ray of a suite and its exact answer, in words and digits for whoever wants to see why.

#include <string>

#include "durero/conform/suite.hpp"

namespace durero::conform {

/// How many digits an exact number is shown with.
inline constexpr int shown_digits = 40;

/// The case, the question, every crossing of the ray with t to 40 digits and as x + y√Δ, the first point, and what
/// else may be answered. Precondition: the case was answered.
std::string explanation(const SuiteCase& of, std::size_t ray);

/// Of these the exact answer, the crossings, the first point and what else may be answered.
std::string exact_answer(const SuiteCase& of, std::size_t ray);

}  // namespace durero::conform
