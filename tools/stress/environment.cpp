// SPDX-License-Identifier: Apache-2.0
#include "stress/environment.hpp"

namespace stress {

std::span<const Environment> environments() {
#if defined(__x86_64__)
  constexpr unsigned daz = 0x0040, down = 0x2000, up = 0x4000, zero = 0x6000, ftz = 0x8000;
  static constexpr Environment all[] = {{"ftz", ftz}, {"daz", daz},   {"ftz+daz", ftz | daz},
                                        {"up", up},   {"down", down}, {"zero", zero}};
  return all;
#else
  return {};
#endif
}

}  // namespace stress
