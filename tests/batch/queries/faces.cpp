// SPDX-License-Identifier: Apache-2.0
#include "batch/queries/faces.hpp"

#include <cstring>

namespace batch_tests {

namespace {

/// A code's function as one that writes a number.
template <class T, auto Scalar>
std::int32_t code(int kind_a, const T* a, int kind_b, const T* b, Result<T>& result) {
  const std::int32_t answer = Scalar(kind_a, a, kind_b, b);
  if (answer < 0) return answer;
  result[0] = static_cast<T>(answer);
  return 0;
}

template <class T, auto Many>
std::int64_t code_many(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b,
                       std::span<std::vector<T>> columns) {
  std::vector<std::uint8_t> bytes(columns[0].size());
  const std::int64_t returned = Many(a, b, bytes.data());
  columns[0].assign(bytes.begin(), bytes.end());
  return returned;
}

template <class T, auto Matrix>
std::int64_t code_matrix(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b, std::vector<T>& out,
                         std::ptrdiff_t row_stride) {
  std::vector<std::uint8_t> bytes(out.begin(), out.end());
  const std::int64_t returned = Matrix(a, b, bytes.data(), row_stride);
  out.assign(bytes.begin(), bytes.end());
  return returned;
}

template <class T, auto Scalar, auto Many, auto Matrix>
constexpr QueryFace<T> code_face(const char* name) {
  return {name, 1, false, true, code<T, Scalar>, code_many<T, Many>, code_matrix<T, Matrix>};
}

/// A function that writes a struct of numbers.
template <class T, class Struct, auto Scalar>
std::int32_t structure(int kind_a, const T* a, int kind_b, const T* b, Result<T>& result) {
  Struct found;
  const std::int32_t error = Scalar(kind_a, a, kind_b, b, &found);
  if (error == 0) std::memcpy(result.data(), &found, sizeof found);
  return error;
}

template <class T, auto Many>
std::int64_t five_columns(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b,
                          std::span<std::vector<T>> c) {
  return Many(a, b, c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data());
}

template <class T, auto Many>
std::int64_t three_columns(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b,
                           std::span<std::vector<T>> c) {
  return Many(a, b, c[0].data(), c[1].data(), c[2].data());
}

/// A function that writes one number.
template <class T, auto Scalar>
std::int32_t number(int kind_a, const T* a, int kind_b, const T* b, Result<T>& result) {
  return Scalar(kind_a, a, kind_b, b, &result[0]);
}

template <class T, auto Many>
std::int64_t one_column(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b,
                        std::span<std::vector<T>> c) {
  return Many(a, b, c[0].data());
}

template <class T, auto Matrix>
std::int64_t number_matrix(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b, std::vector<T>& out,
                           std::ptrdiff_t row_stride) {
  return Matrix(a, b, out.data(), row_stride);
}

template <class T, auto Scalar, auto Many, auto Matrix>
constexpr QueryFace<T> number_face(const char* name) {
  return {name, 1, false, false, number<T, Scalar>, one_column<T, Many>, number_matrix<T, Matrix>};
}

template <class T, class Struct, auto Scalar, auto Many, auto Matrix>
constexpr QueryFace<T> distance_face(const char* name) {
  return {name, 5, true, false, structure<T, Struct, Scalar>, five_columns<T, Many>, number_matrix<T, Matrix>};
}

/// A ratio by its constant.
template <int which, class T>
std::int32_t ratio(int kind_a, const T* a, int kind_b, const T* b, Result<T>& result) {
  return Face<T>::ratio(which, kind_a, a, kind_b, b, &result[0]);
}
template <int which, class T>
std::int64_t ratio_many(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b,
                        std::span<std::vector<T>> c) {
  return Face<T>::ratio_many(which, a, b, c[0].data());
}
template <int which, class T>
std::int64_t ratio_matrix(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b, std::vector<T>& out,
                          std::ptrdiff_t row_stride) {
  return Face<T>::ratio_matrix(which, a, b, out.data(), row_stride);
}
template <int which, class T>
constexpr QueryFace<T> ratio_face(const char* name) {
  return {name, 1, false, false, ratio<which, T>, ratio_many<which, T>, ratio_matrix<which, T>};
}

/// Within a distance that is less than most of the workloads' and more than some.
template <class T>
std::int32_t within(int kind_a, const T* a, int kind_b, const T* b) {
  return Face<T>::within(kind_a, a, kind_b, b, T{1} / 2);
}
template <class T>
std::int64_t within_many(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b, std::uint8_t* out) {
  return Face<T>::within_many(a, b, T{1} / 2, out);
}
template <class T>
std::int64_t within_matrix(const typename Face<T>::Shapes* a, const typename Face<T>::Shapes* b, std::uint8_t* out,
                           std::ptrdiff_t row_stride) {
  return Face<T>::within_matrix(a, b, T{1} / 2, out, row_stride);
}

}  // namespace

template <>
std::span<const QueryFace<double>> query_faces<double>() {
  static constexpr QueryFace<double> faces[] = {
      code_face<double, vesica_relation_f64, vesica_relation_many_f64, vesica_relation_matrix_f64>("relation"),
      code_face<double, vesica_contains_f64, vesica_contains_many_f64, vesica_contains_matrix_f64>("contains"),
      number_face<double, vesica_area_f64, vesica_area_many_f64, vesica_area_matrix_f64>("area"),
      number_face<double, vesica_iou_f64, vesica_iou_many_f64, vesica_iou_matrix_f64>("iou"),
      distance_face<double, vesica_closest_points_f64, vesica_nearest_f64, vesica_nearest_many_f64,
                    vesica_nearest_matrix_f64>("nearest"),
      distance_face<double, vesica_closest_points_f64, vesica_boundary_distance_f64, vesica_boundary_distance_many_f64,
                    vesica_boundary_distance_matrix_f64>("boundary_distance"),
      {"depth", 3, false, false, structure<double, vesica_penetration_f64, vesica_depth_f64>,
       three_columns<double, vesica_depth_many_f64>, number_matrix<double, vesica_depth_matrix_f64>},
      ratio_face<VESICA_RATIO_OVER_SECOND, double>("over_second"),
      ratio_face<VESICA_RATIO_GENERALIZED, double>("generalized"),
      ratio_face<VESICA_RATIO_COMPLETE, double>("complete"),
      code_face<double, within<double>, within_many<double>, within_matrix<double>>("within"),
  };
  return faces;
}

template <>
std::span<const QueryFace<float>> query_faces<float>() {
  static constexpr QueryFace<float> faces[] = {
      code_face<float, vesica_relation_f32, vesica_relation_many_f32, vesica_relation_matrix_f32>("relation"),
      code_face<float, vesica_contains_f32, vesica_contains_many_f32, vesica_contains_matrix_f32>("contains"),
      number_face<float, vesica_area_f32, vesica_area_many_f32, vesica_area_matrix_f32>("area"),
      number_face<float, vesica_iou_f32, vesica_iou_many_f32, vesica_iou_matrix_f32>("iou"),
      distance_face<float, vesica_closest_points_f32, vesica_nearest_f32, vesica_nearest_many_f32,
                    vesica_nearest_matrix_f32>("nearest"),
      distance_face<float, vesica_closest_points_f32, vesica_boundary_distance_f32, vesica_boundary_distance_many_f32,
                    vesica_boundary_distance_matrix_f32>("boundary_distance"),
      {"depth", 3, false, false, structure<float, vesica_penetration_f32, vesica_depth_f32>,
       three_columns<float, vesica_depth_many_f32>, number_matrix<float, vesica_depth_matrix_f32>},
      ratio_face<VESICA_RATIO_OVER_SECOND, float>("over_second"),
      ratio_face<VESICA_RATIO_GENERALIZED, float>("generalized"),
      ratio_face<VESICA_RATIO_COMPLETE, float>("complete"),
      code_face<float, within<float>, within_many<float>, within_matrix<float>>("within"),
  };
  return faces;
}

}  // namespace batch_tests
