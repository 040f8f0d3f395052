// SPDX-License-Identifier: Apache-2.0
/// The ways an array of shapes may lie in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "batch.hpp"
#include "batch/shapes.hpp"
#include "capi/face.hpp"
#include "properties/pair.hpp"

namespace batch_tests {

enum class Layout {
  columns,           ///< a column a number, each with another alignment
  packed,            ///< records without padding
  padded,            ///< records with other data after them
  odd_records,       ///< records at odd bytes
  backward_columns,  ///< columns that run towards lower addresses
  backward_records,  ///< records that do
  repeated,          ///< stride 0: the first shape as often as the count says
  single,            ///< count 1, which repeats beside any other count
};
inline constexpr std::array all_layouts{
    Layout::columns,          Layout::packed,           Layout::padded,   Layout::odd_records,
    Layout::backward_columns, Layout::backward_records, Layout::repeated, Layout::single};

inline const char* name(Layout layout) {
  constexpr std::array<const char*, all_layouts.size()> names{
      "columns", "packed", "padded", "odd_records", "backward_columns", "backward_records", "repeated", "single"};
  return names.at(static_cast<std::size_t>(layout));
}

inline bool one_shape(Layout layout) { return layout == Layout::repeated || layout == Layout::single; }

/// An array of shapes in memory of its own. All other bytes about it are ones: read as a number they are NaN, so an
/// element taken from a wrong place is an invalid shape.
template <class T>
class Stored {
 public:
  /// offset: where the first byte lies, past a multiple of 64.
  Stored(int kind, std::span<const Numbers<T>> shapes, Layout layout, std::size_t offset = 0)
      : layout_(layout), fields_(static_cast<std::size_t>(properties::field_count(kind))) {
    view_.kind = kind;
    view_.count = static_cast<std::int64_t>(shapes.size());
    place(shapes.size(), offset);
    const std::size_t written = one_shape(layout) ? 1 : shapes.size();
    for (std::size_t i = 0; i < written && i < shapes.size(); ++i) write(i, shapes[i]);
    if (layout == Layout::single) view_.count = 1;
  }

  Stored(const Stored&) = delete;
  Stored& operator=(const Stored&) = delete;

  /// As the functions behind the C interface take it.
  const vesica::batch::Shapes<T>& view() const { return view_; }

 private:
  static constexpr std::size_t line = 64;

  /// Finds room for n elements and points the fields at the first one.
  void place(std::size_t n, std::size_t offset) {
    const bool columns = layout_ == Layout::columns || layout_ == Layout::backward_columns;
    const std::size_t element = columns ? sizeof(T) : record_size();
    const std::size_t stretch = (one_shape(layout_) ? 1 : n) * element;
    memory_.assign(line + offset + (columns ? fields_ * (stretch + 1) : stretch + element) + line, std::byte{0xFF});
    std::byte* begin = aligned_start() + offset + (layout_ == Layout::odd_records ? 1 : 0);
    const bool backward = layout_ == Layout::backward_columns || layout_ == Layout::backward_records;
    const std::size_t last = backward && n > 0 ? (n - 1) * element : 0;
    for (std::size_t k = 0; k < fields_; ++k) {
      const std::size_t at = last + (columns ? k * (stretch + 1) : k * sizeof(T));
      view_.field[k] = reinterpret_cast<const T*>(begin + at);
    }
    view_.stride = one_shape(layout_) ? 0
                   : backward         ? -static_cast<std::ptrdiff_t>(element)
                                      : static_cast<std::ptrdiff_t>(element);
  }

  std::byte* aligned_start() {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    return memory_.data() + (line - address % line) % line;
  }

  std::size_t record_size() const {
    const std::size_t packed = fields_ * sizeof(T);
    switch (layout_) {
      case Layout::padded:
        return packed + 2 * sizeof(T);
      case Layout::odd_records:
        return packed + 3;
      case Layout::backward_records:
        return packed + 5;
      default:
        return packed;
    }
  }

  void write(std::size_t i, const Numbers<T>& numbers) {
    for (std::size_t k = 0; k < fields_; ++k) {
      const std::ptrdiff_t first = view_.field[k].bytes() - memory_.data();
      const std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(i) * view_.stride;
      std::memcpy(memory_.data() + at, &numbers[k], sizeof(T));
    }
  }

  Layout layout_;
  std::size_t fields_;
  std::vector<std::byte> memory_;
  vesica::batch::Shapes<T> view_{};
};

/// The same as the C functions take it.
template <class T>
typename capi_tests::Face<T>::Shapes c_shapes(const vesica::batch::Shapes<T>& view) {
  typename capi_tests::Face<T>::Shapes shapes{};
  shapes.kind = view.kind;
  shapes.count = view.count;
  shapes.stride = view.stride;
  for (int k = 0; k < properties::field_count(view.kind); ++k) {
    shapes.field[k] = reinterpret_cast<const T*>(view.field[k].bytes());
  }
  return shapes;
}
template <class T>
typename capi_tests::Face<T>::Shapes c_shapes(const Stored<T>& stored) {
  return c_shapes(stored.view());
}

}  // namespace batch_tests
