#pragma once
/// In the place of GMP's numbers: Boost's own integers and fractions, with 64-bit limbs too. Their sums, products and
/// texts are the same.
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/rational_adaptor.hpp>
#include <cstddef>
#include <memory>
#include <new>

namespace durero::number {

/// The greatest size of a number in bytes: throw_when_numbers_outgrow_memory().
std::size_t greatest_size_of_number();

/// Memory of the limbs of numbers. Throws std::bad_alloc beyond that size.
template <class T>
struct LimbAllocator {
  using value_type = T;
  LimbAllocator() = default;
  template <class U>
  LimbAllocator(const LimbAllocator<U>&) {}
  T* allocate(std::size_t count) {
    if (count > greatest_size_of_number() / sizeof(T)) throw std::bad_alloc();
    return std::allocator<T>().allocate(count);
  }
  void deallocate(T* memory, std::size_t count) { std::allocator<T>().deallocate(memory, count); }
  bool operator==(const LimbAllocator&) const = default;
};

}  // namespace durero::number

namespace boost::multiprecision {

static_assert(sizeof(limb_type) == 8, "numbers have the limbs of the build with GMP");

using gmp_int = cpp_int_backend<0, 0, signed_magnitude, unchecked, durero::number::LimbAllocator<limb_type>>;
using gmp_rational = rational_adaptor<gmp_int>;

}  // namespace boost::multiprecision
