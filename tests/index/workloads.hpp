// SPDX-License-Identifier: Apache-2.0
/// Sets of shapes to index and join: the workloads of docs/join.md, each a trap for some index.
#pragma once

#include <vesica.h>

#include <cstdint>
#include <string>
#include <vector>

namespace index_tests {

/// A set of shapes of one kind, records side by side.
template <class T>
struct Records {
  std::int32_t kind;
  std::vector<T> numbers;
  std::int64_t count() const;
};

/// Sets laid end to end.
template <class T>
using Laid = std::vector<Records<T>>;

/// Names of workloads of rectangles.
const std::vector<std::string>& rect_workloads();

/// n rectangles of a workload.
template <class T>
Records<T> rects(const std::string& workload, std::int64_t n, std::uint64_t seed);

/// The same extents as shapes of all six kinds, n / 6 each; one in `invalid_every` broken, if that is not 0.
template <class T>
Laid<T> mixed(const std::string& workload, std::int64_t n, std::uint64_t seed, std::int64_t invalid_every = 0);

}  // namespace index_tests
