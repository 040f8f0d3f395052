// SPDX-License-Identifier: Apache-2.0
/// Overlap of arrays that lie in a CUDA device's memory: in step, one shape against many, every pair of two arrays, and
/// how many overlap. The answers are those of the library, bit for bit, and the device finds every one of them itself.
///
/// A batch is three kernels. The first one runs the pair's filter in the arrays' own scalar, float or double, and lists
/// the undecided pairs. The second one decides these in double, and contact by integers, and lists the rest.
/// The third one decides those exactly, in few threads, since each needs up to 40 kB of local memory. A list has no
/// particular order, but each answer has its place: the results are always the same.
///
/// For programs compiled with nvcc's --expt-relaxed-constexpr and without --use_fast_math. docs/cuda.md has an example.
/// In a kernel of one's own, overlap_or_error() and the other constexpr functions need only <vesica/vesica.hpp>.
#pragma once

#include <cuda_runtime.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vesica/overlap.hpp>

namespace vesica::cuda {

/// An array of shapes of one kind in device memory. Byte for byte the struct vesica_shapes_f64 or vesica_shapes_f32 of
/// vesica.h, with the same meaning; but numbers must be aligned, as a device requires.
template <class T>
struct Shapes {
  std::int32_t kind, reserved;
  std::int64_t count;
  std::ptrdiff_t stride;  ///< bytes from one element to the next; 0 repeats one shape
  const T* field[8];      ///< where each number of the first element is
  const std::int32_t *rings = nullptr, *polygons = nullptr;  ///< not used by these kinds
  std::int64_t each = 0;                                     ///< nor is this
};

/// An array of structs in device memory.
template <template <class> class Shape, class T>
Shapes<T> records(const Shape<T>* first, std::int64_t count) noexcept {
  Shapes<T> shapes{static_cast<std::int32_t>(kind_of<Shape>), 0, count, sizeof(Shape<T>), {}};
  for (int k = 0; k < ShapeTraits<Shape<T>>::fields; ++k) shapes.field[k] = reinterpret_cast<const T*>(first) + k;
  return shapes;
}

/// Elements [first, first + count) of an array: so a matrix is done in tiles, or by several devices.
template <class T>
Shapes<T> part(Shapes<T> shapes, std::int64_t first, std::int64_t count) noexcept {
  for (const T*& field : shapes.field) {
    if (field == nullptr) continue;
    field = reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(field) + first * shapes.stride);
  }
  shapes.count = count;
  return shapes;
}

/// Pairs of one batch, at most. Larger arrays need several batches.
inline constexpr std::int64_t most_pairs = 0xfffffffe;

/// Device memory that a batch of `pairs` pairs needs: 8 bytes a pair, and 16. When a batch is done, its first 32 bits
/// are the number of pairs with an invalid shape; their answer is 0.
constexpr std::size_t work_bytes(std::int64_t pairs) noexcept { return 16 + 8 * static_cast<std::size_t>(pairs); }

struct Work {
  void* memory;  ///< aligned to 16 bytes, as from cudaMalloc
  std::size_t bytes;
};

namespace detail {

using Index = std::uint32_t;

/// A shape that stands for all elements.
template <class Shape>
struct One {
  Shape shape;
  __device__ const Shape& operator[](Index) const noexcept { return shape; }
};

/// The shapes of an array.
template <template <class> class Shape, class T>
class Column {
 public:
  explicit Column(const Shapes<T>& s) noexcept : stride_(s.count == 1 ? 0 : s.stride) {
    for (int k = 0; k < fields; ++k) field_[k] = reinterpret_cast<const std::byte*>(s.field[k]);
  }
  __device__ Shape<T> operator[](Index i) const noexcept { return shape(i, std::make_integer_sequence<int, fields>()); }

 private:
  static constexpr int fields = ShapeTraits<Shape<T>>::fields;

  template <int... k>
  __device__ Shape<T> shape(Index i, std::integer_sequence<int, k...>) const noexcept {
    const std::int64_t offset = static_cast<std::int64_t>(i) * stride_;
    return {*reinterpret_cast<const T*>(field_[k] + offset)...};
  }

  const std::byte* field_[fields];
  std::int64_t stride_;
};

/// The pairs of a batch: number k is row(k) of a and column(k) of b.
template <class A, class B>
struct InStep {
  A a;
  B b;
  Index count;
  __device__ Index row(Index k) const noexcept { return k; }
  __device__ Index column(Index k) const noexcept { return k; }
};
template <class A, class B>
struct Matrix {
  A a;
  B b;
  Index count, columns;
  __device__ Index row(Index k) const noexcept { return k / columns; }
  __device__ Index column(Index k) const noexcept { return k % columns; }
};

/// The output of answers: a byte a pair, or added up for each column.
struct Bytes {
  std::uint8_t* out;
  std::int64_t row_size;  // 0: in step
  __device__ void set(Index row, Index column, bool overlap) const noexcept {
    out[static_cast<std::int64_t>(row) * row_size + column] = overlap ? 1 : 0;
  }
};
struct Counts {
  std::uint32_t* out;
  __device__ void set(Index, Index column, bool overlap) const noexcept {
    if (overlap) atomicAdd(out + column, 1U);
  }
};

/// Pairs that are still open.
struct Open {
  Index* count;
  Index* pair;
  __device__ void add(Index k) const noexcept { pair[atomicAdd(count, 1U)] = k; }
};

/// Calls action with the shapes of a pair in the order of kinds.
template <class Pairs, class Action>
__device__ std::int32_t with_pair(const Pairs& pairs, Index k, Action action) noexcept {
  const auto& a = pairs.a[pairs.row(k)];
  const auto& b = pairs.b[pairs.column(k)];
  if constexpr (vesica::detail::in_order<std::decay_t<decltype(a)>, std::decay_t<decltype(b)>>) {
    return action(a, b);
  } else {
    return action(b, a);
  }
}

struct ByFilter {
  template <class A, class B>
  __device__ std::int32_t operator()(const A& a, const B& b) const noexcept {
    return vesica::detail::decide_by_filter(a, b);
  }
};
struct InDouble {
  template <template <class> class A, template <class> class B, class T>
  __device__ std::int32_t operator()(const A<T>& a, const B<T>& b) const noexcept {
    const A<double> first = widen(a);
    const B<double> second = widen(b);
    const std::int32_t answer = vesica::detail::decide_by_filter(first, second);
    if constexpr (vesica::filter::HasIntegers<A<double>, B<double>>) {
      if (answer < 0) return vesica::detail::answer_of(vesica::filter::by_integers(first, second));
    }
    return answer;
  }
};
struct Exactly {
  template <template <class> class A, template <class> class B, class T>
  __device__ std::int32_t operator()(const A<T>& a, const B<T>& b) const noexcept {
    if (check(a) != 0 || check(b) != 0) return error_shape;
    return vesica::detail::overlap::exact(widen(a), widen(b)) ? 1 : 0;
  }
};

__device__ inline Index thread() noexcept { return blockIdx.x * blockDim.x + threadIdx.x; }
__device__ inline Index threads() noexcept { return gridDim.x * blockDim.x; }

template <class Pairs, class Out>
__device__ void answer_or_list(const Pairs& pairs, Index k, std::int32_t answer, Out out, Open open) noexcept {
  if (answer < 0) {
    open.add(k);
  } else {
    out.set(pairs.row(k), pairs.column(k), answer == 1);
  }
}

template <class Pairs, class Out>
__global__ void overlap_by_filter(Pairs pairs, Out out, Open open) {
  // In 64 bits: the sum may be beyond the last index.
  for (std::uint64_t k = thread(); k < pairs.count; k += threads()) {
    const auto pair = static_cast<Index>(k);
    answer_or_list(pairs, pair, with_pair(pairs, pair, ByFilter()), out, open);
  }
}

template <class Pairs, class Out>
__global__ void overlap_in_double(Pairs pairs, Out out, Open left, Open open) {
  for (std::uint64_t i = thread(); i < *left.count; i += threads()) {
    const Index k = left.pair[i];
    answer_or_list(pairs, k, with_pair(pairs, k, InDouble()), out, open);
  }
}

template <class Pairs, class Out>
__global__ void overlap_exactly(Pairs pairs, Out out, Open left, Index* invalid) {
  for (std::uint64_t i = thread(); i < *left.count; i += threads()) {
    const Index k = left.pair[i];
    const std::int32_t answer = with_pair(pairs, k, Exactly());
    if (answer < 0) atomicAdd(invalid, 1U);
    out.set(pairs.row(k), pairs.column(k), answer == 1);
  }
}

template <class... Parameters, class... Arguments>
cudaError_t launch(void (*kernel)(Parameters...), unsigned blocks, unsigned threads, cudaStream_t stream,
                   Arguments... arguments) noexcept {
  cudaLaunchConfig_t config{};
  config.gridDim = dim3(blocks);
  config.blockDim = dim3(threads);
  config.stream = stream;
  return cudaLaunchKernelEx(&config, kernel, arguments...);
}

/// Threads of each kernel. The first one's blocks depend on the batch, the others' not: how many pairs they find is
/// known to the device alone.
inline constexpr unsigned block = 256, most_blocks = 16384, blocks_in_double = 512, exact_block = 32,
                          exact_blocks = 128;

template <class Pairs, class Out>
cudaError_t run(const Pairs& pairs, const Out& out, const Work& work, cudaStream_t stream) noexcept {
  if (work.bytes < work_bytes(pairs.count)) return cudaErrorInvalidValue;
  auto* const counts = static_cast<Index*>(work.memory);
  const Open first{counts + 1, counts + 4}, second{counts + 2, counts + 4 + pairs.count};
  cudaError_t error = cudaMemsetAsync(counts, 0, 4 * sizeof(Index), stream);
  if (error != cudaSuccess || pairs.count == 0) return error;
  const unsigned blocks = (pairs.count - 1) / block + 1;
  error = launch(overlap_by_filter<Pairs, Out>, blocks < most_blocks ? blocks : most_blocks, block, stream, pairs, out,
                 first);
  if (error != cudaSuccess) return error;
  error = launch(overlap_in_double<Pairs, Out>, blocks < blocks_in_double ? blocks : blocks_in_double, block, stream,
                 pairs, out, first, second);
  if (error != cudaSuccess) return error;
  return launch(overlap_exactly<Pairs, Out>, exact_blocks, exact_block, stream, pairs, out, second, counts);
}

template <template <class> class Shape, class T>
bool is_kind(const Shapes<T>& s) noexcept {
  return s.kind == static_cast<std::int32_t>(kind_of<Shape>) && s.count >= 0 && s.count <= most_pairs;
}

template <template <class> class A, template <class> class B, class T>
Matrix<Column<A, T>, Column<B, T>> matrix(const Shapes<T>& a, const Shapes<T>& b) noexcept {
  return {Column<A, T>(a), Column<B, T>(b), static_cast<Index>(a.count * b.count), static_cast<Index>(b.count)};
}
template <template <class> class A, template <class> class B, class T>
bool is_matrix(const Shapes<T>& a, const Shapes<T>& b) noexcept {
  return is_kind<A>(a) && is_kind<B>(b) && (b.count == 0 || a.count <= most_pairs / b.count);
}

}  // namespace detail

// Each function queues a batch on a stream and returns at once. A and B name the kinds, in any order: for instance
// overlap_many<Ellipse, Rect>(ellipses, rects, out, work). It returns an error of the launch, or cudaErrorInvalidValue
// for arrays of other kinds, counts that do not agree, more than most_pairs pairs, or too little memory.

/// out[i]: whether a[i] overlaps b[i], 1 or 0. A count of 1 repeats.
template <template <class> class A, template <class> class B, class T>
cudaError_t overlap_many(const Shapes<T>& a, const Shapes<T>& b, std::uint8_t* out, const Work& work,
                         cudaStream_t stream = nullptr) noexcept {
  if (!detail::is_kind<A>(a) || !detail::is_kind<B>(b)) return cudaErrorInvalidValue;
  if (a.count != b.count && a.count != 1 && b.count != 1) return cudaErrorInvalidValue;
  const std::int64_t count = a.count == 1 ? b.count : a.count;
  const detail::InStep<detail::Column<A, T>, detail::Column<B, T>> pairs{
      detail::Column<A, T>(a), detail::Column<B, T>(b), static_cast<detail::Index>(count)};
  return detail::run(pairs, detail::Bytes{out, 0}, work, stream);
}

/// out[i]: whether a shape that the host knows overlaps b[i].
template <template <class> class A, template <class> class B, class T>
cudaError_t overlap_one(const A<T>& a, const Shapes<T>& b, std::uint8_t* out, const Work& work,
                        cudaStream_t stream = nullptr) noexcept {
  if (!detail::is_kind<B>(b)) return cudaErrorInvalidValue;
  const detail::InStep<detail::One<A<T>>, detail::Column<B, T>> pairs{
      {a}, detail::Column<B, T>(b), static_cast<detail::Index>(b.count)};
  return detail::run(pairs, detail::Bytes{out, 0}, work, stream);
}

/// out[i * row_size + j]: whether a[i] overlaps b[j]. row_size is at least b's count; with part(), a tile goes to its
/// place in a greater matrix.
template <template <class> class A, template <class> class B, class T>
cudaError_t overlap_matrix(const Shapes<T>& a, const Shapes<T>& b, std::uint8_t* out, std::int64_t row_size,
                           const Work& work, cudaStream_t stream = nullptr) noexcept {
  if (!detail::is_matrix<A, B>(a, b) || row_size < b.count) return cudaErrorInvalidValue;
  return detail::run(detail::matrix<A, B>(a, b), detail::Bytes{out, row_size}, work, stream);
}

/// Adds to out[j] how many of a overlap b[j]. So tiles of a add up; out is to be 0 before the first.
template <template <class> class A, template <class> class B, class T>
cudaError_t overlap_counts(const Shapes<T>& a, const Shapes<T>& b, std::uint32_t* out, const Work& work,
                           cudaStream_t stream = nullptr) noexcept {
  if (!detail::is_matrix<A, B>(a, b)) return cudaErrorInvalidValue;
  return detail::run(detail::matrix<A, B>(a, b), detail::Counts{out}, work, stream);
}

}  // namespace vesica::cuda
