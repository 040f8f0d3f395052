// SPDX-License-Identifier: Apache-2.0
// Numbers where a caller has them, at any address. A pointer of type T* promises the compiler an aligned address, even
// as an argument of memcpy, so such numbers are reached by bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vesica/scalar.hpp>

namespace vesica {

/// A pointer to adjacent numbers, at any address. Always inlined: objects of several instruction sets use it.
template <class T>
class Unaligned {
 public:
  Unaligned() = default;
  VESICA_INLINE Unaligned(const T* p) noexcept : at_(reinterpret_cast<const std::byte*>(p)) {}

  VESICA_INLINE T operator[](std::ptrdiff_t i) const noexcept {
    T x;
    (*this + i).copy_to(x);
    return x;
  }
  /// To a number, or to a vector the first numbers.
  template <class Vector>
  VESICA_INLINE void copy_to(Vector& vector) const noexcept {
    std::memcpy(&vector, at_, sizeof vector);
  }
  /// As a plain pointer; null where it is not aligned.
  const T* aligned() const noexcept { return address() % alignof(T) == 0 ? reinterpret_cast<const T*>(at_) : nullptr; }
  /// The address of number i.
  VESICA_INLINE const std::byte* bytes(std::ptrdiff_t i = 0) const noexcept {
    return at_ + i * static_cast<std::ptrdiff_t>(sizeof(T));
  }
  VESICA_INLINE Unaligned operator+(std::ptrdiff_t numbers) const noexcept { return Unaligned(bytes(numbers)); }
  /// By a number of bytes within the address space.
  VESICA_INLINE Unaligned advanced(std::int64_t bytes) const noexcept {
    return Unaligned(at_ + static_cast<std::ptrdiff_t>(bytes));
  }
  /// As a number. Of null, or beyond an array, an address may not be formed.
  VESICA_INLINE std::uintptr_t address() const noexcept { return reinterpret_cast<std::uintptr_t>(at_); }

 private:
  VESICA_INLINE explicit Unaligned(const std::byte* at) noexcept : at_(at) {}

  const std::byte* at_;
};

}  // namespace vesica
