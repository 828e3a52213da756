#pragma once
/// Arrays that are read here and there: in large pages of memory, where the system has them, fewer reads have to find
/// out first where a page lies.

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace durero::accel {

/// An allocator that asks for large pages where an array fills one. Whether it gets them shows in time alone.
template <class T>
struct LargePages {
  using value_type = T;  ///< of an array's entries
  LargePages() = default;
  /// All are alike.
  template <class Other>
  LargePages(const LargePages<Other>&) noexcept {}

  /// Room for n entries. Throws std::bad_alloc where there is none.
  T* allocate(std::size_t n) {
    if (n > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = n * sizeof(T);
    void* const room = ::operator new(bytes, alignment(bytes));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (bytes >= page) madvise(room, bytes, MADV_HUGEPAGE);  // refused, it is as if it had not been asked
#endif
    return static_cast<T*>(room);
  }
  /// Gives it back.
  void deallocate(T* room, std::size_t n) noexcept { ::operator delete(room, alignment(n * sizeof(T))); }

  bool operator==(const LargePages&) const = default;

 private:
  static constexpr std::size_t page = std::size_t{1} << 21;  // bytes, on most machines
  static std::align_val_t alignment(std::size_t bytes) { return std::align_val_t{bytes >= page ? page : alignof(T)}; }
};

/// A vector in such memory.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace durero::accel
