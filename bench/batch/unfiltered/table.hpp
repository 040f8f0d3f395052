// SPDX-License-Identifier: Apache-2.0
/// The yardsticks of one instruction set: kernels without error bounds or validity checks, and a reader of memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vesica/shapes.hpp>

namespace vesica::unfiltered {

/// Columns of shapes: field[k][i] is number k of element i.
template <class T>
using Columns = const T* const*;

/// out[i] = 1 where the shapes overlap, else 0; returns how many do. n must be a multiple of 64.
template <class T>
using Kernel = std::int64_t (*)(Columns<T> first, Columns<T> second, std::int64_t n, std::uint8_t* out) noexcept;

template <class T>
struct PairKernels {
  Kernel<T> in_step = nullptr;
  Kernel<T> one_against_many = nullptr;  // the first shape, against all of the second
};

/// Indexed by the two kinds; empty where there is no yardstick.
template <class T>
using Kernels = PairKernels<T>[kind_count][kind_count];

struct Table {
  const char* name;
  Kernels<float> f32;
  Kernels<double> f64;
  /// Sum of n numbers, n a multiple of 256: nothing but loads, as fast as memory delivers them.
  float (*sum_f32)(const float* numbers, std::size_t n) noexcept;
  double (*sum_f64)(const double* numbers, std::size_t n) noexcept;

  const Kernels<float>& of(float) const noexcept { return f32; }
  const Kernels<double>& of(double) const noexcept { return f64; }
  float sum(const float* numbers, std::size_t n) const noexcept { return sum_f32(numbers, n); }
  double sum(const double* numbers, std::size_t n) const noexcept { return sum_f64(numbers, n); }
};

#if defined(__x86_64__)
extern const Table sse2, avx2, avx512;
#elif defined(__aarch64__)
extern const Table neon;
#endif

}  // namespace vesica::unfiltered
