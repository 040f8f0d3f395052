// SPDX-License-Identifier: Apache-2.0
// The area of ellipses in double-doubles: half of the time that it takes is the product's error, which is one
// instruction where the processor fuses and a call of the C library elsewhere.
#include "fused.hpp"

#if VESICA_CHOOSES_FUSED
#include "compiled_once.hpp"

namespace vesica::detail::area {

namespace {

/// All that it calls is compiled into it by g++. What clang only calls there, it calls as it is for any processor.
[[gnu::target("fma"), gnu::flatten, gnu::noinline]] double area_in_disc_fused(const Against<DoubleDouble>& f) noexcept {
  return area_in_disc(f);
}

}  // namespace

template <>
double called_area_in_disc(const Against<DoubleDouble>& f) noexcept {
  return has_fused() ? area_in_disc_fused(f) : area_in_disc(f);
}

}  // namespace vesica::detail::area
#endif
