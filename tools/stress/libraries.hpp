// SPDX-License-Identifier: Apache-2.0
/// The library once for each instruction set, in one process, and arrays of shapes for it.
#pragma once

#include <vesica.h>

#include <cstring>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "batch/guard_pages.hpp"
#include "capi/face.hpp"
#include "stress/query.hpp"

namespace stress {

using batch_tests::Edge;
using batch_tests::GuardedMemory;

/// A copy that runs by one instruction set.
struct Loaded {
  std::string isa;
  void* handle;
};

/// One for each instruction set that this processor has.
const std::vector<Loaded>& loaded();

/// A function of such a copy; throws where there is none.
void* find_symbol(const Loaded& library, const std::string& symbol);

/// All names that find_symbol() was asked for.
const std::set<std::string>& functions_asked();

template <class Function>
Function* find(const Loaded& library, const std::string& symbol) {
  return reinterpret_cast<Function*>(find_symbol(library, symbol));
}

template <class T>
struct Types;
template <>
struct Types<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr const char* suffix = "_f64";
  static constexpr Scalar scalar = Scalar::f64;
};
template <>
struct Types<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr const char* suffix = "_f32";
  static constexpr Scalar scalar = Scalar::f32;
};

/// An array of shapes between guard pages: columns or records, forwards or backwards, at any byte.
template <class T>
class Array {
 public:
  using Shapes = typename Types<T>::Shapes;

  Array(int kind, std::span<const Numbers> shapes, unsigned layout, GuardedMemory& memory) : shapes_{} {
    const auto fields = static_cast<std::size_t>(properties::field_count(kind));
    const bool columns = layout % 2 == 0, backward = layout / 2 % 4 == 0;
    const std::size_t padding = columns ? 0 : layout / 8 % 3 * 5, count = shapes.size();
    const std::size_t element = columns ? sizeof(T) : fields * sizeof(T) + padding;
    const std::size_t size = columns ? fields * count * sizeof(T) : count * element;
    std::byte* begin = memory.place(size, layout / 32 % 2 == 0 ? Edge::before : Edge::after);
    std::memset(begin, 0xFF, size);
    shapes_.kind = kind;
    shapes_.count = static_cast<std::int64_t>(count);
    shapes_.stride = backward ? -static_cast<std::ptrdiff_t>(element) : static_cast<std::ptrdiff_t>(element);
    for (std::size_t k = 0; k < fields; ++k) {
      std::byte* field = begin + (columns ? k * count * sizeof(T) : k * sizeof(T));
      for (std::size_t i = 0; i < count; ++i) {
        const T number = static_cast<T>(shapes[backward ? count - 1 - i : i][k]);
        std::memcpy(field + i * element, &number, sizeof number);
      }
      shapes_.field[k] = reinterpret_cast<const T*>(field + (backward ? (count - 1) * element : 0));
    }
  }
  const Shapes& view() const { return shapes_; }

 private:
  Shapes shapes_;
};

/// A function by its name without suffix, of the type that it has as Face<T>'s member.
#define VESICA_FIND(library, T, name)                                                                 \
  (::stress::find<std::remove_pointer_t<std::remove_const_t<decltype(::capi_tests::Face<T>::name)>>>( \
      library, std::string("vesica_" #name) + ::stress::Types<T>::suffix))

}  // namespace stress
