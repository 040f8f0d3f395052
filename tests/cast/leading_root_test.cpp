// SPDX-License-Identifier: Apache-2.0
/// Square roots to as many digits as a number has: the number is between the squares of what the error allows, and the
/// error is of the last digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vesica/cast/leading_root.hpp>

#include "properties/random.hpp"

namespace {

using vesica::detail::cast::Digits;
using vesica::detail::cast::Leading;
using vesica::exact::from_double;

/// 2^exponent.
template <int limbs>
Leading<limbs> power(std::int64_t exponent) {
  Leading<limbs> x;
  x.sign = 1;
  const std::int64_t limb = exponent >= 0 ? exponent / 64 : -((63 - exponent) / 64);
  x.low = static_cast<std::int32_t>(limb) - (limbs - 1);
  x.limb[limbs - 1] = std::uint64_t{1} << (exponent - 64 * limb);
  return x;
}

template <int limbs>
Leading<limbs> draw(properties::Random& random) {
  Leading<limbs> x;
  x.sign = 1;
  x.low = random.integer(-60, 60);
  for (auto& limb : x.limb) limb = random.chance(0.8) ? random.bits() : 0;
  x.limb[limbs - 1] = (random.bits() >> random.below(64)) | 1;
  return x;
}

template <int limbs>
Digits digits(const Leading<limbs>& a) {
  Digits x;
  x.limbs = limbs;
  x.set(a.sign, a.span());
  x.error = a.error;
  return x;
}
template <int limbs>
Leading<limbs> leading(const Digits& a) {
  Leading<limbs> x;
  x.set(a.sign, a.span());
  x.error = a.error;
  return x;
}

/// a, of which 2^error may be missing.
template <int limbs>
void check(const Leading<limbs>& a) {
  const Leading<limbs> x = leading<limbs>(vesica::detail::cast::root(digits(a)));
  ASSERT_EQ(x.sign, 1);
  // Exactly, in twice as many digits.
  const auto exactly = [](const Leading<limbs>& number) {
    Leading<2 * limbs + 8> out;
    out.set(1, number.span());
    return out;
  };
  if (x.error == x.nothing) {
    EXPECT_EQ((square(exactly(x)) - exactly(a)).sign, 0);
    return;
  }
  // As precise as a, but for some bits.
  const std::int64_t of_a = a.error == a.nothing ? 64 * limbs : std::min<std::int64_t>(a.top() - a.error, 64 * limbs);
  EXPECT_LT(x.error - x.top(), 80 - of_a);
  const auto middle = exactly(x), most = power<2 * limbs + 8>(x.error);
  const auto low = middle - most, high = middle + most;
  const auto below = a.error == a.nothing ? exactly(a) : exactly(a) - power<2 * limbs + 8>(a.error);
  const auto above = a.error == a.nothing ? exactly(a) : exactly(a) + power<2 * limbs + 8>(a.error);
  EXPECT_LE((square(low) - below).sign, 0);
  EXPECT_GE((square(high) - above).sign, 0);
}

template <int limbs>
void check_many() {
  properties::Random random(properties::seed() + 53);
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    Leading<limbs> a = draw<limbs>(random);
    check(a);
    a.error = a.top() - random.integer(80, 64 * limbs + 40);
    check(a);
  }
  check(Leading<limbs>(from_double(1)));
  check(Leading<limbs>(from_double(2)));
  check(Leading<limbs>(from_double(0x1p-1074)));
  check(Leading<limbs>(from_double(0x1.fffffffffffffp+1023)));
}

TEST(LeadingRoot, Of6Limbs) { check_many<6>(); }
TEST(LeadingRoot, Of12Limbs) { check_many<12>(); }
TEST(LeadingRoot, Of24Limbs) { check_many<24>(); }

}  // namespace
