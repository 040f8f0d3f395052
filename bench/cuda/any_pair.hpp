// SPDX-License-Identifier: Apache-2.0
/// The batches of vesica/cuda.cuh for kinds that are known only when the program runs. Compiled apart from its callers,
/// since its kernels take minutes.
#pragma once

#include <cstdint>
#include <vesica/cuda.cuh>

namespace vesica::bench {

/// overlap_many() of arrays in step, a's kind not after b's. T is float or double.
template <class T>
cudaError_t overlap_any(const cuda::Shapes<T>& a, const cuda::Shapes<T>& b, std::uint8_t* out,
                        const cuda::Work& work) noexcept;

/// The other forms, for one pair of kinds.
cudaError_t overlap_tile(const cuda::Shapes<float>& rects, const cuda::Shapes<float>& ellipses, std::uint8_t* out,
                         std::int64_t row_size, const cuda::Work& work) noexcept;
cudaError_t count_tile(const cuda::Shapes<float>& rects, const cuda::Shapes<float>& ellipses, std::uint32_t* out,
                       const cuda::Work& work) noexcept;
cudaError_t overlap_first(const Rect<float>& rect, const cuda::Shapes<float>& ellipses, std::uint8_t* out,
                          const cuda::Work& work) noexcept;

}  // namespace vesica::bench
