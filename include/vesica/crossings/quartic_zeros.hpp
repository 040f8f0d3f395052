// SPDX-License-Identifier: Apache-2.0
/// The zeros of a quartic between 0 and 1: bisection by Descartes' rule of signs, in steps that double in length where
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
  bool is_certain_before = false, is_certain_after = false;  ///< the signs
};

/// In order, each narrower than the shortest interval of the tangent that matters, which two steps of 48 bits reach.
/// Four zeros, and as many that rounding cannot distinguish from zeros.
struct Spots {
  Spot spot[16];
  int count = 0;
  double shortest = 0x1p-95;
  bool is_full() const noexcept { return count == 16; }
  void add(const Spot& s) noexcept {
    if (!is_full()) spot[count++] = s;
  }
};

inline double root(int degree, double x) noexcept {
  return degree == 1 ? x : degree == 2 ? std::sqrt(x) : degree == 3 ? std::cbrt(x) : std::sqrt(std::sqrt(x));
}

/// Values below 2 to this power, eight times the negligible, are not distinguished from a group of zeros.
inline constexpr int least_exponent = -316;

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
    const auto step_from = [this](double from, double value) {
      return from - value / ((order + 1) * derivative<order + 1>(from));
    };
    // A zero that Newton's steps do not reach soon is one of a group, for which the caller has other means.
    for (int i = 0; i < 16; ++i) {
      const double value = derivative<order>(t);
      ((value < 0) == sign ? low : high) = t;
      double next = step_from(t, value);
      if (std::fabs(next - t) < 0x1p-52) return t;
      // From afar they may lead beyond a zero that is at an end, again and again, but not from there.
      if (low == 0 && next <= 0) {
        next = step_from(0, at_low);
        if (std::fabs(next) < 0x1p-52) return 0;
      } else if (high == 1 && next >= 1) {
        next = step_from(1, at_high);
        if (std::fabs(next - 1) < 0x1p-52) return 1;
      }
      t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
  }
  /// So far from t all zeros of a group of k may be, with what rounding adds; 1 for some of those of 2^-5 or more. The
  /// value is not negligible beyond that.
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
    const double leading = std::fabs(derivative<k>(t));
    const double rest = 0x1p-46 * most + arithmetic::power_of_two(least_exponent - bernstein.exponent);
    if constexpr (k > 1) {
      // So most of those that are too far need no roots.
      if (std::fabs(derivative<0>(t)) + rest > 1.01 * least_far<k> * leading) return 1;
      if (std::fabs(derivative<1>(t)) + rest > 1.01 * least_far<k - 1> * leading) return 1;
    }
    double most_reach = root(k, (std::fabs(derivative<0>(t)) + rest) / leading);
    const auto see = [&](double x) { most_reach = std::max(most_reach, x); };
    if constexpr (k > 1) see(root(k - 1, (std::fabs(derivative<1>(t)) + rest) / leading));
    if constexpr (k > 2) see(root(k - 2, (std::fabs(derivative<2>(t)) + rest) / leading));
    if constexpr (k > 3) see(root(1, (std::fabs(derivative<3>(t)) + rest) / leading));
    return 2 * most_reach;
  }
  /// True if reach(k, t) is 2^-5 or more wherever t is, with little work. Were it less, the derivatives at t of order i
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
  /// True if the value at t is lost in what rounding adds.
  bool is_unknown_at(double t) const noexcept { return std::fabs(derivative<0>(t)) <= 0x1p-46 * most; }
  double height() const noexcept {
    const double t = zero_of_derivative<1>();
    return arithmetic::scale(std::fabs(derivative<0>(t)), bernstein.exponent);
  }
  /// The value at t, a multiple of 2^-53 between 0 and 1, where its sign is certain and it is not negligible; else 0.
  /// No cancellation except within the terms, each right to a relative 2^-50 plus 2^-60. The quartic that
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

 private:
  /// A value below this at a group of k, over the derivative of order k, is less than 2^-5 in reach().
  template <int k>
  static constexpr double least_far = 1.0 / (1 << 6 * k);
  static constexpr double binomial[5][5] = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  /// Sums of binomials i over j, j from the second index on.
  static constexpr double at_most[5][5] = {
      {1, 0, 0, 0, 0}, {2, 1, 0, 0, 0}, {4, 3, 1, 0, 0}, {8, 7, 4, 1, 0}, {16, 15, 11, 5, 1}};
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
  /// Adds the spot from the interval's start on.
  void add_spot(const Interval& i, double length) noexcept {
    Spot s{i.from,
           i.from + Real(length),
           i.changes,
           i.q.coefficient[0].negative(),
           i.q.coefficient[4].negative(),
           i.changes == 2 ? Local(i.q).height() : 0,
           !i.q.coefficient[0].negligible(),
           !i.q.coefficient[4].negligible()};
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
    if (i.length < spots_.shortest) return end(i, i.length);
    const Local local(i.q, i.limbs);
    // Hardly any digit is left: a part would have negligible coefficients only.
    if (local.bernstein.exponent < -312) return end(i, i.length);
    i.limbs = local.bernstein.limbs;
    Group groups[4] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}};
    for (int k = i.changes; k <= 4; ++k) {
      Group& group = groups[k - 1] = find_group(i, local, k);
      if (k == 1 && ends_with(i, group)) return;
      // A group that reaches far is likely part of one of more zeros, which is seen better.
      if (group.reach >= 0x1p-32) continue;
      if (narrow(i, local, group)) return;
      group.reach = 1;
    }
    // The narrowest first, which may be one of zeros beyond an end.
    for (;;) {
      Group& narrowest =
          *std::min_element(groups, groups + 4, [](const Group& g, const Group& h) { return g.reach < h.reach; });
      if (narrowest.reach >= 0x1p-5) break;
      if (narrow(i, local, narrowest)) return;
      narrowest.reach = 1;
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
    if (count_ == most_pending) return add_spot(low, low.length);
    ++count_;
  }
  /// About where zeros of a group are, and how far from there all of them may be; 1 if that is not known to be less.
  struct Group {
    double t, reach;
  };
  /// Finds a group of k zeros; others are beyond the ends or complex. One change of sign means a group of one.
  Group find_group(const Interval& i, const Local& local, int k) const noexcept {
    // A reach of 2^-5 ends only what is shorter than that.
    if (!(k == 1 && i.length < 0x1p5 * spots_.shortest) && local.is_far_reaching(k)) return {0, 1};
    const double t = local.zero_of_derivative(k - 1), reach = local.reach(k, t);
    return {t, k > 1 && reach < 0x1p-5 && local.is_unknown_at(t) ? exact_reach(i, k, t) : reach};
  }
  /// True if an interval with one change ends, its zero being known.
  bool ends_with(Interval& i, const Group& zero) noexcept {
    if (!(zero.reach * i.length < spots_.shortest)) return false;
    if (i.q.coefficient[0].negligible() || i.q.coefficient[4].negligible()) return false;
    step(i, zero.t * i.length);
    end(i, 0);
    return true;
  }
  /// The sign of the first or last coefficient of a part that begins or ends at t, if it is certain and the coefficient
  /// not negligible; else 0.
  static double sign_at(const Interval& i, const Local& local, double t) noexcept {
    if (t != 0 && t != 1) return local.certain_value(t);
    const Fixed& c = i.q.coefficient[t == 0 ? 0 : 4];
    return c.negligible() ? 0 : c.negative() ? -1 : 1;
  }
  /// As reach(), if doubles do not decide.
  static double exact_reach(const Interval& i, int k, double t) noexcept {
    const double least = arithmetic::power_of_two(least_exponent);
    const Derivatives d(i.q, t, i.limbs);
    double most = 0;
    for (int order = 0; order < k; ++order) {
      most = std::max(most, root(k - order, (d.size[order] + least) / d.size[k]));
    }
    return 2 * most;
  }
  /// True if all zeros of an interval are in this part of it, as none is on either side.
  static bool has_no_zero_beside(const Interval& i, exact::Limb from, exact::Limb to) noexcept {
    const exact::Limb side[][2] = {{0, from}, {to, 0}};
    Quartic beside;
    for (const auto& [begin, end] : side) {
      if (begin != end && part(i.q, begin, end, i.limbs, beside) != 0) return false;
    }
    return true;
  }
  /// The part within reach of a group, a power of two long, takes the place of an interval if all of the zeros are in
  /// it; or nothing does, if there is none.
  bool narrow(Interval& i, const Local& local, const Group& group) noexcept {
    const double t = group.t;
    const int bits = arithmetic::exponent_of(group.reach) + 1;  // half its length
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
    const auto grid = [](double x) { return x == 1 ? exact::Limb{0} : static_cast<exact::Limb>(x * 0x1p64); };
    Interval& inner = *pending_[count_];
    inner.changes = part(i.q, grid(low), grid(high), i.limbs, inner.q);
    // Negligible coefficients may hide that a zero is elsewhere.
    const bool has_all = inner.changes == i.changes && inner.q.has_digits();
    if (!has_all && !has_no_zero_beside(i, grid(low), grid(high))) return false;
    if (inner.changes == 0) {
      --count_;
      return true;
    }
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
