// SPDX-License-Identifier: Apache-2.0
/// The time of first contact of two ellipses where exponents are unlike: to about 100 bits, without trials.
///
/// It is the greatest T(n) (bound.hpp), n = -v + s perp(v), in one of the sectors of directions (ellipse_sector.hpp).
/// The slope of T, w - perp(v).x (bound.hpp), has exact terms too where it may cancel, the point x of M being near ends
/// of axes.
///
/// The l at which the slope is 0 is found in doubles of any exponent. Then T is evaluated there to 100 bits or from
/// leading digits. What a better l would gain is added, with a bound on its error; Newton's method gives a better one,
/// from the same digits. So a bad l costs time, and never a wrong answer.
#pragma once

#include <vesica/cast/ellipse_sector.hpp>
#include <vesica/cast/share_search.hpp>

namespace vesica::detail::cast {

/// Of a pair of ellipses whose line enters M after the start and does not graze it.
class EllipseTime {
  using Few = Leading<exact::few_limbs>;
  template <class Real>
  using Sizes = EllipseSector::Sizes<Real>;
  template <class Real>
  using Reach = EllipseSector::Reach<Real>;
  template <class Real>
  using Ends = EllipseSector::Ends<Real>;

 public:
  explicit EllipseTime(const ExactPair& pair) noexcept
      : pair_(pair),
        squared_{&pair.reach_a_.squared, &pair.reach_b_.squared},
        sector_(pair),
        vv_(exact::rounded(pair.vv_)) {}

  /// The greatest T(n).
  WideTime time() noexcept {
    find_sector();
    Digits share = digits(find_share(), most_limbs);
    Terms<Rough> few = terms<Rough>();
    ShareSearch search;
    for (int i = 0, far_steps = 0;; ++i) {
      const Evaluated at = limbs_ == 0 ? evaluate(rough(share), few) : evaluate(share.with_limbs(limbs_));
      const WideTime found{at.time, at.is_near};
      if (at.is_near && at.is_below_all_doubles()) return {Rough(crossings::Real(1.0), 0, least_exponent), true};
      if (found.tells() || i == most_steps || (at.more_digits && !has_digits_for(at.time))) return found;
      if (limbs_ > 0 && !at.is_near && ++far_steps == most_far_steps) return found;
      // A step of 100 bits gains some 200. Of a direction that is not near only its side is asked.
      if (at.more_digits && (at.is_near || at.step.sign() == 0)) limbs_ += exact::few_limbs;
      const Wide l = wide(share), step = wide(at.step);
      if (step.sign() == 0 || step.exponent < l.exponent - (at.is_near ? 0 : 2)) {
        // This is the direction now.
        share = (share + digits(at.step, most_limbs)).with_limbs(most_limbs);
      } else {
        share = digits(search.next(l, step), most_limbs);
      }
      if (share.sign <= 0) return found;
    }
  }

 private:
  static constexpr int least_exponent = -1100;  ///< below those of doubles
  static constexpr int most_steps = 20;         ///< of Newton's method, each of some 100 bits
  static constexpr int most_far_steps = 4;      ///< of these by digits from a direction that is not near
  static constexpr int most_trials = 60;        ///< before them, of l
  static constexpr int most_limbs = exact::more_limbs;
  static_assert(most_limbs % exact::few_limbs == 0);

  /// Whether more digits are worth while. Of short numbers trials are as quick as all that the least time may need.
  bool has_digits_for(const Rough& time) const noexcept {
    const int needed = limbs_ + (time.exponent - least_exponent) / 64;
    return pair_.is_long() || limbs_ == 0 ? limbs_ < most_limbs : needed < most_limbs;
  }
  void set_sector(const SectorEdge& e, const SectorEdge& f) noexcept {
    sector_.set(e, f);
    for (bool& known : straight_known_) known = false;
  }
  /// In which the slope changes its sign.
  void find_sector() noexcept {
    int low = -1, high = sector_.edges();
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      set_sector(sector_.edge(middle), sector_.edge(middle));
      (slope({}).value.sign() > 0 ? low : high) = middle;
    }
    set_sector(low < 0 ? SectorEdge{SectorEdge::across_v, -1, false} : sector_.edge(low),
               high == sector_.edges() ? SectorEdge{SectorEdge::across_v, 1, false} : sector_.edge(high));
    if (low < 0 || high == sector_.edges()) find_gap(low < 0 ? -1 : 1);
  }
  /// The reach across v less w, by (x^2 - w^2) / (x + w) where it cancels; 0 where it is not known well.
  void find_gap(int side) noexcept {
    const Rough a = root(Rough(*squared_[0])), b = root(Rough(*squared_[1])), w = turned(Rough(pair_.w_), side),
                twice = crossings::times(2, a * b);
    Rough gap = a + b - w;
    if (!gap.is_precise()) {
      const Few of_a(*squared_[0]), of_b(*squared_[1]), rest = square(Few(pair_.w_)) - of_a - of_b;
      Rough over = twice - rough(rest);
      if (!over.is_precise()) over = rough(times(4, of_a * of_b) - square(rest)) / (twice + rough(rest));
      gap = over / (a + b + w);
    }
    gap_ = gap.is_precise() ? wide(gap) : Wide{};
  }

  /// The slope in s at a share l, how steeply it falls, and how far s may change for that to hold roughly. Of the terms
  /// of either sign, how many times more is there of the positive ones, and by which power of l that falls.
  struct Slope {
    Wide value, fall, room, against;
    int excess = 0;
    double power = 1;
  };
  Slope slope(const Wide& l) const noexcept {
    const SeenDirection<Wide> n = between(sector_.from(), sector_.to(), l);
    const bool a_by_x = sector_.is_by_x(n, 0), b_by_x = sector_.is_by_x(n, 1);
    const Reach<Wide> a = sector_.reach(sector_.sizes(), n, 0, a_by_x),
                      b = sector_.reach(sector_.sizes(), n, 1, b_by_x);
    const int which = (a_by_x ? 1 : 0) + (b_by_x ? 2 : 0);
    if (!straight_known_[which]) straight_[which] = Wide(exact::rounded(sector_.straight(a_by_x, b_by_x)));
    straight_known_[which] = true;
    Wide falls[2];
    Slope out = fall(n.against, a.h, b.h, falls);
    const Wide& known = straight_[which];
    Wide positive, negative, falling, rising;
    if (gap_.sign() > 0 && gap_ < arithmetic::abs(known)) {
      const bool is_last = sector_.ends_across_v();
      const Wide rest = left_of_reach(n, a, 0) + left_of_reach(n, b, 1);
      positive = is_last ? rest : gap_, negative = is_last ? gap_ : rest;
      (is_last ? falling : rising) = out.fall;
    } else {
      (known.sign() > 0 ? positive : negative) = arithmetic::abs(known);
      for (int i = 0; i < 2; ++i) {
        const Reach<Wide>& r = i == 0 ? a : b;
        const Wide part = r.beside / (r.h * r.sum);
        if (part.sign() > 0) {
          negative = negative + part, rising = rising + falls[i];
        } else {
          positive = positive - part, falling = falling + falls[i];
        }
      }
    }
    out.value = positive - negative;
    if (out.value.exponent < positive.exponent - 50) out.value = {};  // rounding errors
    if (l.sign() > 0 && positive.sign() > 0 && negative.sign() > 0) {
      const Wide power = l / as_share({1, 0}, n.against) * (falling / positive + rising / negative);
      out.excess = positive.exponent - negative.exponent;
      out.power = power.value * arithmetic::scale(1, power.exponent);
    }
    return out;
  }
  /// What its reach across v is more than perp(v).x.
  Wide left_of_reach(const SeenDirection<Wide>& n, const Reach<Wide>& r, int i) const noexcept {
    const Wide across = arithmetic::root(wide(Few(*squared_[i]))), area = sector_.sizes().area[i] * n.against;
    const Wide product =
        r.p * arithmetic::abs(sector_.sizes().by_k[i]) + r.q * arithmetic::abs(sector_.sizes().by_c[i]);
    return area * area / (r.h * (across * r.h + product));
  }
  Slope fall(const Wide& against, const Wide& height_a, const Wide& height_b, Wide (&falls)[2]) const noexcept {
    Slope out;
    out.against = against;
    for (int i = 0; i < 2; ++i) {
      const Wide h = (i == 0 ? height_a : height_b) * vv_ / against, area = sector_.sizes().area[i] * vv_;
      falls[i] = area * area / (h * h * h);
      const Wide room = h / (arithmetic::root(wide(Few(*squared_[i]))) * Wide{8, 0});
      if (i == 0 || room < out.room) out.room = room;
    }
    out.fall = falls[0] + falls[1];
    return out;
  }
  /// A change of s as one of l: dl / ds = (n.v)^2 / (v.v |e x f|).
  Wide as_share(const Wide& step, const Wide& against) const noexcept {
    return step * against * against / (vv_ * sector_.width(sector_.from(), sector_.to()));
  }
  /// From where on n is e, and f, but for what is 0 there.
  void find_bends(Wide& first, Wide& last) const noexcept {
    const auto look = [&](const Wide& e, const Wide& f) {
      if (e.sign() == 0 || f.sign() == 0) return;
      const Wide x = arithmetic::abs(e / f);
      if (first.sign() == 0 || x < first) first = x;
      if (last < x) last = x;
    };
    for (int i = 0; i < 2; ++i) {
      look(sector_.from().along[i], sector_.to().along[i]);
      look(sector_.from().across[i], sector_.to().across[i]);
    }
    look(sector_.from().against, sector_.to().against);
    if (first.sign() == 0) first = last = {1, 0};
  }

  /// By Newton's method, on the logarithms where terms of unlike sizes are to be equal; within a bracket.
  Wide find_share() const noexcept {
    Wide first, last;
    find_bends(first, last);
    Wide l = arithmetic::root(first * last), low{1, first.exponent - 5000}, high{1, last.exponent + 5000};
    for (int i = 0, size = 0;; ++i) {
      const Slope at = slope(l);
      (at.value.sign() > 0 ? low : high) = l;
      const bool is_slow = i > 4 && at.value.exponent > size - 3;
      size = at.value.exponent;
      Wide next = l;
      if (std::abs(at.excess) > 2 && at.power < 4 && i < most_trials) {
        next.exponent += static_cast<int>(lane::max(-5000.0, lane::min(5000.0, at.excess / at.power)));
      } else {
        next = l + as_share(at.value / at.fall, at.against);
        const Wide change = arithmetic::abs(next - l);
        if (change.sign() == 0 || change.exponent < l.exponent - 26 || i > most_trials) return l;
      }
      if (is_slow || !(low < next) || !(next < high)) next = arithmetic::root(low * high);
      if (last < next && l < last) next = last;
      if (next < first && first < l) next = first;
      l = next;
    }
  }

  /// What n = e + l f is seen by, whatever l is.
  template <class Real>
  struct Terms {
    SeenDirection<Real> e, f;
    Sizes<Real> sizes;
    Ends<Real> ends[4];
    bool is_known[4] = {};

    const Ends<Real>& of_ends(const EllipseTime& time, bool a_by_x, bool b_by_x) noexcept {
      const int which = (a_by_x ? 1 : 0) + (b_by_x ? 2 : 0);
      if (!is_known[which]) ends[which] = time.sector_.ends<Real>(a_by_x, b_by_x, time.limbs_);
      is_known[which] = true;
      return ends[which];
    }
  };
  template <class Real>
  Terms<Real> terms() const noexcept {
    return {sector_.from<Real>(limbs_), sector_.to<Real>(limbs_), sector_.sizes<Real>(limbs_), {}, {}};
  }

  /// The greatest T(n), from one n; how far off the best l is.
  struct Evaluated {
    Rough time, step;
    bool is_near;      ///< the step is so short that what it gains has a bound
    bool more_digits;  ///< are needed

    bool is_below_all_doubles() const noexcept {
      return arithmetic::scale(std::fabs(rounded(time.value)) + time.error, time.exponent - least_exponent) < 1;
    }
  };
  /// A step of Newton's method in s is slope / bend, bend = k (n.v)^3 / v.v with k = sum of area^2 / h^3. It gains
  /// about slope^2 / (2 bend v.v).
  ///
  /// Proved: the greatest T lies within 2d (bound.hpp), where h changes by a share x = d / (4 room) at most. So bend is
  /// between bend / (1 + x)^3 and bend / (1 - x)^3 there, and what is gained between (1 - x)^3 and (1 + x)^3 times the
  /// above. As x <= 1/4, that is within 4 x of it.
  template <class Real>
  VESICA_COLD Evaluated evaluate(const Real& l, Terms<Real>& terms) const noexcept {
    const SeenDirection<Real> n = between(terms.e, terms.f, l);
    const SeenDirection<Wide> seen_n = between(sector_.from(), sector_.to(), wide(rough(l)));
    const bool a_by_x = sector_.is_by_x(seen_n, 0), b_by_x = sector_.is_by_x(seen_n, 1);
    const Sizes<Real>& s = terms.sizes;
    const Ends<Real>& ends = terms.of_ends(*this, a_by_x, b_by_x);
    const Reach<Real> a = sector_.reach(s, n, 0, a_by_x), b = sector_.reach(s, n, 1, b_by_x);
    const Real of_a = a.h * a.sum, of_b = b.h * b.sum;
    const Real beside = ends.straight * of_a * of_b - a.beside * of_b - b.beside * of_a;
    const Rough slope = rough(beside) / rough(of_a * of_b), against = rough(n.against);
    const Rough height_a = rough(a.h), height_b = rough(b.h);
    const Rough k = square(rough(s.area[0]) / height_a) / height_a + square(rough(s.area[1]) / height_b) / height_b;
    Wide falls[2];
    const Slope at = fall(seen_n.against, wide(height_a), wide(height_b), falls);
    const Wide steepest(std::fabs(rounded(slope.value)) + slope.error, slope.exponent), change = steepest / at.fall;
    const Real ahead = ends.along_e + l * ends.along_f;
    const Real gap = ahead * a.sum * b.sum - a.rest * b.sum - b.rest * a.sum;
    const Rough time = rough(gap) / rough(a.sum * b.sum * n.against);
    const Rough unit = k * against;
    const Wide rest = Wide(0.51, 0) * steepest * change / vv_ * (change / at.room);
    const Rough gain =
        square(slope) / crossings::times(2, unit * square(against)) + Rough({}, rest.value, rest.exponent);
    const bool is_known = slope.sign_is_known();
    const Rough step = is_known ? slope / (unit * rough(sector_.width(terms.e, terms.f))) : Rough();
    return {time + gain, step, change < at.room,
            !is_known || Wide(gain.error, gain.exponent) < Wide(time.error, time.exponent)};
  }
  Evaluated evaluate(const Digits& l) const noexcept {
    Terms<Digits> as_many = terms<Digits>();
    return evaluate(l, as_many);
  }

  const ExactPair& pair_;
  const Number<6>* squared_[2];
  EllipseSector sector_;
  Wide vv_, gap_;
  int limbs_ = 0;  ///< of the digits, 0 for Rough
  mutable Wide straight_[4];
  mutable bool straight_known_[4];
};

}  // namespace vesica::detail::cast
