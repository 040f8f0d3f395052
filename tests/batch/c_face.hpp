// SPDX-License-Identifier: Apache-2.0
/// The batch functions of vesica.h by scalar type.
#pragma once

#include <vesica.h>

#include <cstddef>
#include <cstdint>

namespace batch_tests {

template <class T>
struct CFace;

template <>
struct CFace<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr auto from_records = vesica_shapes_from_records_f64;
  static constexpr auto many = vesica_overlap_many_f64;
  static constexpr auto matrix = vesica_overlap_matrix_f64;
  static constexpr auto select = vesica_overlap_select_f64;
};

template <>
struct CFace<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr auto from_records = vesica_shapes_from_records_f32;
  static constexpr auto many = vesica_overlap_many_f32;
  static constexpr auto matrix = vesica_overlap_matrix_f32;
  static constexpr auto select = vesica_overlap_select_f32;
};

}  // namespace batch_tests
