// SPDX-License-Identifier: Apache-2.0
// Zeros of quartics: how many are found and how narrowly, and how much of that is known from doubles alone. Where less
// is known the search is slower and still right; where more is known a bound is narrower than its proof, or there is a
// better proof, which is a reason to write other numbers here. The quartics are the same everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vesica/crossings/quartic_zeros.hpp>

#include "crossings/quartics.hpp"
#include "properties/random.hpp"

namespace zeros_test {
namespace {

using namespace vesica::detail::crossings;
using properties::Random;

/// Fixed: the numbers below are of these quartics.
constexpr std::uint64_t seed = 5;
constexpr int count = 4000;

/// Products of (t - z), or of pairs of complex ones (t - z)^2 + w^2, over 2^down: the zeros in groups of any width.
Quartic draw(Random& random, int down) {
  double power[5] = {1, 0, 0, 0, 0};
  const double centre = random.between(-0.25, 1.25);
  const int narrow = random.integer(1, 45);
  const double spread = std::ldexp(random.unit(), -narrow);
  const auto zero = [&](bool in_group) {
    return in_group ? centre + spread * random.between(-1, 1) : random.between(-3, 3);
  };
  const int in_group = random.integer(0, 4), pairs = random.below(3);
  for (int i = 0; i < 4;) {
    const double z = zero(i < in_group);
    const bool is_pair = i / 2 < pairs && i < 3;
    const double w = !is_pair ? 0 : (i < in_group ? spread : 3) * random.unit();
    const double factor[] = {is_pair ? z * z + w * w : -z, is_pair ? -2 * z : 1, 1};
    const int degree = is_pair ? 2 : 1;
    double next[5] = {};
    for (int j = 0; j <= i; ++j) {
      for (int k = 0; k <= degree; ++k) next[j + k] += power[j] * factor[k];
    }
    std::copy(next, next + 5, power);
    i += degree;
  }
  return crossings_test::quartic_of_powers(power, down);
}

/// By half widths from 1 down to 2^-120.
int bits_of(const Real& from, const Real& to) {
  const double width = rounded(to - from);
  return width > 0 ? std::clamp(-std::ilogb(width), 0, 120) : 120;
}

/// Each in a quarter of the outline, and the same half a turn on.
TEST(ZerosOfQuartics, SpotsAreAsNarrow) {
  Random random(seed);
  std::array<int, 6> found{};  // spots, zeros in them, bits of their widths; of either sign before; bits of heights
  for (int i = 0; i < 10 * count; ++i) {
    const Quartic q = draw(random, random.integer(20, 340));
    Spots spots, opposite, alone;
    ZeroSearch(q, 1, spots, &opposite);
    ZeroSearch(q, 1, alone, nullptr);
    ASSERT_EQ(spots.count, opposite.count);
    ASSERT_EQ(spots.count, alone.count);
    found[0] += spots.count;
    bool negative = q.coefficient[0].negative();
    for (int k = 0; k < spots.count; ++k) {
      const Spot &s = spots.spot[k], &other = opposite.spot[k];
      EXPECT_EQ(rounded(s.from - alone.spot[k].from), 0);
      EXPECT_LT(std::fabs(rounded(other.from - s.from - Real(2))), 0x1p-90);
      EXPECT_LT(std::fabs(rounded(other.to - s.to - Real(2))), 0x1p-90);
      EXPECT_TRUE(rounded(s.from) >= 1 && rounded(s.to) <= 2 && rounded(s.to - s.from) >= 0);
      EXPECT_TRUE(k == 0 || rounded(s.from - spots.spot[k - 1].to) >= 0) << "in order";
      // Between spots there is no zero.
      if (s.most < 4 && i < 5 * count) {
        EXPECT_TRUE(s.negative_before == negative || q.coefficient[0].negligible());
      }
      negative = s.negative_after;
      found[1] += s.most;
      found[2] += bits_of(s.from, s.to);
      found[3] += s.negative_before;
      found[4] += s.negative_after;
      found[5] += s.height > 0 ? std::min(-std::ilogb(s.height), 400) : 0;
    }
  }
  EXPECT_EQ(found, (std::array<int, 6>{30490, 45532, 2368780, 13939, 12725, 519689}));
}

/// The sign of the value at t, a multiple of 2^-53 above 0; 0 where it is negligible.
int sign_at(const Quartic& q, double t) {
  Quartic before = q;
  if (t < 1) part(q, 0, static_cast<vesica::exact::Limb>(t * 0x1p64), Fixed::limbs, before);
  const Fixed& value = before.coefficient[4];
  return value.negligible() ? 0 : value.negative() ? -1 : 1;
}

/// Next to the separating points, and elsewhere, the value has the sign that these imply.
TEST(ZerosOfQuartics, NoneIsBesideSpots) {
  Random random(properties::seed());
  int told = 0;
  for (int i = 0; i < 100000 * properties::repeat(); ++i) {
    const Quartic q = draw(random, random.integer(20, 340));
    Spots spots;
    if (random.chance(0.5)) spots.shortest = 0x1p-64;
    ZeroSearch(q, 0, spots, nullptr);
    if (spots.is_full()) continue;
    for (int k = 0; k < 4; ++k) {
      double t = random.unit();
      if (spots.count > 0 && k > 0) {
        const Spot& s = spots.spot[random.below(spots.count)];
        t = rounded(k == 1 ? s.from : s.to) + (k == 1 ? -1 : 1) * std::ldexp(random.unit(), -random.integer(0, 50));
      }
      t = std::floor(t * 0x1p53) * 0x1p-53;
      if (!(t > 0 && t <= 1)) continue;
      const auto ends_after = [t](const Spot& s) { return rounded(s.to - Real(t)) > -0x1p-60; };
      const auto after = std::find_if(spots.spot, spots.spot + spots.count, ends_after);
      const bool is_last = after == spots.spot + spots.count;
      if (!is_last && rounded(after->from - Real(t)) < 0x1p-60) continue;  // within a spot
      const bool negative = is_last ? q.coefficient[4].negative() : after->negative_before;
      const int sign = sign_at(q, t);
      const bool is_certain = is_last ? !q.coefficient[4].negligible() : after->is_certain_before;
      if (sign == 0 || !is_certain) continue;
      ++told;
      ASSERT_EQ(sign < 0, negative) << i << ' ' << t;
    }
  }
  EXPECT_GT(told, 100000 * properties::repeat());
}

/// The facts about a quartic that doubles decide.
TEST(ZerosOfQuartics, DoublesTellAsMuch) {
  Random random(seed + 1);
  std::array<int, 5> far{}, reach{}, certain{}, zeros{};
  for (int i = 0; i < count; ++i) {
    const Quartic q = draw(random, i % 4 == 0 ? random.integer(250, 340) : random.integer(20, 250));
    const Local local(q);
    for (int k = 1; k <= 4; ++k) {
      const auto at = static_cast<std::size_t>(k);
      far[at] += local.is_far_reaching(k);
      const double t = local.zero_of_derivative(k - 1), r = local.reach(k, t);
      EXPECT_TRUE(t >= 0 && t <= 1);
      EXPECT_FALSE(local.is_far_reaching(k) && r < 0x1p-5) << "what is far by little work is far";
      reach[at] += r < 1 ? std::clamp(-std::ilogb(r), 0, 60) : 0;
      zeros[at] += t > 0 && t < 1;
    }
    for (int k = 0; k <= 16; ++k) certain[0] += local.certain_value(k / 16.0) != 0;
    for (int k = 1; k <= 40; ++k) {
      certain[1] += local.certain_value(local.zero_of_derivative(0) + std::ldexp(1, -k - 2)) != 0;
    }
    certain[2] += local.height() > 0 ? std::clamp(-std::ilogb(local.height()), 0, 400) : 0;
  }
  EXPECT_EQ(far, (std::array<int, 5>{0, 38, 213, 638, 2313}));
  EXPECT_EQ(reach, (std::array<int, 5>{0, 35795, 16614, 2633, 6402}));
  EXPECT_EQ(certain, (std::array<int, 5>{51220, 120342, 739654, 0, 0}));
  EXPECT_EQ(zeros, (std::array<int, 5>{0, 892, 2033, 1217, 1972}));
}

}  // namespace
}  // namespace zeros_test
