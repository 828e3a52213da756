#pragma once
/// Memory on large pages, for long arrays that are read at random. A read of another page needs its address
/// translation, of which the processor caches a few; large pages are so few that all fit.

#include <cstddef>
#include <vector>

namespace durero::accel {

/// The least size of an array, in bytes, that is put on large pages.
inline constexpr std::size_t large_page = std::size_t{1} << 21;

/// The alignment of a shorter array, in bytes.
inline constexpr std::size_t cache_line = 64;

/// @{ Allocates and frees memory, aligned to a cache line at least. From `large_page` bytes on it lies on large pages,
/// if the system grants them. Throws std::bad_alloc. Memory must be freed with the size it was allocated with.
void* allocate_on_large_pages(std::size_t bytes);
void free_on_large_pages(void* memory, std::size_t bytes) noexcept;
/// @}

/// An allocator of such memory.
template <class T>
struct LargePages {
  using value_type = T;  ///< the type of the elements
  static_assert(alignof(T) <= cache_line);

  LargePages() = default;
  /// All allocators are equal.
  template <class U>
  LargePages(const LargePages<U>&) noexcept {}

  /// @{ The operations of std::allocator.
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_on_large_pages(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { free_on_large_pages(memory, count * sizeof(T)); }
  bool operator==(const LargePages&) const noexcept { return true; }
  /// @}
};

/// A vector in such memory.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace durero::accel
