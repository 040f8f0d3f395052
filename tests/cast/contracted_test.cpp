// SPDX-License-Identifier: Apache-2.0
/// The header compiled by whom sums and products may be fused: for processors with fused multiply-adds g++ does so
/// unless it is told otherwise. The time is the greatest double before contact all the same. Expected times are from
/// rational arithmetic: there is no contact before them, and some before the next double.
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>
#include <vesica/cast.hpp>

#include "properties/random.hpp"
#include "vesica.h"

namespace {

using vesica::Circle;
using vesica::Ellipse;
using vesica::Point;
using vesica::Rect;
using vesica::Segment;

constexpr double forever = std::numeric_limits<double>::infinity();

#if defined(VESICA_HAS_FUSED)
TEST(ContractedCast, FusedDifference) {
  const double x = 1 + 0x1p-30, y = 1 - 0x1p-30;
  EXPECT_EQ(vesica::lane::fused_difference(x, x, 1 + 0x1p-29), 0x1p-60);
  EXPECT_EQ(vesica::lane::fused_difference(x, y, 1), -0x1p-60);
}
#endif

// All numbers are such that products are not fused ones: sizes or speeds are below 2^-40.

TEST(ContractedCast, RayAtADisc) {
  const Circle<double> disc{0x1.c840f69ec1f8p+6, 0x1.cc87eb6e7f948p+11, 0x1.99e9964268ca6p+11};
  const Point<double> from{-0x1.3519c1e2934d8p+14, -0x1.6a70b8377aa44p+15};
  EXPECT_EQ(vesica::cast(disc, from, 0x1.29779568f97afp-46, 0x1.3cad3bb718027p-45, forever).t, 0x1.3375700e2ae08p+60);
}

TEST(ContractedCast, RayAtARectangle) {
  const Rect<double> rect{0x1.c6bf52633ffffp+10, -0x1.10d9316ebfff3p+9, -0x1.3711544e16008p-2,
                          0x1.8608c86298edep-1,  0x1.6888b8addd214p-41, 0x1.4de75a49154fp-43};
  const Point<double> from{0x1.c6bf52633fffap+10, -0x1.10d9316ebfff7p+9};
  EXPECT_EQ(vesica::cast(rect, from, 0x1.104c148242af3p-12, 0x1.f0c6d4210213ep-13, forever).t, 0x1.ccc558fce49afp-29);
}

TEST(ContractedCast, RayAtASegment) {
  const Segment<double> segment{0x1.fac0d35bb85d8p-2, -0x1.0a58982793184p-1, 0x1.fac0d35bb8324p-2,
                                -0x1.0a58982792f4ap-1};
  const Point<double> from{0x1.316d44ea5e506p+0, -0x1.52219d5016c22p+0};
  EXPECT_EQ(vesica::cast(segment, from, -0x1.a243b3b1e3eb9p-3, 0x1.df9efd6f0cc79p-3, forever).t, 0x1.b596fb7c80f55p+1);
}

TEST(ContractedCast, TwoDiscs) {
  const Circle<double> a{0x1.e82868811808p-4, 0x1.e71bbade70634p-1, 0x1.6bf34fc4d536p-3};
  const Circle<double> b{-0x1.1c3e47c0f21d5p+4, -0x1.be67346d1c165p+2, 0x1.aa9cc2af0f5cp-44};
  EXPECT_EQ(vesica::cast(a, b, 0x1.3b41788ab18ddp+3, 0x1.109ea30930ca6p+2, forever).t, 0x1.d28a29b9cedebp+0);
  // No contact by the double after it, and contact by the one after that.
  EXPECT_EQ(vesica::cast(a, b, 0x1.3b41788ab18ddp+3, 0x1.109ea30930ca6p+2, 0x1.d28a29b9cedebp+0).t, forever);
  EXPECT_EQ(vesica::cast(a, b, 0x1.3b41788ab18ddp+3, 0x1.109ea30930ca6p+2, 0x1.d28a29b9cedecp+0).t,
            0x1.d28a29b9cedebp+0);
}

/// The same as of the library, to the bit.
template <class B>
void expect_as_in_library(const Rect<double>* rect, const Ellipse<double>* ellipse, const B& b, double vx, double vy) {
  const auto expect = [&](const auto& a, std::int32_t kind) {
    vesica::Impact<double> here{};
    vesica_impact_f64 there{};
    const std::int32_t kind_b = std::is_same_v<B, Rect<double>> ? VESICA_RECT : VESICA_ELLIPSE;
    const std::int32_t code = vesica::cast_or_error(a, b, vx, vy, forever, here);
    ASSERT_EQ(code, vesica_cast_f64(kind, &a, kind_b, &b, vx, vy, forever, &there));
    if (code == vesica::cast_hit) {
      EXPECT_EQ(here.t, there.t);
    }
  };
  if (rect != nullptr) expect(*rect, VESICA_RECT);
  if (ellipse != nullptr) expect(*ellipse, VESICA_ELLIPSE);
}

TEST(ContractedCast, BoxesAndEllipses) {
  EXPECT_EQ(vesica::cast(Rect<double>{0, 0, 1, 0, 1, 1}, Ellipse<double>{8, 0.25, 1, 0, 2, 1}, -1, 0, forever).t, 5);
  EXPECT_EQ(vesica::cast(Ellipse<double>{8, 0.25, 0, 1, 1, 2}, Rect<double>{0, 0, 1, 0, 1, 1}, 1, 0, forever).t, 5);
  properties::Random random(properties::seed());
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const auto whole = [&] { return static_cast<double>(random.integer(-4, 4)); };
    const auto size = [&] { return random.chance(0.5) ? random.integer(1, 3) : random.between(0x1p-20, 3); };
    const double far_x = random.integer(6, 12), y = random.chance(0.5) ? whole() : random.between(-5, 5);
    const Rect<double> box{0, whole(), 1 + random.unit(), whole(), size(), size()},
        other{far_x, y, 1, random.unit(), size(), size()};
    const Ellipse<double> e{0, 0, 1, random.unit(), size(), size()}, f{far_x, y, 1, whole(), size(), size()};
    const double vx = -size(), vy = random.chance(0.3) ? 0 : random.between(-1, 1);
    expect_as_in_library(&box, &e, f, vx, vy);
    expect_as_in_library(&box, &e, other, vx, vy);
  }
}

#if defined(VESICA_HAS_FUSED)
/// Fused products do not suffice where the direction has next to no component across v.
TEST(ContractedCast, MeetingsWithAndWithoutFusedProducts) {
  using namespace vesica::detail::cast;
  const auto meets = [](const auto& a, const auto& b, double vx, double vy, double& t) {
    Scene scene;
    set_scene(body(a), body(b), {vx, vy, forever}, scene);
    EXPECT_TRUE(has_fused_products(scene));
    Meeting met;
    const bool found = fused_meeting(scene, met);
    t = met.found.time.value.high;
    return found;
  };
  double t = 0;
  const Rect<double> box{0, 0, 1, 0, 1, 1};
  EXPECT_TRUE(meets(box, Ellipse<double>{8, 3 - 0x1p-45, 1, 0, 2, 2}, -1, 0, t));
  EXPECT_NEAR(t, 7, 0x1p-20);
  EXPECT_TRUE(meets(box, Rect<double>{8, 0, 1, 0, 2, 2}, -1, 0, t));
  EXPECT_EQ(t, 5);
  const Ellipse<double> disc{0, 0, 1, 0, 2, 2}, far{8, -0x1.0004p-36, 1, 0, 1, 1};
  EXPECT_FALSE(meets(disc, far, -1, 0x1p-39, t));
  expect_as_in_library(nullptr, &disc, far, -1, 0x1p-39);
  // Neither, for a corner at a small disc.
  const Rect<double> turned{0, 0, 1, 1, 1, 1};
  const Ellipse<double> small{8, -0x1.8p-37 - 0x1p-86, 1, 0, 0x1p-33, 0x1p-33};
  EXPECT_FALSE(meets(turned, small, -1, 0x1p-39, t));
  expect_as_in_library(&turned, nullptr, small, -1, 0x1p-39);
}
#endif

}  // namespace
