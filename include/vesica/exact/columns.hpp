// SPDX-License-Identifier: Apache-2.0
/// The sign of a b - c^2 from the top: products of limbs are added up column by column, as by hand, until what is left
/// cannot change it. So the digits that cancel cost time, and hardly any others.
#pragma once

#include <vesica/exact/limbs.hpp>

namespace vesica::exact::detail {

/// A sum of products of limbs in two's complement, of 192 bits, in units of a column's place.
struct ColumnSum {
  Limb low = 0, middle = 0, high = 0;

  constexpr void add(Limb a, Limb b) noexcept {
    const LimbPair sum = multiply_add(a, b, low, 0);
    low = sum.low;
    middle += sum.high;
    high += middle < sum.high;
  }
  /// The products of limbs of a and b that lie at `column` of the grid.
  constexpr void add(const Span& a, const Span& b, int column) noexcept {
    const int k = column - a.low - b.low, last = k < a.size ? k : a.size - 1;
    for (int i = k < b.size ? 0 : k - b.size + 1; i <= last; ++i) add(a.limb[i], b.limb[k - i]);
  }
  /// The same of a by itself. Each product of different limbs is formed once.
  constexpr void add_square(const Span& a, int column) noexcept {
    const int k = column - 2 * a.low;
    ColumnSum different;
    for (int i = k < a.size ? 0 : k - a.size + 1; 2 * i < k; ++i) different.add(a.limb[i], a.limb[k - i]);
    add(different);
    add(different);
    if (k >= 0 && k % 2 == 0 && k / 2 < a.size) add(a.limb[k / 2], a.limb[k / 2]);
  }
  constexpr void add(const ColumnSum& other) noexcept {
    low += other.low;
    const Limb carry = low < other.low, added = other.middle + carry;
    middle += added;
    high += other.high + static_cast<Limb>(added < carry) + static_cast<Limb>(middle < added);
  }
  constexpr void subtract(const ColumnSum& other) noexcept {
    const Limb borrow = low < other.low, taken = other.middle + borrow;
    high -= other.high + static_cast<Limb>(taken < borrow) + static_cast<Limb>(middle < taken);
    middle -= taken;
    low -= other.low;
  }
  /// On to the next column below.
  constexpr void go_down() noexcept {
    high = middle;
    middle = low;
    low = 0;
  }
  constexpr ColumnSum negated() const noexcept {
    ColumnSum out;
    out.subtract(*this);
    return out;
  }
  constexpr int sign() const noexcept { return high >> 63 != 0 ? -1 : (high | middle | low) != 0 ? 1 : 0; }
  /// Whether it is at least -2^76, and less than 2^76.
  constexpr bool is_small() const noexcept {
    const Limb above = middle >> 12;
    return high == 0 ? above == 0 : high == ~Limb{0} && above == ~Limb{0} >> 12;
  }
};

/// Whether so many columns are worth while: of short numbers whole products are as quick then; of long ones n columns
/// take 3/4 n^2 products, and should take fewer than half of what whole products do.
constexpr bool are_worth_while(int columns, const Span& a, const Span& b) noexcept {
  constexpr int always = 96;
  return columns <= always || 2 * columns * columns < a.size * b.size;
}

/// a b - c^2, of numbers of at most 1024 limbs, down to the column `last` of the grid. False where so many digits
/// cancel that the columns do not tell its sign. What the columns below add to either product is less than 1024 * 2^64
/// at a column: so a sum that is not small decides, and one that is has room for the next column.
constexpr bool columns_tell(ColumnSum& sum, int& last, const Span& a, const Span& b, const Span& c) noexcept {
  const int top_of_product = a.low + a.size + b.low + b.size, top_of_square = 2 * (c.low + c.size);
  const int bottom = a.low + b.low < 2 * c.low ? a.low + b.low : 2 * c.low;
  const int top = (top_of_product > top_of_square ? top_of_product : top_of_square) - 2;
  for (int column = top; column >= bottom && sum.is_small(); --column) {
    if (!are_worth_while(top - column + 1, a, b)) return false;
    last = column;
    sum.go_down();
    sum.add(a, b, column);
    ColumnSum square;
    square.add_square(c, column);
    sum.subtract(square);
  }
  return true;
}
/// Its sign alone.
constexpr bool columns_tell(int& sign, const Span& a, const Span& b, const Span& c) noexcept {
  ColumnSum sum;
  int last = 0;
  const bool tell = columns_tell(sum, last, a, b, c);
  sign = sum.sign();
  return tell;
}

}  // namespace vesica::exact::detail
