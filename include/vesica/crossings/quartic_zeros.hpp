// SPDX-License-Identifier: Apache-2.0
/// Where a quartic is zero between 0 and 1: bisection by Descartes' rule of signs, in steps that double in length where
/// the zeros of an interval lie close together. J. Abbott, ACM Comm. Computer Algebra 48 (2014) 3; M. Sagraloff and K.
/// Mehlhorn, J. Symb. Comput. 73 (2016) 46.
#pragma once

#include <algorithm>
#include <utility>
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
  bool is_full() const noexcept { return count == 16; }
  void add(const Spot& s) noexcept {
    if (!is_full()) spot[count++] = s;
  }
};

/// The shortest interval of the tangent that matters.
inline constexpr double shortest = 0x1p-96;

/// In doubles, scaled: the coefficients about a point, and where the zeros of an interval are by them.
struct Local {
  InDoubles bernstein;
  double power[5];
  double most = 0;

  explicit Local(const Quartic& q, int limbs = Fixed::limbs) noexcept : bernstein(q, limbs) {
    const double* b = bernstein.coefficient;
    for (int i = 0; i < 5; ++i) most = std::max(most, std::fabs(b[i]));
    // Their differences, those of the differences, and so on.
    const double first[4] = {b[1] - b[0], b[2] - b[1], b[3] - b[2], b[4] - b[3]};
    const double second[3] = {first[1] - first[0], first[2] - first[1], first[3] - first[2]};
    const double third[2] = {second[1] - second[0], second[2] - second[1]};
    power[0] = b[0];
    power[1] = 4 * first[0];
    power[2] = 6 * second[0];
    power[3] = 4 * third[0];
    power[4] = third[1] - third[0];
  }
  /// The derivative of an order, over the order's factorial.
  template <int order>
  double derivative(double t) const noexcept {
    double value = binomial[4][order] * power[4];
    for (int i = 3; i >= order; --i) value = value * t + binomial[i][order] * power[i];
    return value;
  }
  /// About where the derivative of an order changes its sign; the end at which it is less where it does not.
  double zero_of_derivative(int order) const noexcept {
    switch (order) {
      case 0:
        return zero_of_derivative<0>();
      case 1:
        return zero_of_derivative<1>();
      case 2:
        return zero_of_derivative<2>();
      default:
        return zero_of_derivative<3>();
    }
  }
  template <int order>
  double zero_of_derivative() const noexcept {
    double low = 0, high = 1;
    const double at_low = derivative<order>(0), at_high = derivative<order>(1);
    const bool sign = at_low < 0;
    if ((at_high < 0) == sign) return std::fabs(at_low) < std::fabs(at_high) ? 0 : 1;
    double t = 0.5;
    // A zero that Newton's steps do not reach soon is one of a group, for which the caller has other means.
    for (int i = 0; i < 16; ++i) {
      const double value = derivative<order>(t), slope = (order + 1) * derivative<order + 1>(t);
      ((value < 0) == sign ? low : high) = t;
      double next = t - value / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const double change = std::fabs(next - t);
      t = next;
      if (change < 0x1p-52) break;
    }
    return t;
  }
  /// So far from t all zeros of a group of k may be, with what rounding adds; 1 for some of those of 2^-5 or more.
  double reach(int k, double t) const noexcept {
    switch (k) {
      case 1:
        return reach<1>(t);
      case 2:
        return reach<2>(t);
      case 3:
        return reach<3>(t);
      default:
        return reach<4>(t);
    }
  }
  template <int k>
  double reach(double t) const noexcept {
    const double leading = std::fabs(derivative<k>(t)), rest = 0x1p-46 * most;
    if constexpr (k > 1) {
      // So most of those that are too far need no roots.
      if (std::fabs(derivative<0>(t)) + rest > 1.01 * least_far<k> * leading) return 1;
      if (std::fabs(derivative<1>(t)) + rest > 1.01 * least_far<k - 1> * leading) return 1;
    }
    double most_reach = root<k>((std::fabs(derivative<0>(t)) + rest) / leading);
    const auto see = [&](double x) { most_reach = std::max(most_reach, x); };
    if constexpr (k > 1) see(root<k - 1>((std::fabs(derivative<1>(t)) + rest) / leading));
    if constexpr (k > 2) see(root<k - 2>((std::fabs(derivative<2>(t)) + rest) / leading));
    if constexpr (k > 3) see(root<1>((std::fabs(derivative<3>(t)) + rest) / leading));
    return 2 * most_reach;
  }
  /// Whether reach(k, t) is 2^-5 or more wherever t is, with little work. Were it less, the derivatives at t of order i
  /// below k would be less than 2^(-6 (k - i)) times the one of order k, `leading`. So `leading` would exceed 2^(6 k)
  /// times what rounding adds, and, by Taylor's series about t, the sum of all others 1/32 of it at most: the value at
  /// the ends would be less than 1.04 times the sum of the derivatives' greatest values from order k on.
  bool is_far_reaching(int k) const noexcept {
    double leading = 0, all = 0;
    for (int i = 4; i >= k; --i) {
      const double size = std::fabs(power[i]);
      leading += binomial[i][k] * size;
      all += at_most[i][k] * size;
    }
    constexpr double least[] = {0x1p-46, 0x1p-40, 0x1p-34, 0x1p-28, 0x1p-22};
    const double ends = std::max(std::fabs(bernstein.coefficient[0]), std::fabs(bernstein.coefficient[4]));
    // All roundings together are below 2^-41 of the greatest coefficient.
    return 1.01 * leading < least[k] * most || 1.1 * all + 0x1p-40 * most < ends;
  }
  double height() const noexcept {
    const double t = zero_of_derivative<1>();
    return arithmetic::scale(std::fabs(derivative<0>(t)), bernstein.exponent);
  }
  /// The value at t, a multiple of 2^-53 between 0 and 1, where its sign is certain and it is not negligible; else 0.
  /// Without cancellation but that of the terms themselves, each right to 2^-50 of itself and 2^-60. The quartic that
  /// part() cuts off has it as its first or last coefficient, to 2^-379.
  double certain_value(double t) const noexcept {
    if (bernstein.exponent < -250) return 0;
    const double* b = bernstein.coefficient;
    const double u = 1 - t, uu = u * u, tt = t * t;
    const double term[5] = {b[0] * (uu * uu), 4 * b[1] * (uu * u * t), 6 * b[2] * (uu * tt), 4 * b[3] * (u * t * tt),
                            b[4] * (tt * tt)};
    double sum = 0, size = 0;
    for (const double x : term) {
      sum += x;
      size += std::fabs(x);
    }
    return std::fabs(sum) > 0x1p-47 * size + 0x1p-59 ? sum : 0;
  }

  /// Whether every coefficient of a part within `way` of t is negligible, and so the part's changes of sign are 4: by
  /// Taylor's series about t they are at most the sum of the derivatives' sizes times the powers of `way`. All
  /// roundings together are below 2^-41 of the greatest coefficient.
  bool is_negligible_near(double t, double way) const noexcept {
    if (bernstein.exponent >= -275) return false;
    double size = std::fabs(derivative<4>(t));
    size = size * way + std::fabs(derivative<3>(t));
    size = size * way + std::fabs(derivative<2>(t));
    size = size * way + std::fabs(derivative<1>(t));
    size = size * way + std::fabs(derivative<0>(t));
    return arithmetic::scale(size + 0x1p-41 * most, bernstein.exponent + 320) < 1;
  }

 private:
  /// What is less than this at a group of k, over the derivative of order k, is less than 2^-5 in reach().
  template <int k>
  static constexpr double least_far = 1.0 / (1 << 6 * k);
  static constexpr double binomial[5][5] = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  /// Sums of binomials i over j, j from the second index on.
  static constexpr double at_most[5][5] = {
      {1, 0, 0, 0, 0}, {2, 1, 0, 0, 0}, {4, 3, 1, 0, 0}, {8, 7, 4, 1, 0}, {16, 15, 11, 5, 1}};

  template <int degree>
  static double root(double x) noexcept {
    return degree == 1 ? x : degree == 2 ? std::sqrt(x) : degree == 3 ? std::cbrt(x) : std::sqrt(std::sqrt(x));
  }
};

class ZeroSearch {
 public:
  /// The spots of a quarter of the outline; and, if `opposite` is given, those half a turn on, where the quartic is the
  /// same.
  ZeroSearch(const Quartic& whole, double quarter, Spots& spots, Spots* opposite) noexcept
      : spots_(spots), opposite_(opposite) {
    for (int i = 0; i < places; ++i) pending_[i] = &interval_[i];
    interval_[0] = {whole, Real(quarter), Real(quarter + 2), 1.0, whole.sign_changes(), Fixed::limbs};
    count_ = interval_[0].changes > 0 ? 1 : 0;
    while (count_ > 0 && !spots_.is_full()) visit(*pending_[count_ - 1]);
  }

 private:
  struct Interval {
    Quartic q;
    Real from, opposite_from;
    double length;
    int changes;
    int limbs;  ///< so many of the lowest hold the coefficients
  };
  static constexpr int most_pending = 8, places = most_pending + 1;
  Interval interval_[places];
  Interval* pending_[places];  ///< those after the first count_ are free
  int count_;
  Spots& spots_;
  Spots* opposite_;

  void step(Interval& i, double way) const noexcept {
    i.from = i.from + Real(way);
    if (opposite_ != nullptr) i.opposite_from = i.opposite_from + Real(way);
  }
  /// Of what is left of an interval whose start is where the spot's is.
  void add_spot(const Interval& i, double length) noexcept {
    Spot s{i.from,
           i.from + Real(length),
           i.changes,
           i.q.coefficient[0].negative(),
           i.q.coefficient[4].negative(),
           i.changes == 2 ? Local(i.q).height() : 0};
    spots_.add(s);
    if (opposite_ == nullptr) return;
    s.from = i.opposite_from;
    s.to = i.opposite_from + Real(length);
    opposite_->add(s);
  }
  void end(const Interval& i, double length) noexcept {
    add_spot(i, length);
    --count_;
  }
  /// The last of those pending: a narrower one takes its place, or halves, or none.
  void visit(Interval& i) noexcept {
    // Of negligible coefficients there are 4 changes.
    if (i.length < shortest || (i.changes == 4 && i.q.negligible())) {
      end(i, i.length);
      return;
    }
    const Local local(i.q, i.limbs);
    i.limbs = local.bernstein.limbs;
    for (int k = i.changes; k <= 4; ++k) {
      if (visit_group(i, local, k)) return;
    }
    visit_halves(i, *pending_[count_]);
  }
  /// The higher half stays where the whole was.
  void visit_halves(Interval& high, Interval& low) noexcept {
    const HalvesChanges changes = halve(high.q, low.q, high.limbs);
    low.from = high.from;
    low.opposite_from = high.opposite_from;
    low.limbs = high.limbs;
    low.length = high.length = 0.5 * high.length;
    step(high, high.length);
    high.changes = changes.high;
    low.changes = changes.low;
    if (high.changes == 0) {
      --count_;
      std::swap(pending_[count_], pending_[count_ + 1]);
    }
    if (low.changes == 0) return;
    if (count_ < most_pending) {
      ++count_;
    } else {
      add_spot(low, low.length);
    }
  }
  /// Whether the zeros are in the middle of a group of k, others being beyond the ends or complex: then this ends
  /// the interval, or narrows it to the group.
  bool visit_group(Interval& i, const Local& local, int k) noexcept {
    const bool may_end = k == 1;  // and so has one change, as k is not less
    // A reach of 2^-5 ends only what is shorter than that.
    if (!(may_end && i.length < 0x1p5 * shortest) && local.is_far_reaching(k)) return false;
    const double t = local.zero_of_derivative(k - 1), reach = local.reach(k, t);
    if (may_end && reach * i.length < shortest && !i.q.coefficient[0].negligible() &&
        !i.q.coefficient[4].negligible()) {
      step(i, t * i.length);
      end(i, 0);
      return true;
    }
    return reach < 0x1p-5 && narrow(i, local, t, reach);
  }
  /// The sign of the first or last coefficient of a part that begins or ends at t, if it is certain and the coefficient
  /// not negligible; else 0.
  static double sign_at(const Interval& i, const Local& local, double t) noexcept {
    if (t != 0 && t != 1) return local.certain_value(t);
    const Fixed& c = i.q.coefficient[t == 0 ? 0 : 4];
    return c.negligible() ? 0 : c.negative() ? -1 : 1;
  }
  /// The part within reach of t, a power of two long, if all of the zeros are in it.
  bool narrow(Interval& i, const Local& local, double t, double reach) noexcept {
    const int bits = arithmetic::exponent_of(reach) + 1;  // half its length
    double half = arithmetic::power_of_two(bits < -50 ? -50 : bits);
    double low = static_cast<double>(static_cast<std::int64_t>((t - half) / half)) * half;
    if (low < 0) low = 0;
    double high = low + 4 * half;
    if (high > 1) {
      high = 1;
      low = 1 - 4 * half;
    }
    // An odd number of changes has ends of unlike signs.
    const double ends = sign_at(i, local, low) * sign_at(i, local, high);
    if (i.changes % 2 == 0 ? ends < 0 : ends > 0) return false;
    if (i.changes != 4 && local.is_negligible_near(t, 4 * half)) return false;
    const auto grid = [](double x) { return x == 1 ? exact::Limb{0} : static_cast<exact::Limb>(x * 0x1p64); };
    Interval& inner = *pending_[count_];
    if (!part(i.q, grid(low), grid(high), i.limbs, i.changes, inner.q)) return false;
    inner.changes = i.changes;
    inner.from = i.from;
    inner.opposite_from = i.opposite_from;
    step(inner, low * i.length);
    inner.length = (high - low) * i.length;
    inner.limbs = i.limbs;
    std::swap(pending_[count_ - 1], pending_[count_]);
    return true;
  }
};

}  // namespace vesica::detail::crossings
