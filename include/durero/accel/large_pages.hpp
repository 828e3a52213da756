#pragma once
/// Memory for long arrays that are read here and there. Each read of another page is looked up in a table of which the
/// processor keeps a part; of large pages there are so few that it keeps all.

#include <cstddef>
#include <vector>

namespace durero::accel {

/// From so many bytes on an array begins on a large page, and the system is asked for such.
inline constexpr std::size_t large_page = std::size_t{1} << 21;

/// What a shorter one is aligned to, in bytes.
inline constexpr std::size_t cache_line = 64;

/// @{ Memory of so many bytes, aligned to a cache line at least. It comes on large pages where the system gives them,
/// which is no promise. Throws std::bad_alloc; is given back with the same number.
void* allocate_on_large_pages(std::size_t bytes);
void free_on_large_pages(void* memory, std::size_t bytes) noexcept;
/// @}

/// The allocator of a container that is to have such memory.
template <class T>
struct LargePages {
  using value_type = T;  ///< what is allocated
  static_assert(alignof(T) <= cache_line);

  LargePages() = default;
  /// All of them share one memory.
  template <class U>
  LargePages(const LargePages<U>&) noexcept {}

  /// @{ As std::allocator has it; a container asks for no more than it could address.
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_on_large_pages(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { free_on_large_pages(memory, count * sizeof(T)); }
  bool operator==(const LargePages&) const noexcept { return true; }
  /// @}
};

/// A vector in such memory.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace durero::accel
