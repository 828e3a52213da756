#pragma once
/// Memory that runs out on demand. Replaces the global operator new, so include it in one source of a program.

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

namespace durero::test {

inline constexpr long plenty = std::numeric_limits<long>::max();
inline thread_local long allocations_left = plenty;

/// While it lives, the first `n` allocations succeed and every later one throws std::bad_alloc.
class OutOfMemoryAfter {
 public:
  explicit OutOfMemoryAfter(long n) { allocations_left = n; }
  ~OutOfMemoryAfter() { allocations_left = plenty; }
  OutOfMemoryAfter(const OutOfMemoryAfter&) = delete;
  OutOfMemoryAfter& operator=(const OutOfMemoryAfter&) = delete;
};

/// How many allocations an action makes, on this thread.
template <class Action>
long allocations_of(Action&& action) {
  allocations_left = plenty - 1;
  action();
  return plenty - 1 - std::exchange(allocations_left, plenty);
}

/// Runs `edit` with memory running out at its first allocation, its second, … until it no longer does, calling `check`
/// after each failure. Answers how many allocations the edit makes.
template <class Edit, class Check>
long fail_every_allocation(Edit&& edit, Check&& check) {
  for (long n = 0;; ++n) {
    try {
      const OutOfMemoryAfter limit(n);
      edit();
      return n;
    } catch (const std::bad_alloc&) {
    }
    check();
  }
}

}  // namespace durero::test

// Never inlined: the compiler would take the free() in a delete for a mismatch with a new that it did not see into.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (durero::test::allocations_left != durero::test::plenty && durero::test::allocations_left-- <= 0)
    throw std::bad_alloc();
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  if (durero::test::allocations_left != durero::test::plenty && durero::test::allocations_left-- <= 0)
    throw std::bad_alloc();
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return memory;
  throw std::bad_alloc();
}
// The library's own nothrow form need not call the one above, and every delete is the one below.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
