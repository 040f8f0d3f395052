// SPDX-License-Identifier: Apache-2.0
#include "cuda/any_pair.hpp"

#include <vesica/each_shape.hpp>

// One pair shows in less time that this compiles for a device.
#if defined(VESICA_ONE_PAIR)
#define VESICA_ASKED_PAIRS(X) X(rect, Rect, ellipse, Ellipse)
#else
#define VESICA_ASKED_PAIRS(X) VESICA_EACH_PAIR(X)
#endif

namespace vesica::bench {

template <class T>
cudaError_t overlap_any(const cuda::Shapes<T>& a, const cuda::Shapes<T>& b, std::uint8_t* out,
                        const cuda::Work& work) noexcept {
#define VESICA_ASK(a_name, A, b_name, B)                                                                        \
  if (a.kind == static_cast<std::int32_t>(Kind::a_name) && b.kind == static_cast<std::int32_t>(Kind::b_name)) { \
    return cuda::overlap_many<A, B>(a, b, out, work);                                                           \
  }
  VESICA_ASKED_PAIRS(VESICA_ASK)
#undef VESICA_ASK
  return cudaErrorInvalidValue;
}
template cudaError_t overlap_any(const cuda::Shapes<float>&, const cuda::Shapes<float>&, std::uint8_t*,
                                 const cuda::Work&) noexcept;
template cudaError_t overlap_any(const cuda::Shapes<double>&, const cuda::Shapes<double>&, std::uint8_t*,
                                 const cuda::Work&) noexcept;

cudaError_t overlap_tile(const cuda::Shapes<float>& rects, const cuda::Shapes<float>& ellipses, std::uint8_t* out,
                         std::int64_t row_size, const cuda::Work& work) noexcept {
  return cuda::overlap_matrix<Rect, Ellipse>(rects, ellipses, out, row_size, work);
}
cudaError_t count_tile(const cuda::Shapes<float>& rects, const cuda::Shapes<float>& ellipses, std::uint32_t* out,
                       const cuda::Work& work) noexcept {
  return cuda::overlap_counts<Rect, Ellipse>(rects, ellipses, out, work);
}
cudaError_t overlap_first(const Rect<float>& rect, const cuda::Shapes<float>& ellipses, std::uint8_t* out,
                          const cuda::Work& work) noexcept {
  return cuda::overlap_one<Rect, Ellipse>(rect, ellipses, out, work);
}

}  // namespace vesica::bench
