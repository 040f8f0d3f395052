// SPDX-License-Identifier: Apache-2.0
/// Arrays of shapes against pages that may not be touched.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "batch/guard_pages.hpp"
#include "batch/layout.hpp"

namespace batch_tests {

/// Writes arrays of shapes into guarded memory: a column each to its own, records together, the last record without
/// what may follow its numbers.
class GuardedShapes {
 public:
  template <class T>
  vesica::batch::Shapes<T> write(int kind, std::span<const Numbers<T>> shapes, Layout layout, Edge edge) {
    const bool columns = layout == Layout::columns || layout == Layout::backward_columns;
    const bool backward = layout == Layout::backward_columns || layout == Layout::backward_records;
    const auto fields = static_cast<std::size_t>(properties::field_count(kind));
    const std::size_t n = one_shape(layout) ? std::min<std::size_t>(1, shapes.size()) : shapes.size();
    const std::size_t element = columns ? sizeof(T) : fields * sizeof(T) + (layout == Layout::packed ? 0 : 3);
    const std::size_t used = columns ? sizeof(T) : fields * sizeof(T), gaps = n > 0 ? (n - 1) * element : 0;
    const auto step = static_cast<std::ptrdiff_t>(element);
    vesica::batch::Shapes<T> view{kind,
                                  static_cast<std::int64_t>(shapes.size()),
                                  one_shape(layout) ? 0
                                  : backward        ? -step
                                                    : step,
                                  {}};
    for (std::size_t k = 0; k < fields; ++k) {
      std::byte* low = memory_[columns ? k : 0].place(n > 0 ? gaps + used : 0, edge) + (columns ? 0 : k * sizeof(T));
      for (std::size_t i = 0; i < n; ++i) {
        std::memcpy(low + (backward ? n - 1 - i : i) * element, &shapes[i][k], sizeof(T));
      }
      view.field[k] = reinterpret_cast<const T*>(low + (backward ? gaps : 0));
    }
    if (layout == Layout::single) view.count = 1;
    return view;
  }

 private:
  std::array<GuardedMemory, std::tuple_size_v<properties::Numbers>> memory_;
};

}  // namespace batch_tests
