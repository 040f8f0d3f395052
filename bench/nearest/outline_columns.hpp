// SPDX-License-Identifier: Apache-2.0
/// Pairs as columns, and how a batch on them is timed.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nearest/outline_pairs.hpp"

namespace vesica::bench {

/// Pairs a call, as many as a pass of single calls has.
inline constexpr std::size_t pairs_a_call = 256;

class OutlineColumns {
 public:
  OutlineColumns(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs)
      : kinds_{kind_a, kind_b}, count_(pairs.size()) {
    for (std::size_t k = 0; k < 6; ++k) {
      for (const OutlinePair& p : pairs) {
        columns_[0][k].push_back(p.a[k]);
        columns_[1][k].push_back(p.b[k]);
      }
    }
  }

  std::size_t count() const { return count_; }

  /// Side 0 or 1 of some of the pairs.
  vesica_shapes_f64 shapes(std::size_t side, std::size_t first, std::size_t count) const {
    vesica_shapes_f64 s{};
    s.kind = kinds_[side];
    s.count = static_cast<std::int64_t>(count);
    s.stride = sizeof(double);
    for (std::size_t k = 0; k < 6; ++k) s.field[k] = columns_[side][k].data() + first;
    return s;
  }

 private:
  std::array<std::int32_t, 2> kinds_;
  std::array<std::array<std::vector<double>, 6>, 2> columns_;
  std::size_t count_;
};

/// Median nanoseconds a pair of calls (a, b, out) with five columns of room for results; each on pairs not seen before.
template <class Many>
double batch_nanoseconds(const OutlineColumns& columns, const Many& many) {
  using Clock = std::chrono::steady_clock;
  std::array<std::array<double, pairs_a_call>, 5> out{};
  std::vector<double> times;
  for (std::size_t first = 0; first + pairs_a_call <= columns.count(); first += pairs_a_call) {
    const vesica_shapes_f64 a = columns.shapes(0, first, pairs_a_call), b = columns.shapes(1, first, pairs_a_call);
    const Clock::time_point start = Clock::now();
    many(a, b, out);
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() / pairs_a_call);
  }
  return median(std::move(times));
}

}  // namespace vesica::bench
