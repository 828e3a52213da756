#include "durero/accel/large_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <new>

namespace durero::accel {

void* allocate_on_large_pages(std::size_t bytes) {
  if (bytes < large_page) return ::operator new(bytes, std::align_val_t{cache_line});
  void* const memory = ::operator new(bytes, std::align_val_t{large_page});
#ifdef MADV_HUGEPAGE
  // Advice: where it is not taken, the pages are small, and nothing else is different.
  (void)madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_on_large_pages(void* memory, std::size_t bytes) noexcept {
  if (bytes < large_page) return ::operator delete(memory, std::align_val_t{cache_line});
  ::operator delete(memory, std::align_val_t{large_page});
}

}  // namespace durero::accel
