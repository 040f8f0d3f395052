// SPDX-License-Identifier: Apache-2.0
// Limb arithmetic of exact/number.hpp: against GMP, and without 128-bit integers against with.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>
#include <vesica/exact/number.hpp>

#include "exact/portable_limbs.hpp"
#include "properties/random.hpp"

namespace {

namespace detail = vesica::exact::detail;
using vesica::exact::Limb;

/// Random, short, or full of ones: carries run far.
Limb any_limb(properties::Random& random) {
  const Limb limb = random.bits();
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return ~Limb{0};
    case 2:
      return limb >> random.below(64);
    case 3:
      return ~Limb{0} << random.below(64);
    default:
      return limb;
  }
}

std::vector<Limb> any_limbs(properties::Random& random, int most) {
  std::vector<Limb> limbs(static_cast<std::size_t>(random.integer(1, most)));
  for (Limb& limb : limbs) limb = any_limb(random);
  return limbs;
}

mpz_class integer(const Limb* limbs, std::size_t n) {
  mpz_class value;
  mpz_import(value.get_mpz_t(), n, -1, sizeof(Limb), 0, 0, limbs);
  return value;
}
mpz_class integer(const std::vector<Limb>& limbs) { return integer(limbs.data(), limbs.size()); }

TEST(Limbs, PortableMultiplyAddOfLandmarks) {
  constexpr std::array<Limb, 9> landmarks{
      0, 1, 0xffffffff, 0x100000000, 0x1ffffffff, Limb{1} << 63, (Limb{1} << 63) - 1, 0xffffffff00000000, ~Limb{0}};
  for (const Limb a : landmarks) {
    for (const Limb b : landmarks) {
      for (const Limb c : landmarks) {
        for (const Limb d : landmarks) {
          const auto wide = detail::multiply_add(a, b, c, d);
          const auto sum = portable::multiply_add(a, b, c, d);
          ASSERT_EQ(sum.low, wide.low) << a << " " << b << " " << c << " " << d;
          ASSERT_EQ(sum.high, wide.high) << a << " " << b << " " << c << " " << d;
        }
      }
    }
  }
  // (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1
  const auto most = portable::multiply_add(~Limb{0}, ~Limb{0}, ~Limb{0}, ~Limb{0});
  EXPECT_EQ(most.low, ~Limb{0});
  EXPECT_EQ(most.high, ~Limb{0});
}

TEST(Limbs, PortableMultiplyAdd) {
  properties::Random random(properties::seed());
  for (int i = 0; i < 200'000 * properties::repeat(); ++i) {
    const Limb a = any_limb(random), b = any_limb(random), c = any_limb(random), d = any_limb(random);
    const auto wide = detail::multiply_add(a, b, c, d);
    const auto sum = portable::multiply_add(a, b, c, d);
    ASSERT_TRUE(sum.low == wide.low && sum.high == wide.high)
        << a << " " << b << " " << c << " " << d << ", seed " << properties::seed();
  }
}

TEST(Limbs, Multiply) {
  properties::Random random(properties::seed());
  for (int i = 0; i < 10'000 * properties::repeat(); ++i) {
    const std::vector<Limb> a = any_limbs(random, 40), b = any_limbs(random, 40);
    std::vector<Limb> product(a.size() + b.size(), 0x5555), again = product;
    const int na = static_cast<int>(a.size()), nb = static_cast<int>(b.size());
    detail::multiply(a.data(), na, b.data(), nb, product.data());
    portable::multiply(a.data(), na, b.data(), nb, again.data());
    ASSERT_EQ(integer(product), integer(a) * integer(b)) << "seed " << properties::seed();
    ASSERT_EQ(again, product) << "seed " << properties::seed();
  }
}

TEST(Limbs, MultiplyByItself) {
  properties::Random random(properties::seed());
  for (int i = 0; i < 10'000 * properties::repeat(); ++i) {
    const std::vector<Limb> a = any_limbs(random, 40);
    std::vector<Limb> square(2 * a.size(), 0x5555), again = square;
    detail::multiply_by_itself(a.data(), static_cast<int>(a.size()), square.data());
    portable::multiply_by_itself(a.data(), static_cast<int>(a.size()), again.data());
    ASSERT_EQ(integer(square), integer(a) * integer(a)) << "seed " << properties::seed();
    ASSERT_EQ(again, square) << "seed " << properties::seed();
  }
}

}  // namespace
