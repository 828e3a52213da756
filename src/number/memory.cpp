#include "durero/number/memory.hpp"

#include <gmp.h>

#include <cstdlib>
#include <new>

namespace durero::number {
namespace {

// GMP is C, but an exception passes through it: its frames have unwind tables, as all code has on the machines that
// this is for. What GMP held at that moment is lost, which a program that ends or gives up can afford.
void* checked(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}

void* allocate(std::size_t size) {
  if (size > largest_number) throw std::bad_alloc();
  return checked(std::malloc(size));
}

void* reallocate(void* memory, std::size_t, std::size_t size) {
  if (size > largest_number) throw std::bad_alloc();
  return checked(std::realloc(memory, size));
}

void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void throw_when_numbers_outgrow_memory() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace durero::number
