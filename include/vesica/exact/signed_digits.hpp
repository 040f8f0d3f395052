// SPDX-License-Identifier: Apache-2.0
/// Polynomials in long numbers from the top: the digits of a value are formed one after the other, the greatest first,
/// from as many digits of its factors, until no digit below can change its sign. So the digits that cancel take time,
/// and hardly any others, however many there are.
///
/// Digits have signs. Thus a carry goes up by one place at most, and a digit of a sum of products is known once the
/// three columns below it are; thus also long runs of zeros or ones, which lie between numbers far apart, become zeros,
/// and are left out. A. Avizienis, IRE Trans. Electronic Computers EC-10 (1961) 389; M. D. Ercegovac and K. S. Trivedi,
/// IEEE Trans. Computers C-26 (1977) 681.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vesica/exact/number.hpp>

namespace vesica::exact::detail {

/// Places are 57 bits apart: value = sum of digits d * 2^(57 place), |d| <= 2^56 + 1.
using Digit = std::int64_t;
inline constexpr int digit_bits = 57;

/// The sum of products at a column, in units of its place: 128 bits in two's complement. Up to 13,892 products, each
/// counted as often as its factor says, add less than 2^125.8. (The numbers in a sum have 302 digits at most, and its
/// factors add up to 46 at most.)
struct ColumnSum {
  Limb low = 0, high = 0;

  constexpr void add(Digit a, Digit b) noexcept {
    const auto size = [](Digit x) { return static_cast<Limb>(x < 0 ? -x : x); };
    const LimbPair product = multiply_add(size(a), size(b), 0, 0);
    const ColumnSum magnitude{product.low, product.high};
    add((a < 0) != (b < 0) ? magnitude.negated() : magnitude);
  }
  constexpr void add(const ColumnSum& other) noexcept {
    const Limb added = other.low;
    low += added;
    high += other.high + static_cast<Limb>(low < added);
  }
  constexpr ColumnSum negated() const noexcept { return {0 - low, 0 - high - static_cast<Limb>(low != 0)}; }
  constexpr ColumnSum times(int factor) const noexcept {
    const auto size = static_cast<Limb>(factor < 0 ? -factor : factor);
    const LimbPair product = multiply_add(low, size, 0, 0);
    const ColumnSum out{product.low, high * size + product.high};
    return factor < 0 ? out.negated() : out;
  }
  /// On to the next column below.
  constexpr void go_down() noexcept {
    high = high << digit_bits | low >> (64 - digit_bits);
    low <<= digit_bits;
  }
  /// low + middle 2^57 + high 2^114, low and middle from -2^56 to 2^56 - 1.
  struct Digits {
    Digit low, middle, high;
  };
  constexpr Digits digits() const noexcept {
    constexpr Limb half = Limb{1} << (digit_bits - 1), mask = 2 * half - 1;
    constexpr int over = 64 - digit_bits;
    // Half of their ranges added, low and middle are not negative.
    const Limb x = low + half, y = high + (Limb{1} << (2 * digit_bits - 1 - 64)) + static_cast<Limb>(x < half);
    return {static_cast<Digit>((x & mask) - half), static_cast<Digit>(((x >> digit_bits | y << over) & mask) - half),
            static_cast<Digit>(y) >> (2 * digit_bits - 64)};
  }
  constexpr int sign() const noexcept { return high >> 63 != 0 ? -1 : (high | low) != 0 ? 1 : 0; }
  /// Whether it is at least -2^69 and less than 2^69. If not, no column below can change the sign: all of them are less
  /// than 2^68.9. If so, there is room for the next one.
  constexpr bool is_small() const noexcept {
    const auto above = static_cast<std::int64_t>(high) >> 5;
    return above == 0 || above == -1;
  }
  /// As a number, in units of 2^bit.
  VESICA_CALLED constexpr Number<1> number(int bit) const noexcept {
    const ColumnSum size = sign() < 0 ? negated() : *this;
    const int shift = bit & 63;
    const auto over = [shift](Limb x) { return x >> 1 >> (63 - shift); };
    Number<1> out;
    out.sign = sign();
    out.low = (bit - shift) / 64;
    out.size = 3;
    out.limb[0] = size.low << shift;
    out.limb[1] = size.high << shift | over(size.low);
    out.limb[2] = over(size.high);
    out.strip();
    return out;
  }
};

#if defined(__SIZEOF_INT128__)
/// The same while products are added. Compilers keep it in registers, and need not tell signs apart.
class RunningSum {
 public:
  constexpr explicit RunningSum(const ColumnSum& x) noexcept : bits_(Bits{x.high} << 64 | x.low) {}
  constexpr void add(Digit a, Digit b) noexcept { bits_ += static_cast<Bits>(Wide{a} * b); }
  constexpr ColumnSum sum() const noexcept { return {static_cast<Limb>(bits_), static_cast<Limb>(bits_ >> 64)}; }

 private:
  __extension__ using Wide = __int128;
  __extension__ using Bits = unsigned __int128;
  Bits bits_;
};
#else
struct RunningSum : ColumnSum {
  constexpr explicit RunningSum(const ColumnSum& x) noexcept : ColumnSum(x) {}
  constexpr ColumnSum sum() const noexcept { return *this; }
};
#endif

class SignedDigits;

/// A number of any degree, which must outlive this.
struct AnyNumber {
  int sign;
  Span magnitude;

  template <int Degree>
  constexpr AnyNumber(const Number<Degree>& x) noexcept : sign(x.sign), magnitude(x.span()) {}
  template <int Degree>
  AnyNumber(Number<Degree>&&) = delete;
};

/// A product of two numbers, or the square of one, so many times.
struct Term {
  int factor;
  SignedDigits *x, *y;
};

/// A sum of products, column by column from the top.
class Columns {
 public:
  /// Columns are summed so many at a time.
  static constexpr int block = 4;
  using Sums = ColumnSum[block];

  constexpr Columns() noexcept : Columns({}) {}
  constexpr Columns(std::initializer_list<Term> terms) noexcept;

  /// The places of the uppermost column and the lowest one, which is above that if there are no products.
  constexpr int top() const noexcept { return top_; }
  constexpr int bottom() const noexcept { return bottom_; }
  /// The sum at the next column; 0 below the lowest one. Of factors that are sums themselves where `of_sums`.
  template <bool of_sums>
  constexpr ColumnSum next() noexcept {
    if (at_ == block) {
      for (int i = 0; i < count_; ++i) product_[i].template know_factors<of_sums>();
      sum_block();
    }
    return sums_[at_++];
  }

 private:
  static constexpr int most_terms = 3;

  struct Product {
    Term term;
    int depth;                   ///< of the next column, below the uppermost one of this product
    int done_x = 0, done_y = 0;  ///< so many runs of digits are too high for the columns that are left

    /// Whether any product of digits lies at the next columns.
    constexpr bool is_met() const noexcept;
    /// From this depth on a digit of a square meets itself, or one above it, at the next columns.
    constexpr int middle() const noexcept { return depth < 0 ? 0 : (depth + 1) / 2; }
    template <bool are_sums>
    constexpr void know_factors() noexcept;
    constexpr void add_to(Sums& sums) noexcept;
    constexpr void add_square_to(Sums& sums) noexcept;
  };

  constexpr void sum_block() noexcept;

  Product product_[most_terms];
  int count_ = 0, top_ = 0, bottom_ = 1, at_ = block;
  Sums sums_;
};

/// A number by its digits, from the top down as far as they were asked for.
class SignedDigits {
 public:
  /// Digits at depths [first, end) below the top, no two beside each other 0.
  struct Run {
    std::int16_t first, end;
  };
  /// Zeros around the digits, so that all columns of a block can be summed alike.
  static constexpr int padding = Columns::block - 1;

  SignedDigits(const SignedDigits&) = delete;
  SignedDigits& operator=(const SignedDigits&) = delete;

  constexpr bool is_zero() const noexcept { return is_zero_; }
  constexpr int top() const noexcept { return top_; }
  constexpr int bottom() const noexcept { return bottom_; }
  /// The depth of the lowest digit.
  constexpr int last() const noexcept { return top_ - bottom_; }

  /// Makes digits known down to this depth. `may_be_sum`: only then it may be one of products.
  template <bool may_be_sum>
  VESICA_CALLED constexpr void know(int depth) noexcept {
    const int end = depth < last() + padding ? depth : last() + padding;
    if constexpr (may_be_sum) {
      while (is_sum_ && known_ <= end) sum_digit();
    } else {
      assert(!is_sum_);
    }
    while (known_ <= end) limb_digit();
  }
  /// How many are known in all runs.
  constexpr int dense() const noexcept { return dense_; }
  /// The depth of the first digit that is not 0, as far as is known.
  constexpr int lead() const noexcept { return runs_ == 0 ? known_ : run_[0].first; }
  constexpr Digit operator[](int depth) const noexcept { return digit_[depth]; }

  /// Adds the products of digits at depths [first, end) by those of y, to the block of columns from `depth` on. `run`
  /// goes on to the first run that reaches `first`: as columns go down, no run above it is needed again.
  VESICA_CALLED constexpr void add_products(const SignedDigits& y, int depth, int first, int end, int& run,
                                            Columns::Sums& sums) const noexcept {
    while (run < runs_ && run_[run].end <= first) ++run;
    for (int i = run; i < runs_ && run_[i].first < end; ++i) {
      const int from = run_[i].first > first ? run_[i].first : first, to = run_[i].end < end ? run_[i].end : end;
      // Two columns at a time are what the registers hold.
      for (int c = 0; c < Columns::block; c += 2) {
        const Digit* b = y.digit_ + (depth + c - from);
        RunningSum upper(sums[c]), lower(sums[c + 1]);
        for (int k = from; k < to; ++k, --b) {
          upper.add(digit_[k], b[0]);
          lower.add(digit_[k], b[1]);
        }
        sums[c] = upper.sum();
        sums[c + 1] = lower.sum();
      }
    }
  }

 protected:
  /// Of a number in limbs. There is room for the digits, and for half as many runs.
  VESICA_CALLED constexpr SignedDigits(Digit* room, Run* runs, const AnyNumber& x) noexcept
      : SignedDigits(room, runs, place_below(64 * (x.magnitude.low + x.magnitude.size)) + 1,
                     place_below(64 * x.magnitude.low)) {
    is_zero_ = x.sign == 0;
    sign_ = x.sign;
    limbs_ = x.magnitude;
  }
  /// Of a sum of products.
  VESICA_CALLED constexpr SignedDigits(Digit* room, Run* runs, const Columns& columns) noexcept
      : SignedDigits(room, runs, columns.top() + 3, columns.bottom()) {
    is_zero_ = columns.top() < columns.bottom();
    is_sum_ = true;
    columns_ = columns;
  }

 private:
  constexpr SignedDigits(Digit* room, Run* runs, int top, int bottom) noexcept
      : digit_(room + padding), run_(runs), top_(top), bottom_(bottom) {
    for (int i = 0; i < padding; ++i) room[i] = 0;
  }
  static constexpr int place_below(int bit) noexcept {
    return bit >= 0 ? bit / digit_bits : -((digit_bits - 1 - bit) / digit_bits);
  }

  constexpr void append(Digit digit) noexcept {
    digit_[known_] = digit;
    if (digit != 0) {
      if (runs_ == 0 || run_[runs_ - 1].end + 1 < known_) run_[runs_++].first = static_cast<std::int16_t>(known_);
      run_[runs_ - 1].end = static_cast<std::int16_t>(known_ + 1);
      ++dense_;
    }
    ++known_;
  }

  constexpr Limb bits_at(int place) const noexcept {
    const int bit = digit_bits * place - 64 * limbs_.low, limb = limbs_.low + (bit >> 6), shift = bit & 63;
    return (limbs_.at(limb) >> shift | limbs_.at(limb + 1) << 1 << (63 - shift)) & ((Limb{1} << digit_bits) - 1);
  }
  /// Half of a place's range and more is what lacks to the place above, whatever is below.
  constexpr void limb_digit() noexcept {
    const auto lacking = [](Limb bits) { return static_cast<Digit>(bits >> (digit_bits - 1)); };
    const Limb bits = bits_, below = bits_at(top_ - known_ - 1);
    bits_ = below;
    append(sign_ * (static_cast<Digit>(bits) - (lacking(bits) << digit_bits) + lacking(below)));
  }
  /// The sum at a column goes to its place and the two above; then the second of these lacks nothing but the carry of
  /// the first. So the digit three places up is known.
  constexpr void sum_digit() noexcept {
    const auto [low, middle, high] = columns_.next<false>().digits();
    const Digit second = second_ + high, carry = (second + (Digit{1} << (digit_bits - 1))) >> digit_bits;
    append(third_ + carry);
    third_ = second - (carry << digit_bits);
    second_ = first_ + middle;
    first_ = low;
  }

  Digit* digit_;
  Run* run_;
  int top_, bottom_;
  int known_ = 0, runs_ = 0, dense_ = 0;
  bool is_zero_ = true, is_sum_ = false;

  int sign_ = 0;
  Span limbs_{nullptr, 0, 0};
  Limb bits_ = 0;  ///< at the next place

  Columns columns_;
  Digit first_ = 0, second_ = 0, third_ = 0;  ///< what columns so far add at the last one, and above it
};

constexpr Columns::Columns(std::initializer_list<Term> terms) noexcept : product_{} {
  for (const Term& t : terms) {
    if (t.x->is_zero() || t.y->is_zero()) continue;
    const int top = t.x->top() + t.y->top(), bottom = t.x->bottom() + t.y->bottom();
    top_ = count_ == 0 || top > top_ ? top : top_;
    bottom_ = count_ == 0 || bottom < bottom_ ? bottom : bottom_;
    product_[count_++] = {t, top};
  }
  for (int i = 0; i < count_; ++i) product_[i].depth -= top_;
}

constexpr void Columns::sum_block() noexcept {
  at_ = 0;
  for (ColumnSum& sum : sums_) sum = {};
  for (int i = 0; i < count_; ++i) {
    Product& p = product_[i];
    if (p.is_met()) p.term.x == p.term.y ? p.add_square_to(sums_) : p.add_to(sums_);
    p.depth += block;
  }
}

constexpr bool Columns::Product::is_met() const noexcept {
  return depth > -block && depth <= term.x->last() + term.y->last();
}

/// A digit meets none above the other factor's lead; in the middle of a square it meets itself.
template <bool are_sums>
constexpr void Columns::Product::know_factors() noexcept {
  if (!is_met()) return;
  SignedDigits &x = *term.x, &y = *term.y;
  const int lowest = depth + block - 1;
  x.know<are_sums>(lowest - (&x == &y && middle() < y.lead() ? middle() : y.lead()));
  if (&x != &y) y.know<are_sums>(lowest - x.lead());
}

constexpr void Columns::Product::add_to(Sums& sums) noexcept {
  const SignedDigits &x = *term.x, &y = *term.y;
  const auto add = [&](Sums& to) {
    if (x.dense() <= y.dense()) {
      x.add_products(y, depth, depth - y.last(), depth + block, done_x, to);
    } else {
      y.add_products(x, depth, depth - x.last(), depth + block, done_y, to);
    }
  };
  if (term.factor == 1) return add(sums);
  Sums own{};
  add(own);
  for (int i = 0; i < block; ++i) sums[i].add(own[i].times(term.factor));
}

/// Products of different digits once, doubled, and the squares.
constexpr void Columns::Product::add_square_to(Sums& sums) noexcept {
  const SignedDigits& x = *term.x;
  Sums own{};
  x.add_products(x, depth, depth - x.last(), middle(), done_x, own);
  for (int i = 0; i < block; ++i) {
    const int at = depth + i;
    RunningSum different(own[i]);
    for (int k = middle(); 2 * k < at; ++k) different.add(x[k], x[at - k]);
    RunningSum sum(different.sum().times(2));
    if (at >= 0 && at % 2 == 0) sum.add(x[at / 2], x[at / 2]);
    sums[i].add(sum.sum().times(term.factor));
  }
}

/// Room for the digits of values of a degree, or of a lower one: of a number, or a sum of products of numbers.
template <int Degree>
class DigitsOfDegree : public SignedDigits {
 public:
  constexpr explicit DigitsOfDegree(const AnyNumber& x) noexcept : SignedDigits(room_, runs_, x) { check_room(); }
  constexpr DigitsOfDegree(std::initializer_list<Term> terms) noexcept : SignedDigits(room_, runs_, Columns(terms)) {
    check_room();
  }

 private:
  constexpr void check_room() const noexcept { assert(last() + 2 * padding < capacity); }

  static constexpr int capacity = 64 * limb_capacity(Degree) / digit_bits + 2 * padding + Columns::block;
  Digit room_[std::size_t{capacity}];
  Run runs_[std::size_t{capacity / 2 + 1}];
};

/// The columns of a sum of products that tell its sign, and the next two; all of them where it is 0.
class ToldSum {
 public:
  VESICA_CALLED constexpr explicit ToldSum(std::initializer_list<Term> terms) noexcept {
    Columns columns(terms);
    place_ = columns.top() + 1;
    for (; place_ > columns.bottom() && sum_.is_small(); --place_) {
      sum_.go_down();
      sum_.add(columns.next<true>());
    }
    for (ColumnSum& next : next_) next = columns.next<true>();
    is_whole_ = place_ - 2 <= columns.bottom();
  }
  constexpr int sign() const noexcept { return sum_.sign(); }
  /// The number that these columns are.
  constexpr Number<1> number() const noexcept {
    const int bit = digit_bits * place_;
    return sum_.number(bit) + next_[0].number(bit - digit_bits) + next_[1].number(bit - 2 * digit_bits);
  }
  /// Whether there are no others. The columns below are less than 2^missing().
  constexpr bool is_whole() const noexcept { return is_whole_; }
  constexpr int missing() const noexcept { return digit_bits * (place_ - 2) + 69; }

 private:
  ColumnSum sum_, next_[2];
  int place_;  ///< of the lowest column in the sum
  bool is_whole_;
};

}  // namespace vesica::exact::detail
