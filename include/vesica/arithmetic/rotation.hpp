// SPDX-License-Identifier: Apache-2.0
/// Sine and cosine of an angle in radians. The last digits of the C library's differ between systems; these give the
/// same bits everywhere.
#pragma once

namespace vesica::detail::arithmetic {

/// Sine and cosine of one angle.
struct Rotation {
  double cosine, sine;
};

/// The largest angle that rotation() takes.
inline constexpr double most_radians = 0x1p20;

/// Both are within 4u of the truth, u = 2^-53, for |angle| <= most_radians. Proof, in units of u:
///
///   - Quarter turns are taken out. The two upper parts of pi / 2 have 33 bits and the count has at most 20, so their
///     products are exact. The lower part is off by 2^-122, times 2^20 that is nothing. Three differences below 1 are
///     rounded: what is left, at most 0.79, is off by 1.5.
///   - Taylor's series of sine up to x^17 leaves out less than 0.79^19 / 19! < 2^-63, cosine's up to x^18 less
///     than 0.79^20 / 20! < 2^-67. Each ends in x + x s or 1 + c. s is below 0.11 and c below 0.32, both right to 4u of
///     themselves, and the sum rounds by 0.5: with what is left over less than 3 of sine, and less than 4 of cosine.
inline Rotation rotation(double angle) noexcept {
  constexpr double upper = 0x1.921fb544p+0, middle = 0x1.0b4611a6p-34, lower = 0x1.3198a2e037073p-69;
  const double count = (angle * 0x1.45f306dc9c883p-1 + 0x1.8p52) - 0x1.8p52;
  const double x = ((angle - count * upper) - count * middle) - count * lower, y = x * x;
  const double s =
      y * (-1.0 / 6 +
           y * (1.0 / 120 +
                y * (-1.0 / 5040 +
                     y * (1.0 / 362880 +
                          y * (-1.0 / 39916800 +
                               y * (1.0 / 6227020800 + y * (-1.0 / 1307674368000 + y * (1.0 / 355687428096000))))))));
  const double c =
      y * (-0.5 + y * (1.0 / 24 + y * (-1.0 / 720 +
                                       y * (1.0 / 40320 +
                                            y * (-1.0 / 3628800 +
                                                 y * (1.0 / 479001600 + y * (-1.0 / 87178291200 +
                                                                             y * (1.0 / 20922789888000 +
                                                                                  y * (-1.0 / 6402373705728000)))))))));
  const double sine = x + x * s, cosine = 1 + c;
  const int quarters = static_cast<int>(count) & 3;
  const double first = (quarters & 1) != 0 ? sine : cosine, second = (quarters & 1) != 0 ? cosine : sine;
  return {quarters == 1 || quarters == 2 ? -first : first, quarters >= 2 ? -second : second};
}

}  // namespace vesica::detail::arithmetic
