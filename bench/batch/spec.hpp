// SPDX-License-Identifier: Apache-2.0
/// A row of the table: its measurement and its target.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "batch/isa.hpp"
#include "workloads.hpp"

namespace vesica::bench {

enum class Layout {
  one_many,         ///< the first shape against all of the second, columns, in cache
  in_step,          ///< a[i] with b[i], columns, in cache
  matrix,           ///< every a with every b, columns, in cache
  one_records,      ///< one_many, the many as an array of structs
  records,          ///< in_step, both as arrays of structs
  memory_one_many,  ///< columns several times larger than the last-level cache
  memory_in_step,
  matrix_1e5,     ///< slices of rows of a matrix of 100,000 by 100,000, the answers in fresh memory
  large_matrix,   ///< 1,024 rows, as they come
  sorted_matrix,  ///< the same, rows and columns in the order of an index
  two_threads,    ///< one_many by two threads of the caller at once
  near,           ///< in_step, every pair within float rounding of contact, beside mixed pairs
};

const char* name_of(Layout layout);

/// The target of a row. A missed target is printed, never a failure: timings are no test.
struct BatchTarget {
  enum class Of { nothing, ratio, bandwidth, tests_a_second };
  Of of = Of::nothing;
  double at_least = 0;
};

struct Spec {
  std::int32_t kind_a, kind_b;
  bool single;  ///< float, else double
  const Isa* isa;
  Layout layout;
  Workload workload;

  std::string pair() const;
  /// pair/scalar/instruction set/layout/workload.
  std::string name() const;
  BatchTarget target() const;
};

/// Every row there is, in the order of the table.
std::vector<Spec> all_specs();

}  // namespace vesica::bench
