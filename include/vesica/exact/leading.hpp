// SPDX-License-Identifier: Apache-2.0
/// The leading digits of long numbers. Nearly always they decide the sign of a polynomial, in a small part of the time
/// that all digits take. If they do not, all digits are used.
#pragma once

#include <cstddef>
#include <vesica/exact/number.hpp>
#include <vesica/exact/signed_digits.hpp>

namespace vesica::exact {

/// A number to 64 limbs - 63 binary digits or more.
template <int count>
struct Leading {
  static constexpr int limbs = count;
  static constexpr std::int64_t nothing = -(std::int64_t{1} << 40);

  std::int32_t sign = 0;
  std::int32_t low = 0;                ///< the place of the first limb
  std::int64_t error = nothing;        ///< the number is less than 2^error away, or `nothing` is missing
  Limb limb[std::size_t{limbs}] = {};  ///< the last one not zero, unless the sign is 0

  constexpr Leading() noexcept = default;
  template <int Degree>
  constexpr explicit Leading(const Number<Degree>& x) noexcept {
    if (x.sign != 0) set(x.sign, x.span());
  }
  constexpr explicit Leading(const detail::AnyNumber& x) noexcept {
    if (x.sign != 0) set(x.sign, x.magnitude);
  }
  /// Of a magnitude that may begin with zeros.
  constexpr void set(int its_sign, detail::Span x) noexcept {
    while (x.size > 0 && x.limb[x.size - 1] == 0) --x.size;
    if (x.size == 0) return;
    sign = its_sign;
    low = x.low + x.size - limbs;
    for (int i = 0; i < limbs; ++i) limb[i] = x.at(low + i);
    for (int i = 0; i < x.size - limbs; ++i) {
      if (x.limb[i] != 0) return lose(std::int64_t{64} * low);
    }
  }

  constexpr void lose(std::int64_t exponent) noexcept { error = (error > exponent ? error : exponent) + 1; }
  /// A sum with an error of nothing is below half of that.
  constexpr void lose_if_any(std::int64_t exponent) noexcept {
    if (exponent > nothing / 2) lose(exponent);
  }
  /// As a product.
  constexpr void lose_factors(const Leading& a, const Leading& b) noexcept {
    lose_if_any(a.top() + b.error);
    lose_if_any(b.top() + a.error);
    lose_if_any(a.error + b.error);
  }

  /// Products are formed from here on, one limb more than is kept at least.
  static constexpr int first_formed = limbs - 2;
  /// What multiply() leaves out below that, of factors that are not 0.
  constexpr void lose_unformed(const Leading& a, const Leading& b) noexcept {
    static_assert(first_formed % 2 == 0 && first_formed < 64);
    if (a.lowest() + b.lowest() < first_formed) lose(std::int64_t{64} * (a.low + b.low + first_formed + 1) + 6);
  }

  /// Its magnitude is less than 2^top, and at least half of that unless it is 0.
  constexpr std::int64_t top() const noexcept {
    return sign == 0 ? nothing : 64 * (std::int64_t{low} + limbs) - std::countl_zero(limb[limbs - 1]);
  }
  /// Its lowest limb that is not 0, unless it is 0.
  constexpr int lowest() const noexcept {
    int i = 0;
    while (limb[i] == 0) ++i;
    return i;
  }
  constexpr bool sign_is_certain() const noexcept { return error == nothing || top() - 1 > error; }
  constexpr detail::Span span() const noexcept { return {limb, low, limbs}; }
};

namespace detail {

/// a * b, the same number or two.
template <int limbs>
constexpr Leading<limbs> product(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  Leading<limbs> product;
  if (a.sign != 0 && b.sign != 0) {
    constexpr int first = product.first_formed;
    Limb limb[std::size_t{2 * limbs}];
    if (&a == &b) {
      multiply_by_itself(a.limb, limbs, limb, first);
    } else {
      multiply(a.limb, limbs, b.limb, limbs, limb, first);
    }
    product.set(a.sign * b.sign, {limb + first, a.low + b.low + first, 2 * limbs - first});
    product.lose_unformed(a, b);
  }
  product.lose_factors(a, b);
  return product;
}

}  // namespace detail

template <int limbs>
constexpr Leading<limbs> operator*(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  return detail::product(a, b);
}
template <int limbs>
constexpr Leading<limbs> square(const Leading<limbs>& a) noexcept {
  return detail::product(a, a);
}

/// A small positive whole number of times.
template <int limbs>
constexpr Leading<limbs> times(int factor, const Leading<limbs>& a) noexcept {
  Leading<limbs> product;
  const Limb size = static_cast<Limb>(factor);
  if (a.sign != 0) {
    Limb limb[std::size_t{limbs + 1}];
    detail::multiply(&size, 1, a.limb, limbs, limb);
    product.set(a.sign, {limb, a.low, limbs + 1});
  }
  product.lose_if_any(a.error + static_cast<std::int64_t>(std::bit_width(size)));
  return product;
}

template <int limbs>
constexpr Leading<limbs> operator-(const Leading<limbs>& a) noexcept {
  Leading<limbs> negative = a;
  negative.sign = -a.sign;
  return negative;
}

template <int limbs>
constexpr Leading<limbs> operator+(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  Leading<limbs> sum;
  // One limb more than the longer of them; what is cut off below is the same for both, so that no order changes.
  constexpr int n = limbs + 2;
  Limb limb[std::size_t{n}];
  if (a.sign == 0 || b.sign == 0) {
    sum = a.sign == 0 ? b : a;
    sum.error = Leading<limbs>::nothing;
  } else {
    const int low = (a.low > b.low ? a.low : b.low) - 1;
    const int order = a.sign == b.sign ? 1 : detail::compare_magnitude(a.span(), b.span());
    const detail::Span x = order < 0 ? b.span() : a.span(), y = order < 0 ? a.span() : b.span();
    if (a.sign == b.sign) {
      detail::add_magnitude(x, y, low, n, limb);
    } else {
      detail::subtract_magnitude(x, y, low, n, limb);
    }
    sum.set(order < 0 ? b.sign : a.sign, {limb, low, n});
    if (a.low < low || b.low < low) sum.lose(std::int64_t{64} * low);
  }
  sum.lose_if_any(a.error);
  sum.lose_if_any(b.error);
  return sum;
}

template <int limbs>
constexpr Leading<limbs> operator-(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  return a + -b;
}

/// For numbers with more limbs than this, leading digits are tried first: few of them, and then more.
inline constexpr int least_long = 16, few_limbs = 6, some_limbs = 12, more_limbs = 24;

template <int Degree>
constexpr bool is_long(const Number<Degree>& x) noexcept {
  return x.size > least_long;
}
template <int limbs>
constexpr bool is_long(const Leading<limbs>&) noexcept {
  return false;
}

namespace detail {

/// Whether a limb costs time in products: of all zeros or all ones it hardly does.
constexpr bool is_dense(Limb x) noexcept { return x + 1 > 1; }
template <int Degree>
constexpr int dense_limbs(const Number<Degree>& x) noexcept {
  int count = 0;
  for (int i = 0; i < x.size; ++i) count += is_dense(x.limb[i]) ? 1 : 0;
  return count;
}
/// Whether so many leading limbs are worth while: at most two thirds of the dense ones.
template <int Degree>
constexpr bool is_longer(const Number<Degree>& x, int limbs) noexcept {
  return 2 * dense_limbs(x) > 3 * limbs;
}

/// Whether few limbs are dense, in few runs, each of which costs as much as two limbs: products of products have the
/// squares of these numbers.
template <int Degree>
constexpr bool is_sparse(const Number<Degree>& x) noexcept {
  constexpr int most = 21;
  int cost = 0;
  bool was_dense = false;
  for (int i = 0; i < x.size && cost <= most; ++i) {
    const bool costs = is_dense(x.limb[i]);
    if (costs) cost += was_dense ? 1 : 3;
    was_dense = costs;
  }
  return cost <= most;
}

template <int limbs, class Polynomial, int... Degree>
constexpr bool digits_tell(int& sign, const Polynomial& value, const Number<Degree>&... x) noexcept {
  const auto leading = value(Leading<limbs>(x)...);
  sign = leading.sign;
  return leading.sign_is_certain();
}

/// Whether leading digits are long enough to decide the sign of a polynomial in these numbers.
template <class Polynomial, int... Degree>
constexpr bool leading_digits_tell(int& sign, const Polynomial& value, const Number<Degree>&... x) noexcept {
  if (!(is_long(x) || ...)) return false;
  if (digits_tell<few_limbs>(sign, value, x...) || digits_tell<some_limbs>(sign, value, x...)) return true;
  return (is_longer(x, more_limbs) || ...) && digits_tell<more_limbs>(sign, value, x...);
}

}  // namespace detail

/// The sign of a polynomial in these numbers, given as a function of numbers of any type.
template <class Polynomial, int... Degree>
constexpr int sign_of(const Polynomial& value, const Number<Degree>&... x) noexcept {
  int sign = 0;
  return detail::leading_digits_tell(sign, value, x...) ? sign : value(x...).sign;
}

/// a b + factor c d, the factor being 1 or -1.
template <int factor>
struct TwoProducts {
  template <class A, class B, class C, class D>
  constexpr auto operator()(const A& a, const B& b, const C& c, const D& d) const noexcept {
    static_assert(factor == 1 || factor == -1);
    if constexpr (factor == 1) {
      return a * b + c * d;
    } else {
      return a * b - c * d;
    }
  }
};
using SumOfProducts = TwoProducts<1>;
using DifferenceOfProducts = TwoProducts<-1>;

namespace detail {

/// What tells the sign of a b + factor c d, of degree 32 at most; c and d may be the same number.
VESICA_CALLED constexpr ToldSum told_products(const AnyNumber& a, const AnyNumber& b, int factor, const AnyNumber& c,
                                              const AnyNumber& d) noexcept {
  DigitsOfDegree<16> w(a), x(b), y(c), z(d);
  return ToldSum({{1, &w, &x}, {factor, &y, c.magnitude.limb == d.magnitude.limb ? &y : &z}});
}
constexpr int compare_long_products(const AnyNumber& a, const AnyNumber& b, const AnyNumber& c,
                                    const AnyNumber& d) noexcept {
  return told_products(a, b, -1, c, d).sign();
}

}  // namespace detail

/// As sign_of() of any polynomial. Where few digits do not tell it, digits from the top do; below a degree of 5 all
/// digits are as quick.
template <int factor, int A, int B, int C, int D>
requires(A + B > 4) constexpr int sign_of(const TwoProducts<factor>& value, const Number<A>& a, const Number<B>& b,
                                          const Number<C>& c, const Number<D>& d) noexcept {
  static_assert(A <= 16 && B <= 16 && C <= 16 && D <= 16);
  if (!is_long(a) && !is_long(b) && !is_long(c) && !is_long(d)) return value(a, b, c, d).sign;
  int sign = 0;
  if (detail::digits_tell<few_limbs>(sign, value, a, b, c, d)) return sign;
  return detail::told_products(a, b, factor, c, d).sign();
}

namespace detail {

/// Sign of a^2 x - b^2 y, of degree 32 at most.
VESICA_CALLED constexpr int compare_long_squares_times(const AnyNumber& a, const AnyNumber& x, const AnyNumber& b,
                                                       const AnyNumber& y) noexcept {
  using Few = Leading<few_limbs>;
  const Few few = square(Few(a)) * Few(x) - square(Few(b)) * Few(y);
  if (few.sign_is_certain()) return few.sign;
  DigitsOfDegree<16> p(a), q(x), r(b), s(y);
  DigitsOfDegree<32> p_p{{1, &p, &p}}, r_r{{1, &r, &r}};
  return ToldSum({{1, &p_p, &q}, {-1, &r_r, &s}}).sign();
}

}  // namespace detail

namespace detail {

/// The sign of a b - c d where signs or magnitudes tell it, else 2.
template <int A, int B, int C, int D>
constexpr int compare_products_roughly(const Number<A>& a, const Number<B>& b, const Number<C>& c,
                                       const Number<D>& d) noexcept {
  const int sign = a.sign * b.sign, other = c.sign * d.sign;
  if (sign != other) return sign > other ? 1 : -1;
  if (sign == 0) return 0;
  // The top bit of a product is that of its factors' sum, or one below.
  const std::int64_t left = top_bit(a) + top_bit(b), right = top_bit(c) + top_bit(d);
  return left + 1 < right ? -sign : right + 1 < left ? sign : 2;
}

}  // namespace detail

/// Sign of a b - c d, with neither product formed where signs, magnitudes or leading digits tell.
template <int A, int B, int C, int D>
constexpr int compare_products(const Number<A>& a, const Number<B>& b, const Number<C>& c,
                               const Number<D>& d) noexcept {
  static_assert(A <= 16 && B <= 16 && C <= 16 && D <= 16);
  const int rough = detail::compare_products_roughly(a, b, c, d);
  if (rough < 2) return rough;
  if (is_long(a) || is_long(b) || is_long(c) || is_long(d)) return detail::compare_long_products(a, b, c, d);
  return compare(a * b, c * d);
}
/// Sign of a b - c^2, in the same way.
template <int A, int B, int C>
constexpr int compare_product_with_square(const Number<A>& a, const Number<B>& b, const Number<C>& c) noexcept {
  static_assert(A <= 16 && B <= 16 && C <= 16);
  const int rough = detail::compare_products_roughly(a, b, c, c);
  if (rough < 2) return rough;
  if (is_long(a) || is_long(b)) return detail::compare_long_products(a, b, c, c);
  return compare(a * b, square(c));
}

/// Sign of a^2 x - b^2 y.
template <int A, int X, int B, int Y>
constexpr int compare_squares_times(const Number<A>& a, const Number<X>& x, const Number<B>& b,
                                    const Number<Y>& y) noexcept {
  static_assert(A <= 16 && X <= 16 && B <= 16 && Y <= 16);
  const bool is_any_long = is_long(a) || is_long(x) || is_long(b) || is_long(y);
  return is_any_long ? detail::compare_long_squares_times(a, x, b, y) : compare(square(a) * x, square(b) * y);
}

/// What is known of a sum of products; its sign is certain, and it is to 2^-110 or better.
constexpr Leading<few_limbs> leading(const detail::ToldSum& told) noexcept {
  Leading<few_limbs> out(told.number());
  if (!told.is_whole()) out.lose(told.missing());
  return out;
}

/// The signs of numbers; once one was not certain nothing is.
struct Signs {
  bool certain = true;

  template <int Degree>
  constexpr int of(const Number<Degree>& x) noexcept {
    return x.sign;
  }
  /// Of leading digits.
  template <class Kept>
  constexpr int of(const Kept& x) noexcept {
    certain = certain && x.sign_is_certain();
    return x.sign;
  }
  /// Of a polynomial in these numbers.
  template <class Polynomial, int... Degree>
  constexpr int of_polynomial(const Polynomial& value, const Number<Degree>&... x) noexcept {
    return sign_of(value, x...);
  }
  template <class Polynomial, int limbs, class... Same>
  constexpr int of_polynomial(const Polynomial& value, const Leading<limbs>& x, const Same&... rest) noexcept {
    return of(value(x, rest...));
  }
};

}  // namespace vesica::exact
