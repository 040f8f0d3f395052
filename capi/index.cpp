// SPDX-License-Identifier: Apache-2.0
// The index: its building, checking and reading.
#include "index_arguments.hpp"
#include "join/nearest.hpp"
#include "join/select.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

/// The arguments of a build, checked; the sets' view.
template <class T>
int32_t check_build(const CShapesOf<T>* sets, int32_t set_count, const void* to, int64_t size, const void* scratch,
                    int64_t scratch_size, index::Sets& view) noexcept {
  if (to == nullptr || scratch == nullptr) return VESICA_E_NULL;
  const int32_t error = view_sets<T>(sets, set_count, view, vesica::has_core_or_path);
  if (error != 0) return error;
  const bool room = size >= index::size_bound(view.items) && scratch_size >= index::scratch_bound(view.items);
  return room && aligned(to) && aligned(scratch) ? 0 : VESICA_E_ARGUMENT;
}

int64_t bytes_or_invalid(const void* built) noexcept {
  const index::Header& header = index::View(built).header();
  return header.placed == header.items ? header.size : VESICA_E_SHAPE;
}

template <class T>
int64_t build(const CShapesOf<T>* sets, int32_t set_count, void* to, int64_t size, void* scratch,
              int64_t scratch_size) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(build<T>, sets, set_count, to, size, scratch, scratch_size);
  index::Sets view;
  const int32_t error = check_build<T>(sets, set_count, to, size, scratch, scratch_size, view);
  if (error != 0) return error;
  for (int s = 0; s < index::build_steps; ++s) index::build_step(index_kernels(), view, s, 0, 1, to, scratch);
  return bytes_or_invalid(to);
}

template <class T>
int64_t step(int32_t number, int64_t part, int64_t parts, const CShapesOf<T>* sets, int32_t set_count, void* to,
             int64_t size, void* scratch, int64_t scratch_size) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(step<T>, number, part, parts, sets, set_count, to, size, scratch, scratch_size);
  index::Sets view;
  const int32_t error = check_build<T>(sets, set_count, to, size, scratch, scratch_size, view);
  if (error != 0) return error;
  const bool last = number == index::build_steps - 1;
  if (number < 0 || number >= index::build_steps || parts < 1 || part < 0 || part >= parts) return VESICA_E_ARGUMENT;
  if ((number == 0 || last) && parts != 1) return VESICA_E_ARGUMENT;
  if (!index::build_step(index_kernels(), view, number, part, parts, to, scratch)) return VESICA_E_ARGUMENT;
  return last ? bytes_or_invalid(to) : 0;
}

template <class T>
int64_t select(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one, int64_t* out,
               int64_t capacity, int64_t* state) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(select<T>, from, sets, set_count, one, out, capacity, state);
  if (one == nullptr || (capacity > 0 && (out == nullptr || state == nullptr))) return VESICA_E_NULL;
  index::Sets items, single;
  int32_t error = first_error(check_index(from), view_sets<T>(one, 1, single, vesica::has_core_or_path));
  if (sets != nullptr) error = first_error(error, view_sets<T>(sets, set_count, items, vesica::has_core_or_path));
  if (error != 0) return error;
  if (capacity < 0 || single.items != 1) return VESICA_E_ARGUMENT;
  if (sets == nullptr ? set_count != 0 : items.items != index::View(from).items()) return VESICA_E_ARGUMENT;
  const index::Selection selection{index_kernels(), from, &items, single,
                                   sets == nullptr ? nullptr : decide_overlap<T>};
  if (capacity > 0 && !index::selection_state_is_sound(selection, state)) return VESICA_E_ARGUMENT;
  double box[4];
  if (!index::bounds_of_item(selection.kernels, single, 0, box)) return VESICA_E_SHAPE;
  return capacity == 0 ? index::count_selected(selection, box)
                       : index::write_selected(selection, box, out, capacity, state);
}

bool is_count(int64_t count) noexcept { return count >= 0 && count <= index::most_items; }

}  // namespace

int64_t vesica_index_size(int64_t count) { return is_count(count) ? index::size_bound(count) : VESICA_E_ARGUMENT; }
int64_t vesica_index_scratch(int64_t count) {
  return is_count(count) ? index::scratch_bound(count) : VESICA_E_ARGUMENT;
}

int64_t vesica_index_build_f64(const vesica_shapes_f64* sets, int32_t set_count, void* index, int64_t index_size,
                               void* scratch, int64_t scratch_size) {
  return build<double>(sets, set_count, index, index_size, scratch, scratch_size);
}
int64_t vesica_index_build_f32(const vesica_shapes_f32* sets, int32_t set_count, void* index, int64_t index_size,
                               void* scratch, int64_t scratch_size) {
  return build<float>(sets, set_count, index, index_size, scratch, scratch_size);
}

int64_t vesica_index_step_f64(int32_t number, int64_t part, int64_t parts, const vesica_shapes_f64* sets,
                              int32_t set_count, void* index, int64_t index_size, void* scratch, int64_t scratch_size) {
  return step<double>(number, part, parts, sets, set_count, index, index_size, scratch, scratch_size);
}
int64_t vesica_index_step_f32(int32_t number, int64_t part, int64_t parts, const vesica_shapes_f32* sets,
                              int32_t set_count, void* index, int64_t index_size, void* scratch, int64_t scratch_size) {
  return step<float>(number, part, parts, sets, set_count, index, index_size, scratch, scratch_size);
}

int32_t vesica_index_check(const void* index, int64_t size) {
  VESICA_DEFAULT_ENVIRONMENT(vesica_index_check, index, size);
  if (index == nullptr) return VESICA_E_NULL;
  if (!aligned(index)) return VESICA_E_ARGUMENT;
  return index::is_sound(index, size) ? 0 : VESICA_E_INDEX;
}

int64_t vesica_index_bytes(const void* index) {
  const int32_t error = check_index(index);
  return error != 0 ? error : index::View(index).header().size;
}

int64_t vesica_index_count(const void* index) {
  const int32_t error = check_index(index);
  return error != 0 ? error : index::View(index).items();
}

int32_t vesica_index_bounds(const void* index, vesica_aabb_f64* out) {
  if (out == nullptr) return VESICA_E_NULL;
  const int32_t error = check_index(index);
  if (error != 0) return error;
  std::memcpy(out, index::View(index).header().bounds, sizeof *out);
  return 0;
}

int64_t vesica_index_order(const void* index, int64_t* out, int64_t capacity) {
  if (capacity > 0 && out == nullptr) return VESICA_E_NULL;
  const int32_t error = check_index(index);
  if (error != 0) return error;
  if (capacity < 0) return VESICA_E_ARGUMENT;
  const index::View view(index);
  int64_t n = 0;
  for (int64_t b = 0; b < view.blocks() && n < capacity; ++b) {
    const index::Block& block = view.block(b);
    for (int32_t i = 0; i < block.count && n < capacity; ++i) out[n++] = index::item_at(block, i);
  }
  return view.header().placed;
}

int64_t vesica_index_select_f64(const void* index, const vesica_shapes_f64* sets, int32_t set_count,
                                const vesica_shapes_f64* one, int64_t* out, int64_t capacity, int64_t* state) {
  return select<double>(index, sets, set_count, one, out, capacity, state);
}
int64_t vesica_index_select_f32(const void* index, const vesica_shapes_f32* sets, int32_t set_count,
                                const vesica_shapes_f32* one, int64_t* out, int64_t capacity, int64_t* state) {
  return select<float>(index, sets, set_count, one, out, capacity, state);
}
