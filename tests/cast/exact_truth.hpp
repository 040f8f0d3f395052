// SPDX-License-Identifier: Apache-2.0
/// One cast against the rational oracle: hit or miss, and that the time is the last double before contact.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "cast/face.hpp"
#include "oracle/motion.hpp"

namespace cast_test {

/// Returns the library's code. Two shapes with round outlines would take the oracle too long.
inline std::int32_t expect_exact(const Pair& p, const Motion& m) {
  SCOPED_TRACE(describe(p, m));
  const auto meets = [&](double time, int less = 0) {
    return oracle::meets(p.kind_a, p.a.data(), p.kind_b, p.b.data(), {m.vx, m.vy, time, less});
  };
  // A time of polygons that differs from a double differs by more than this share of it.
  constexpr int precision = 8000;
  const Answer r = cast(Scalar::f64, p, m);
  const bool start = meets(0);
  EXPECT_EQ(r.code, start ? VESICA_CAST_START : meets(m.end) ? VESICA_CAST_HIT : VESICA_CAST_MISS);
  if (r.code != VESICA_CAST_HIT) return r.code;
  EXPECT_TRUE(r.t == 0 || !meets(r.t, precision)) << std::hexfloat << r.t;
  EXPECT_TRUE(meets(r.t) || meets(std::nextafter(r.t, infinity), precision)) << std::hexfloat << r.t;
  return r.code;
}

}  // namespace cast_test
