#pragma once
/// What happens where exact numbers grow beyond memory.

#include <cstddef>

namespace durero::number {

/// The largest number, in bytes, where nothing else is said: no sum, product or root of stored numbers comes near it,
/// and two such numbers are still multiplied in seconds.
inline constexpr std::size_t largest_number = std::size_t{1} << 25;

/// From here on GMP throws std::bad_alloc for a larger number, and where memory runs out; by itself it would end the
/// program. For a program to call before it computes.
void throw_when_numbers_outgrow_memory(std::size_t largest = largest_number);

}  // namespace durero::number
