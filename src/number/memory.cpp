#include "durero/number/memory.hpp"

#include <gmp.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace durero::number {
namespace {

// GMP is C, but an exception passes through it: its frames have unwind tables, as all code has on the machines that
// this is for. The number that GMP was about to enlarge may then call memory its own that it does not have, and is
// released all the same. So nothing is freed from there on, which a program that ends or gives up can afford.
std::atomic<bool> outgrown = false;
std::atomic<std::size_t> greatest_size = largest_number;

[[noreturn]] void give_up() {
  outgrown = true;
  throw std::bad_alloc();
}

void* allocate(std::size_t size) {
  void* const memory = size > greatest_size ? nullptr : std::malloc(size);
  if (!memory) give_up();
  return memory;
}

void* reallocate(void* memory, std::size_t, std::size_t size) {
  void* const enlarged = size > greatest_size ? nullptr : std::realloc(memory, size);
  if (!enlarged) give_up();
  return enlarged;
}

void release(void* memory, std::size_t) {
  if (!outgrown) std::free(memory);
}

}  // namespace

void throw_when_numbers_outgrow_memory(std::size_t largest) {
  greatest_size = largest;
  mp_set_memory_functions(allocate, reallocate, release);
}

}  // namespace durero::number
