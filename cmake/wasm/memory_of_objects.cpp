// Operators that throw where memory is at an end; those of a library without exceptions end the program.
#include <cstdlib>
#include <new>

namespace {

void* allocated(std::size_t size) {
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

// aligned_alloc asks for a multiple of the alignment.
void* allocated(std::size_t size, std::align_val_t align) {
  const auto unit = static_cast<std::size_t>(align);
  if (size > SIZE_MAX - unit) throw std::bad_alloc();
  if (void* const memory = std::aligned_alloc(unit, (size / unit + 1) * unit)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void* operator new(std::size_t size, std::align_val_t align) { return allocated(size, align); }
void* operator new[](std::size_t size, std::align_val_t align) { return allocated(size, align); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
