// SPDX-License-Identifier: Apache-2.0
// The nearest items of an index, for one shape and for all of some sets.
#include <limits>

#include "index_arguments.hpp"
#include "join/nearest.hpp"
#include "queries.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

/// Distances of one shape to n others.
template <class T>
void measure(int32_t kind_a, const void* const* a, int32_t kind_b, const void* const* b, int64_t n,
             void* distance) noexcept {
  T* const columns[] = {static_cast<T*>(distance), nullptr, nullptr, nullptr, nullptr};
  vesica::batch::query_many<T, T>(vesica::queries::nearest, vesica::kernels(), columns_of<T>(kind_a, a, 1),
                                  columns_of<T>(kind_b, b, n), n, columns);
}

/// Sets of shapes as a caller passes them.
template <class T>
struct CSets {
  const CShapesOf<T>* sets;
  int32_t count;
};

bool has_distance(int32_t kind) noexcept {
  return vesica::queries::nearest.paths == nullptr ? vesica::has_core(kind) : vesica::has_core_or_path(kind);
}

/// The index and its sets, those that are asked about, and what both functions are asked.
template <class T>
int32_t check_nearest(const void* from, const CSets<T>& sets, const CSets<T>& asked, int64_t k, T within,
                      const void* out, const void* distance, index::Sets& view, index::Sets& asked_view) noexcept {
  const int32_t of_shapes = first_error(view_sets<T>(asked.sets, asked.count, asked_view, has_distance),
                                        view_sets<T>(sets.sets, sets.count, view, has_distance));
  const bool writes = k > 0 && (of_shapes != 0 || asked_view.items > 0);
  if (writes && (out == nullptr || distance == nullptr)) return VESICA_E_NULL;
  const int32_t error = first_error(check_index(from), of_shapes);
  if (error != 0) return error;
  return k >= 0 && within >= 0 && view.items == index::View(from).items() ? 0 : VESICA_E_ARGUMENT;
}

template <class T>
int64_t nearest(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one, int64_t k,
                T within, int64_t* out, T* distance) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(nearest<T>, from, sets, set_count, one, k, within, out, distance);
  if (one == nullptr) return VESICA_E_NULL;
  index::Sets items, single;
  const int32_t error = check_nearest<T>(from, {sets, set_count}, {one, 1}, k, within, out, distance, items, single);
  if (error != 0) return error;
  if (single.items != 1) return VESICA_E_ARGUMENT;
  const index::Nearest query{index_kernels(), from, items, measure<T>, k, static_cast<double>(within)};
  double box[4];
  if (!index::bounds_of_item(query.kernels, single, 0, box)) return VESICA_E_SHAPE;
  return index::find_nearest<T>(query, single, 0, box, out, distance);
}

template <class T>
int64_t join_nearest(const CShapesOf<T>* sets_a, int32_t set_count_a, const void* index_b, const CShapesOf<T>* sets_b,
                     int32_t set_count_b, int64_t k, T within, int64_t part, int64_t parts, int64_t* out,
                     T* distance) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(join_nearest<T>, sets_a, set_count_a, index_b, sets_b, set_count_b, k, within, part, parts,
                             out, distance);
  index::Sets a, b;
  const int32_t error =
      check_nearest<T>(index_b, {sets_b, set_count_b}, {sets_a, set_count_a}, k, within, out, distance, b, a);
  if (error != 0) return error;
  if (k < 1 || parts < 1 || part < 0 || part >= parts || k > INT64_MAX / 8 / (a.items + 1)) return VESICA_E_ARGUMENT;
  const index::Nearest query{index_kernels(), index_b, b, measure<T>, k, static_cast<double>(within)};
  const int64_t share = a.items / parts, rest = a.items % parts;
  const int64_t begin = share * part + (part < rest ? part : rest), end = begin + share + (part < rest ? 1 : 0);
  int64_t found = 0;
  bool invalid = false;
  for (int64_t i = begin; i < end; ++i) {
    double box[4];
    const auto item = static_cast<uint32_t>(i);
    const bool valid = index::bounds_of_item(query.kernels, a, item, box);
    const int64_t n = valid ? index::find_nearest<T>(query, a, item, box, out + i * k, distance + i * k) : 0;
    for (int64_t j = n; j < k; ++j) {
      out[i * k + j] = -1;
      distance[i * k + j] = std::numeric_limits<T>::infinity();
    }
    found += n;
    invalid = invalid || !valid;
  }
  return invalid ? VESICA_E_SHAPE : found;
}

}  // namespace

int64_t vesica_index_nearest_f64(const void* index, const vesica_shapes_f64* sets, int32_t set_count,
                                 const vesica_shapes_f64* one, int64_t k, double within, int64_t* out,
                                 double* distance) {
  return nearest<double>(index, sets, set_count, one, k, within, out, distance);
}
int64_t vesica_index_nearest_f32(const void* index, const vesica_shapes_f32* sets, int32_t set_count,
                                 const vesica_shapes_f32* one, int64_t k, float within, int64_t* out, float* distance) {
  return nearest<float>(index, sets, set_count, one, k, within, out, distance);
}
int64_t vesica_join_nearest_f64(const vesica_shapes_f64* sets_a, int32_t set_count_a, const void* index_b,
                                const vesica_shapes_f64* sets_b, int32_t set_count_b, int64_t k, double within,
                                int64_t part, int64_t parts, int64_t* out, double* distance) {
  return join_nearest<double>(sets_a, set_count_a, index_b, sets_b, set_count_b, k, within, part, parts, out, distance);
}
int64_t vesica_join_nearest_f32(const vesica_shapes_f32* sets_a, int32_t set_count_a, const void* index_b,
                                const vesica_shapes_f32* sets_b, int32_t set_count_b, int64_t k, float within,
                                int64_t part, int64_t parts, int64_t* out, float* distance) {
  return join_nearest<float>(sets_a, set_count_a, index_b, sets_b, set_count_b, k, within, part, parts, out, distance);
}
