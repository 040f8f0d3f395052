// SPDX-License-Identifier: Apache-2.0
/// The time of first contact of two ellipses where exponents are unlike: to about 100 bits, without trials.
///
/// It is the greatest T(n) (bound.hpp), n = -v + s perp(v). In s each ellipse has a bend of width c at s_i, and reaches
/// r across v. T is greatest where the slopes of both add up to w, that is where what they lack of their limits,
///
///     rest(s) = r (1 - x / sqrt(1 + x^2)),   x = (s - s_i) / c,
///
/// adds up to r_a + r_b - |w|; for w < 0 both are mirrored. That s is found in doubles of any exponent. Then T is
/// evaluated there from leading digits, and its error includes a bound on what a better s would gain; Newton's method
/// gives a better one from the same digits. So a bad s costs time, and never a wrong answer.
#pragma once

#include <vesica/cast/ellipse_contact.hpp>

namespace vesica::detail::cast {

template <int Degree>
Wide wide(const Number<Degree>& x) noexcept {
  return Wide(exact::rounded(x));
}

/// The bends of two ellipses: their widths, their reaches, and how far the second is behind the first; and the slope
/// that is asked for, with what it leaves of the reaches, `gap`.
struct Bends {
  Wide width[2], reach[2], way, slope, gap;

  /// What is left of both at a place, and how steeply it falls there; how far that is above `gap`.
  struct Rest {
    Wide value, fall, above;
  };
  /// At a distance from one of them.
  Rest rest(int from, const Wide& y) const noexcept {
    constexpr Wide one{1, 0};
    const Wide other = from == 0 ? y - way : y + way;
    Rest both;
    Wide slopes;
    for (int i = 0; i < 2; ++i) {
      const Wide x = (i == from ? y : other) / width[i], h = arithmetic::root(one + x * x);
      both.value = both.value + reach[i] * (x.sign() > 0 ? one / (h * (h + x)) : one - x / h);
      both.fall = both.fall + reach[i] / (width[i] * (h * h * h));
      slopes = slopes + reach[i] * (x / h);
    }
    both.above = slope < gap ? slope - slopes : both.value - gap;
    return both;
  }
};

/// A place, by its distance from the middle of one of two bends.
struct BesideBend {
  int bend;
  Wide way;
};

/// Where the rest of both is `gap`, at most the sum of their reaches. Seen from the nearer bend the rest goes with the
/// logarithm of the distance, over which it is bisected where Newton's method does not go on.
inline BesideBend place_of_rest(const Bends& b) noexcept {
  constexpr Wide two{2, 0};
  const int left = b.way.sign() >= 0 ? 0 : 1, right = 1 - left;
  const Wide half = arithmetic::abs(b.way) * Wide{0.5, 0};
  const auto is_behind = [&](int bend, const Wide& y) { return b.rest(bend, y).above.sign() > 0; };
  // Not before the left one, where more is left.
  const bool beyond = is_behind(right, {}), near_right = beyond || is_behind(left, half);
  const int bend = near_right ? right : left;
  const double side = near_right && !beyond ? -1 : 1;
  const auto at = [&](const Wide& d) { return Wide{side * d.value, d.exponent}; };
  const bool first_is_narrow = b.width[0] < b.width[1];
  const Wide &narrow = b.width[first_is_narrow ? 0 : 1], &broad = b.width[first_is_narrow ? 1 : 0];
  const Wide share = b.gap / (b.reach[0] + b.reach[1]), far = arithmetic::root(two / share);  // at most so many widths
  Wide low = narrow * Wide{0x1p-30, 0}, high = beyond ? broad * far : half;
  if (!(low < high) || is_behind(bend, at(low)) != (side > 0)) return {bend, {}};
  // The place if both were alike, if that is possible.
  Wide d = b.width[bend] * (Wide{1, 0} - share) / arithmetic::root(share * (two - share));
  if (!(low < d) || !(d < high)) d = arithmetic::root(low * high);
  for (int i = 0, digits = high.exponent - low.exponent; i < 60; ++i) {
    const auto [rest, fall, above] = b.rest(bend, at(d));
    (above.sign() > 0) == (side > 0) ? low = d : high = d;
    Wide next = d + at(two * rest * above / ((arithmetic::root(rest * b.gap) + b.gap) * fall));
    const bool is_slow = i % 2 == 1 && 2 * (high.exponent - low.exponent) > digits + 1;
    digits = high.exponent - low.exponent;
    if (is_slow || !(low < next) || !(next < high)) next = arithmetic::root(low * high);
    const Wide change = arithmetic::abs(next - d);
    d = next;
    if (change.sign() == 0 || change.exponent < d.exponent - 26) break;
  }
  return {bend, at(d)};
}

/// A direction n, by what it has of perp(v) more than an ellipse's bend has, times r^2 of that one.
struct EllipsePlace {
  int bend = -1;
  Leading<exact::more_limbs> beside;

  bool is_known() const noexcept { return bend >= 0; }
};
template <int limbs, int from>
Leading<limbs> with_limbs(const Leading<from>& x) noexcept {
  Leading<limbs> out;
  if (x.sign != 0) out.set(x.sign, x.span());
  out.error = out.nothing;
  return out;
}

/// A pair of ellipses whose line enters M after the start and does not graze it, in so many leading digits.
template <int limbs>
class SeenEllipses {
  using Digits = Leading<limbs>;
  using Seen = EllipseDigits<limbs>;

 public:
  explicit SeenEllipses(const PairDigits<limbs>& pair) noexcept : pair_(pair) {}

  /// The greatest T(n). `place`: where to look first, if it is known; then where it is, for more digits to go on from.
  WideTime time(EllipsePlace& place) const noexcept {
    if (!place.is_known() && !find_place(place)) return {};
    const Digits& unit = pair_.ellipse[place.bend].squared;
    const FromBend from(pair_, place.bend);
    Digits beside = with_limbs<limbs>(place.beside);
    Evaluated at = evaluate(from, beside, unit);
    for (int i = 0; i < most_steps && at.step.sign() != 0 && at.needs_better_place(); ++i) {
      beside = beside + leading<limbs>(at.step * wide(unit));
      beside.error = Digits::nothing;  // this is the direction now
      const Evaluated next = evaluate(from, beside, unit);
      const bool is_nearer = arithmetic::abs(next.step) < arithmetic::abs(at.step);
      at = next;
      if (!is_nearer) break;
    }
    place = at.is_near ? EllipsePlace{place.bend, with_limbs<exact::more_limbs>(beside)} : EllipsePlace{};
    if (at.is_usable && at.is_below_all_doubles()) return {Rough(crossings::Real(1.0), 0, least_exponent), true};
    return {at.time, at.is_usable, at.more_digits};
  }

 private:
  bool find_place(EllipsePlace& place) const noexcept {
    Bends bends;
    if (!reach_less_offset(bends.gap)) return false;
    const auto& [a, b] = pair_.ellipse;
    const bool mirrored = pair_.w.sign < 0;
    for (int i = 0; i < 2; ++i) {
      bends.width[i] = wide(pair_.ellipse[i].area) * wide(pair_.vv) / wide(pair_.ellipse[i].squared);
      bends.reach[i] = arithmetic::root(wide(pair_.ellipse[i].squared));
    }
    bends.slope = arithmetic::abs(wide(pair_.w));
    bends.way = wide(b.m * a.squared - a.m * b.squared) / (wide(a.squared) * wide(b.squared));
    if (mirrored) bends.way = -bends.way;
    const BesideBend found = place_of_rest(bends);
    place = {found.bend, {}};
    const Wide unit = wide(pair_.ellipse[found.bend].squared);
    place.beside = leading<exact::more_limbs>((mirrored ? -found.way : found.way) * unit);
    return true;
  }

  /// At the middle of an ellipse's bend n, times r^2, is -(v.v) (b^2 c u + a^2 k perp(u)); for both ellipses what u.n
  /// and u x n then are, and n.D.
  struct FromBend {
    int bend;
    Digits along[2], across[2], way;

    FromBend(const PairDigits<limbs>& pair, int of) noexcept : bend(of) {
      const Seen& e = pair.ellipse[bend];
      const Digits x = -(pair.vv * (square(e.hy) * e.c)), y = -(pair.vv * (square(e.hx) * e.k));
      along[bend] = x * e.uu;
      across[bend] = y * e.uu;
      // The other's axis by this one's; a cross product changes its sign.
      const Digits &dot = pair.axes_along, cross = bend == 0 ? -pair.axes_across : pair.axes_across;
      along[1 - bend] = x * dot - y * cross;
      across[1 - bend] = x * cross + y * dot;
      way = x * e.along_d + y * e.across_d;
    }
  };

  static constexpr int least_exponent = -1100;  ///< below those of doubles
  static constexpr int most_steps = 6;          ///< of Newton's method, each of some 50 bits

  /// T(n), with all that a better n can gain in the error; how far off the best s is.
  struct Evaluated {
    Rough time;
    Wide step;
    bool is_near = false;  ///< the step is so short that what it gains has a bound
    bool is_usable = false, more_digits = true;

    /// Not where it is better digits that it needs.
    bool needs_better_place() const noexcept { return !is_usable || !(is_precise() || more_digits); }
    bool is_precise() const noexcept { return std::fabs(rounded(time.value)) * 0x1p-66 >= time.error; }
    bool is_below_all_doubles() const noexcept {
      return arithmetic::scale(std::fabs(rounded(time.value)) + time.error, time.exponent - least_exponent) < 1;
    }
  };

  /// H - |w|, in which terms cancel where the line almost grazes.
  bool reach_less_offset(Wide& gap) const noexcept {
    const auto& [a, b] = pair_.ellipse;
    const Digits rest = square(pair_.w) - a.squared - b.squared, product = times(4, a.squared * b.squared);
    const Wide twice_root = arithmetic::root(wide(product));
    const Wide sum =
        arithmetic::root(wide(a.squared)) + arithmetic::root(wide(b.squared)) + arithmetic::abs(wide(pair_.w));
    if (rest.sign <= 0) {
      gap = (twice_root - wide(rest)) / sum;
      return true;
    }
    const Digits left = product - square(rest);
    gap = wide(left) / ((twice_root + wide(rest)) * sum);
    return left.sign > 0 && left.sign_is_certain();
  }

  /// At a bend's n and `beside` perp(v) more.
  Evaluated evaluate(const FromBend& from, const Digits& beside, const Digits& squared) const noexcept {
    const Digits offset = from.way + beside * pair_.w;
    Digits heights[2], slopes[2];
    Wide fall, narrowest;
    for (int i = 0; i < 2; ++i) {
      const Seen& e = pair_.ellipse[i];
      // u.perp(v) = -(u x v), u x perp(v) = u.v.
      const Digits p = e.hx * (from.along[i] - beside * e.k), q = e.hy * (from.across[i] + beside * e.c);
      const Digits squared_height = square(p) + square(q);
      if (!squared_height.sign_is_certain()) return {};  // of two squares, not both 0
      heights[i] = root(squared_height);
      if (!rough(heights[i]).is_precise()) return {};
      // Of the bend's own ellipse all but this cancels.
      slopes[i] = i == from.bend ? squared * beside : q * (e.hy * e.c) - p * (e.hx * e.k);
      const Wide of_unit = wide(heights[i]) / wide(squared), area = wide(e.area) * wide(pair_.vv);
      fall = fall + area * area / (of_unit * of_unit * of_unit);
      const Wide room = of_unit / (arithmetic::root(wide(e.squared)) * Wide{8, 0});
      if (i == 0 || room < narrowest) narrowest = room;
    }
    const Digits &h = heights[0], &g = heights[1], sum = pair_.w * h * g - slopes[0] * g - slopes[1] * h;
    const Rough slope = rough(sum) / rough(h * g);
    const Wide steepest(std::fabs(rounded(slope.value)) + slope.error, slope.exponent);
    Evaluated out;
    out.step = Wide(slope.scaled()) / fall;
    out.is_near = steepest / fall < narrowest;
    const Digits gap = offset - h - g;
    if (gap.sign <= 0) return out;
    out.time = rough(gap) / rough(squared * pair_.vv);
    out.is_usable = out.is_near;
    const Wide gain = steepest * steepest / (fall * wide(pair_.vv));
    // The gain as a number of its own: where T is 0, in whatever unit, it is all that there is.
    out.more_digits = !out.is_usable || gain < Wide(out.time.error, out.time.exponent);
    out.time = out.time + Rough({}, 1.01 * gain.value, gain.exponent);
    return out;
  }

  const PairDigits<limbs>& pair_;
};

}  // namespace vesica::detail::cast
