// SPDX-License-Identifier: Apache-2.0
/// Where a quartic is zero between 0 and 1: bisection by Descartes' rule of signs, in steps that double in length where
/// the zeros of an interval lie close together. J. Abbott, ACM Comm. Computer Algebra 48 (2014) 3; M. Sagraloff and K.
/// Mehlhorn, J. Symb. Comput. 73 (2016) 46.
#pragma once

#include <vesica/crossings/fixed.hpp>
#include <vesica/crossings/points.hpp>

namespace vesica::detail::crossings {

/// An interval which is too short to be taken apart further, with at most `most` zeros by multiplicity.
struct Spot {
  Real from, to;
  int most;
  bool negative_before, negative_after;
  double height;  ///< of two zeros or none: the quartic's extreme between them; 0 where they are one
};

/// In order. Four zeros, and as many that rounding cannot tell from zeros.
struct Spots {
  Spot spot[16];
  int count = 0;
  void add(const Spot& s) noexcept {
    if (count < 16) spot[count++] = s;
  }
};

/// The shortest interval of the tangent that matters.
inline constexpr double shortest = 0x1p-96;

/// In doubles, scaled: the coefficients about a point, and where the zeros of an interval are by them.
struct Local {
  double bernstein[5], power[5];
  double most = 0;
  int exponent;

  explicit Local(const Quartic& q) noexcept : exponent(to_doubles(q, bernstein)) {
    double d[5];
    for (int i = 0; i < 5; ++i) {
      d[i] = bernstein[i];
      most = std::fmax(most, std::fabs(d[i]));
    }
    constexpr double binomial[5] = {1, 4, 6, 4, 1};
    for (int i = 0; i < 5; ++i) {
      power[i] = binomial[i] * d[0];
      for (int k = 0; k < 4 - i; ++k) d[k] = d[k + 1] - d[k];
    }
  }
  /// The derivative of an order, over the order's factorial.
  double derivative(int order, double t) const noexcept {
    constexpr double binomial[5][5] = {
        {1, 1, 1, 1, 1}, {0, 1, 2, 3, 4}, {0, 0, 1, 3, 6}, {0, 0, 0, 1, 4}, {0, 0, 0, 0, 1}};
    double value = 0;
    for (int i = 4; i >= order; --i) value = value * t + binomial[order][i] * power[i];
    return value;
  }
  /// About where the derivative of an order changes its sign; the end at which it is less where it does not.
  double zero_of_derivative(int order) const noexcept {
    double low = 0, high = 1;
    const double at_low = derivative(order, 0), at_high = derivative(order, 1);
    const bool sign = at_low < 0;
    if ((at_high < 0) == sign) return std::fabs(at_low) < std::fabs(at_high) ? 0 : 1;
    double t = 0.5;
    // A zero that Newton's steps do not reach soon is one of a group, for which the caller has other means.
    for (int i = 0; i < 16; ++i) {
      const double value = derivative(order, t), slope = (order + 1) * (order < 4 ? derivative(order + 1, t) : 0);
      ((value < 0) == sign ? low : high) = t;
      double next = t - value / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const double change = std::fabs(next - t);
      t = next;
      if (change < 0x1p-52) break;
    }
    return t;
  }
  /// So far from t all zeros of a group of k may be, with what rounding adds.
  double reach(int k, double t) const noexcept {
    const double leading = std::fabs(derivative(k, t)), rest = 0x1p-46 * most;
    double most_reach = 0;
    for (int i = 0; i < k; ++i) {
      const double part = (std::fabs(derivative(i, t)) + rest) / leading;
      const int root = k - i;
      const double r = root == 1   ? part
                       : root == 2 ? std::sqrt(part)
                       : root == 3 ? std::cbrt(part)
                                   : std::sqrt(std::sqrt(part));
      most_reach = std::fmax(most_reach, r);
    }
    return 2 * most_reach;
  }
  double height() const noexcept {
    const double t = zero_of_derivative(1);
    return arithmetic::scale(std::fabs(derivative(0, t)), exponent);
  }
};

class ZeroSearch {
 public:
  ZeroSearch(const Quartic& whole, double quarter, Spots& spots) noexcept : spots_(spots) {
    push({whole, Real(quarter), 1.0, whole.sign_changes()});
    while (count_ > 0) {
      const Interval top = pending_[--count_];
      visit(top);
    }
  }

 private:
  struct Interval {
    Quartic q;
    Real from;
    double length;
    int changes;
  };
  Interval pending_[8];
  int count_ = 0;
  Spots& spots_;

  void push(const Interval& i) noexcept {
    if (i.changes == 0) return;
    if (count_ < 8) {
      pending_[count_++] = i;
    } else {
      end(i, i.from, i.from + Real(i.length));
    }
  }
  void end(const Interval& i, const Real& from, const Real& to) noexcept {
    spots_.add({from, to, i.changes, i.q.coefficient[0].negative(), i.q.coefficient[4].negative(),
                i.changes == 2 ? Local(i.q).height() : 0});
  }
  void visit(const Interval& i) noexcept {
    if (i.length < shortest || i.q.negligible()) {
      end(i, i.from, i.from + Real(i.length));
      return;
    }
    const Local local(i.q);
    const double t = local.zero_of_derivative(i.changes - 1), reach = local.reach(i.changes, t);
    if (i.changes == 1 && reach * i.length < shortest && !i.q.coefficient[0].negligible() &&
        !i.q.coefficient[4].negligible()) {
      const Real at = i.from + Real(t) * Real(i.length);
      end(i, at, at);
      return;
    }
    if (reach < 0x1p-5 && narrow(i, t, reach)) return;
    // In a group with zeros beyond the ends, or with complex ones.
    for (int k = i.changes + 1; k <= 4; ++k) {
      const double middle = local.zero_of_derivative(k - 1), wide = local.reach(k, middle);
      if (wide < 0x1p-5 && narrow(i, middle, wide)) return;
    }
    const Halves halves(i.q);
    const double half = 0.5 * i.length;
    push({halves.high, i.from + Real(half), half, halves.high.sign_changes()});
    push({halves.low, i.from, half, halves.low.sign_changes()});
  }
  /// The part within reach of t, a power of two long, if all of the zeros are in it.
  bool narrow(const Interval& i, double t, double reach) noexcept {
    const int bits = arithmetic::exponent_of(reach) + 1;  // half its length
    double half = arithmetic::power_of_two(bits < -50 ? -50 : bits);
    double low = std::floor((t - half) / half) * half;
    if (low < 0) low = 0;
    double high = low + 4 * half;
    if (high > 1) {
      high = 1;
      low = 1 - 4 * half;
    }
    const auto grid = [](double x) { return x == 1 ? exact::Limb{0} : static_cast<exact::Limb>(x * 0x1p64); };
    const Quartic inner = part(i.q, grid(low), grid(high));
    const int changes = inner.sign_changes();
    if (changes != i.changes) return false;
    push({inner, i.from + Real(low) * Real(i.length), (high - low) * i.length, changes});
    return true;
  }
};

}  // namespace vesica::detail::crossings
