// SPDX-License-Identifier: Apache-2.0
// Every kernel of vesica/cuda.cuh for compile.py: batches in step of every pair of kinds, the other forms for one pair;
// a kernel as a user writes one; and one whose instructions are known.
#include <vesica/cuda.cuh>
#include <vesica/vesica.hpp>

namespace vesica {

namespace cuda {

#define VESICA_IN_STEP(a, A, b, B)                                                                          \
  template cudaError_t overlap_many<A, B, float>(const Shapes<float>&, const Shapes<float>&, std::uint8_t*, \
                                                 const Work&, cudaStream_t) noexcept;
VESICA_EACH_PAIR(VESICA_IN_STEP)
#undef VESICA_IN_STEP

template cudaError_t overlap_many<Ellipse, Rect, double>(const Shapes<double>&, const Shapes<double>&, std::uint8_t*,
                                                         const Work&, cudaStream_t) noexcept;
template cudaError_t overlap_many<Rect, Rect, double>(const Shapes<double>&, const Shapes<double>&, std::uint8_t*,
                                                      const Work&, cudaStream_t) noexcept;
template cudaError_t overlap_one<Rect, Rect, float>(const Rect<float>&, const Shapes<float>&, std::uint8_t*,
                                                    const Work&, cudaStream_t) noexcept;
template cudaError_t overlap_one<Rect, Circle, double>(const Rect<double>&, const Shapes<double>&, std::uint8_t*,
                                                       const Work&, cudaStream_t) noexcept;
template cudaError_t overlap_matrix<Rect, Rect, float>(const Shapes<float>&, const Shapes<float>&, std::uint8_t*,
                                                       std::int64_t, const Work&, cudaStream_t) noexcept;
template cudaError_t overlap_counts<Rect, Rect, float>(const Shapes<float>&, const Shapes<float>&, std::uint32_t*,
                                                       const Work&, cudaStream_t) noexcept;

}  // namespace cuda

__global__ void predicates(const Rect<float>* a, const Ellipse<float>* b, std::int32_t* out) {
  const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
  out[4 * i] = overlap_or_error(a[i], b[i]);
  out[4 * i + 1] = contains_or_error(b[i], a[i]);
  out[4 * i + 2] = relation_or_error(a[i], b[i]);
  out[4 * i + 3] = check(b[i]);
}

/// A loop that takes 11 operations of float a number, 8 of double (one of them on a condition), 2 loads and 1 store.
__global__ void known_instructions(const float* x, const double* y, double* out, unsigned n) {
  for (unsigned i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += gridDim.x * blockDim.x) {
    const float f = x[i];
    const double d = y[i];
    float a = f;
    for (int k = 0; k < 11; ++k) a = std::fma(a, f, f);
    double b = d;
    for (int k = 0; k < 7; ++k) b = std::fma(b, d, d);
    out[i] = a > 3 ? b * d : b;
  }
}

}  // namespace vesica
