#pragma once
/// An explanation shows a ray of a suite and its exact answer in words and digits.

#include <string>

#include "durero/conform/families/suite.hpp"

namespace durero::conform {

/// The number of digits of an exact number in an explanation.
inline constexpr int shown_digits = 40;

/// The explanation: the case, the question, every crossing of the ray with t to 40 digits and as x + y√Δ, the first
/// point, and the permissible answers. Precondition: the case was answered.
std::string explanation(const SuiteCase& of, std::size_t ray);

/// The last part of the explanation: the exact answer, the crossings, the first point and the permissible answers.
/// Precondition: the case was answered.
std::string exact_answer(const SuiteCase& of, std::size_t ray);

}  // namespace durero::conform
