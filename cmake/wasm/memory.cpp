// In the place of src/number/memory.cpp: the limit of Boost's numbers.
#include "durero/number/memory.hpp"

#include "durero/number/rational.hpp"

namespace durero::number {
namespace {

std::size_t greatest_size = largest_number;

}  // namespace

std::size_t greatest_size_of_number() { return greatest_size; }

void throw_when_numbers_outgrow_memory(std::size_t largest) { greatest_size = largest; }

}  // namespace durero::number
