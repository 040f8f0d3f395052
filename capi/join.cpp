// SPDX-License-Identifier: Apache-2.0
// All pairs of two indexes.
#include "join/join.hpp"

#include "index_arguments.hpp"
#include "queries.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

/// Which of n pairs have an a that contains b.
template <class T>
void decide_contains(int32_t kind_a, const void* const* a, int64_t count_a, int32_t kind_b, const void* const* b,
                     int64_t n, uint8_t* out) noexcept {
  vesica::batch::query_many<T, uint8_t>(vesica::queries::contains, vesica::kernels(), columns_of<T>(kind_a, a, count_a),
                                        columns_of<T>(kind_b, b, n), n, &out);
}

template <class T>
index::Decide decider(int32_t query) noexcept {
  if (query == VESICA_JOIN_BOUNDS) return nullptr;
  if (query == VESICA_JOIN_INTERIORS) return decide_overlap<T, vesica::Common::insides>;
  return query == VESICA_JOIN_OVERLAP ? decide_overlap<T> : decide_contains<T>;
}

/// One side: its index, and its sets, of the index's items, or absent where nothing is decided.
template <class T>
int32_t check_side(int32_t query, const void* from, const CShapesOf<T>* sets, int32_t set_count,
                   index::Sets& view) noexcept {
  return query == VESICA_JOIN_BOUNDS ? check_index(from) : check_indexed<T>(from, sets, set_count, view);
}

bool decides(int32_t query, int32_t kind_a, int32_t kind_b) noexcept {
  if (query != VESICA_JOIN_CONTAINS && query != VESICA_JOIN_INSIDE) return true;
  return vesica::queries::contains.answers(kind_a, kind_b);
}

/// True if the query decides every pair of a set of one side and a set of the other.
bool decides_all(int32_t query, const index::Sets& a, const index::Sets& b) noexcept {
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      if (!decides(query, a.set[i].kind, b.set[j].kind)) return false;
    }
  }
  return true;
}

template <class T>
int64_t join(int32_t query, const void* index_a, const CShapesOf<T>* sets_a, int32_t set_count_a, const void* index_b,
             const CShapesOf<T>* sets_b, int32_t set_count_b, int64_t part, int64_t parts, void* scratch,
             int64_t scratch_size, int64_t* out_a, int64_t* out_b, int64_t capacity, int64_t* state) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(join<T>, query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts,
                             scratch, scratch_size, out_a, out_b, capacity, state);
  if (index_a == nullptr || index_b == nullptr || scratch == nullptr) return VESICA_E_NULL;
  if (capacity > 0 && (out_a == nullptr || out_b == nullptr || state == nullptr)) return VESICA_E_NULL;
  index::Sets a, b;
  const int32_t error = first_error(check_side<T>(query, index_a, sets_a, set_count_a, a),
                                    check_side<T>(query, index_b, sets_b, set_count_b, b));
  if (error != 0) return error;
  if (!decides_all(query, a, b)) return VESICA_E_KIND;
  if (query < VESICA_JOIN_OVERLAP || query > VESICA_JOIN_INTERIORS) return VESICA_E_ARGUMENT;
  if (parts < 1 || part < 0 || part >= parts || capacity < 0) return VESICA_E_ARGUMENT;
  if (!aligned(scratch) || scratch_size < index::join_scratch_bytes()) return VESICA_E_ARGUMENT;
  const index::Join all{index_kernels(),
                        {index_a, &a},
                        {index_b, &b},
                        decider<T>(query),
                        query == VESICA_JOIN_INSIDE,
                        static_cast<uint32_t>(query),
                        part,
                        parts,
                        scratch};
  if (capacity == 0) return index::count_pairs(all);
  if (!index::state_is_sound(all, state)) return VESICA_E_ARGUMENT;
  return index::write_pairs(all, out_a, out_b, nullptr, capacity, state);
}

}  // namespace

int64_t vesica_join_scratch(void) { return index::join_scratch_bytes(); }

int64_t vesica_join_f64(int32_t query, const void* index_a, const vesica_shapes_f64* sets_a, int32_t set_count_a,
                        const void* index_b, const vesica_shapes_f64* sets_b, int32_t set_count_b, int64_t part,
                        int64_t parts, void* scratch, int64_t scratch_size, int64_t* out_a, int64_t* out_b,
                        int64_t capacity, int64_t* state) {
  return join<double>(query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts, scratch,
                      scratch_size, out_a, out_b, capacity, state);
}
int64_t vesica_join_f32(int32_t query, const void* index_a, const vesica_shapes_f32* sets_a, int32_t set_count_a,
                        const void* index_b, const vesica_shapes_f32* sets_b, int32_t set_count_b, int64_t part,
                        int64_t parts, void* scratch, int64_t scratch_size, int64_t* out_a, int64_t* out_b,
                        int64_t capacity, int64_t* state) {
  return join<float>(query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts, scratch,
                     scratch_size, out_a, out_b, capacity, state);
}
