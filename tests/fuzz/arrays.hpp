// SPDX-License-Identifier: Apache-2.0
/// A fuzzer's bytes as arrays of shapes, and room for what functions of arrays write.
#pragma once

#include "capi/face.hpp"
#include "fuzz/bytes.hpp"

namespace fuzz {

using capi_tests::Face;

/// The most shapes of an array.
inline constexpr std::int64_t most = 40;

/// Records of a kind, packed or not, at any byte, forwards or backwards; or one shape repeated.
template <class T>
typename Face<T>::Shapes array(Bytes& bytes, GuardedMemory& memory, std::int64_t count) {
  typename Face<T>::Shapes shapes{};
  shapes.kind = bytes.kind();
  shapes.count = count;
  shapes.reserved = bytes.below(128) == 127;
  shapes.each = bytes.below(128) == 127;
  const std::int32_t known = vesica_field_count(shapes.kind);
  const std::size_t fields = known < 0 ? 0 : static_cast<std::size_t>(known);
  const bool repeated = bytes.below(8) == 7, backward = bytes.below(4) == 3;
  const std::size_t element = fields * sizeof(T) + bytes.below(9),
                    stored = repeated ? 1 : static_cast<std::size_t>(count);
  const std::size_t size = stored * element;
  std::byte* begin = memory.place(size, bytes.below(2) == 0 ? Edge::before : Edge::after);
  for (std::size_t i = 0; i < stored; ++i) {
    for (std::size_t k = 0; k < fields; ++k) {
      const T number = bytes.number<T>();
      std::memcpy(begin + i * element + k * sizeof(T), &number, sizeof number);
    }
  }
  const std::size_t first = backward && stored > 0 ? (stored - 1) * element : 0;
  shapes.stride = repeated ? 0 : static_cast<std::ptrdiff_t>(element) * (backward ? -1 : 1);
  for (std::size_t k = 0; k < fields; ++k) shapes.field[k] = reinterpret_cast<const T*>(begin + first + k * sizeof(T));
  return shapes;
}

/// As many numbers as fit, in pieces for columns.
template <class Out>
Out* room(GuardedMemory& memory, std::int64_t count) {
  return reinterpret_cast<Out*>(memory.place(static_cast<std::size_t>(count) * sizeof(Out), Edge::after));
}

}  // namespace fuzz
